//! A mechanism with its nominal sample: what the tests of guides and slots with play begin with.

use crate::elements::{Built, build};
use loosepin_mechanics::mechanism::{Mechanism, Sample};
use loosepin_mechanics::model::Values;

pub(crate) struct Case {
    pub(crate) mechanism: Mechanism,
    pub(crate) values: Values,
    pub(crate) sample: Sample<f64>,
}

/// The mechanism of a model's text.
pub(crate) fn case(text: &str) -> Case {
    let built = build(text);
    let sample = built.sample();
    let Built { values, mechanism } = built;
    Case { mechanism, values, sample }
}
