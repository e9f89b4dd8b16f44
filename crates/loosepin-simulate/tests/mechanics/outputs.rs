//! What outputs measure, on a crank whose motion is known in closed form.

use crate::elements::crank;
use loosepin_simulate::{Plan, simulate};

const SPEED_RAD_S: f64 = 130.0;
const START_RAD: f64 = 20.0 * std::f64::consts::PI / 180.0;
const ARM_M: f64 = 0.05;
/// Mass times distance of the centre of mass from the axis.
const MOMENT_OF_MASS_KG_M: f64 = 0.3 * 0.025;
/// Round-off of an angle after many turns, and of what is computed from it.
const ROUND_OFF: f64 = 1e-12;

#[test]
fn analytic_outputs_of_a_driven_crank() {
    let (r, w) = (ARM_M, SPEED_RAD_S);
    type Expected<'e> = &'e dyn Fn(f64) -> f64;
    let expected: [(&str, Expected<'_>); 8] = [
        (r#"position_of = "crank.pin", along = "x""#, &|a| r * a.cos()),
        (r#"velocity_of = "crank.pin", along = "x""#, &|a| -r * w * a.sin()),
        (r#"acceleration_of = "crank.pin", along = "y""#, &|a| -r * w * w * a.sin()),
        (r#"angle_of = "crank""#, &|a| a),
        (r#"angular_velocity_of = "crank""#, &|_| w),
        (r#"angular_acceleration_of = "crank""#, &|_| 0.0),
        (r#"force_in = "joint.main", component = "magnitude""#, &|_| MOMENT_OF_MASS_KG_M * w * w),
        (r#"path_of = "crank.pin""#, &|a| r * a.cos()),
    ];
    let outputs = expected.iter().enumerate().map(|(k, (keys, _))| format!("output{k} = {{ {keys} }}\n"));
    let built = crank("130 rad/s", &format!("[output]\n{}", outputs.collect::<String>()));
    let record =
        simulate(&built.mechanism, &built.values, &Plan::of_model(&built.mechanism.model)).expect("it turns").record;
    assert_eq!(record.outputs.len(), expected.len() + 1, "a path is two columns");
    for (output, (keys, of)) in record.outputs.iter().zip(expected) {
        let size = output.value_si.iter().fold(1.0, |size: f64, value| size.max(value.abs()));
        for (&time_s, &value) in record.time_s.iter().zip(&output.value_si) {
            let exact = of(START_RAD + w * time_s);
            assert!((value - exact).abs() < ROUND_OFF * size, "{keys} at {time_s} s: {value}, not {exact}");
        }
    }
}

/// An arm on the crank's pin, at the angle b = B sin(Ω t) from the crank; a post beside them.
const ARM: &str = r#"
[body.arm]
mass = "0.2 kg"
inertia = "1e-4 kg m^2"
centre_of_mass = ["15 mm", "0 mm"]
points = { elbow = ["0 mm", "0 mm"], tip = ["40 mm", "0 mm"] }
[joint.elbow]
kind = "revolute"
bearing = "crank.pin"
journal = "arm.elbow"
[drive.elbow]
joint = "elbow"
motion = { kind = "harmonic", mean = "0 deg", amplitude = "40 deg", frequency = "30 Hz" }
"#;

/// Seen from the arm, whose turning speeds up and slows down, all terms count: Euler's, Coriolis's and the centrifugal one.
#[test]
fn analytic_outputs_seen_from_a_moving_body() {
    const TIP_M: f64 = 0.04;
    const POST_M: [f64; 2] = [0.07, -0.02];
    /// Terms of 1e4 m/s² cancel.
    const ROUND_OFF: f64 = 1e-11;
    let (swing, turning) = (40_f64.to_radians(), std::f64::consts::TAU * 30.0);
    // b, b′ and b″.
    let elbow = |t: f64| {
        let (sine, cosine) = (turning * t).sin_cos();
        [swing * sine, swing * turning * cosine, -swing * turning * turning * sine]
    };
    // A place on a circle of radius r about the observer at the angle f(t): r cos f, r sin f and their derivatives.
    let circle = |radius: f64, [f, rate, change]: [f64; 3]| {
        let (sine, cosine) = f.sin_cos();
        let [x, y] = [radius * cosine, radius * sine];
        let velocity = [-y * rate, x * rate];
        [[x, y], velocity, [-y * change - x * rate * rate, x * change - y * rate * rate]]
    };
    let shaft = |t: f64| [START_RAD + SPEED_RAD_S * t, SPEED_RAD_S, 0.0];
    let back = |jet: [f64; 3], start: f64| [start - jet[0], -jet[1], -jet[2]];
    // From the crank the tip runs on a circle about the pin, and the post on one about the shaft.
    let tip_from_pin = |t: f64| circle(TIP_M, elbow(t));
    let post_from_shaft = |t: f64| circle(POST_M[0].hypot(POST_M[1]), back(shaft(t), POST_M[1].atan2(POST_M[0])));
    // From the tip of the arm the shaft runs on a circle about (-40 mm, 0), the place of the pin.
    let shaft_from_tip = |t: f64| {
        let mut of = circle(ARM_M, back(elbow(t), std::f64::consts::PI));
        of[0][0] -= TIP_M;
        of
    };
    let tip_from_post = |t: f64| {
        let [pin, arm] = [circle(ARM_M, shaft(t)), circle(TIP_M, [0, 1, 2].map(|k| shaft(t)[k] + elbow(t)[k]))];
        let mut sum = [0, 1, 2].map(|k| [pin[k][0] + arm[k][0], pin[k][1] + arm[k][1]]);
        sum[0] = [sum[0][0] - POST_M[0], sum[0][1] - POST_M[1]];
        sum
    };
    type PointMotion<'p> = &'p dyn Fn(f64) -> [[f64; 2]; 3];
    let places: [(&str, &str, PointMotion<'_>); 4] = [
        ("arm.tip", "crank.pin", &tip_from_pin),
        ("ground.anchor", "crank.main", &post_from_shaft),
        ("crank.main", "arm.tip", &shaft_from_tip),
        ("arm.tip", "ground.anchor", &tip_from_post),
    ];
    type Expected<'e> = Box<dyn Fn(f64) -> f64 + 'e>;
    let mut expected: Vec<(String, Expected<'_>)> = Vec::new();
    for (of, to, place) in places {
        for (derivative, measure) in ["position_of", "velocity_of", "acceleration_of"].into_iter().enumerate() {
            for (axis, along) in ["x", "y"].into_iter().enumerate() {
                let keys = format!(r#"{measure} = "{of}", along = "{along}", relative_to = "{to}""#);
                expected.push((keys, Box::new(move |t| place(t)[derivative][axis])));
            }
        }
    }
    for (derivative, measure) in ["angle_of", "angular_velocity_of", "angular_acceleration_of"].into_iter().enumerate()
    {
        let keys = format!(r#"{measure} = "crank", relative_to = "arm""#);
        expected.push((keys, Box::new(move |t| -elbow(t)[derivative])));
    }
    let outputs = expected.iter().enumerate().map(|(k, (keys, _))| format!("output{k} = {{ {keys} }}\n"));
    let built = crank(&format!("{SPEED_RAD_S} rad/s"), &format!("{ARM}[output]\n{}", outputs.collect::<String>()));
    let record =
        simulate(&built.mechanism, &built.values, &Plan::of_model(&built.mechanism.model)).expect("it turns").record;
    assert_eq!(record.outputs.len(), 27);
    for (output, (keys, of)) in record.outputs.iter().zip(&expected) {
        let size = output.value_si.iter().fold(0.0, |size: f64, value| size.max(value.abs()));
        for (&time_s, &value) in record.time_s.iter().zip(&output.value_si) {
            let exact = of(time_s);
            assert!((value - exact).abs() < ROUND_OFF * size, "{keys} at {time_s} s: {value}, not {exact}");
        }
    }
    let words = record.outputs.iter().map(|output| output.words.as_str()).collect::<Vec<_>>();
    assert_eq!(words[2], "x velocity of arm.tip relative to crank.pin");
    assert_eq!(words[24], "angle of crank relative to arm");
}
