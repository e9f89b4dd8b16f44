//! A hole within its position tolerance, nobody knows where, against a closed form.

use crate::silent::run;
use loosepin::model::Model;
use loosepin::study::Study;

/// Radius of the circle that holds the axis, m.
const RADIUS_M: f64 = 5e-5;

/// It moves the pin by R at most in any direction, from where the drawing has it.
#[test]
fn analytic_a_hole_somewhere_in_its_zone() {
    let text = include_str!("../files/position_tolerance.toml");
    let model = Model::from_text("model.toml", text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let text = include_str!("../files/position_tolerance_study.toml");
    let study = Study::from_text("study.toml", text, model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let bounds = run(&study).result.bounds;
    let [bound] = &bounds[..] else { panic!("one bound was asked for") };
    for (end, exact_m) in [(&bound.lower, -RADIUS_M), (&bound.upper, RADIUS_M)] {
        assert!((end.value_si - exact_m).abs() < 1e-3 * RADIUS_M, "{exact_m} {bound:?}");
        assert!((end.widened_si - exact_m) * exact_m.signum() > -1e-12, "{exact_m} {bound:?}");
        assert!((end.widened_si - exact_m).abs() < 1e-2 * RADIUS_M, "{exact_m} {bound:?}");
    }
}
