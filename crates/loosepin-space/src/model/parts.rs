//! What a model of a mechanism in space is made of. Each number is a quantity.

use super::direction::Direction;
use crate::kind::SpatialKind;
use crate::kind::kind_of_joint::KindOfJoint;
use crate::mechanism::drive::JointCoordinate;
use loosepin_text::diagnostics::{Diagnostic, Source, Span};
use loosepin_text::numbers::{QuantityId, QuantityTable};
use std::collections::HashMap;
use std::sync::Arc;

/// A checked model of a mechanism in space.
#[derive(Debug, Clone)]
pub struct SpatialModel {
    /// Its name.
    pub name: String,
    /// Every number of it.
    pub quantities: QuantityTable,
    /// Acceleration of gravity, m/s²; nothing that is computed uses it yet.
    pub gravity_m_s2: Option<[QuantityId; 3]>,
    /// The bodies, the ground first.
    pub bodies: Vec<ModelBody>,
    /// The joints.
    pub joints: Vec<ModelJoint>,
    /// The drives.
    pub drives: Vec<ModelDrive>,
    /// Where bodies are at the start, as far as the file says it.
    pub guesses: Vec<ModelGuess>,
    /// The turn over which it is moved.
    pub cycle: Option<ModelCycle>,
    /// The outputs, in their order.
    pub outputs: Vec<ModelOutput>,
    /// Likely mistakes.
    pub warnings: Vec<Diagnostic>,
    pub(super) source: Arc<Source>,
    pub(super) places: HashMap<String, Span>,
}

/// A body with its named points and axes.
#[derive(Debug, Clone)]
pub struct ModelBody {
    /// Its name.
    pub name: String,
    /// Its mass, kg; nothing that is computed uses it yet, nor the next two.
    pub mass_kg: Option<QuantityId>,
    /// Its centre of mass, m.
    pub centre_of_mass_m: Option<[QuantityId; 3]>,
    /// Inertia about the centre of mass: xx, yy, zz, and xy, xz, yz where the axes are not principal ones, kg m².
    pub inertia_kg_m2: Vec<QuantityId>,
    /// Its points.
    pub points: Vec<ModelPoint>,
    /// Its named axes.
    pub axes: Vec<(String, Direction)>,
}

/// A named point of a body.
#[derive(Debug, Clone)]
pub struct ModelPoint {
    /// Its name.
    pub name: String,
    /// In the frame of the body, m.
    pub position_m: [QuantityId; 3],
}

/// A point of a body, by their places in the lists.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PointId {
    /// The body; 0 is the ground.
    pub body: usize,
    /// The point of it.
    pub point: usize,
}

/// A joint.
#[derive(Debug, Clone)]
pub struct ModelJoint {
    /// Its name.
    pub name: String,
    /// Its kind.
    pub form: ModelJointForm,
    /// The marker of the bearing.
    pub bearing: ModelMarker,
    /// The marker of the journal.
    pub journal: ModelMarker,
    /// Its play; `None` for an ideal joint.
    pub play: Option<ModelPlay>,
}

/// The kind of a joint with its numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ModelJointForm {
    /// A kind without a number of its own.
    Plain(SpatialKind),
    /// A screw.
    Screw {
        /// Advance in one turn, m.
        pitch_m: QuantityId,
    },
}

impl ModelJointForm {
    /// The word for its kind.
    pub fn word(&self) -> &'static str {
        self.with_pitch(|_| 1.0).word()
    }

    /// Keys of a file that give a joint of this kind play; none where it has none.
    pub fn play_keys(&self) -> &'static [&'static str] {
        self.with_pitch(|_| 1.0).play_keys()
    }

    /// Whether both bodies move as one.
    pub(super) fn is_rigid(&self) -> bool {
        self.with_pitch(|_| 1.0).freedoms() == 0
    }

    /// The kind, with the pitch of a screw.
    pub(super) fn with_pitch(&self, pitch_m: impl Fn(QuantityId) -> f64) -> SpatialKind {
        match self {
            Self::Plain(kind) => *kind,
            Self::Screw { pitch_m: id } => SpatialKind::screw(pitch_m(*id)),
        }
    }
}

/// Where a joint is on a body.
#[derive(Debug, Clone, Copy)]
pub struct ModelMarker {
    /// The point.
    pub point: PointId,
    /// z of the marker: the axis of the joint.
    pub axis: Direction,
    /// x of the marker, as far as it is across the axis; `None` for the default.
    pub across: Option<Direction>,
    /// Errors of manufacture.
    pub misalignment: ModelMisalignment,
}

/// How far a marker is from where it should be on its body, along its own axes x, y and z; nothing where the file does not say it.
#[derive(Debug, Clone, Copy, Default)]
pub struct ModelMisalignment {
    /// Displacement of its point, m.
    pub shift_m: Option<[QuantityId; 3]>,
    /// Rotation vector about its point, rad.
    pub tilt_rad: Option<[QuantityId; 3]>,
}

/// Play of a joint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ModelPlay {
    /// A pin in a bearing between two stops.
    Pin {
        /// Length of the bearing, m.
        bearing_length_m: QuantityId,
        /// Radius of the bearing minus radius of the pin, m.
        radial_clearance_m: QuantityId,
        /// From the middle to either stop, m.
        axial_clearance_m: QuantityId,
    },
    /// A shaft in a bearing without stops.
    Shaft {
        /// Length of the bearing, m.
        bearing_length_m: QuantityId,
        /// Radius of the bearing minus radius of the shaft, m.
        radial_clearance_m: QuantityId,
    },
    /// A ball in a socket.
    Ball {
        /// Radius of the socket minus radius of the ball, m.
        radial_clearance_m: QuantityId,
    },
}

impl ModelPlay {
    /// The length of the bearing; `None` of a ball.
    pub fn bearing_length_m(&self) -> Option<QuantityId> {
        match *self {
            Self::Pin { bearing_length_m, .. } | Self::Shaft { bearing_length_m, .. } => Some(bearing_length_m),
            Self::Ball { .. } => None,
        }
    }

    /// The radial clearance, and that along the axis.
    pub fn clearances_m(&self) -> [Option<QuantityId>; 2] {
        match *self {
            Self::Pin { radial_clearance_m, axial_clearance_m, .. } => {
                [Some(radial_clearance_m), Some(axial_clearance_m)]
            }
            Self::Shaft { radial_clearance_m, .. } | Self::Ball { radial_clearance_m } => {
                [Some(radial_clearance_m), None]
            }
        }
    }
}

/// A joint that is moved at constant speed.
#[derive(Debug, Clone)]
pub struct ModelDrive {
    /// Its name.
    pub name: String,
    /// The joint.
    pub joint: usize,
    /// Which coordinate of it.
    pub coordinate: JointCoordinate,
    /// Its speed, rad/s or m/s.
    pub speed: QuantityId,
    /// Its place at time zero, rad or m.
    pub start: QuantityId,
}

/// Where a body is at the start.
#[derive(Debug, Clone)]
pub struct ModelGuess {
    /// The body.
    pub body: usize,
    /// Origin of its frame in that of the ground, m.
    pub at_m: [QuantityId; 3],
    /// Turns in their order, each about an axis of the body as the turns before left it: the axis, and the angle, rad.
    pub turned: Vec<(Direction, QuantityId)>,
}

/// What a turn of the mechanism is, and in how many steps it is looked at.
#[derive(Debug, Clone, Copy)]
pub struct ModelCycle {
    /// What is counted.
    pub span: ModelCycleSpan,
    /// Positions in a turn.
    pub samples_per_turn: usize,
}

/// What a turn is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ModelCycleSpan {
    /// A turn of this drive.
    Drive(usize),
    /// This time, s.
    Duration(QuantityId),
}

/// An output.
#[derive(Debug, Clone)]
pub struct ModelOutput {
    /// Its name.
    pub name: String,
    /// What is read off.
    pub kind: ModelOutputKind,
}

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

impl ModelOutputKind {
    /// The body that it is read off.
    pub fn body(self) -> usize {
        match self {
            Self::Position { point, .. } | Self::Path { point } => point.body,
            Self::Turn { body, .. } | Self::Orientation { body } => body,
        }
    }

    /// Whether it is a displacement or a rotation with three components, and no number.
    pub fn is_vector(self) -> bool {
        matches!(self, Self::Path { .. } | Self::Orientation { .. })
    }
}
