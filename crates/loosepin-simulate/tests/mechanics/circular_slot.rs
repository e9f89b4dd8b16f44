//! A pin in a circular slot: ideal, and with play at both flanks (`docs/notation.md`).

use crate::case::{Case, case};
use crate::elements::file;
use crate::power_balance::{assert_powers_balance, with_rates};
use loosepin_math::{Dual, Numbers, Vec2};
use loosepin_mechanics::contact::compliance_1_pa;
use loosepin_mechanics::dynamics::{Dynamics, PlayState};
use loosepin_mechanics::mechanism::{IdealMotion, Sample};
use loosepin_mechanics::model::JointId;
use loosepin_simulate::accuracy::{
    DisplacedLoops, PlayReach, position_outputs, quasi_static_check, starts_on_borders, worst_case_extremes,
};
use loosepin_simulate::{Observer, Plan, RunReport, Settings, Step, Window, run, simulate};

const CLEARANCE_M: f64 = 1e-4;
/// Largest residual of the energy account over largest exchange, of tolerances of 1e-9 m and of 5e-12 m in a step.
const ENERGY_RESIDUAL: f64 = 1e-7;

fn observed(case: &Case, end_s: f64, observer: &mut impl Observer) -> RunReport {
    let window = Window { start_s: 0.0, end_s };
    run(&case.mechanism, &case.sample, &window, &Settings::for_simulation(), observer).expect("the run is sound")
}

/// A driven plate that carries the slot, and a disc that is free but for it.
mod disc {
    pub const RADIUS_M: f64 = 0.050;
    pub const HALF_WIDTH_M: f64 = 0.010;

    pub fn text() -> String {
        crate::elements::file("disc_in_a_turning_circular_slot.toml")
    }
}

/// Coordinates of the free disc (place and angle of its frame) where its pin is so far from the centre of the circle, in the direction
/// `phi_rad`, at time zero.
fn disc_at(case: &Case, distance_m: f64, phi_rad: f64, angle_rad: f64) -> [f64; 3] {
    let mut dynamics = Dynamics::new(&case.mechanism, &case.sample);
    let mut q = [0.01, 0.02, angle_rad];
    for _ in 0..2 {
        dynamics.set_state(0.0, &q, &[0.0; 3]);
        let missing = Vec2::new(phi_rad.cos(), phi_rad.sin()) * distance_m - dynamics.plays()[0].eccentricity_m;
        q[0] += missing.x;
        q[1] += missing.y;
    }
    q
}

fn closed() -> [PlayState<f64>; 2] {
    [PlayState { contact: 1.0, inverse_impact_speed_s_m: 2.3, effective_mass_kg: f64::NAN }; 2]
}

/// How far the pin is from the centre with this penetration of the outer flank, 0, or of the inner one, 1.
fn distance_m(place: usize, penetration_m: f64) -> f64 {
    disc::RADIUS_M + [1.0, -1.0][place] * (CLEARANCE_M + penetration_m)
}

#[test]
fn analytic_gap_force_and_stiffness_at_both_flanks() {
    /// Round-off of a place of 0.1 m against a penetration, m.
    const ROUND_OFF_M: f64 = 5e-17;
    // Without loss the force does not depend on the rate, which the turning plate gives it.
    let case = case(&disc::text().replace("restitution = 0.8", "restitution = 1"));
    let h = compliance_1_pa(207e9, 0.3);
    // Eq. (9) for a pin of 9.9 mm in a hollow of 60 mm, and on a cylinder of 40 mm.
    let pin_m = disc::HALF_WIDTH_M - CLEARANCE_M;
    let [hollow_m, cylinder_m] = [1.0, -1.0].map(|side| disc::RADIUS_M + side * disc::HALF_WIDTH_M);
    let stiffnesses = [hollow_m * pin_m / (hollow_m - pin_m), cylinder_m * pin_m / (cylinder_m + pin_m)]
        .map(|radius_m| 4.0 / (3.0 * (h + h)) * radius_m.sqrt());
    let mut dynamics = Dynamics::new(&case.mechanism, &case.sample);
    for (place, stiffness) in stiffnesses.into_iter().enumerate() {
        for penetration_m in [-3e-8, 0.0, 3e-8, 2e-5] {
            for phi_rad in [0.4, 2.9, -1.7] {
                let q = disc_at(&case, distance_m(place, penetration_m), phi_rad, 0.7);
                dynamics.evaluate(0.0, &q, &[0.0; 3], &closed());
                let [found, other] =
                    [place, 1 - place].map(|place| dynamics.plays()[0].contact(&case.sample.plays[0], place));
                assert!((found.penetration_m - penetration_m).abs() < ROUND_OFF_M, "{}", found.penetration_m);
                assert!((other.penetration_m + 2.0 * CLEARANCE_M + penetration_m).abs() < ROUND_OFF_M);
                let [force, none] = [place, 1 - place].map(|place| dynamics.contacts()[place]);
                let expected_n = stiffness * penetration_m.max(0.0).powf(1.5);
                let tolerance_n =
                    1e-12 * expected_n + 1.5 * stiffness * ROUND_OFF_M * (penetration_m.abs() + ROUND_OFF_M).sqrt();
                assert!((force.normal_n - expected_n).abs() <= tolerance_n, "{} {expected_n}", force.normal_n);
                // The slot pushes the pin back to its middle.
                let outwards = Vec2::new(phi_rad.cos(), phi_rad.sin());
                let push_n = [-expected_n, expected_n][place];
                assert!((force.on_journal_n.dot(outwards) - push_n).abs() <= tolerance_n + 1e-9 * expected_n);
                assert_eq!(none.normal_n, 0.0);
            }
        }
    }
}

#[test]
fn identity_derivatives_of_the_gap_and_powers_at_both_flanks() {
    /// Round-off over the largest term.
    const ROUND_OFF: f64 = 1e-10;
    let case = case(&disc::text());
    let mut looked_at = 0;
    for (trial, (place, penetration_m, phi_rad)) in
        [(0, 1.3e-5, 0.3), (0, 2e-6, 2.2), (0, 2e-5, -2.9), (1, 9e-6, 1.1), (1, 2e-5, -0.6), (1, 3e-6, 3.0)]
            .into_iter()
            .enumerate()
    {
        let q = disc_at(&case, distance_m(place, penetration_m), phi_rad, 0.31);
        let spread = |k: usize| ((k + 3 * trial) as f64 * 1.7).sin();
        let rates: Vec<f64> = (0..3).map(|k| [0.4, 0.3, 70.0][k] * spread(k + 5)).collect();
        let mut plain = Dynamics::new(&case.mechanism, &case.sample);
        plain.evaluate(0.0, &q, &rates, &closed());
        let powers = plain.powers();
        let [value, rate, second] = plain.gap(place).gap;
        assert!((value - penetration_m).abs() < 1e-15, "the pin touches");

        let [moving, turning] = with_rates([&q[..3], &rates[..3], plain.accelerations()]);
        let dual_sample = Sample::broadcast(&case.sample);
        let mut dual = Dynamics::new(&case.mechanism, &dual_sample);
        dual.set_state(Dual::variable(0.0), &moving, &turning);
        let motion = dual.plays()[0].contact(&dual_sample.plays[0], place);
        assert!((rate - motion.penetration_m.derivative).abs() < ROUND_OFF, "{rate}");
        assert!((motion.penetration_rate_m_s.value - rate).abs() < ROUND_OFF);
        let largest = plain.accelerations().iter().fold(10.0_f64, |largest, a| largest.max(a.abs()));
        let expected = motion.penetration_rate_m_s.derivative;
        assert!((second - expected).abs() < ROUND_OFF * largest, "{second} {expected}");
        assert_eq!(plain.gap(place).penetration_acceleration_m_s2, second);

        let energy = dual.energy(|contact| contact == place);
        assert_powers_balance(&energy, &powers, ROUND_OFF, &format!("trial {trial}"));
        // Where the pin leaves so fast that the force is cut at zero, there is no friction.
        assert!(powers.friction_loss_w >= 0.0);
        looked_at += usize::from(powers.friction_loss_w > 0.0);
    }
    assert!(looked_at > 3, "the force acts in {looked_at} of 6 places");
}

#[test]
fn analytic_friction_of_a_pin_that_rolls_and_slides_on_either_flank() {
    /// Round-off over the force.
    const ROUND_OFF: f64 = 1e-9;
    let case = case(&disc::text());
    let mut dynamics = Dynamics::new(&case.mechanism, &case.sample);
    let depth_m = 1e-5;
    for place in [0, 1] {
        let q = disc_at(&case, distance_m(place, depth_m), 0.8, 0.7);
        for spin_rad_s in [0.0, 5e-3, 40.0, -40.0] {
            // The pin's centre moves with the plate, and the pin turns against it.
            dynamics.set_state(0.0, &q, &[0.0; 3]);
            let plate_rad_s = dynamics.plays()[0].spins_rad_s[0];
            let mut rates = [0.0, 0.0, plate_rad_s + spin_rad_s];
            for _ in 0..2 {
                dynamics.set_state(0.0, &q, &rates);
                let motion = &dynamics.plays()[0];
                let seen = motion.eccentricity_rate_m_s.plus(motion.eccentricity_m.turned(), -plate_rad_s);
                rates[0] -= seen.x;
                rates[1] -= seen.y;
            }
            dynamics.evaluate(0.0, &q, &rates, &closed());
            let force = dynamics.contacts()[place];
            let arm_m = disc::HALF_WIDTH_M - CLEARANCE_M - 0.5 * depth_m;
            let expected_m_s = arm_m * spin_rad_s;
            assert!((force.sliding_m_s - expected_m_s).abs() < 1e-13, "{} {expected_m_s}", force.sliding_m_s);
            let share = ((expected_m_s.abs() - 1e-4) / 9e-4).clamp(0.0, 1.0);
            let friction_n = -0.09 * share * force.normal_n * expected_m_s.signum();
            assert!((force.moment_on_journal_n_m - arm_m * friction_n).abs() <= ROUND_OFF * force.normal_n);
            // About the centre of the circle the flank's arm is R + b or -(R - b), less what both give way.
            let flank_m = [1.0, -1.0][place] * distance_m(place, depth_m) + arm_m;
            assert!((force.moment_on_bearing_n_m + flank_m * friction_n).abs() <= ROUND_OFF * force.normal_n);
            assert!((force.friction_loss_w + friction_n * expected_m_s).abs() <= ROUND_OFF * force.normal_n);
        }
    }
}

/// Steps in which either flank is pressed, and how far the pin has been from the middle of the slot.
#[derive(Debug, Default)]
struct Flanks {
    steps: [usize; 2],
    furthest_m: f64,
}

impl Observer for Flanks {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        let end_s = step.end_s;
        let dynamics = step.set_state(end_s);
        for place in [0, 1] {
            let penetration_m = dynamics.plays()[0].contact(&dynamics.sample().plays[0], place).penetration_m;
            self.steps[place] += usize::from(penetration_m > 0.0);
            self.furthest_m = self.furthest_m.max(penetration_m + CLEARANCE_M);
        }
    }
}

#[test]
fn identity_energy_of_a_disc_that_falls_from_flank_to_flank() {
    let case = case(&disc::text());
    let mut flanks = Flanks::default();
    let report = observed(&case, 0.5, &mut flanks);
    let energy = report.energy.expect("it was integrated");
    println!("residual {:.1e}, {flanks:?}, {:?}", energy.relative_residual(), report.plays);
    assert!(energy.relative_residual() < ENERGY_RESIDUAL, "{energy:?}");
    assert!(energy.friction_loss_j > 0.0 && energy.contact_loss_j > 0.0, "{energy:?}");
    assert!(flanks.steps.iter().all(|&steps| steps > 20), "{flanks:?}");
    let deepest_m = report.plays.iter().map(|play| play.largest_penetration_m).fold(0.0, f64::max);
    assert!(flanks.furthest_m <= CLEARANCE_M + deepest_m + 1e-12, "{flanks:?} {deepest_m}");
}

/// The end of a coupler of 100 mm from the crank's pin, 75 mm from the centre of the slot: on the side of the line from pin to centre where
/// it is at the start.
fn coupler_end_m(time_s: f64, side: f64) -> [Vec2<f64>; 2] {
    let turn = |rpm: f64, start_deg: f64| {
        let angle_rad = start_deg.to_radians() + rpm * std::f64::consts::TAU / 60.0 * time_s;
        Vec2::new(angle_rad.cos(), angle_rad.sin())
    };
    let (crank, plate) = (turn(240.0, 50.0), turn(-60.0, 10.0));
    let pin = crank * 0.040;
    let centre = Vec2::new(0.110, 0.020) + plate * 0.015 - plate.turned() * 0.008;
    let way = centre - pin;
    let distance = way.length();
    let along = (0.1_f64.powi(2) - 0.075_f64.powi(2) + distance * distance) / (2.0 * distance);
    let aside = side * (0.1_f64.powi(2) - along * along).sqrt();
    [pin, pin + way * (along / distance) + way.turned() * (aside / distance)]
}

fn ideal_linkage() -> String {
    file("linkage_with_a_circular_slot.toml").replace("clearance = \"0.1 mm\"", "clearance = \"0 mm\"")
}

#[test]
fn analytic_an_ideal_slot_moves_as_a_link_of_its_radius() {
    /// Round-off of positions of 0.1 m, m.
    const ROUND_OFF_M: f64 = 1e-14;
    let case = case(&ideal_linkage());
    let ideal = &case.mechanism.ideal;
    assert_eq!((ideal.free, ideal.constraint_rows(), case.mechanism.dynamic_freedoms), (1, 1, 0));
    let mut motion = IdealMotion::new(&case.mechanism, &case.sample.ideal, &case.sample.drives).expect("it closes");
    let coupler = ideal.slot_of_body[3];
    let end_m = |motion: &IdealMotion<'_>| motion.kinematics().poses[coupler].point_m(Vec2::new(0.1, 0.0));
    let [pin_m, above_m] = coupler_end_m(0.0, 1.0);
    let side = if (end_m(&motion) - above_m).length() < 1e-3 { 1.0 } else { -1.0 };
    assert!((motion.kinematics().poses[coupler].position_m - pin_m).length() < ROUND_OFF_M);
    for step in 1..=200 {
        let time_s = f64::from(step) * 2.5e-3;
        motion.move_to(time_s).expect("it closes");
        let expected_m = coupler_end_m(time_s, side)[1];
        assert!((end_m(&motion) - expected_m).length() < ROUND_OFF_M, "{time_s}: {:?} {expected_m:?}", end_m(&motion));
    }
}

/// Where the coupler is at the end of a run, and the force on its end.
struct Last {
    end_m: Vec2<f64>,
    on_end_n: Vec2<f64>,
}

impl Default for Last {
    fn default() -> Self {
        Self { end_m: Vec2::zero(), on_end_n: Vec2::zero() }
    }
}

impl Observer for Last {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        let end_s = step.end_s;
        let dynamics = step.evaluate(end_s);
        let coupler = dynamics.mechanism().real.slot_of_body[3];
        self.end_m = dynamics.kinematics.poses[coupler].point_m(Vec2::new(0.1, 0.0));
        self.on_end_n = dynamics.joint_force_n(JointId(3));
    }
}

/// With a link of 1 mg and of 2 mg the motion differs by 3.5 nm and by twice that: what they lead to at no mass is compared.
#[test]
fn identity_a_run_with_an_ideal_slot_is_that_with_a_link_without_mass() {
    /// What the runs differ by where 1e-9 m is asked for, and over forces of 0.4 N.
    const MOTION_M: f64 = 1e-10;
    const FORCE_N: f64 = 1e-9;
    // The crank is free: its motion follows from the forces.
    let free = ideal_linkage()
        .replace("[drive.crank]\njoint = \"main\"\nspeed = \"240 rpm\"\nstart_angle = \"50 deg\"\n", "")
        .replace(
            "drive = \"crank\"\ntransient_turns = 0\nrecorded_turns = 2\nsamples_per_turn = 200",
            "duration = \"0.3 s\"",
        )
        + "\n[initial.joint.main]\nangle = \"50 deg\"\nangular_velocity = \"240 rpm\"\n";
    let (before, slot) = free.split_at(free.find("[joint.slot]").expect("the slot"));
    let after = &slot[slot.find("[drive.plate]").expect("the drive")..];
    let linked = |mg: f64| {
        format!(
            "{before}[joint.slot]\nkind = \"revolute\"\nbearing = \"link.end\"\njournal = \"coupler.end\"\n\
             [joint.hinge]\nkind = \"revolute\"\nbearing = \"plate.centre\"\njournal = \"link.start\"\n\
             [body.link]\nmass = \"{mg}e-6 kg\"\ninertia = \"{mg}e-10 kg m^2\"\ncentre_of_mass = [\"0 mm\", \"0 mm\"]\n\
             points = {{ start = [\"0 mm\", \"0 mm\"], end = [\"75 mm\", \"0 mm\"] }}\n{after}"
        )
    };
    let [with_slot, light, heavier] = [free.clone(), linked(1.0), linked(2.0)].map(|text| {
        let mut last = Last::default();
        let energy = observed(&case(&text), 0.3, &mut last).energy.expect("it was integrated");
        assert!(energy.relative_residual() < ENERGY_RESIDUAL, "{energy:?}");
        last
    });
    let without_mass = |of: fn(&Last) -> Vec2<f64>| of(&light) * 2.0 - of(&heavier);
    let motion_m = (with_slot.end_m - without_mass(|last| last.end_m)).length();
    let force_n = (with_slot.on_end_n - without_mass(|last| last.on_end_n)).length();
    println!("{motion_m:e} m, {force_n:e} of {:?} N", with_slot.on_end_n);
    assert!((with_slot.end_m - light.end_m).length() > 10.0 * MOTION_M, "the link is felt");
    assert!(motion_m < MOTION_M && force_n < FORCE_N, "{motion_m:e} {force_n:e}");
    assert!(with_slot.on_end_n.length() > 0.1);
}

#[test]
fn analytic_worst_case_of_a_yoke_is_that_of_the_radius_with_the_clearance() {
    /// Round-off of positions of 0.1 m, m.
    const ROUND_OFF_M: f64 = 1e-15;
    let case = case(&file("yoke_with_a_circular_slot.toml"));
    let speed_rad_s = 400.0 * std::f64::consts::TAU / 60.0;
    let mut motion =
        IdealMotion::new(&case.mechanism, &case.sample.ideal, &case.sample.drives).expect("the start closes");
    let reaches = PlayReach::of_sample(&case.mechanism, &case.sample, [0.0]).expect("there is an answer");
    assert_eq!(reaches, [PlayReach::Slot { clearance_m: CLEARANCE_M }]);
    let mut loops = DisplacedLoops::new(&case.mechanism, &case.values);
    let mut side = None;
    for time_s in [0.0, 0.021, 0.058, 0.097, 0.13] {
        motion.move_to(time_s).expect("it closes");
        let crank_rad = 30f64.to_radians() + speed_rad_s * time_s;
        // The centre is 3 mm below the rail's point of the yoke, and 140 mm before its tool.
        let height_m = 0.040 * crank_rad.sin() - 0.002;
        let across_m = |radius_m: f64| (radius_m * radius_m - height_m * height_m).sqrt();
        let [ideal_m, most_m, least_m] = [0.0, CLEARANCE_M, -CLEARANCE_M].map(|c| across_m(0.090 + c));
        loops.set_position(motion.coordinates());
        let reading = position_outputs(&case.mechanism)[0].reading;
        let found_m = loops.value(reading) - 0.040 * crank_rad.cos() - 0.140;
        let side = *side.get_or_insert(found_m.signum());
        assert!((found_m - side * ideal_m).abs() < ROUND_OFF_M, "{found_m} {ideal_m}");
        let exact = worst_case_extremes(&mut loops, reading, &reaches, &starts_on_borders(&reaches));
        let mut expected_m = [side * (least_m - ideal_m), side * (most_m - ideal_m)];
        expected_m.sort_by(f64::total_cmp);
        assert!((exact.lowest.deviation_si - expected_m[0]).abs() < ROUND_OFF_M, "{exact:?} {expected_m:?}");
        assert!((exact.highest.deviation_si - expected_m[1]).abs() < ROUND_OFF_M, "{exact:?} {expected_m:?}");
    }
}

#[test]
fn identity_runs_with_play_keep_their_energy_and_stay_within_the_worst_case() {
    for name in ["yoke_with_a_circular_slot.toml", "linkage_with_a_circular_slot.toml"] {
        let case = case(&file(name));
        let cycle = loosepin_mechanics::model::Cycle {
            recorded_turns: 1.0,
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
        println!("{name}: residual {:.1e}, {:?}", record.energy.relative_residual, record.joints);
        assert!(record.energy.relative_residual < ENERGY_RESIDUAL, "{:e}", record.energy.relative_residual);
        assert!(record.orbits.is_empty(), "a pin in a slot has no orbit");
        assert!(record.joints[0].peak_force_n > 0.0 && !record.impacts.is_empty());
        let shares = quasi_static_check(&case.mechanism, &case.values, record).expect("it is ideal");
        assert!(shares.iter().all(|share| !share.is_exceeded && share.largest_share > 0.8), "{shares:?}");
    }
}
