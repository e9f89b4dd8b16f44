//! A slider with play in its guide (`docs/notation.md`): its corners, their forces, and the case of Flores, Leine and Glocker.

use crate::case::{Case, case};
use crate::elements::file;
use crate::power_balance::{assert_powers_balance, with_rates};
use loosepin_math::{Dual, Numbers};
use loosepin_mechanics::dynamics::{Dynamics, PlayState};
use loosepin_mechanics::mechanism::Sample;
use loosepin_simulate::{Observer, Onset, RunFailure, RunReport, Separation, Settings, Step, Window, run};
use std::collections::BTreeSet;
use std::path::Path;

fn read(file: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/slider_crank_guide").join(file);
    std::fs::read_to_string(path).expect("the case is there")
}

/// Value and tolerance of an expected number, SI.
fn expected(name: &str) -> [f64; 2] {
    let table: toml::Table = read("expected.toml").parse().expect("the file is right");
    ["value", "tolerance"].map(|key| {
        let text = table["expected"][name][key].as_str().expect("a number with its unit");
        let (number, unit) = text.split_once(' ').expect("a number with its unit");
        number.parse::<f64>().expect("a number") * if unit == "ms" { 1e-3 } else { 1.0 }
    })
}

fn assert_expected(name: &str, found: f64) {
    let [value, tolerance] = expected(name);
    assert!((found - value).abs() <= tolerance, "{name}: {found} instead of {value} within {tolerance}");
}

/// The crank and rod of the case as a double pendulum whose end carries the slider as a point mass: θ1, θ2, ω1, ω2.
#[derive(Clone, Copy)]
struct DoublePendulum([f64; 4]);

impl DoublePendulum {
    const L1_M: f64 = 0.153;
    const L2_M: f64 = 0.306;

    /// Lagrange's equations.
    fn rates(&self) -> [f64; 4] {
        const M1: f64 = 0.038;
        const M2: f64 = 0.038;
        const M3: f64 = 0.076;
        let [t1, t2, w1, w2] = self.0;
        let (l1, l2, g) = (Self::L1_M, Self::L2_M, 9.81);
        let m11 = 7.4e-5 + M1 * (l1 / 2.0).powi(2) + (M2 + M3) * l1 * l1;
        let m22 = 5.9e-4 + M2 * (l2 / 2.0).powi(2) + M3 * l2 * l2;
        let coupling = (M2 / 2.0 + M3) * l1 * l2;
        let m12 = coupling * (t1 - t2).cos();
        let h1 = -coupling * (t1 - t2).sin() * w2 * w2 - (M1 / 2.0 + M2 + M3) * g * l1 * t1.cos();
        let h2 = coupling * (t1 - t2).sin() * w1 * w1 - (M2 / 2.0 + M3) * g * l2 * t2.cos();
        let determinant = m11 * m22 - m12 * m12;
        [w1, w2, (m22 * h1 - m12 * h2) / determinant, (m11 * h2 - m12 * h1) / determinant]
    }

    /// Runge and Kutta's step of order four.
    fn after(&self, step_s: f64) -> Self {
        let moved = |slope: [f64; 4], share: f64| Self(std::array::from_fn(|k| self.0[k] + share * step_s * slope[k]));
        let k1 = self.rates();
        let k2 = moved(k1, 0.5).rates();
        let k3 = moved(k2, 0.5).rates();
        let k4 = moved(k3, 1.0).rates();
        moved(std::array::from_fn(|k| (k1[k] + 2.0 * k2[k] + 2.0 * k3[k] + k4[k]) / 6.0), 1.0)
    }

    /// After `time_s` from the start of the case, in steps that leave no error above round-off.
    fn at(time_s: f64) -> Self {
        const STEPS: usize = 2000;
        (0..STEPS).fold(Self([0.0, 0.0, 150.0, -75.0]), |state, _| state.after(time_s / STEPS as f64))
    }

    /// Ordinate of the slider, m, and its rate, m/s.
    fn slider(&self) -> [f64; 2] {
        let [t1, t2, w1, w2] = self.0;
        let (l1, l2) = (Self::L1_M, Self::L2_M);
        [l1 * t1.sin() + l2 * t2.sin(), l1 * w1 * t1.cos() + l2 * w2 * t2.cos()]
    }
}

#[derive(Default)]
struct Seen {
    /// θ1, θ2, ω1, ω2 at 1 ms.
    at_1_ms: Option<[f64; 4]>,
    /// Contact, time, speed.
    onsets: Vec<(usize, f64, f64)>,
    /// Sets of closed contacts.
    states: BTreeSet<Vec<usize>>,
    closed: BTreeSet<usize>,
}

impl Observer for Seen {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        if step.start_s <= 1e-3 && 1e-3 <= step.end_s {
            let dynamics = step.set_state(1e-3);
            let bodies = &dynamics.mechanism().real.slot_of_body;
            if bodies.len() < 3 {
                return;
            }
            let slots = [1, 2].map(|body| dynamics.mechanism().real.slot_of_body[body]);
            let (poses, twists) = (&dynamics.kinematics.poses, &dynamics.kinematics.twists);
            let [crank, rod] = slots;
            self.at_1_ms =
                Some([poses[crank].angle_rad(), poses[rod].angle_rad(), twists[crank].angular, twists[rod].angular]);
        }
    }
    fn contact_begins(&mut self, onset: &Onset) {
        self.onsets.push((onset.contact, onset.time_s, onset.speed_m_s));
        self.closed.insert(onset.contact);
        self.states.insert(self.closed.iter().copied().collect());
    }
    fn contact_ends(&mut self, separation: &Separation) {
        self.closed.remove(&separation.contact);
        self.states.insert(self.closed.iter().copied().collect());
    }
}

#[test]
fn analytic_free_phase_and_first_impact_of_both_upper_corners() {
    /// Both corners begin where both gaps are within the tolerance of events, 1e-13 m, at 0.84 m/s.
    const TOGETHER_S: f64 = 1e-12;
    let pendulum = DoublePendulum::at(1e-3);
    for (name, value) in ["crank_angle", "rod_angle", "crank_speed", "rod_speed"].into_iter().zip(pendulum.0) {
        assert_expected(name, value);
    }
    let [ordinate_m, rate_m_s] = DoublePendulum::at(expected("impact_time")[0]).slider();
    assert!((ordinate_m - 1e-3).abs() < 2e-12, "{ordinate_m}");
    assert_expected("impact_speed", rate_m_s);

    let Case { mechanism, sample, .. } = case(&read("model.toml"));
    let mut seen = Seen::default();
    let window = Window { start_s: 0.0, end_s: 2.8e-3 };
    run(&mechanism, &sample, &window, &Settings::for_simulation(), &mut seen).expect("the run is sound");
    for (name, value) in ["crank_angle", "rod_angle", "crank_speed", "rod_speed"]
        .into_iter()
        .zip(seen.at_1_ms.expect("the run goes beyond 1 ms"))
    {
        assert_expected(name, value);
    }
    let [(first, first_s, speed_m_s), (second, second_s, _), ..] = seen.onsets[..] else { panic!("{:?}", seen.onsets) };
    let mut names = [first, second].map(|contact| mechanism.contact_name(contact));
    names.sort();
    assert_eq!(names, ["guide (upper front)", "guide (upper rear)"]);
    assert_expected("impact_time", first_s);
    assert_expected("impact_speed", speed_m_s);
    assert!((second_s - first_s).abs() < TOGETHER_S, "{first_s} {second_s}");
}

/// A run of `end_s` with the tolerance of a simulation.
fn observed(case: &Case, end_s: f64) -> (RunReport, Seen) {
    let mut seen = Seen::default();
    let window = Window { start_s: 0.0, end_s };
    let report = run(&case.mechanism, &case.sample, &window, &Settings::for_simulation(), &mut seen);
    (report.expect("the run is sound"), seen)
}

#[test]
fn identity_energy_is_accounted_for_over_many_impacts() {
    /// Largest residual over largest exchange, of tolerances of 1e-9 m and of 5e-12 m in a step.
    const ENERGY_RESIDUAL: f64 = 1e-7;
    let text = read("model.toml");
    let rough = text.replace("restitution = 0.4\n", "restitution = 0.4\nfriction = { coefficient = 0.1 }\n");
    for text in [text, rough] {
        let (report, seen) = observed(&case(&text), 0.2);
        let energy = report.energy.expect("it was integrated");
        println!("{} contacts, residual {:.1e}", report.plays[0].contacts, energy.relative_residual());
        assert!(energy.relative_residual() < ENERGY_RESIDUAL, "{energy:?}");
        // Most of what the crank has at the start is lost in impacts.
        assert!(
            energy.contact_loss_j > 0.1 && (text.contains("friction") == (energy.friction_loss_j > 0.0)),
            "{energy:?}"
        );
        assert!(report.plays[0].contacts > 50, "{:?}", report.plays);
        // Free, one corner, two corners at one face.
        for state in [vec![], vec![0], vec![0, 1], vec![2, 3]] {
            assert!(seen.states.contains(&state), "{state:?} is not among {:?}", seen.states);
        }
    }
}

#[test]
fn identity_a_slider_that_is_pushed_off_its_middle_reaches_all_states() {
    /// As above.
    const ENERGY_RESIDUAL: f64 = 1e-7;
    let (report, seen) = observed(&case(&file("slider_with_play_in_its_guide.toml")), 0.07);
    let energy = report.energy.expect("it was integrated");
    println!("{} contacts, residual {:.1e}", report.plays[0].contacts, energy.relative_residual());
    assert!(energy.relative_residual() < ENERGY_RESIDUAL, "{energy:?}");
    assert!(energy.friction_loss_j > 0.0 && energy.contact_loss_j > 0.0, "{energy:?}");
    // Free, one corner, a face, two opposite corners.
    for states in [
        vec![vec![]],
        vec![vec![0], vec![1], vec![2], vec![3]],
        vec![vec![0, 1], vec![2, 3]],
        vec![vec![0, 3], vec![1, 2]],
    ] {
        assert!(states.iter().any(|state| seen.states.contains(state)), "none of {states:?}: {:?}", seen.states);
    }
}

/// Coordinates of crank, rod and slider for a tilted slider whose upper front corner is `penetration_m` deep.
fn upper_front_at(penetration_m: f64) -> [f64; 3] {
    const TILT_RAD: f64 = 0.0137;
    const ROD_RAD: f64 = -0.083;
    let (a, b, c) = (0.05, 0.025, 0.001);
    let ordinate_m = penetration_m + b + c - a * TILT_RAD.sin() - b * TILT_RAD.cos();
    let crank_rad = ((ordinate_m - DoublePendulum::L2_M * ROD_RAD.sin()) / DoublePendulum::L1_M).asin();
    [crank_rad, ROD_RAD, TILT_RAD]
}

#[test]
fn analytic_corner_just_below_at_and_just_above_contact() {
    /// Round-off of the ordinate, m.
    const ROUND_OFF_M: f64 = 1e-16;
    /// K of the case: steel on steel, corners of 5 mm, N/m^1.5, to its seven digits.
    const STIFFNESS: f64 = 1.072316e10;
    const DIGITS: f64 = 1e-6;
    let Case { mechanism, sample, .. } = case(&read("model.toml"));
    let mut dynamics = Dynamics::new(&mechanism, &sample);
    let mut states = vec![PlayState::flight(); mechanism.contacts.len()];
    let corner = 1;
    assert_eq!(mechanism.contact_name(corner), "guide (upper front)");
    states[corner] = PlayState { contact: 1.0, inverse_impact_speed_s_m: 2.3, effective_mass_kg: f64::NAN };
    for penetration_m in [-1e-8, 0.0, 1e-8, 1e-5] {
        dynamics.evaluate(0.0, &upper_front_at(penetration_m), &[0.0; 3], &states);
        let found_m = dynamics.gap(corner).gap[0];
        assert!((found_m - penetration_m).abs() < ROUND_OFF_M, "{found_m:e} {penetration_m:e}");
        let force = dynamics.contacts()[corner];
        let expected_n = STIFFNESS * penetration_m.max(0.0).powf(1.5);
        // dF/F = 3/2 dδ/δ.
        let tolerance_n =
            DIGITS * expected_n + STIFFNESS * 1.5 * ROUND_OFF_M * (penetration_m.abs() + ROUND_OFF_M).sqrt();
        assert!((force.normal_n - expected_n).abs() <= tolerance_n, "{} {expected_n}", force.normal_n);
        // The upper face pushes down, at the front.
        assert!((force.on_journal_n.y + force.normal_n).abs() <= 1e-12 * force.normal_n);
        assert!(force.moment_on_journal_n_m <= 0.0);
        let others: f64 = dynamics.contacts().iter().map(|contact| contact.normal_n).sum();
        assert_eq!(others, force.normal_n, "only one corner touches");
    }
}

#[test]
fn analytic_slider_jams_on_two_opposite_corners() {
    let Case { mechanism, sample, .. } = case(&read("model.toml"));
    let mut dynamics = Dynamics::new(&mechanism, &sample);
    let guide = mechanism.contacts_of(0);
    let state = PlayState { contact: 1.0, inverse_impact_speed_s_m: 2.3, effective_mass_kg: f64::NAN };
    // Centred in the guide and tilted by more than the play allows: a sin θ > c + b (1 - cos θ).
    dynamics.evaluate(0.0, &[0.0, 0.0, 0.0211], &[0.0; 3], &vec![state; mechanism.contacts.len()]);
    let normals_n: Vec<f64> = guide.clone().map(|contact| dynamics.contacts()[contact].normal_n).collect();
    assert!(normals_n[1] > 0.0 && normals_n[2] > 0.0, "{normals_n:?}");
    assert_eq!([normals_n[0], normals_n[3]], [0.0, 0.0]);
    let [front, rear] = [1, 2].map(|corner| dynamics.contacts()[guide.start + corner]);
    // They push against each other and turn the slider back together.
    let largest_n = front.normal_n;
    assert!((front.on_journal_n + rear.on_journal_n).length() < 1e-9 * largest_n);
    let moment_n_m = front.moment_on_journal_n_m + rear.moment_on_journal_n_m;
    let arm_m = 0.05 * 0.0211_f64.cos() - 0.025 * 0.0211_f64.sin();
    assert!((moment_n_m / (-2.0 * arm_m * largest_n) - 1.0).abs() < 1e-9, "{moment_n_m} {largest_n}");
}

#[test]
fn identity_derivatives_of_gaps_and_powers_of_corners_and_of_edges() {
    let text = file("slider_on_a_turning_guide.toml");
    derivatives_and_powers(&text);
    // The corners are at 34 and at 76 mm: both ends of the block overhang, one of them, none.
    for ends in [["40 mm", "71 mm"], ["41 mm", "300 mm"], ["-200 mm", "72 mm"], ["-200 mm", "300 mm"]] {
        let ends = format!("angle = \"17 deg\", start = \"{}\", end = \"{}\"", ends[0], ends[1]);
        derivatives_and_powers(&text.replace("angle = \"17 deg\"", &ends));
    }
}

fn derivatives_and_powers(text: &str) {
    /// Round-off over the largest term.
    const ROUND_OFF: f64 = 1e-11;
    let Case { mechanism, sample, .. } = case(text);
    let n = mechanism.real.free;
    assert_eq!(n, 3, "place and angle of the block");
    let (start, start_rates) = mechanism.start(&sample).expect("it closes");
    let mut in_contact = 0;
    for trial in 0..8 {
        let time_s = 1e-4 * f64::from(trial);
        let spread = |k: usize| ((k + 3 * trial as usize) as f64 * 1.7).sin();
        let q: Vec<f64> = (0..n).map(|k| start[k] + [6e-4, 6e-4, 0.021][k] * spread(k)).collect();
        let rates: Vec<f64> = (0..n).map(|k| start_rates[k] + [3.0, 3.0, 90.0][k] * spread(k + 5)).collect();
        let mut plain = Dynamics::new(&mechanism, &sample);
        plain.set_state(time_s, &q, &rates);
        let states: Vec<PlayState<f64>> = mechanism
            .contacts
            .iter()
            .map(|at| {
                let penetration_m = plain.plays()[at.play].penetration_at_m(&sample.plays[at.play], at.place);
                let contact = f64::from(penetration_m > 0.0);
                PlayState { contact, inverse_impact_speed_s_m: 2.3, effective_mass_kg: 0.41 }
            })
            .collect();
        in_contact += states.iter().filter(|state| state.contact > 0.0).count();
        plain.evaluate(time_s, &q, &rates, &states);
        let powers = plain.powers();

        let [moving, turning] = with_rates([&q[..n], &rates[..n], plain.accelerations()]);
        let dual_sample = Sample::broadcast(&sample);
        let mut dual = Dynamics::new(&mechanism, &dual_sample);
        dual.set_state(Dual::variable(time_s), &moving, &turning);
        for (contact, at) in mechanism.contacts.iter().enumerate() {
            let [value, rate, second] = plain.gap(contact).gap;
            let motion = dual.plays()[at.play].contact(&dual_sample.plays[at.play], at.place);
            assert!((motion.penetration_m.value - value).abs() < 1e-15);
            let scale_m_s = rates.iter().fold(150.0_f64, |scale, rate| scale.max(rate.abs()));
            assert!((motion.penetration_m.derivative - rate).abs() < ROUND_OFF * scale_m_s, "{rate}");
            assert!((motion.penetration_rate_m_s.value - rate).abs() < ROUND_OFF * scale_m_s, "{rate}");
            let change_m_s2 = motion.penetration_rate_m_s.derivative;
            let largest = plain.accelerations().iter().fold(scale_m_s * scale_m_s, |l, a| l.max(a.abs()));
            assert!((change_m_s2 - second).abs() < ROUND_OFF * largest, "{contact}: {change_m_s2} {second}");
        }
        let energy = dual.energy(|contact| states[contact].contact > 0.0);
        assert_powers_balance(&energy, &powers, ROUND_OFF, &format!("trial {trial}"));
        assert!(powers.friction_loss_w >= 0.0 && powers.contact_loss_w.is_finite());
    }
    assert!(in_contact > 8, "only {in_contact} contacts were looked at");
}

/// Ambrósio's friction at a sliding speed, over μ: none up to 0.1 mm/s, all of it from 1 mm/s on.
fn ambrosio(speed_m_s: f64) -> f64 {
    ((speed_m_s.abs() - 1e-4) / 9e-4).clamp(0.0, 1.0).copysign(speed_m_s)
}

#[test]
fn analytic_friction_of_each_corner_at_stick_and_slip() {
    /// Round-off over the force.
    const ROUND_OFF: f64 = 1e-9;
    let Case { mechanism, sample, .. } = case(&file("slider_on_a_turning_guide.toml"));
    let mut dynamics = Dynamics::new(&mechanism, &sample);
    let (start, _) = mechanism.start(&sample).expect("it closes");
    let state = PlayState { contact: 1.0, inverse_impact_speed_s_m: 2.3, effective_mass_kg: f64::NAN };
    let states = vec![state; mechanism.contacts.len()];
    // The guide turns with the arm: the block turns along and its middle moves by v along the line.
    let (arm_rad, spin_rad_s): (f64, f64) = (11f64.to_radians(), 140.0 * std::f64::consts::TAU / 60.0);
    let line_rad = arm_rad + 17f64.to_radians();
    let normal = [-line_rad.sin(), line_rad.cos()];
    for (upper, speed_m_s) in
        [(true, 0.0), (true, 7e-5), (true, 5e-4), (true, -5e-4), (true, 0.2), (false, -0.2), (false, 6e-4)]
    {
        let sign = if upper { 1.0 } else { -1.0 };
        let depth_m = 0.3e-3 + 2e-6;
        let q = [start[0] + sign * depth_m * normal[0], start[1] + sign * depth_m * normal[1], start[2]];
        dynamics.set_state(0.0, &q, &[0.0; 3]);
        // Rates of the block's frame that carry it with the arm, and along the line.
        let rates = [
            -spin_rad_s * q[1] + speed_m_s * line_rad.cos(),
            spin_rad_s * q[0] + speed_m_s * line_rad.sin(),
            spin_rad_s,
        ];
        dynamics.evaluate(0.0, &q, &rates, &states);
        for corner in 0..4 {
            let force = dynamics.contacts()[corner];
            assert_eq!(force.normal_n > 0.0, (corner < 2) == upper, "corner {corner}");
            if force.normal_n > 0.0 {
                // v_T along n turned by 90°, which points backwards at the upper face and forwards at the lower one.
                let expected_m_s = -sign * speed_m_s;
                assert!((force.sliding_m_s - expected_m_s).abs() < 1e-15, "{} {expected_m_s}", force.sliding_m_s);
                let along_n = force.on_journal_n.x * line_rad.cos() + force.on_journal_n.y * line_rad.sin();
                let friction_n = -0.13 * ambrosio(speed_m_s) * force.normal_n;
                assert!((along_n - friction_n).abs() <= ROUND_OFF * force.normal_n, "{along_n} {friction_n}");
                assert!((force.friction_loss_w + friction_n * speed_m_s).abs() <= ROUND_OFF * force.normal_n);
            }
        }
    }
}

/// Speed of a block that lies on the lower face of a guide at `slope_deg`, with μ = 0.2, at 0.25 s and 0.45 s.
fn speeds_on_a_slope_m_s(slope_deg: f64) -> [f64; 2] {
    #[derive(Default)]
    struct Speeds([f64; 2]);
    impl Observer for Speeds {
        fn step(&mut self, step: &mut Step<'_, '_>) {
            for (k, time_s) in [0.25, 0.45].into_iter().enumerate() {
                if step.start_s <= time_s && time_s <= step.end_s {
                    self.0[k] = step.set_state(time_s).kinematics.twists[1].linear.length();
                }
            }
        }
    }
    let text = file("block_on_a_slope.toml").replace("-10 deg", &format!("{slope_deg} deg"));
    let Case { mechanism, sample, .. } = case(&text);
    let mut speeds = Speeds::default();
    let window = Window { start_s: 0.0, end_s: 0.5 };
    run(&mechanism, &sample, &window, &Settings::for_simulation(), &mut speeds).expect("the run is sound");
    speeds.0
}

#[test]
fn analytic_block_on_a_slope_sticks_below_the_friction_angle_and_slides_above() {
    /// Between them friction of this law grows to its full value, m/s.
    const GROWING_M_S: std::ops::Range<f64> = 1e-4..1e-3;
    /// Of bounces that have not wholly died, m/s.
    const TOLERANCE_M_S: f64 = 1e-4;
    let friction_deg = 0.2_f64.atan().to_degrees();
    for speed_m_s in speeds_on_a_slope_m_s(-(friction_deg - 0.5)) {
        assert!(GROWING_M_S.contains(&speed_m_s), "it creeps: {speed_m_s}");
    }
    let slope_rad = (friction_deg + 0.5).to_radians();
    let [early, late] = speeds_on_a_slope_m_s(-(friction_deg + 0.5));
    let gained_m_s = 9.81 * (slope_rad.sin() - 0.2 * slope_rad.cos()) * 0.2;
    assert!((late - early - gained_m_s).abs() < TOLERANCE_M_S, "{early} {late} {gained_m_s}");
}

#[test]
fn text_of_a_slider_that_leaves_its_guide_and_identity_of_one_that_does_not() {
    let with_ends = |ends: &str| {
        let text = file("slider_with_play_in_its_guide.toml");
        case(&text.replace("angle = \"12 deg\" }", &format!("angle = \"12 deg\", {ends} }}")))
    };
    let (free, seen_free) = observed(&case(&file("slider_with_play_in_its_guide.toml")), 0.02);
    let (held, seen_held) = observed(&with_ends("start = \"-300 mm\", end = \"300 mm\""), 0.02);
    assert_eq!((free, seen_free.onsets), (held, seen_held.onsets), "the same bits");

    // The rear overhangs the start from the beginning; then the front passes it too.
    let Case { mechanism, sample, .. } = with_ends("start = \"60 mm\", end = \"300 mm\"");
    let window = Window { start_s: 0.0, end_s: 0.07 };
    let failure = run(&mechanism, &sample, &window, &Settings::for_simulation(), &mut Seen::default());
    let Err(RunFailure::BeyondGuide { contact, joint, along_m, ends_m, time_s }) = failure else {
        panic!("{failure:?}")
    };
    assert_eq!((joint.as_str(), ends_m), ("guide", [0.06, 0.3]));
    assert!(contact.ends_with(" front)") && along_m < 0.06 && along_m > 0.059, "{contact} {along_m}");
    let failure = RunFailure::BeyondGuide { contact, joint, along_m: 0.0595, ends_m, time_s: 0.5 * (time_s / time_s) };
    let expected = "at 500 ms the slider has left its guide: its corner guide (upper front) is at 59.5 mm, and the faces reach from 60 mm to 300 mm";
    assert_eq!(failure.to_string().replace("lower", "upper"), expected);
}

#[test]
fn identity_corners_that_touch_almost_together_do_not_stall() {
    /// Largest residual over largest exchange: a tolerance of 1e-9 m is a larger share of a fall of 20 µm.
    const ENERGY_RESIDUAL: f64 = 1e-6;
    /// A fall with two or four contacts takes some hundred evaluations; a stall takes thousands.
    const MAX_EVALUATIONS: u64 = 4000;
    let smooth = file("block_on_a_slope.toml").replace("friction = { coefficient = 0.2 }\n", "");
    // A torque tilts the block a little on its way down: the corners meet the face from 1e-15 m to 1e-6 m apart.
    for torque_n_m in [0.0, 1e-12, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3] {
        let load =
            format!("[load.twist]\nkind = \"torque\"\nbody = \"block\"\ntorque = \"{torque_n_m} N m\"\n\n[initial.");
        let case = case(&smooth.replacen("[initial.", &load, 1));
        let (report, seen) = observed(&case, 0.004);
        assert!(report.counters.evaluations < MAX_EVALUATIONS, "{torque_n_m}: {:?}", report.counters);
        assert!(seen.states.contains(&vec![2]) || seen.states.contains(&vec![3]), "{:?}", seen.states);
        let energy = report.energy.expect("it was integrated");
        assert!(energy.relative_residual() < ENERGY_RESIDUAL, "{torque_n_m}: {energy:?}");
    }
}
