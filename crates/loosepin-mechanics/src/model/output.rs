//! Outputs: what a run measures.

use super::ids::{Actuator, Axis, BodyId, JointId, PointId};
use super::wear::WearMeasure;
use loosepin_text::units::{Dimension, ReadableUnit};

/// An output column of a run.
#[derive(Debug, Clone)]
pub struct Output {
    /// Name in the file.
    pub name: String,
    /// The measured quantity.
    pub kind: OutputKind,
    /// The unit in which people read it.
    pub unit: ReadableUnit,
}

/// The quantity that an output measures.
#[derive(Debug, Clone)]
pub enum OutputKind {
    /// A position or angle, or one of its time derivatives.
    Motion {
        /// The position or angle.
        of: Position,
        /// Which derivative.
        derivative: Derivative,
    },
    /// Force of a joint on its journal's (slider's, second) body, N.
    Force {
        /// The joint.
        joint: JointId,
        /// Which component.
        component: Component,
    },
    /// Torque, force or power of a drive or control.
    Effort {
        /// The drive or control.
        actuator: Actuator,
        /// Which of them.
        effort: Effort,
    },
    /// Path of a point: two columns, x and y, m.
    Path(Relative<PointId>),
    /// Largest stress along a flexible body, Pa: bending and axial force at the outer fibre.
    Stress(BodyId),
    /// Wear of a joint after all cycles: one number of a run, without a history.
    Wear {
        /// The joint.
        joint: JointId,
        /// Which measure.
        measure: WearMeasure,
    },
}

/// A coordinate of a point or the angle of a body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Position {
    /// Coordinate of a point, m. Seen from a point of a body: from there, along an axis of that body.
    Point(Relative<PointId>, Axis),
    /// Angle of a body's x axis from that of the ground or of another body, continuous, rad.
    Angle(Relative<BodyId>),
}

/// Something that moves, and what it is seen from: `relative_to` in files.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Relative<T> {
    /// What moves.
    pub of: T,
    /// Where the observer sits; at the origin of the ground if absent.
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

/// A measure of what a drive or control does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Effort {
    /// Torque on the journal's body of a revolute joint, N m; the bearing's body gets the opposite.
    Torque,
    /// Force on the slider along the guide, or on the pin along its slot, N; the other body gets the opposite.
    Force,
    /// Power that it supplies, W: torque times angular velocity, or force times velocity, of its joint.
    Power,
}

/// A component of a force.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Component {
    /// Along the ground's x axis.
    X,
    /// Along the ground's y axis.
    Y,
    /// The length of the vector.
    Magnitude,
}

impl<T> Relative<T> {
    /// Seen from the ground.
    pub fn to_ground(of: T) -> Self {
        Self { of, to: None }
    }
}

impl OutputKind {
    /// Dimension of its columns.
    pub fn dimension(&self) -> Dimension {
        match self {
            Self::Motion { of: Position::Point(..), derivative } => match derivative {
                Derivative::Position => Dimension::LENGTH,
                Derivative::Velocity => Dimension::VELOCITY,
                Derivative::Acceleration => Dimension::ACCELERATION,
            },
            Self::Motion { of: Position::Angle(_), derivative } => match derivative {
                Derivative::Position => Dimension::ANGLE,
                Derivative::Velocity => Dimension::ANGULAR_VELOCITY,
                Derivative::Acceleration => Dimension::ANGULAR_ACCELERATION,
            },
            Self::Path(_) => Dimension::LENGTH,
            Self::Force { .. } => Dimension::FORCE,
            Self::Effort { effort, .. } => effort.dimension(),
            Self::Stress(_) => Dimension::PRESSURE,
            Self::Wear { measure, .. } => measure.dimension(),
        }
    }
}

impl Effort {
    /// Its dimension.
    pub fn dimension(self) -> Dimension {
        match self {
            Self::Torque => Dimension::TORQUE,
            Self::Force => Dimension::FORCE,
            Self::Power => Dimension::POWER,
        }
    }
}
