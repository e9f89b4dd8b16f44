//! What outputs read off.

use crate::model::direction::Direction;
use crate::model::marker::PointId;
use crate::output::{PointOutput, RotationOutput, SpatialOutput};
use crate::sampling::part::PartOfOutput;
use loosepin_math::Vec3;
use loosepin_text::units::Dimension;

/// What an output reads off.
#[derive(Debug, Clone, Copy)]
pub enum ModelOutputKind {
    /// The place of a point along a direction of the ground.
    Position {
        /// The point.
        point: PointId,
        /// The direction.
        along: Direction,
    },
    /// The path of a point: how far it is displaced, in whatever direction.
    Path {
        /// The point.
        point: PointId,
    },
    /// The turn of a body about an axis of it.
    Turn {
        /// The body.
        body: usize,
        /// The axis, in the frame of the body.
        about: Direction,
    },
    /// The orientation of a body: how far it is rotated from the ideal one, about whatever axis.
    Orientation {
        /// The body.
        body: usize,
    },
}

/// What components of outputs are made of, for given values of a model.
pub(in crate::model) trait OutputValues<E> {
    /// A point in the frame of its body, m.
    fn point_m(&self, point: PointId) -> Vec3;
    /// The unit vector of a direction that stands at this key of the output's table.
    fn unit(&self, direction: Direction, key: &'static str) -> Result<Vec3, E>;
}

impl ModelOutputKind {
    /// The body that it is read off.
    pub fn body(self) -> usize {
        match self {
            Self::Position { point, .. } | Self::Path { point } => point.body,
            Self::Turn { body, .. } | Self::Orientation { body } => body,
        }
    }

    /// The point that it is read off; `None` where a body is asked for.
    pub fn point(self) -> Option<PointId> {
        match self {
            Self::Position { point, .. } | Self::Path { point } => Some(point),
            Self::Turn { .. } | Self::Orientation { .. } => None,
        }
    }

    /// Whether it is a displacement or a rotation with three components, and no number.
    pub fn is_vector(self) -> bool {
        matches!(self, Self::Path { .. } | Self::Orientation { .. })
    }

    /// Whether it is the path of a point, which has a direction at each place.
    pub fn is_path(self) -> bool {
        matches!(self, Self::Path { .. })
    }

    /// Whether it is an angle whose whole turns are counted from position to position.
    pub fn counts_turns(self) -> bool {
        matches!(self, Self::Turn { .. })
    }

    /// What it is of its point or of its body, in words.
    pub fn word(self) -> &'static str {
        match self {
            Self::Position { .. } => "position",
            Self::Path { .. } => "displacement",
            Self::Turn { .. } => "turn",
            Self::Orientation { .. } => "rotation",
        }
    }

    /// Dimension of its numbers.
    pub fn dimension(self) -> Dimension {
        match self {
            Self::Position { .. } | Self::Path { .. } => Dimension::LENGTH,
            Self::Turn { .. } | Self::Orientation { .. } => Dimension::ANGLE,
        }
    }

    /// The parts that a study asks for, in the order in which they are listed.
    pub fn asked_parts(self) -> &'static [PartOfOutput] {
        use PartOfOutput::{Across, Along, Magnitude, Number, X, Y, Z};
        match self {
            Self::Position { .. } | Self::Turn { .. } => &[Number],
            Self::Path { .. } => &[X, Y, Z, Along, Across, Magnitude],
            // Components of the rotation are turns about axes, which turn_of has.
            Self::Orientation { .. } => &[Magnitude],
        }
    }

    /// Whether a sample can read off this part.
    pub(crate) fn has_part(self, part: PartOfOutput) -> bool {
        if part.needs_path() { self.is_path() } else { self.is_vector() != (part == PartOfOutput::Number) }
    }

    /// A part in words, with the name of the point or of the body.
    pub fn words_of_part(self, part: PartOfOutput, name: &str) -> String {
        match part {
            PartOfOutput::Number => format!("{} of {name}", self.word()),
            PartOfOutput::X | PartOfOutput::Y | PartOfOutput::Z => format!("{} of {name}", part.word()),
            PartOfOutput::Along => format!("error of {name} along its path"),
            PartOfOutput::Across => format!("distance of {name} from the line along its path"),
            PartOfOutput::Magnitude if self.point().is_none() => format!("angle of {name} from its ideal orientation"),
            PartOfOutput::Magnitude => format!("distance of {name} from its ideal place"),
        }
    }

    /// What is read off a mechanism: one number, or three components.
    pub(in crate::model) fn components<E>(self, values: &impl OutputValues<E>) -> Result<Vec<SpatialOutput>, E> {
        Ok(match self {
            Self::Position { point, along } => {
                let (point_m, direction) = (values.point_m(point), values.unit(along, "along")?);
                vec![PointOutput { body: point.body, point_m, direction }.into()]
            }
            Self::Path { point } => SpatialOutput::displacement(point.body, values.point_m(point)).to_vec(),
            Self::Turn { body, about } => vec![RotationOutput { body, axis: values.unit(about, "about")? }.into()],
            Self::Orientation { body } => SpatialOutput::rotation(body).to_vec(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::ModelOutputKind;
    use crate::model::direction::Direction;
    use crate::model::marker::PointId;
    use crate::sampling::part::PartOfOutput;
    use loosepin_text::units::Dimension;

    const POINT: PointId = PointId { body: 2, point: 1 };
    const KINDS: [ModelOutputKind; 4] = [
        ModelOutputKind::Position { point: POINT, along: Direction::Z },
        ModelOutputKind::Path { point: POINT },
        ModelOutputKind::Turn { body: 3, about: Direction::Z },
        ModelOutputKind::Orientation { body: 3 },
    ];

    #[test]
    fn what_is_of_a_point_is_a_length_and_what_is_of_a_body_an_angle() {
        for kind in KINDS {
            let expected = match kind.point() {
                Some(point) => (point.body, Dimension::LENGTH),
                None => (3, Dimension::ANGLE),
            };
            assert_eq!((kind.body(), kind.dimension()), expected, "{kind:?}");
        }
    }

    #[test]
    fn a_sample_can_read_what_a_study_asks_for() {
        for kind in KINDS {
            let parts = kind.asked_parts();
            assert!(parts.iter().all(|part| kind.has_part(*part)), "{kind:?}");
            assert_eq!(kind.has_part(PartOfOutput::Number), !kind.is_vector(), "{kind:?}");
            assert_eq!(kind.has_part(PartOfOutput::Along), kind.is_path(), "{kind:?}");
            let words: Vec<String> = parts.iter().map(|part| kind.words_of_part(*part, "rod.tip")).collect();
            assert!(words.iter().all(|own| words.iter().filter(|other| *other == own).count() == 1), "{words:?}");
        }
    }
}
