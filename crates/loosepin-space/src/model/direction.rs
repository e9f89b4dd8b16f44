//! Directions in the frame of a body.

use loosepin_math::Vec3;
use loosepin_text::document::{Kind, quantity};
use loosepin_text::numbers::{QuantityId, Values};
use loosepin_text::units::{Dimension, Rule};

/// Three lengths.
pub(crate) const LENGTHS: Kind = Kind::Three(&quantity(Dimension::LENGTH, Rule::Finite));

/// Numbers of a direction.
pub(crate) const NUMBERS: Kind = Kind::Three(&quantity(Dimension::NUMBER, Rule::Finite));

/// A direction in the frame of a body: a coordinate axis, the name of an axis of the body, or three numbers.
pub(crate) const DIRECTION: Kind = Kind::AnyOf(&[Kind::Text, NUMBERS]);

/// A direction in the frame of a body; its length does not matter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Direction {
    /// A coordinate axis of the frame, or its opposite.
    Coordinate(Vec3),
    /// Three numbers.
    Numbers([QuantityId; 3]),
    /// From one point of the body to another, each with its coordinates.
    Between([[QuantityId; 3]; 2]),
}

impl Direction {
    /// The z axis of the frame.
    pub(crate) const Z: Direction = Self::Coordinate(Vec3::Z);

    /// The words for coordinate axes.
    pub(crate) const WORDS: &'static [(&'static str, Direction)] = &[
        ("x", Self::Coordinate(Vec3::X)),
        ("y", Self::Coordinate(Vec3::Y)),
        ("z", Self::Coordinate(Vec3::Z)),
        ("-x", Self::Coordinate(Vec3::new(-1.0, 0.0, 0.0))),
        ("-y", Self::Coordinate(Vec3::new(0.0, -1.0, 0.0))),
        ("-z", Self::Coordinate(Vec3::new(0.0, 0.0, -1.0))),
    ];

    /// The direction called `word`.
    pub(crate) fn from_word(word: &str) -> Option<Self> {
        Self::WORDS.iter().find(|(own, _)| *own == word).map(|(_, direction)| *direction)
    }

    /// The direction with these values, as long as it was written.
    pub fn vector(&self, values: &Values) -> Vec3 {
        match self {
            Self::Coordinate(axis) => *axis,
            Self::Numbers(numbers) => vector(*numbers, values),
            Self::Between([from, to]) => vector(*to, values) - vector(*from, values),
        }
    }

    /// Whether it is a coordinate axis.
    pub(crate) fn is_coordinate(&self) -> bool {
        matches!(self, Self::Coordinate(_))
    }
}

/// Three values as a vector.
pub(crate) fn vector(ids: [QuantityId; 3], values: &Values) -> Vec3 {
    Vec3::from(ids.map(|id| values[id]))
}
