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
