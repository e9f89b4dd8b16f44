//! Dimensions and units of expected numbers.

use super::case::Case;
use loosepin_mechanics::contact::NormalContact;
use loosepin_text::units::{Dimension, ReadableUnit, SiUnit, parse_unit};

/// The dimension of the stiffness of a joint with play; that of a number for laws without one.
pub(super) fn stiffness_dimension(case: &Case, play: usize) -> Dimension {
    let stiffness = case.sample.plays[play].normal.stiffness();
    stiffness.map_or(Dimension::NUMBER, |(_, exponent)| Dimension::contact_stiffness(exponent))
}

/// The SI unit of a dimension.
pub(super) fn si_unit(dimension: Dimension) -> ReadableUnit {
    ReadableUnit { text: dimension.si_unit(), si_per_unit: 1.0 }
}

pub(super) fn dimension_of(unit: &SiUnit) -> Dimension {
    parse_unit(unit.symbol()).map_or(Dimension::NUMBER, |measured| measured.dimension)
}

pub(super) fn state_dimension(part: usize) -> Dimension {
    match part {
        0 | 1 => Dimension::LENGTH,
        2 => Dimension::ANGLE,
        3 | 4 => Dimension::VELOCITY,
        5 => Dimension::ANGULAR_VELOCITY,
        6 | 7 => Dimension::ACCELERATION,
        _ => Dimension::ANGULAR_ACCELERATION,
    }
}
