//! Ideal values, velocities, accelerations and the effect of dimensions against closed forms and differences.

use super::{Built, build_case, build_case_with, build_text, case_names, ideal_at, spread};
use loosepin_math::Vec2;
use loosepin_mechanics::mechanism::{IdealMotion, Sample, point_m};
use loosepin_mechanics::model::{Model, Position, QuantityId};
use loosepin_simulate::accuracy::record::{MotionRecord, OutputMotion};
use loosepin_simulate::accuracy::{
    AccuracyError, DisplacedLoops, MotionPlan, Scatter, ScatterCorrelation, dimension_derivatives, dimension_direction,
    motion, play_gradients, position_outputs,
};

/// Round-off of positions of order 0.1 m after closing a loop, m or rad.
const POSITION_M: f64 = 1e-13;
/// Round-off relative to the largest entry of a history.
const RELATIVE: f64 = 1e-11;
/// Central differences with the steps used here: truncation and round-off, relative to the scale of the derivative.
const DIFFERENCE: f64 = 1e-7;

pub(crate) fn plan(built: &Built, positions: usize) -> MotionPlan {
    let span = built.mechanism.model.cycle.span;
    MotionPlan {
        span,
        positions,
        scatter: Vec::new(),
        correlations: Vec::new(),
        paths: Vec::new(),
        asked: Vec::new(),
        overrides: Vec::new(),
    }
}

pub(crate) fn motion_of(built: &Built, positions: usize) -> MotionRecord {
    try_motion_of(built, positions).unwrap_or_else(|error| panic!("{error}"))
}

pub(crate) fn try_motion_of(built: &Built, positions: usize) -> Result<MotionRecord, AccuracyError> {
    motion(&built.mechanism, &built.values, &plan(built, positions))
}

pub(crate) fn output<'r>(record: &'r MotionRecord, name: &str) -> &'r OutputMotion {
    record.outputs.iter().find(|output| output.name == name).unwrap_or_else(|| panic!("no output {name}"))
}

/// Slider position x = r cos θ + √(l² - r² sin²θ) and its first two derivatives with respect to θ.
fn slider_m(r: f64, l: f64, angle: f64) -> [f64; 3] {
    let (s, c) = angle.sin_cos();
    let root = (l * l - r * r * s * s).sqrt();
    let first = -r * s - r * r * s * c / root;
    let second = -r * c - r * r * (c * c - s * s) / root - r.powi(4) * s * s * c * c / root.powi(3);
    [r * c + root, first, second]
}

#[test]
fn analytic_slider_crank_over_the_cycle() {
    let built = build_case("slider_crank_5000");
    let record = motion_of(&built, 360);
    let speed = record.drive_speed_rad_s.expect("the drive has a constant speed");
    let slider = output(&record, "slider");
    assert_eq!(record.outputs.len(), 1, "velocity and acceleration belong to the position");
    assert_eq!(record.drive_angle_rad.len(), 361);
    assert_eq!(slider.words, "x of slider.pin");
    assert_eq!(record.mobility, "1 degree of freedom, 1 drive");
    for (k, angle) in record.drive_angle_rad.iter().enumerate() {
        let [x, first, second] = slider_m(0.05, 0.12, *angle);
        assert!((slider.value_si[k] - x).abs() < POSITION_M);
        assert!((slider.velocity_si[k] - first * speed).abs() < RELATIVE * 30.0);
        assert!((slider.acceleration_si[k] - second * speed * speed).abs() < RELATIVE * 2e4);
    }
}

#[test]
fn published_extremes_of_the_ideal_slider_acceleration() {
    /// Half a unit of the last printed digit, m/s².
    const LAST_DIGIT_M_S2: f64 = 0.5e-4;
    let built = build_case("slider_crank_5000");
    let sample = built.sample();
    let mechanism = &built.mechanism;
    let output = &position_outputs(mechanism)[0];
    let acceleration = |angle_rad: f64| {
        let motion = ideal_at(&built, &sample, angle_rad / built.input().speed_rad_s);
        let arm = |point| point_m(&mechanism.model, &built.values, point);
        let change = |slot| motion.acceleration(slot);
        output.reading.acceleration(&mechanism.ideal, motion.kinematics(), change, arm)
    };
    assert!((acceleration(0.0) - -19_419.360_5).abs() < LAST_DIGIT_M_S2);
    let top = 121.998_f64.to_radians();
    assert!((acceleration(top) - 9_695.855_7).abs() < LAST_DIGIT_M_S2);
    let degree = 1f64.to_radians();
    assert!(acceleration(top - 0.01 * degree) < acceleration(top));
    assert!(acceleration(top + 0.01 * degree) < acceleration(top));
}

#[test]
fn analytic_four_bar_by_freudenstein() {
    let built = build_case("four_bar_600");
    let record = motion_of(&built, 180);
    let rocker = output(&record, "rocker");
    let length = |path: &str| built.values[built.quantity(path)];
    let (a, b, c) =
        (length("parameter.crank_length"), length("parameter.coupler_length"), length("parameter.rocker_length"));
    let ground = &built.mechanism.model.bodies[0].points;
    let at = |name: &str| {
        let point = ground.iter().find(|point| point.name == name).expect("the ground has the pivot");
        Vec2::new(built.values[point.position_m[0]], built.values[point.position_m[1]])
    };
    let pivots = &ground.iter().map(|point| point.name.clone()).collect::<Vec<_>>();
    assert_eq!(pivots.len(), 2, "{pivots:?}");
    let base = at(&pivots[1]) - at(&pivots[0]);
    let (d, tilt) = (base.length(), base.y.atan2(base.x));
    for (k, angle) in record.drive_angle_rad.iter().enumerate() {
        // Freudenstein: k1 cos φ - k2 cos θ + k3 = cos(θ - φ), solved for φ with t = tan(φ/2).
        let theta = angle - tilt;
        let (k1, k2, k3) = (d / a, d / c, (a * a - b * b + c * c + d * d) / (2.0 * a * c));
        let p = theta.cos() - k1 - k2 * theta.cos() + k3;
        let q = -2.0 * theta.sin();
        let r = k1 - (k2 + 1.0) * theta.cos() + k3;
        let root = (q * q - 4.0 * p * r).sqrt();
        let known = rocker.value_si[k] - tilt;
        let off = [-1.0, 1.0]
            .map(|sign| 2.0 * ((-q + sign * root) / (2.0 * p)).atan())
            .map(|phi| ((phi - known) / 2.0).sin().abs() * 2.0);
        // The half-angle formula loses digits where p is small.
        assert!(off[0].min(off[1]) < 1e-12, "at {angle}: {off:?}");
    }
}

#[test]
fn identity_velocities_and_accelerations_are_differences_of_positions() {
    for case in case_names() {
        let built = build_case(&case);
        let sample = built.sample();
        let mechanism = &built.mechanism;
        let speed = built.input().speed_rad_s.abs();
        let (time_s, step_s) = (1.234 / speed, 2e-4 / speed);
        let states = [-1.0, 0.0, 1.0].map(|k| ideal_at(&built, &sample, time_s + k * step_s));
        let arm = |point| point_m(&mechanism.model, &built.values, point);
        for output in position_outputs(mechanism) {
            let value = |k: usize| output.reading.value(&mechanism.ideal, states[k].kinematics(), arm);
            let change = |slot| states[1].acceleration(slot);
            let [_, velocity, acceleration] = output.reading.jet(&mechanism.ideal, states[1].kinematics(), change, arm);
            let first = (value(2) - value(0)) / (2.0 * step_s);
            let second = (value(2) - 2.0 * value(1) + value(0)) / (step_s * step_s);
            assert!((velocity - first).abs() < DIFFERENCE * speed, "{case} {}: {velocity} {first}", output.name);
            // Round-off 1e-16 over the square of the step 2e-4.
            assert!((acceleration - second).abs() < 3e-7 * speed * speed, "{case} {}", output.name);
        }
    }
}

#[test]
fn identity_gradients_are_differences_of_the_closed_loops() {
    const STEP_M: f64 = 1e-6;
    for case in case_names() {
        let built = build_case(&case);
        let sample = built.sample();
        let turn_s = built.input().turn_s();
        let state = ideal_at(&built, &sample, 0.31 * turn_s);
        let readings: Vec<Position> = position_outputs(&built.mechanism).iter().map(|output| output.reading).collect();
        let mut loops = DisplacedLoops::new(&built.mechanism, &built.values);
        loops.set_position(state.coordinates());
        let plays = built.mechanism.plays.len();
        // Not only at the centres: the exact worst case needs gradients anywhere in the discs.
        let at: Vec<Vec2<f64>> = (0..plays).map(|k| Vec2::new(1e-4 * spread(k, 0.1), 1e-4 * spread(k, 0.2))).collect();
        loops.displace(&at).expect("a tenth of a millimetre is harmless");
        let gradients = play_gradients(&mut loops, &readings).expect("the position is regular");
        for play in 0..plays {
            for direction in [Vec2::new(1.0, 0.0), Vec2::new(0.0, 1.0)] {
                let mut values = [-1.0, 1.0].map(|sign| {
                    let mut moved = at.clone();
                    moved[play] += direction * (sign * STEP_M);
                    loops.displace(&moved).expect("a micrometre is harmless");
                    readings.iter().map(|reading| loops.value(*reading)).collect::<Vec<f64>>()
                });
                let [below, above] = &mut values;
                for (k, gradient) in gradients.iter().enumerate() {
                    let difference = (above[k] - below[k]) / (2.0 * STEP_M);
                    let exact = gradient[play].dot(direction);
                    assert!((exact - difference).abs() < 1e-8, "{case} output {k} joint {play}: {exact} {difference}");
                }
            }
        }
    }
}

/// A pin on a crank runs on a circle: an error of the crank's length is all across its path, and none of it along.
#[test]
fn analytic_an_error_of_the_radius_is_across_the_circle() {
    const DEVIATION_M: f64 = 2e-5;
    for (speed, start) in [("130 rad/s", "20 deg"), ("-60 rad/s", "0 deg")] {
        let output = "[parameter]\nlength = \"50 mm\"\n[output]\npin = { path_of = \"crank.pin\" }\n";
        let drive = format!("speed = \"{speed}\"\nstart_angle = \"{start}\"");
        let text =
            crate::elements::crank_text(&drive, "drive = \"crank\"", output).replace("[\"50 mm\"", "[\"length\"");
        let built = build_text(&text);
        let quantity = built.mechanism.model.find("parameter.length").expect("a parameter");
        let plan = MotionPlan {
            span: built.mechanism.model.cycle.span,
            positions: 24,
            scatter: vec![Scatter { quantity, standard_deviation_si: DEVIATION_M }],
            correlations: Vec::new(),
            paths: Vec::new(),
            asked: Vec::new(),
            overrides: Vec::new(),
        };
        let record = motion(&built.mechanism, &built.values, &plan).expect("it turns");
        let names: Vec<&str> = record.outputs.iter().map(|output| output.name.as_str()).collect();
        assert_eq!(names, ["pin x", "pin y", "pin along", "pin normal"]);
        assert_eq!(record.outputs[3].words, "error of crank.pin across its path");
        assert!(record.outputs[2].value_si.is_empty() && record.outputs[3].acceleration_si.is_empty());
        for position in 0..=24 {
            let of = |output: usize| record.outputs[output].dimensional_standard_deviation_si[position];
            assert!(of(2) < 1e-12 * DEVIATION_M, "along: {}", of(2));
            assert!((of(3) / DEVIATION_M - 1.0).abs() < 1e-10, "across: {}", of(3));
        }
    }
}

/// Along and across a path are x and y turned: of one play, or of one dimension, the squares add up to the same.
#[test]
fn identity_errors_of_a_path_are_those_of_its_coordinates_turned() {
    let built = build_case("four_bar_coupler_path");
    let model = &built.mechanism.model;
    let quantity = model.find("parameter.coupler_length").expect("a parameter");
    let plan = MotionPlan {
        span: model.cycle.span,
        positions: 36,
        scatter: vec![Scatter { quantity, standard_deviation_si: 2e-5 }],
        correlations: Vec::new(),
        paths: Vec::new(),
        asked: Vec::new(),
        overrides: Vec::new(),
    };
    let record = motion(&built.mechanism, &built.values, &plan).expect("it turns");
    let of = |name: &str| record.outputs.iter().find(|output| output.name == name).expect("an output");
    let (turned, straight) = ([of("tool along"), of("tool normal")], [of("tool x"), of("tool y")]);
    let close = |turned: [f64; 2], straight: [f64; 2]| {
        let [turned, straight] = [turned, straight].map(|[a, b]| a.hypot(b));
        assert!(straight > 1e-10 && (turned / straight - 1.0).abs() < 1e-12, "{turned} {straight}");
    };
    let mut shares = Vec::new();
    for position in 0..record.drive_angle_rad.len() {
        for joint in 0..2 {
            // A disc has a gradient of any direction: the lengths of g_x and g_y are those of its parts.
            let part = |output: &OutputMotion| output.clearance.contributors[joint].first_order_si[position];
            close(turned.map(part), straight.map(part));
        }
        let part = |output: &OutputMotion| output.dimensional_standard_deviation_si[position];
        close(turned.map(part), straight.map(part));
        shares.push(part(turned[0]) / part(turned[0]).hypot(part(turned[1])));
    }
    let (least, most) =
        shares.iter().fold((1.0_f64, 0.0_f64), |(least, most), share| (least.min(*share), most.max(*share)));
    assert!(least < 0.3 && most > 0.9, "the direction changes over the path: {least} to {most}");
}

/// Outputs of the mechanism with one quantity changed, at the given angle of the input drive.
fn outputs_with(model: &Model, set: &[(QuantityId, f64)], angle_rad: f64) -> Vec<f64> {
    let values = model.quantities.evaluate(set).expect("a small step keeps the rules");
    let mechanism = loosepin_mechanics::mechanism::Mechanism::new(model, &values).expect("a small step closes");
    let sample = Sample::<f64>::new(&mechanism, &values).expect("the values fit");
    let input = model.cycle_input(&values);
    let mut motion = IdealMotion::new(&mechanism, &sample.ideal, &sample.drives).expect("the start closes");
    motion.move_to((angle_rad - input.start_rad) / input.speed_rad_s).expect("the loops close");
    let arm = |point| point_m(model, &values, point);
    position_outputs(&mechanism)
        .iter()
        .map(|output| output.reading.value(&mechanism.ideal, motion.kinematics(), arm))
        .collect()
}

#[test]
fn identity_dimension_derivatives_are_differences_of_solved_mechanisms() {
    let mut compared = 0;
    for case in ["slider_crank_5000", "four_bar_600", "six_bar", "five_bar_two_drives", "scotch_yoke", "eight_bar"] {
        let built = build_case(case);
        let model = &built.mechanism.model;
        let sample = built.sample();
        let input = built.input();
        let angle_rad = input.start_rad + 0.77;
        let time_s = 0.77 / input.speed_rad_s;
        let state = ideal_at(&built, &sample, time_s);
        let mut loops = DisplacedLoops::new(&built.mechanism, &built.values);
        loops.set_position(state.coordinates());
        let readings: Vec<Position> = position_outputs(&built.mechanism).iter().map(|output| output.reading).collect();
        for (id, quantity) in model.quantities.iter().filter(|(_, quantity)| quantity.is_settable()) {
            let direction = dimension_direction(&built.mechanism, &built.values, id).expect("it can be varied");
            if direction.leaves_motion_alone(&built.mechanism) {
                continue;
            }
            let derivatives = dimension_derivatives(
                &mut loops,
                &built.mechanism,
                &built.values,
                &direction,
                model.cycle.span,
                time_s,
                &readings,
            )
            .expect("the position is regular");
            let step = 1e-6 * if built.values[id] == 0.0 { 1.0 } else { built.values[id].abs().max(1.0) };
            let [below, above] =
                [-step, step].map(|step| outputs_with(model, &[(id, built.values[id] + step)], angle_rad));
            for (k, derivative) in derivatives.iter().enumerate() {
                let difference = (above[k] - below[k]) / (2.0 * step);
                let scale = 1.0 + derivative.abs();
                assert!(
                    (derivative - difference).abs() < 2e-7 * scale,
                    "{case}, output {k} by {}: {derivative} {difference}",
                    quantity.path
                );
                compared += 1;
            }
        }
    }
    assert!(compared > 50, "only {compared} derivatives were compared");
}

#[test]
fn analytic_dimensional_standard_deviation_of_the_slider() {
    let built = build_case("slider_crank_5000");
    let scatter = [("parameter.crank_length", 2e-5), ("parameter.rod_length", 3e-5), ("body.crank.mass", 1e-3)]
        .map(|(path, sigma)| Scatter { quantity: built.quantity(path), standard_deviation_si: sigma });
    let plan = MotionPlan { scatter: scatter.to_vec(), ..plan(&built, 90) };
    let record = motion(&built.mechanism, &built.values, &plan).expect("the plan is sound");
    let slider = output(&record, "slider");
    let paths: Vec<&str> = slider.dimensional_contributors.iter().map(|c| c.path.as_str()).collect();
    assert_eq!(paths, ["parameter.crank_length", "parameter.rod_length"], "a mass does not shape the motion");
    for (k, angle) in record.drive_angle_rad.iter().enumerate() {
        let (r, l): (f64, f64) = (0.05, 0.12);
        let (s, c) = angle.sin_cos();
        let root = (l * l - r * r * s * s).sqrt();
        let (by_crank, by_rod) = ((c - r * s * s / root).abs() * 2e-5, l / root * 3e-5);
        assert!((slider.dimensional_contributors[0].standard_deviation_si[k] - by_crank).abs() < 1e-16);
        assert!((slider.dimensional_contributors[1].standard_deviation_si[k] - by_rod).abs() < 1e-16);
        let both = by_crank.hypot(by_rod);
        assert!((slider.dimensional_standard_deviation_si[k] - both).abs() < 1e-16);
    }
}

#[test]
fn analytic_correlated_dimensions_of_the_slider() {
    const LINEAR: f64 = -0.7;
    let built = build_case("slider_crank_5000");
    let [crank, rod, mass] =
        ["parameter.crank_length", "parameter.rod_length", "body.crank.mass"].map(|path| built.quantity(path));
    let scatter = [(crank, 2e-5), (rod, 3e-5)]
        .map(|(quantity, sigma)| Scatter { quantity, standard_deviation_si: sigma })
        .to_vec();
    // A correlation with what does not shape the motion changes nothing.
    let correlations = [(rod, crank, LINEAR), (crank, mass, 0.9)]
        .map(|(first, second, linear)| ScatterCorrelation { first, second, linear })
        .to_vec();
    let plan = MotionPlan { scatter, correlations, ..plan(&built, 90) };
    let record = motion(&built.mechanism, &built.values, &plan).expect("the plan is sound");
    let slider = output(&record, "slider");
    for (k, angle) in record.drive_angle_rad.iter().enumerate() {
        let (r, l): (f64, f64) = (0.05, 0.12);
        let (s, c) = angle.sin_cos();
        let root = (l * l - r * r * s * s).sqrt();
        let (by_crank, by_rod) = ((c - r * s * s / root) * 2e-5, l / root * 3e-5);
        let both = (by_crank * by_crank + by_rod * by_rod + 2.0 * LINEAR * by_crank * by_rod).sqrt();
        assert!((slider.dimensional_standard_deviation_si[k] - both).abs() < 1e-16);
    }
}

#[test]
fn analytic_expressions_are_followed_and_edges_of_rules_respected() {
    let text = TWO_LINKS.replace("\"link_length\", \"0 mm\"", "\"link_length * link_length / (80 mm)\", \"play / 2\"");
    let built = build_text(&text);
    let model = &built.mechanism.model;
    let point = model.bodies[1].points[1].position_m;
    let by_length = dimension_direction(&built.mechanism, &built.values, built.quantity("parameter.link_length"));
    let slope = by_length.expect("it can be varied").derivatives[point[0]];
    // d(l²/80 mm)/dl = 2 l/80 mm at l = 52 mm.
    assert!((slope - 2.0 * 0.052 / 0.08).abs() < 1e-12, "{slope}");
    // A clearance of zero cannot go below: three points above give the slope.
    let by_play = dimension_direction(&built.mechanism, &built.values, built.quantity("parameter.play"));
    let slope = by_play.expect("it can be varied").derivatives[point[1]];
    assert!((slope - 0.5).abs() < 1e-12, "{slope}");
}

#[test]
fn identity_a_drive_that_turns_backwards_is_recorded_by_increasing_angle() {
    let forwards = build_case("slider_crank_5000");
    let speed = forwards.input().speed_rad_s;
    let backwards = build_case_with("slider_crank_5000", &[("drive.crank.speed", -speed)]);
    let [ahead, back] = [&forwards, &backwards].map(|built| motion_of(built, 72));
    assert!(back.drive_angle_rad.windows(2).all(|pair| pair[0] < pair[1]));
    let (ahead, back) = (output(&ahead, "slider"), output(&back, "slider"));
    for k in 0..=72 {
        assert!((ahead.value_si[k] - back.value_si[k]).abs() < POSITION_M);
        assert!((ahead.velocity_si[k] + back.velocity_si[k]).abs() < RELATIVE * 30.0);
        assert!((ahead.acceleration_si[k] - back.acceleration_si[k]).abs() < RELATIVE * 2e4);
        assert!((ahead.clearance.first_order_si[k] - back.clearance.first_order_si[k]).abs() < POSITION_M);
    }
}

/// A crank with a joint that has a clearance of zero, driven by nothing else.
const TWO_LINKS: &str = r#"
name = "two links"
gravity = "9.81 m/s^2"
[parameter]
link_length = "52 mm"
play = "0 mm"
[body.ground]
points = { o = ["0 mm", "0 mm"] }
[body.crank]
mass = "0.3 kg"
inertia = "1e-4 kg m^2"
centre_of_mass = ["20 mm", "0 mm"]
points = { main = ["0 mm", "0 mm"], pin = ["link_length", "0 mm"] }
[contact.steel]
law = "hertz"
restitution = 0.9
stiffness = "6.6e10 N/m^1.5"
exponent = 1.5
[body.plate]
mass = "0.2 kg"
inertia = "1e-4 kg m^2"
centre_of_mass = ["0 mm", "0 mm"]
points = { pin = ["0 mm", "0 mm"], rail = ["0 mm", "0 mm"] }
[body.carriage]
mass = "0.2 kg"
inertia = "1e-4 kg m^2"
centre_of_mass = ["0 mm", "0 mm"]
points = { rail = ["0 mm", "0 mm"], way = ["0 mm", "0 mm"] }
[joint.main]
kind = "revolute"
bearing = "ground.o"
journal = "crank.main"
[joint.pin]
kind = "revolute"
bearing = "crank.pin"
journal = "plate.pin"
bearing_radius = "8 mm"
radial_clearance = "play"
contact = "steel"
[joint.way]
kind = "prismatic"
guide = { point = "ground.o", angle = "0 deg" }
slider = "carriage.way"
[joint.rail]
kind = "prismatic"
guide = { point = "carriage.rail", angle = "90 deg" }
slider = { point = "plate.rail", angle = "90 deg" }
[drive.crank]
joint = "main"
speed = "60 rpm"
start_angle = "20 deg"
[cycle]
drive = "crank"
[output.plate]
position_of = "plate.pin"
along = "x"
"#;

#[test]
fn a_drive_that_turns_very_often_in_a_turn_is_refused() {
    // A second drive of an arm on the crank, 1 rad at 5e5 Hz: to and fro 5e5 times in 1 s, 4 rad each, in steps of 0.2 rad.
    let by_hand = 5e5 * 4.0 / 0.2;
    let arm = "[body.arm]\nmass = \"0.2 kg\"\ninertia = \"1e-4 kg m^2\"\ncentre_of_mass = [\"0 mm\", \"0 mm\"]\n\
               points = { pin = [\"0 mm\", \"0 mm\"] }\n[joint.wrist]\nkind = \"revolute\"\nbearing = \"crank.main\"\n\
               journal = \"arm.pin\"\n[drive.shake]\njoint = \"wrist\"\n\
               motion = { kind = \"harmonic\", mean = \"0 deg\", amplitude = \"1 rad\", frequency = \"5e5 Hz\", phase = \"0 deg\" }\n";
    let built = build_text(&format!("{TWO_LINKS}{arm}"));
    let error = motion(&built.mechanism, &built.values, &plan(&built, 36)).expect_err("1e7 steps");
    let AccuracyError::TooLong { ref drive, steps, most: 200_000 } = error else { panic!("{error}") };
    // The mean over 64 instants.
    assert!((steps / by_hand - 1.0).abs() < 0.15 && drive == "shake", "{error}");
    let slower = build_text(&format!("{TWO_LINKS}{arm}").replace("5e5 Hz", "500 Hz"));
    motion_of(&slower, 36);
    // A rate that is large for a short time is no long way: 1 rad within some milliseconds of the 60 s of a turn.
    let brief = "motion = { kind = \"expression\", position = \"1 rad * (1 - exp(-time / (1 ms)))\" }";
    let harmonic = arm.lines().find(|line| line.starts_with("motion")).expect("a motion");
    let brief = format!("{TWO_LINKS}{}", arm.replace(harmonic, brief)).replace("60 rpm", "1 rpm");
    motion_of(&build_text(&brief), 36);
    // A radian is one whatever the size: a crank of a tenth of a millimetre is followed.
    motion_of(&build_text(&TWO_LINKS.replace("52 mm", "0.1 mm")), 36);
}

#[test]
fn text_of_errors() {
    let built = build_case("slider_crank_5000");
    let fail = |plan: &MotionPlan| motion(&built.mechanism, &built.values, plan).expect_err("it must fail").to_string();
    assert_eq!(fail(&plan(&built, 3)), "3 positions a cycle were asked for; must be at least 12");
    let rod = built.quantity("parameter.rod_length");
    let bad = Scatter { quantity: rod, standard_deviation_si: -1e-5 };
    assert_eq!(
        fail(&MotionPlan { scatter: vec![bad], ..plan(&built, 36) }),
        "the standard deviation of parameter.rod_length is -0.00001; must be a finite number >= 0"
    );
    let derived = Scatter { quantity: built.quantity("body.rod.points.small_end.x"), standard_deviation_si: 1e-5 };
    assert_eq!(
        fail(&MotionPlan { scatter: vec![derived], ..plan(&built, 36) }),
        "body.rod.points.small_end.x is not a free number of the model, so it cannot be set"
    );
    let still = build_case_with("slider_crank_5000", &[("drive.crank.speed", 0.0)]);
    let error = motion(&still.mechanism, &still.values, &plan(&still, 36)).expect_err("nothing turns");
    assert_eq!(error, AccuracyError::StandsStill { drive: "crank".to_owned() });
    assert_eq!(error.to_string(), "drive 'crank' has speed zero, so it has no cycle");
}
