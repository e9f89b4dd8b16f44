//! What every kind of play says of itself.

use crate::kind::frames::MarkerShift;
use crate::play::block::Block;

/// How far a journal may leave its ideal place in the bearing.
///
/// The admissible set is a product of balls, one for each [`Block`]: intervals, discs and balls. Its variables are those of the blocks in
/// their order.
pub(crate) trait KindOfPlay: PlayNumbers<f64> {
    /// Its name.
    const WORD: &'static str;
    /// The word of the kind of joint that it belongs to.
    const JOINT: &'static str;
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
    /// The first number that cannot be, if one is: its name, its value and the rule that it breaks.
    fn mistake(&self) -> Option<(&'static str, f64, &'static str)>;
    /// Its sizes in words.
    fn words(&self) -> String;
}

/// The numbers `N` of a play: values, or quantities of a model.
pub(crate) trait PlayNumbers<N> {
    /// The same play with other numbers.
    type With<M>;
    /// The same play with what `number` makes of its numbers.
    fn with<M>(&self, number: impl Fn(N) -> M) -> Self::With<M>;
    /// The radial clearance, and that along the axis.
    fn clearances_m(&self) -> [Option<N>; 2];
    /// Length of the bearing, its middle at the marker, m; `None` where the play does not depend on one.
    fn bearing_length_m(&self) -> Option<N> {
        None
    }
}

/// Play that a model file can give a kind of joint.
pub(crate) trait PlayOfFile {
    /// Keys of the joint's table that give it; none where there is no play.
    const KEYS: &'static [&'static str];
}

/// The play of a kind of joint that has none.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum NoPlay {}

impl PlayOfFile for NoPlay {
    const KEYS: &'static [&'static str] = &[];
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
