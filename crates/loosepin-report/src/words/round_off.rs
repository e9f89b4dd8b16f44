//! Numbers of a result that are nothing but round-off, such as the deviation of an output that nothing moves: they are 0 where they are shown.

use std::borrow::Cow;

use loosepin_result::round_off::round_off_si;
use loosepin_result::simulation::Drawing;
use loosepin_result::study::{BoundEnd, BoundRecord, NumericalError, StudyResult};

/// The distance of the farthest point of a body from the origin of the body, which is the size of a mechanism.
pub(crate) fn size_m(drawing: &Drawing) -> f64 {
    let points = drawing.bodies.iter().flat_map(|body| &body.points);
    points.map(|point| point.x_m.hypot(point.y_m)).filter(|size_m| size_m.is_finite()).fold(0.0, f64::max)
}

/// The result with 0 in the place of bounds of which both ends are round-off.
pub(crate) fn without_round_off(result: &StudyResult) -> Cow<'_, StudyResult> {
    let size_m = size_m(&result.drawing);
    let is_round_off = |bound: &BoundRecord| {
        let ends = [bound.lower.widened_si, bound.upper.widened_si];
        let threshold_si = round_off_si(&bound.unit, size_m);
        !bound.statistic.is_probability() && ends != [0.0; 2] && ends.iter().all(|end| end.abs() < threshold_si)
    };
    if !result.bounds.iter().any(is_round_off) {
        return Cow::Borrowed(result);
    }
    let mut cleaned = result.clone();
    for bound in cleaned.bounds.iter_mut().filter(|bound| is_round_off(bound)) {
        for end in [&mut bound.lower, &mut bound.upper] {
            let error = NumericalError { sampling_si: 0.0, optimisation_si: 0.0, surrogate_si: 0.0 };
            *end = BoundEnd { value_si: 0.0, widened_si: 0.0, witness: std::mem::take(&mut end.witness), error };
        }
    }
    Cow::Owned(cleaned)
}
