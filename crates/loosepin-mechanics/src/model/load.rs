//! Loads: forces and torques from outside.

use super::function::Function;
use super::ids::{BodyId, JointId, PointId};
use super::load_table::LoadTable;
use super::quantity::QuantityId;

/// A force or a torque from outside; the ground gets nothing in return.
#[derive(Debug, Clone)]
pub struct Load {
    /// Name in the file.
    pub name: String,
    /// Its kind, with the point or body that it acts on.
    pub kind: LoadKind,
    /// Its size over time.
    pub course: Course,
    /// The joint whose coordinate and rate its size is over.
    pub joint: Option<JointId>,
}

/// The kinds of load.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LoadKind {
    /// A force on a point.
    Force {
        /// The point.
        point: PointId,
        /// Its direction, rad, from the x axis of the ground or of the body.
        direction_rad: QuantityId,
        /// Whether the direction turns with the body.
        follows_body: bool,
    },
    /// A torque on a body.
    Torque {
        /// The body.
        body: BodyId,
    },
}

impl LoadKind {
    /// The body that it acts on.
    pub fn body(&self) -> BodyId {
        match *self {
            Self::Force { point, .. } => point.body,
            Self::Torque { body } => body,
        }
    }
}

/// How something changes with time.
#[derive(Debug, Clone)]
pub enum Course {
    /// Not at all.
    Constant(QuantityId),
    /// mean + amplitude sin(2π frequency t + phase).
    Harmonic {
        /// Its middle.
        mean: QuantityId,
        /// Largest departure from the middle.
        amplitude: QuantityId,
        /// Oscillations in a second, 1/s, > 0.
        frequency: QuantityId,
        /// At time zero, rad.
        phase_rad: QuantityId,
    },
    /// By a function of the time, then of the coordinate and the rate of a joint where the load names one.
    Function(Function),
    /// By points.
    Table(LoadTable),
}
