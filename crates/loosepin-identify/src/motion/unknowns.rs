//! The unknowns of a study: what of it is known as an interval or as a list.

use super::grid::Axis;
use loosepin_result::identification::PlayBounds;
use loosepin_study::{EpistemicInput, EpistemicSubject, Study};
use loosepin_text::units::SiUnit;
use loosepin_uncertainty::EpistemicVariable;

/// The axis of an input of the study.
pub(crate) fn axis(input: &EpistemicInput) -> Axis {
    match input.variable {
        EpistemicVariable::OneOf(_) => Axis::Members(input.variable.choices()),
        _ => Axis::Continuous,
    }
}

/// Value of an input at a share of its axis.
pub(crate) fn value(input: &EpistemicInput, share: f64) -> f64 {
    match &input.variable {
        EpistemicVariable::OneOf(members) => members.values()[(share as usize).min(members.values().len() - 1)],
        _ => {
            let [lower, upper] = input.variable.ends();
            lower + share * (upper - lower)
        }
    }
}

/// An input with the interval that it has after the measurement.
pub(crate) fn bounds(study: &Study, input: &EpistemicInput, after_si: [f64; 2]) -> PlayBounds {
    let unit = match &input.subject {
        EpistemicSubject::Quantity(quantity) => SiUnit::of_dimension(study.model.quantities()[*quantity].dimension),
        EpistemicSubject::Parameter { dimension, .. } => SiUnit::of_dimension(*dimension),
        EpistemicSubject::Law { .. } | EpistemicSubject::Play => SiUnit::NONE,
    };
    let before_si = input.variable.ends();
    PlayBounds {
        path: input.path.clone(),
        name: name(&input.path),
        unit,
        before_si,
        after_si,
        is_identifiable: after_si[0] > before_si[0] && after_si[1] < before_si[1],
        is_interval: matches!(input.variable, EpistemicVariable::Interval(_)),
    }
}

/// Name in sentences: the path without its group, with spaces.
pub(crate) fn name(path: &str) -> String {
    let short = path.split_once('.').map_or(path, |(_, rest)| rest);
    short.replace(['.', '_'], " ")
}
