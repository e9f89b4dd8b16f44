//! What every kind of play says of itself.

use crate::kind::frames::MarkerShift;
use crate::play::block::Block;

/// How far a journal may leave its ideal place in the bearing.
///
/// The admissible set is a product of balls, one for each [`Block`]: intervals, discs and balls. Its variables are those of the blocks in
/// their order.
pub trait KindOfPlay {
    /// Its name.
    fn word(&self) -> &'static str;
    /// The name of the kind of joint that it belongs to.
    fn joint_word(&self) -> &'static str;
    /// The blocks of variables.
    fn blocks(&self) -> Vec<Block>;
    /// Where the variables take the bearing's marker.
    fn marker_shift(&self, variables: &[f64]) -> MarkerShift;
    /// Derivatives of [`Self::marker_shift`] by each variable.
    fn derivatives(&self, variables: &[f64]) -> Vec<MarkerShift>;
    /// Second derivatives of [`Self::marker_shift`], by two variables, that are not zero: it is a polynomial of second degree.
    fn second_derivatives(&self) -> Vec<(usize, usize, MarkerShift)> {
        Vec::new()
    }
    /// Length of the bearing, its middle at the marker, m; `None` where the play does not depend on one.
    fn bearing_length_m(&self) -> Option<f64> {
        None
    }
    /// The first number that cannot be, if one is: its name, its value and the rule that it breaks.
    fn mistake(&self) -> Option<(&'static str, f64, &'static str)>;
}

/// The mistake of a clearance that is not zero or a positive number.
pub(crate) fn clearance_mistake(name: &'static str, value_m: f64) -> Option<(&'static str, f64, &'static str)> {
    (!(value_m >= 0.0 && value_m.is_finite())).then_some((name, value_m, "must be >= 0"))
}

/// The mistake of a bearing in which the journal cannot be, or leans too far.
pub(crate) fn length_mistake(length_m: f64, clearance_m: f64) -> Option<(&'static str, f64, &'static str)> {
    if !(length_m > 0.0 && length_m.is_finite()) {
        return Some(("bearing length, m", length_m, "must be > 0"));
    }
    let lean = 2.0 * clearance_m / length_m;
    (lean > MAX_SLOPE).then_some(("largest lean 2c/l", lean, "must be <= 0.5"))
}

/// Largest slope of a journal in its bearing: beyond it a section across the journal is no circle any more.
const MAX_SLOPE: f64 = 0.5;
