//! Dynamic runs against the loops of the ideal mechanism.

use super::{Built, build_case, build_case_with, case_names};
use loosepin_math::Vec2;
use loosepin_mechanics::mechanism::IdealMotion;
use loosepin_simulate::accuracy::{DisplacedLoops, check_quasi_static, position_outputs, quasi_static_check};
use loosepin_simulate::{Observer, Plan, Settings, Simulation, Step, Window, run, simulate};

fn simulate_turns(built: &Built, turns: f64, samples_per_turn: usize) -> Simulation {
    let mut cycle = built.mechanism.model.cycle.clone();
    (cycle.transient_turns, cycle.recorded_turns, cycle.samples_per_turn) = (0.0, turns, samples_per_turn);
    let plan = Plan {
        cycle,
        settings: Settings::for_study(),
        with_states: false,
        lyapunov_turns: None,
        second_run: false,
        overrides: Vec::new(),
    };
    simulate(&built.mechanism, &built.values, &plan).unwrap_or_else(|error| panic!("{error}"))
}

/// Compares the outputs of a run with those of the ideal mechanism whose journals are displaced like the run's.
struct Twin<'a> {
    built: &'a Built,
    ideal: IdealMotion<'a>,
    loops: DisplacedLoops<'a>,
    largest: f64,
    looks: usize,
}

impl Observer for Twin<'_> {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        let (start_s, end_s) = (step.start_s, step.end_s);
        for time_s in [0.5 * (start_s + end_s), end_s] {
            let dynamics = step.set_state(time_s);
            let eccentricities_m: Vec<Vec2<f64>> =
                dynamics.plays().iter().map(|motion| motion.eccentricity_m).collect();
            self.ideal.move_to(time_s).expect("the ideal mechanism turns");
            self.loops.set_position(self.ideal.coordinates());
            self.loops.displace(&eccentricities_m).expect("a run closes its loops with its own eccentricities");
            let mechanism = &self.built.mechanism;
            let (model, values) = (&mechanism.model, &self.built.values);
            for output in position_outputs(mechanism) {
                let arm = |point| loosepin_mechanics::mechanism::point_m(model, values, point);
                let real = output.reading.value(&mechanism.real, &dynamics.kinematics, arm);
                self.largest = self.largest.max((real - self.loops.value(output.reading)).abs());
                self.looks += 1;
            }
        }
    }
}

#[test]
fn identity_a_run_is_the_ideal_mechanism_with_the_eccentricities_of_the_run() {
    /// Round-off of positions of order 0.1 m, m or rad.
    const ROUND_OFF: f64 = 1e-12;
    for case in
        ["slider_crank_5000", "four_bar_600", "slider_crank_two_clearances", "six_bar", "four_bar_floating_coupler"]
    {
        let built = build_case(case);
        let sample = built.sample();
        let turn_s = built.input().turn_s();
        let window = Window { start_s: 0.0, end_s: turn_s };
        let mut twin = Twin {
            built: &built,
            ideal: IdealMotion::new(&built.mechanism, &sample.ideal, &sample.drives).expect("the start closes"),
            loops: DisplacedLoops::new(&built.mechanism, &built.values),
            largest: 0.0,
            looks: 0,
        };
        run(&built.mechanism, &sample, &window, &Settings::for_study(), &mut twin).expect("the run is sound");
        assert!(twin.looks > 200, "{case}: {} looks", twin.looks);
        assert!(twin.largest < ROUND_OFF, "{case}: {:e}", twin.largest);
    }
}

#[test]
fn identity_runs_respect_the_quasi_static_worst_case() {
    for case in
        ["slider_crank_5000", "four_bar_600", "slider_crank_two_clearances", "four_bar_three_clearances", "six_bar"]
    {
        let built = build_case(case);
        let mut simulation = simulate_turns(&built, 1.0, 200);
        let record = &mut simulation.record;
        check_quasi_static(&built.mechanism, &built.values, record).expect("the check can be made");
        let columns = position_outputs(&built.mechanism).len();
        assert_eq!(record.quasi_static_check.len(), columns, "{case}");
        for share in &record.quasi_static_check {
            println!("{case} {}: {:.4} of the worst case", share.output, share.largest_share);
            assert!(!share.is_exceeded && share.largest_share <= 1.0 + 1e-6, "{case} {share:?}");
            // Journals reach their rims, and impacts press them on.
            assert!(share.largest_share > 0.5, "{case} {share:?}");
            assert_eq!(share.samples_without_worst_case, 0, "{case}");
        }
    }
}

#[test]
fn identity_a_run_beyond_the_worst_case_is_caught() {
    let built = build_case("slider_crank_5000");
    let mut simulation = simulate_turns(&built, 0.25, 100);
    let record = &mut simulation.record;
    let share = &quasi_static_check(&built.mechanism, &built.values, record).expect("the check can be made")[0];
    let row = record.time_s.iter().position(|time_s| Some(*time_s) == share.time_s).expect("a sample");
    // One part in ten thousand beyond the worst case: 50 nm.
    record.outputs[0].deviation_si[row] = 1.0001 * share.worst_case_si;
    let share = &quasi_static_check(&built.mechanism, &built.values, record).expect("the check can be made")[0];
    assert!(share.is_exceeded && share.largest_share > 1.00005, "{share:?}");
}

#[test]
fn identity_no_clearance_is_the_ideal_motion() {
    /// Round-off of a position of order 0.1 m, and of velocities and accelerations relative to it.
    const ROUND_OFF: f64 = 1e-13;
    for (case, path) in [
        ("slider_crank_5000", "joint.gudgeon.radial_clearance"),
        ("four_bar_600", "joint.coupler_pin.radial_clearance"),
        ("six_bar", "joint.coupler_pin.radial_clearance"),
    ] {
        let with_play = build_case(case);
        let built = build_case_with(case, &[(path, 0.0)]);
        assert!(built.mechanism.is_ideal());
        let simulation = simulate_turns(&built, 1.0, 60);
        let record = super::motion::motion_of(&with_play, 60);
        // The ideal motion has no errors of paths.
        for output in record.outputs.iter().filter(|output| !output.value_si.is_empty()) {
            let history = simulation.record.outputs.iter().find(|h| h.name == output.name).expect("the same outputs");
            assert!(history.deviation_si.iter().all(|deviation| deviation.abs() < ROUND_OFF), "{case} {}", output.name);
            for (value, ideal) in history.value_si.iter().zip(&output.value_si) {
                assert!((value - ideal).abs() < ROUND_OFF, "{case} {}: {value} {ideal}", output.name);
            }
        }
        for (name, of, kind) in
            [("slider_velocity", "slider", 1), ("slider_acceleration", "slider", 2), ("arm_speed", "arm", 1)]
        {
            let Some(history) = simulation.record.outputs.iter().find(|h| h.name == name) else { continue };
            let output = super::motion::output(&record, of);
            let expected = if kind == 1 { &output.velocity_si } else { &output.acceleration_si };
            let largest = expected.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
            for (value, ideal) in history.value_si.iter().zip(expected) {
                assert!((value - ideal).abs() < 10.0 * ROUND_OFF * largest, "{case} {name}: {value} {ideal}");
            }
        }
        let share = quasi_static_check(&built.mechanism, &built.values, &simulation.record);
        assert_eq!(share, Ok(Vec::new()), "without play there is nothing to check");
    }
}

/// Largest residual of the loops of ideal joints at the ends of all accepted steps and between them.
#[derive(Default)]
struct Drift {
    at_ends_m: f64,
    between_m: f64,
    steps: usize,
}

impl Observer for Drift {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        let (start_s, end_s) = (step.start_s, step.end_s);
        let look = |step: &mut Step<'_, '_>, time_s: f64| {
            let dynamics = step.set_state(time_s);
            let mut residuals = vec![0.0; dynamics.mechanism().real.constraint_rows()];
            dynamics.constraint_residuals(&mut residuals);
            residuals.iter().fold(0.0_f64, |worst, residual| worst.max(residual.abs()))
        };
        self.at_ends_m = self.at_ends_m.max(look(step, start_s)).max(look(step, end_s));
        for share in [0.3, 0.7] {
            self.between_m = self.between_m.max(look(step, start_s + share * (end_s - start_s)));
        }
        self.steps += 1;
    }
}

#[test]
fn identity_loops_of_ideal_joints_do_not_drift_over_ten_cycles() {
    /// Error allowed to the six-bar, m.
    const DRIFT_M: f64 = 1e-12;
    for (case, turns) in [("six_bar", 10.0), ("six_bar_stephenson", 1.0), ("eight_bar", 1.0)] {
        let built = build_case(case);
        assert!(built.mechanism.real.constraint_rows() > 0, "{case} has a loop of ideal joints");
        let sample = built.sample();
        let turn_s = built.input().turn_s();
        let window = Window { start_s: 0.0, end_s: turns * turn_s };
        let mut drift = Drift::default();
        run(&built.mechanism, &sample, &window, &Settings::for_study(), &mut drift).expect("the run is sound");
        println!("{case}: {:.1e} m at ends, {:.1e} m between, {} steps", drift.at_ends_m, drift.between_m, drift.steps);
        assert!(drift.at_ends_m < DRIFT_M && drift.between_m < DRIFT_M, "{case}");
        assert!(drift.steps > 1000, "{case}: {} steps", drift.steps);
    }
}

/// A plate on three cranks of 41 mm, the first one driven: of its two redundant loops each becomes singular where its pivots and
/// cranks lie on one line, at different places of the turn. A rod hangs from the plate by a pin with play and pushes a weight along a guide.
const PLATE_ON_THREE_CRANKS: &str = r#"
name = "plate on three cranks"
gravity = "9.81 m/s^2"
[body.ground]
points = { a = ["0 mm", "0 mm"], b = ["120 mm", "0 mm"], c = ["52 mm", "67 mm"] }
[body.first]
mass = "0.21 kg"
inertia = "0.7e-4 kg m^2"
centre_of_mass = ["19 mm", "0 mm"]
points = { pivot = ["0 mm", "0 mm"], pin = ["41 mm", "0 mm"] }
[body.second]
mass = "0.23 kg"
inertia = "0.8e-4 kg m^2"
centre_of_mass = ["22 mm", "1 mm"]
points = { pivot = ["0 mm", "0 mm"], pin = ["41 mm", "0 mm"] }
[body.third]
mass = "0.19 kg"
inertia = "0.6e-4 kg m^2"
centre_of_mass = ["17 mm", "-2 mm"]
points = { pivot = ["0 mm", "0 mm"], pin = ["41 mm", "0 mm"] }
[body.plate]
mass = "0.83 kg"
inertia = "1.9e-3 kg m^2"
centre_of_mass = ["57 mm", "23 mm"]
points = { a = ["0 mm", "0 mm"], b = ["120 mm", "0 mm"], c = ["52 mm", "67 mm"], hanger = ["85 mm", "-31 mm"] }
[body.rod]
mass = "0.14 kg"
inertia = "3.1e-4 kg m^2"
centre_of_mass = ["79 mm", "0 mm"]
points = { eye = ["0 mm", "0 mm"], tip = ["160 mm", "0 mm"] }
[contact.steel]
law = "lankarani-nikravesh"
restitution = 0.87
youngs_modulus = "207 GPa"
poisson_ratio = 0.3
[joint.main]
kind = "revolute"
bearing = "ground.a"
journal = "first.pivot"
[joint.pivot_b]
kind = "revolute"
bearing = "ground.b"
journal = "second.pivot"
[joint.pivot_c]
kind = "revolute"
bearing = "ground.c"
journal = "third.pivot"
[joint.pin_a]
kind = "revolute"
bearing = "plate.a"
journal = "first.pin"
[joint.pin_b]
kind = "revolute"
bearing = "plate.b"
journal = "second.pin"
[joint.pin_c]
kind = "revolute"
bearing = "plate.c"
journal = "third.pin"
[joint.eye]
kind = "revolute"
bearing = "plate.hanger"
journal = "rod.eye"
bearing_radius = "7 mm"
radial_clearance = "0.2 mm"
contact = "steel"
[joint.rest]
kind = "prismatic"
guide = { point = "ground.a", angle = "-70 deg" }
slider = { point = "weight.top", angle = "0 deg" }
[body.weight]
mass = "0.31 kg"
inertia = "0.5e-4 kg m^2"
points = { top = ["0 mm", "0 mm"] }
centre_of_mass = ["3 mm", "0 mm"]
[joint.link]
kind = "revolute"
bearing = "weight.top"
journal = "rod.tip"
[drive.crank]
joint = "main"
speed = "310 rpm"
start_angle = "33 deg"
[cycle]
drive = "crank"
[assembly]
guess = { second = "33 deg", third = "33 deg", plate = "0 deg", rod = "-113 deg" }
[output.plate]
angle_of = "plate"
"#;

#[test]
fn identity_redundant_loops_hold_through_every_place_where_one_of_them_is_singular() {
    /// Round-off of lengths of order 0.1 m.
    const ROUND_OFF: f64 = 1e-12;
    let built = super::build_text(PLATE_ON_THREE_CRANKS);
    assert_eq!(built.mechanism.redundant.iter().map(|(_, count)| count).sum::<usize>(), 1);
    let sample = built.sample();
    let turn_s = built.input().turn_s();
    let window = Window { start_s: 0.0, end_s: 2.0 * turn_s };
    let mut drift = Drift::default();
    run(&built.mechanism, &sample, &window, &Settings::for_study(), &mut drift).expect("the run is sound");
    assert!(drift.at_ends_m < ROUND_OFF && drift.between_m < ROUND_OFF, "{:e} {:e}", drift.at_ends_m, drift.between_m);
    let record = simulate_turns(&built, 2.0, 90).record;
    assert!(
        record.outputs[0].value_si.iter().all(|angle_rad| angle_rad.abs() < 1e-11),
        "{:?}",
        record.outputs[0].value_si
    );
    // The account of energy sees every force of a loop that does work: a wrong one near a singular place shows.
    assert!(record.energy.relative_residual < 1e-7, "{:e}", record.energy.relative_residual);
}

#[test]
fn identity_every_case_has_an_answer() {
    for case in case_names() {
        let built = build_case(&case);
        let record = super::motion::motion_of(&built, 36);
        assert!(record.singular_positions.is_empty(), "{case}: {:?}", record.singular_positions);
        assert_eq!(record.drive_angle_rad.len(), 37, "{case}: {:?}", record.singular_positions);
        for output in &record.outputs {
            let answer = &output.clearance;
            assert_eq!(answer.contributors.len(), built.mechanism.plays.len(), "{case}");
            for k in 0..=36 {
                let sum: f64 = answer.contributors.iter().map(|joint| joint.first_order_si[k]).sum();
                assert!((sum - answer.first_order_si[k]).abs() <= 1e-15, "{case} {}", output.name);
                assert!(answer.disc_standard_deviation_si[k] <= answer.rim_standard_deviation_si[k]);
                // The same but for round-off where teeth between two flanks are all the play there is.
                let round_off = 1.0 + 4.0 * f64::EPSILON;
                assert!(answer.rim_standard_deviation_si[k] <= answer.first_order_si[k] * round_off);
            }
        }
    }
}

/// A mechanism without play whose drives determine its motion, with a million turns.
fn million_turns() -> (Built, Plan) {
    let built = build_case_with("slider_crank_5000", &[("joint.gudgeon.radial_clearance", 0.0)]);
    assert!(built.mechanism.is_ideal());
    let mut plan = Plan::of_model(&built.mechanism.model);
    (plan.cycle.transient_turns, plan.cycle.recorded_turns, plan.cycle.samples_per_turn) = (1e6, 1.0, 60);
    (built, plan)
}

#[test]
fn analytic_a_run_whose_longest_steps_take_too_many_evaluations_is_refused_before_it_starts() {
    let (built, mut plan) = million_turns();
    (plan.cycle.transient_turns, plan.cycle.recorded_turns) = (0.0, 1e6);
    plan.cycle.samples_per_turn = 1;
    for built in [built, build_case("slider_crank_5000")] {
        let failure = simulate(&built.mechanism, &built.values, &plan).expect_err("it is refused");
        // 96 steps a turn of 12 evaluations each.
        assert_eq!(failure.to_string(), "1000000 turns take at least 1.15e9 evaluations; must be at most 3.00e8");
        assert_eq!(failure.code(), "too_many_turns");
    }
}

#[test]
fn a_run_without_play_ends_at_the_limit_of_evaluations() {
    let (built, _) = million_turns();
    let sample = loosepin_mechanics::mechanism::Sample::new(&built.mechanism, &built.values).expect("a sample");
    let settings = Settings { largest_evaluations: 500, ..Settings::for_simulation() };
    let window = Window { start_s: 0.0, end_s: 1.0 };
    struct Count(u64);
    impl Observer for Count {
        fn step(&mut self, _step: &mut Step<'_, '_>) {
            self.0 += 1;
        }
    }
    let mut count = Count(0);
    let failure = run(&built.mechanism, &sample, &window, &settings, &mut count).expect_err("it is stopped");
    assert_eq!(failure.code(), "too_many_evaluations");
    // A step counts 12 evaluations, as one that is integrated.
    assert_eq!(count.0, 42);
}

#[test]
fn more_numbers_than_a_history_holds_are_refused() {
    let (built, mut plan) = million_turns();
    (plan.cycle.transient_turns, plan.cycle.recorded_turns, plan.cycle.samples_per_turn) = (0.0, 1.0, 1_000_000);
    plan.with_states = true;
    // A million rows of two numbers for each output, and nine for each body.
    let mut many = built.mechanism.clone();
    let output = many.model.outputs[0].clone();
    many.model.outputs.extend((0..60).map(|_| output.clone()));
    let failure = simulate(&many, &built.values, &plan).expect_err("it is refused");
    assert_eq!(failure.code(), "too_many_numbers");
}
