//! A pin with play in a straight slot with round ends (`docs/notation.md`).

use crate::case::{Case, case};
use crate::elements::file;
use crate::power_balance::{assert_powers_balance, with_rates};
use loosepin_math::{Dual, Numbers, Vec2};
use loosepin_mechanics::contact::{compliance_1_pa, cylinder_stiffness_n_m1_5};
use loosepin_mechanics::dynamics::{Dynamics, PlayState};
use loosepin_mechanics::mechanism::{IdealMotion, Sample};
use loosepin_mechanics::model::JointId;
use loosepin_simulate::accuracy::{
    DisplacedLoops, PlayReach, position_outputs, quasi_static_check, starts_on_borders, worst_case_extremes,
};
use loosepin_simulate::{Observer, Plan, RunReport, Settings, Step, Window, run, simulate};

const END_RADIUS_M: f64 = 0.010;
const CLEARANCE_M: f64 = 1e-4;
const HALF_LENGTH_M: f64 = 0.055;

/// A driven arm that carries the slot, and a disc that is free but for it.
fn disc_in_a_turning_slot() -> String {
    file("disc_in_a_turning_slot.toml")
}

fn observed(case: &Case, end_s: f64, observer: &mut impl Observer) -> RunReport {
    let window = Window { start_s: 0.0, end_s };
    run(&case.mechanism, &case.sample, &window, &Settings::for_simulation(), observer).expect("the run is sound")
}

/// Coordinates of the free disc (place and angle of its frame) where its centre is at (ξ, η) along and across the slot at
/// time zero, in units of the slot's frame.
fn disc_at(case: &Case, along_m: f64, across_m: f64, angle_rad: f64) -> [f64; 3] {
    let (start, _) = case.mechanism.start(&case.sample).expect("it closes");
    let mut dynamics = Dynamics::new(&case.mechanism, &case.sample);
    let mut q = [start[0], start[1], angle_rad];
    for _ in 0..2 {
        dynamics.set_state(0.0, &q, &[0.0; 3]);
        let motion = &dynamics.plays()[0];
        let line = motion.directions[0];
        let wanted = line * along_m + line.turned() * across_m;
        let missing = wanted - motion.eccentricity_m;
        q[0] += missing.x;
        q[1] += missing.y;
    }
    q
}

fn closed() -> [PlayState<f64>; 1] {
    [PlayState { contact: 1.0, inverse_impact_speed_s_m: 2.3, effective_mass_kg: f64::NAN }]
}

/// The place of the pin with its centre |w| = c + δ off, at an angle φ from the face's normal beyond the upper end.
fn in_end(phi_rad: f64, penetration_m: f64) -> [f64; 2] {
    let off_m = CLEARANCE_M + penetration_m;
    [HALF_LENGTH_M + off_m * phi_rad.sin(), off_m * phi_rad.cos()]
}

#[test]
fn analytic_gap_force_and_stiffness_at_face_transition_and_end() {
    /// Round-off of a place of 0.1 m against a penetration, m.
    const ROUND_OFF_M: f64 = 1e-16;
    // Without loss the force does not depend on the rate, which the turning arm gives it.
    let case = case(&disc_in_a_turning_slot().replace("restitution = 0.8", "restitution = 1"));
    let h = compliance_1_pa(207e9, 0.3);
    let face = 4.0 / (3.0 * (h + h)) * (END_RADIUS_M - CLEARANCE_M).sqrt();
    let end = cylinder_stiffness_n_m1_5([h, h], END_RADIUS_M, CLEARANCE_M);
    // Half way between: q = 1/2 at sin² φ = 1/8, where q² (3 - 2 q) = 1/2.
    let between_rad = (1.0_f64 / 8.0).sqrt().asin();
    let mut dynamics = Dynamics::new(&case.mechanism, &case.sample);
    for penetration_m in [-3e-8, 0.0, 3e-8, 2e-5] {
        let across_m = CLEARANCE_M + penetration_m;
        let places = [
            ([0.013, across_m], face),
            ([-0.021, -across_m], face),
            ([HALF_LENGTH_M, across_m], face),
            (in_end(between_rad, penetration_m), 0.5 * (face + end)),
            (in_end(0.6, penetration_m), end),
            (in_end(std::f64::consts::FRAC_PI_2, penetration_m), end),
            (in_end(0.9, penetration_m).map(|x| -x), end),
        ];
        for ([along_m, across_m], stiffness) in places {
            let q = disc_at(&case, along_m, across_m, 0.7);
            dynamics.evaluate(0.0, &q, &[0.0; 3], &closed());
            let contact = dynamics.plays()[0].contact(&case.sample.plays[0], 0);
            assert!((contact.penetration_m - penetration_m).abs() < 2.0 * ROUND_OFF_M, "{}", contact.penetration_m);
            let force = dynamics.contacts()[0];
            let expected_n = stiffness * penetration_m.max(0.0).powf(1.5);
            let tolerance_n =
                1e-12 * expected_n + 1.5 * stiffness * 2.0 * ROUND_OFF_M * (penetration_m.abs() + ROUND_OFF_M).sqrt();
            assert!(
                (force.normal_n - expected_n).abs() <= tolerance_n,
                "at {along_m} {across_m}: {} {expected_n}",
                force.normal_n
            );
        }
    }
    let slot = *case.sample.plays[0].shape.slot().expect("a slot");
    assert!((slot.end_stiffening - (END_RADIUS_M / CLEARANCE_M).sqrt() + 1.0).abs() < 1e-14);
}

#[test]
fn identity_derivatives_of_the_gap_and_powers_at_faces_and_ends() {
    /// Round-off over the largest term.
    const ROUND_OFF: f64 = 1e-10;
    let case = case(&disc_in_a_turning_slot());
    let mut looked_at = 0;
    for (trial, [along_m, across_m]) in
        [[0.017, 1.13e-4], [-0.04, -1.02e-4], in_end(0.2, 9e-6), in_end(0.45, 2e-5), in_end(1.3, 1e-5)]
            .into_iter()
            .enumerate()
    {
        let q = disc_at(&case, along_m, across_m, 0.31);
        let spread = |k: usize| ((k + 3 * trial) as f64 * 1.7).sin();
        let rates: Vec<f64> = (0..3).map(|k| [1.9, 2.3, 70.0][k] * spread(k + 5)).collect();
        let mut plain = Dynamics::new(&case.mechanism, &case.sample);
        plain.evaluate(0.0, &q, &rates, &closed());
        let powers = plain.powers();
        let [value, rate, second] = plain.gap(0).gap;
        assert!(value > 0.0, "the pin touches");

        let [moving, turning] = with_rates([&q[..3], &rates[..3], plain.accelerations()]);
        let dual_sample = Sample::broadcast(&case.sample);
        let mut dual = Dynamics::new(&case.mechanism, &dual_sample);
        dual.set_state(Dual::variable(0.0), &moving, &turning);
        let motion = dual.plays()[0].contact(&dual_sample.plays[0], 0);
        let offset_m = CLEARANCE_M + motion.penetration_m.value;
        // g = (c + δ)² - c².
        assert!((rate - 2.0 * offset_m * motion.penetration_m.derivative).abs() < ROUND_OFF, "{rate}");
        let speed = motion.penetration_rate_m_s;
        assert!((speed.value - motion.penetration_m.derivative).abs() < ROUND_OFF * 10.0);
        let expected = 2.0 * (speed.value * speed.value + offset_m * speed.derivative);
        let largest = plain.accelerations().iter().fold(10.0_f64, |largest, a| largest.max(a.abs()));
        assert!((second - expected).abs() < ROUND_OFF * largest, "{second} {expected}");
        assert!((plain.gap(0).penetration_acceleration_m_s2 - speed.derivative).abs() < 1e-6 * largest);

        let energy = dual.energy(|_| true);
        assert_powers_balance(&energy, &powers, ROUND_OFF, &format!("trial {trial}"));
        // Where the pin leaves so fast that the force is cut at zero, there is no friction.
        assert!(powers.friction_loss_w >= 0.0);
        looked_at += usize::from(powers.friction_loss_w > 0.0);
    }
    assert!(looked_at > 2, "the force acts in {looked_at} of 5 places");
}

#[test]
fn identity_pull_along_the_wall_is_the_slope_of_the_stored_energy() {
    /// Differences of the energy over a step of 1e-5 rad.
    const DIFFERENCE: f64 = 1e-6;
    const STEP_RAD: f64 = 1e-5;
    let text = disc_in_a_turning_slot().replace("friction = { coefficient = 0.09 }\n", "");
    let case = case(&text);
    let depth_m = 2e-5;
    let mut dynamics = Dynamics::new(&case.mechanism, &case.sample);
    let mut stored_j = |phi_rad: f64| {
        let [along_m, across_m] = in_end(phi_rad, depth_m);
        dynamics.evaluate(0.0, &disc_at(&case, along_m, across_m, 0.7), &[0.0; 3], &closed());
        let force = dynamics.contacts()[0].on_journal_n;
        let normal = dynamics.plays()[0].contact(&case.sample.plays[0], 0).normal;
        (dynamics.energy(|_| true).stored_j, force.dot(normal.turned()))
    };
    for phi_rad in [0.05, 0.2, 0.36, 0.5] {
        let slope_j = (stored_j(phi_rad + STEP_RAD).0 - stored_j(phi_rad - STEP_RAD).0) / (2.0 * STEP_RAD);
        // φ grows from the face's normal towards the line: against t.
        let expected_n = slope_j / (CLEARANCE_M + depth_m);
        let found_n = stored_j(phi_rad).1;
        assert!(slope_j > 0.0);
        assert!((found_n - expected_n).abs() < DIFFERENCE * expected_n, "at {phi_rad}: {found_n} {expected_n}");
    }
    for phi_rad in [0.0, 0.55, 1.2] {
        assert!(stored_j(phi_rad).1.abs() < 1e-6, "no pull at the face and beyond 30°");
    }
}

/// How far along its slot the disc has been.
#[derive(Debug, Default)]
struct Ways {
    furthest_m: [f64; 2],
    contacts: [usize; 3],
    strongest_n: f64,
}

impl Observer for Ways {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        let (start_s, end_s) = (step.start_s, step.end_s);
        for k in 1..8 {
            let force = step.evaluate(start_s + (end_s - start_s) * f64::from(k) / 8.0).contacts()[0];
            self.strongest_n = self.strongest_n.max(force.normal_n);
        }
        let dynamics = step.set_state(end_s);
        let motion = &dynamics.plays()[0];
        let along_m = motion.directions[0].dot(motion.eccentricity_m);
        self.furthest_m = [self.furthest_m[0].min(along_m), self.furthest_m[1].max(along_m)];
        let normal = motion.contact(&dynamics.sample().plays[0], 0);
        if normal.penetration_m > 0.0 {
            let place = usize::from(along_m > HALF_LENGTH_M) + 2 * usize::from(along_m < -HALF_LENGTH_M);
            self.contacts[place] += 1;
        }
    }
}

#[test]
fn identity_energy_over_faces_and_both_ends() {
    /// Largest residual over largest exchange, of tolerances of 1e-9 m and of 5e-12 m in a step.
    const ENERGY_RESIDUAL: f64 = 1e-7;
    let case = case(&disc_in_a_turning_slot());
    let mut ways = Ways::default();
    let report = observed(&case, 0.5, &mut ways);
    let energy = report.energy.expect("it was integrated");
    println!("{} contacts, residual {:.1e}, {:?}", report.plays[0].contacts, energy.relative_residual(), ways.contacts);
    assert!(energy.relative_residual() < ENERGY_RESIDUAL, "{energy:?}");
    assert!(energy.friction_loss_j > 0.0 && energy.contact_loss_j > 0.0, "{energy:?}");
    assert!(ways.contacts.iter().all(|&steps| steps > 20), "faces and both ends: {:?}", ways.contacts);
    // The peak is taken at five places of its step, with a stiffness that grows evenly between its ends.
    let peak_n = report.plays[0].peak_force_n;
    assert!(peak_n >= ways.strongest_n * 0.98 && peak_n < 1.02 * ways.strongest_n, "{peak_n} {ways:?}");
    // It never goes further than clearance and penetration let it.
    let furthest_m = HALF_LENGTH_M + CLEARANCE_M + report.plays[0].largest_penetration_m;
    for way_m in ways.furthest_m {
        assert!(way_m.abs() <= furthest_m + 1e-12 && way_m.abs() > HALF_LENGTH_M, "{way_m} {furthest_m}");
    }
}

#[test]
fn analytic_ideal_yoke_and_its_worst_case() {
    /// Round-off of positions of 0.1 m, m.
    const ROUND_OFF_M: f64 = 1e-15;
    let case = case(&file("scotch_yoke_with_play_in_its_slot.toml"));
    let speed_rad_s = 400.0 * std::f64::consts::TAU / 60.0;
    let (slope_rad, radius_m) = (75f64.to_radians(), 0.040);
    let mut motion =
        IdealMotion::new(&case.mechanism, &case.sample.ideal, &case.sample.drives).expect("the start closes");
    let reaches = PlayReach::of_sample(&case.mechanism, &case.sample, [0.0]).expect("there is an answer");
    assert_eq!(reaches, [PlayReach::Slot { clearance_m: CLEARANCE_M }]);
    let mut loops = DisplacedLoops::new(&case.mechanism, &case.values);
    for time_s in [0.0, 0.021, 0.058, 0.097, 0.13] {
        motion.move_to(time_s).expect("it closes");
        let crank_rad = 30f64.to_radians() + speed_rad_s * time_s;
        // The slot's middle is 3 mm below the rail's point of the yoke; its line leans.
        let middle_y_m = 0.005 - 0.007 + 0.004;
        let middle_x_m = radius_m * crank_rad.cos() - (radius_m * crank_rad.sin() - middle_y_m) / slope_rad.tan();
        let tool_m = middle_x_m + 0.078;
        loops.set_position(motion.coordinates());
        let reading = position_outputs(&case.mechanism)[0].reading;
        assert!((loops.value(reading) - tool_m).abs() < ROUND_OFF_M, "{} {tool_m}", loops.value(reading));
        let exact = worst_case_extremes(&mut loops, reading, &reaches, &starts_on_borders(&reaches));
        let expected_m = CLEARANCE_M / slope_rad.sin();
        assert!((exact.highest.deviation_si - expected_m).abs() < ROUND_OFF_M);
        assert!((exact.lowest.deviation_si + expected_m).abs() < ROUND_OFF_M);
    }
}

#[test]
fn identity_a_run_of_the_yoke_keeps_its_energy_and_stays_within_the_worst_case() {
    /// As above.
    const ENERGY_RESIDUAL: f64 = 1e-7;
    let case = case(&file("scotch_yoke_with_play_in_its_slot.toml"));
    let cycle = loosepin_mechanics::model::Cycle {
        recorded_turns: 0.5,
        samples_per_turn: 120,
        ..case.mechanism.model.cycle.clone()
    };
    let plan = Plan {
        cycle,
        settings: Settings::for_simulation(),
        with_states: false,
        lyapunov_turns: None,
        second_run: false,
        overrides: Vec::new(),
    };
    let simulation = simulate(&case.mechanism, &case.values, &plan).expect("the run is sound");
    let record = &simulation.record;
    println!("residual {:.1e}", record.energy.relative_residual);
    assert!(record.energy.relative_residual < ENERGY_RESIDUAL, "{:e}", record.energy.relative_residual);
    assert!(record.orbits.is_empty(), "a pin in a slot has no orbit");
    assert!(record.joints[0].peak_force_n > 0.0 && !record.impacts.is_empty());
    let shares = quasi_static_check(&case.mechanism, &case.values, record).expect("it is ideal");
    assert!(shares.iter().all(|share| !share.is_exceeded && share.largest_share > 0.8), "{shares:?}");
}

#[test]
fn analytic_friction_at_the_end_of_a_slot() {
    /// Round-off over the force.
    const ROUND_OFF: f64 = 1e-9;
    let case = case(&disc_in_a_turning_slot());
    let mut dynamics = Dynamics::new(&case.mechanism, &case.sample);
    let [along_m, across_m] = in_end(1.1, 1e-5);
    let q = disc_at(&case, along_m, across_m, 0.7);
    for spin_rad_s in [0.0, 5e-3, 40.0, -40.0] {
        // The pin's centre moves with the slot's body, whose spin is that of its drive; the pin turns against it.
        dynamics.set_state(0.0, &q, &[0.0; 3]);
        let arm_spin_rad_s = dynamics.plays()[0].spins_rad_s[0];
        let mut rates = [0.0, 0.0, arm_spin_rad_s + spin_rad_s];
        for _ in 0..2 {
            dynamics.set_state(0.0, &q, &rates);
            let motion = &dynamics.plays()[0];
            let seen = motion.eccentricity_rate_m_s.plus(motion.eccentricity_m.turned(), -arm_spin_rad_s);
            rates[0] -= seen.x;
            rates[1] -= seen.y;
        }
        dynamics.evaluate(0.0, &q, &rates, &closed());
        let force = dynamics.contacts()[0];
        let arm_m = END_RADIUS_M - CLEARANCE_M - 0.5e-5;
        let expected_m_s = arm_m * spin_rad_s;
        assert!((force.sliding_m_s - expected_m_s).abs() < 1e-13, "{} {expected_m_s}", force.sliding_m_s);
        let share = ((expected_m_s.abs() - 1e-4) / 9e-4).clamp(0.0, 1.0);
        let friction_n = -0.09 * share * force.normal_n * expected_m_s.signum();
        let moment_n_m = arm_m * friction_n;
        assert!((force.moment_on_journal_n_m - moment_n_m).abs() <= ROUND_OFF * force.normal_n, "{spin_rad_s}");
        let loss_w = -friction_n * expected_m_s;
        assert!((force.friction_loss_w - loss_w).abs() <= ROUND_OFF * force.normal_n);
    }
}

/// How far the pin has been off the line of an ideal slot, and the part of the slot's force along that line.
#[derive(Debug, Default)]
struct Drift {
    off_m: f64,
    along_n: f64,
    across_n: f64,
}

impl Observer for Drift {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        let end_s = step.end_s;
        let dynamics = step.evaluate(end_s);
        let [slot, pin] = [2, 1].map(|body| dynamics.mechanism().real.slot_of_body[body]);
        let poses = &dynamics.kinematics.poses;
        let line_rad = poses[slot].angle_rad() + 75f64.to_radians();
        let line = Vec2::new(line_rad.cos(), line_rad.sin());
        let e = poses[pin].point_m(Vec2::new(0.040, 0.0)) - poses[slot].point_m(Vec2::new(0.002, 0.004));
        self.off_m = self.off_m.max(line.turned().dot(e).abs());
        let force = dynamics.joint_force_n(JointId(2));
        self.along_n = self.along_n.max(line.dot(force).abs());
        self.across_n = self.across_n.max(line.turned().dot(force).abs());
    }
}

#[test]
fn identity_an_ideal_slot_holds_its_pin_where_the_guide_has_play() {
    /// Round-off of positions of 0.1 m, m.
    const ROUND_OFF_M: f64 = 1e-14;
    /// As above.
    const ENERGY_RESIDUAL: f64 = 1e-7;
    let text = file("scotch_yoke_with_play_in_its_slot.toml")
        .replace("clearance = \"0.1 mm\"", "clearance = \"0 mm\"")
        .replace(
            "slider = \"yoke.slider\"",
            "slider = \"yoke.slider\"\nhalf_length = \"30 mm\"\nhalf_height = \"14 mm\"\nclearance = \"0.2 mm\"\n\
             corner_radius = \"3 mm\"\ncontact = \"steel\"",
        );
    let case = case(&text);
    assert_eq!((case.mechanism.real.free, case.mechanism.dynamic_freedoms), (3, 2), "the yoke, less one for the slot");
    let mut drift = Drift::default();
    let report = observed(&case, 0.05, &mut drift);
    let energy = report.energy.expect("it was integrated");
    assert!(energy.relative_residual() < ENERGY_RESIDUAL && energy.contact_loss_j > 0.0, "{energy:?}");
    assert!(report.plays[0].contacts > 3, "{:?}", report.plays);
    assert!(drift.off_m < ROUND_OFF_M, "{drift:?}");
    assert!(drift.across_n > 10.0 && drift.along_n < 1e-10 * drift.across_n, "{drift:?}");
}

/// A pin turns in its slot: however its body stands against the line at the start, the loop closes.
#[test]
fn analytic_an_ideal_slot_closes_wherever_the_crank_starts() {
    let text = file("scotch_yoke_with_play_in_its_slot.toml").replace("clearance = \"0.1 mm\"", "clearance = \"0 mm\"");
    for start_deg in (0..360).step_by(15) {
        let case = case(&text.replace("start_angle = \"30 deg\"", &format!("start_angle = \"{start_deg} deg\"")));
        let ideal = IdealMotion::new(&case.mechanism, &case.sample.ideal, &case.sample.drives).expect("it closes");
        let (sine, cosine) = f64::from(start_deg).to_radians().sin_cos();
        let (slot_sine, slot_cosine) = 75_f64.to_radians().sin_cos();
        // The pin (r cos θ, r sin θ) lies on the line through the middle of the slot, (x + 2, 2) mm, which stands at 75°.
        let x_m = 0.040 * cosine - 0.002 - (0.040 * sine - 0.002) * slot_cosine / slot_sine;
        let yoke = case.mechanism.ideal.slot_of_body[2];
        let found = ideal.kinematics().poses[yoke];
        assert!(
            (found.position_m.x - x_m).abs() < 1e-12 && found.angle_rad().abs() < 1e-12,
            "{start_deg}°: {found:?} {x_m}"
        );
    }
}
