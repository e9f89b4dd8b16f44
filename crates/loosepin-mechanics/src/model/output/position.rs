//! Positions and angles, and what they are seen from.

use super::reader::OutputReader;
use crate::model::ids::{Axis, BodyId, PointId};
use crate::model::problem::ModelProblem;
use crate::model::words::part_names::PartNames;
use loosepin_text::document::{Entry, Table};
use loosepin_text::units::Dimension;

/// A coordinate of a point or the angle of a body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Position {
    /// Coordinate of a point, m. Seen from a point of a body: from there, along an axis of that body.
    Point(Relative<PointId>, Axis),
    /// Angle of a body's x axis from that of the ground or of another body, continuous, rad.
    Angle(Relative<BodyId>),
}

/// A moving object and its observer: `relative_to` in files.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Relative<T> {
    /// The observed object.
    pub of: T,
    /// The observer; the origin of the ground if absent.
    pub to: Option<T>,
}

/// A position or one of its derivatives by time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Derivative {
    /// The position or angle itself.
    Position,
    /// Velocity, per second.
    Velocity,
    /// Acceleration, per second².
    Acceleration,
}

impl Position {
    /// Dimension of it or of its derivative.
    pub fn dimension(self, derivative: Derivative) -> Dimension {
        match (self, derivative) {
            (Self::Point(..), Derivative::Position) => Dimension::LENGTH,
            (Self::Point(..), Derivative::Velocity) => Dimension::VELOCITY,
            (Self::Point(..), Derivative::Acceleration) => Dimension::ACCELERATION,
            (Self::Angle(_), Derivative::Position) => Dimension::ANGLE,
            (Self::Angle(_), Derivative::Velocity) => Dimension::ANGULAR_VELOCITY,
            (Self::Angle(_), Derivative::Acceleration) => Dimension::ANGULAR_ACCELERATION,
        }
    }
}

impl<T> Relative<T> {
    /// Seen from the ground.
    pub fn to_ground(of: T) -> Self {
        Self { of, to: None }
    }
}

/// A point in words: `slider.pin`, or `rod.tip relative to crank.pin`.
pub fn relative_words(names: &dyn PartNames, point: Relative<PointId>) -> String {
    let own = names.point(point.of);
    point.to.map_or(own.clone(), |to| format!("{own} relative to {}", names.point(to)))
}

/// The point that `entry` names, and the one under `relative_to`.
pub(super) fn relative_point(
    reader: &mut dyn OutputReader,
    table: &Table<'_>,
    entry: &Entry<'_>,
) -> Option<Relative<PointId>> {
    let of = reader.point(entry);
    let Some(beside) = table.get("relative_to") else { return of.map(Relative::to_ground) };
    let to = reader.point(&beside);
    let (of, to) = (of?, to?);
    refuse_same_body(reader, &beside, of.body, to.body)?;
    Some(Relative { of, to: Some(to) })
}

/// The body that `entry` names, and the one under `relative_to`.
pub(super) fn relative_body(
    reader: &mut dyn OutputReader,
    table: &Table<'_>,
    entry: &Entry<'_>,
) -> Option<Relative<BodyId>> {
    let of = reader.body(entry);
    let Some(beside) = table.get("relative_to") else { return of.map(Relative::to_ground) };
    let to = reader.body(&beside);
    let (of, to) = (of?, to?);
    refuse_same_body(reader, &beside, of, to)?;
    Some(Relative { of, to: Some(to) })
}

/// Reports an observer that is on the same body as the observed object.
fn refuse_same_body(reader: &mut dyn OutputReader, beside: &Entry<'_>, of: BodyId, to: BodyId) -> Option<()> {
    if of != to {
        return Some(());
    }
    let problem = ModelProblem::RelativeToItself { entry: beside.path.describe(), body: reader.body_name(to) };
    reader.document().refuse(&problem, beside.span)
}
