//! A position or angle, or one of its time derivatives.

use super::kind::{KindOfOutput, KindOfReading, Measure};
use super::position::{Derivative, Position, relative_body, relative_point, relative_words};
use super::reader::{NeededKey, OutputReader, needed_choice};
use super::state::OutputState;
use crate::model::ids::{Axis, BodyId, PointId};
use crate::model::words::part_names::PartNames;
use loosepin_math::Real;
use loosepin_text::document::{Key, Kind, Table, optional};
use loosepin_text::units::Dimension;

/// A position or angle, or one of its time derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Motion {
    /// The position or angle.
    pub of: Position,
    /// Which derivative.
    pub derivative: Derivative,
}

impl Motion {
    /// The position or angle itself, m or rad.
    pub const fn position(of: Position) -> Self {
        Self { of, derivative: Derivative::Position }
    }

    /// Its velocity, m/s or rad/s.
    pub const fn velocity(of: Position) -> Self {
        Self { of, derivative: Derivative::Velocity }
    }

    /// Its acceleration, m/s² or rad/s².
    pub const fn acceleration(of: Position) -> Self {
        Self { of, derivative: Derivative::Acceleration }
    }
}

const fn of_point(name: &'static str, doc: &'static str) -> Measure {
    Measure { key: optional(name, Kind::Point, "\"slider.pin\"", doc), beside: &["along", "relative_to"] }
}

const fn of_body(name: &'static str, doc: &'static str) -> Measure {
    Measure { key: optional(name, Kind::Reference("body"), "\"rod\"", doc), beside: &["relative_to"] }
}

impl KindOfOutput for Motion {
    const MEASURES: &'static [Measure] = &[
        of_point("position_of", "a coordinate of a point"),
        of_point("velocity_of", "a velocity of a point"),
        of_point("acceleration_of", "an acceleration of a point"),
        of_body("angle_of", "the angle of a body"),
        of_body("angular_velocity_of", "the angular velocity of a body"),
        of_body("angular_acceleration_of", "the angular acceleration of a body"),
    ];
    const KEYS: &'static [Key] = &[
        optional("along", Kind::Choice(&["x", "y"]), ALONG.example, ALONG.doc),
        optional(
            "relative_to",
            Kind::Reference("point or body"),
            "\"crank.pin\"",
            "reference of the motion: a point of a body, or for angles a body; the ground if omitted",
        ),
    ];
    type Reading = Self;

    fn read(measure: &'static str, table: &Table<'_>, reader: &mut dyn OutputReader) -> Option<Self> {
        let entry = table.get(measure)?;
        let derivative = match measure {
            "position_of" | "angle_of" => Derivative::Position,
            "velocity_of" | "angular_velocity_of" => Derivative::Velocity,
            "acceleration_of" | "angular_acceleration_of" => Derivative::Acceleration,
            _ => return None,
        };
        let of = if matches!(measure, "position_of" | "velocity_of" | "acceleration_of") {
            let along = needed_choice(reader, table, &ALONG, &[("x", Axis::X), ("y", Axis::Y)]);
            let point = relative_point(reader, table, &entry);
            Position::Point(point?, along?)
        } else {
            Position::Angle(relative_body(reader, table, &entry)?)
        };
        Some(Self { of, derivative })
    }

    fn dimension(&self) -> Dimension {
        self.of.dimension(self.derivative)
    }

    fn reading(&self) -> Option<Self> {
        Some(*self)
    }

    fn drawn_point(&self) -> Option<PointId> {
        match *self {
            Self { of: Position::Point(point, _), derivative: Derivative::Position } => Some(point.of),
            _ => None,
        }
    }
}

impl KindOfReading for Motion {
    fn words(&self, names: &dyn PartNames) -> String {
        let [of_point, of_angle] = match self.derivative {
            Derivative::Position => ["", "angle"],
            Derivative::Velocity => [" velocity", "angular velocity"],
            Derivative::Acceleration => [" acceleration", "angular acceleration"],
        };
        match self.of {
            Position::Point(point, Axis::X) => format!("x{of_point} of {}", relative_words(names, point)),
            Position::Point(point, Axis::Y) => format!("y{of_point} of {}", relative_words(names, point)),
            Position::Angle(body) => {
                let name = |body: BodyId| names.body(body);
                let own = format!("{of_angle} of {}", name(body.of));
                body.to.map_or(own.clone(), |to| format!("{own} relative to {}", name(to)))
            }
        }
    }

    fn needs_forces(&self) -> bool {
        self.derivative == Derivative::Acceleration
    }

    #[inline(always)]
    fn value<T: Real>(&self, state: &impl OutputState<T>) -> T {
        match self.derivative {
            Derivative::Position => state.position(self.of),
            Derivative::Velocity => state.velocity(self.of),
            Derivative::Acceleration => state.acceleration(self.of),
        }
    }

    fn position(&self) -> Option<Position> {
        (self.derivative == Derivative::Position).then_some(self.of)
    }

    fn motion_of(&self) -> Option<Position> {
        Some(self.of)
    }
}

const ALONG: NeededKey =
    NeededKey { key: "along", example: "\"x\"", doc: "the axis of the ground, or of the body of relative_to" };
