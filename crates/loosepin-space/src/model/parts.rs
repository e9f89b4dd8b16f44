//! What a model of a mechanism in space is made of. Each number is a quantity.

use super::direction::Direction;
use super::marker::ModelMarker;
use super::output::ModelOutputKind;
use crate::kind::{SpatialKind, SpatialPlay};
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
    /// Acceleration of gravity, m/s².
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

impl SpatialModel {
    /// The quantities that nothing which is computed uses yet: gravity, and masses with where they are.
    pub fn unused_quantities(&self) -> impl Iterator<Item = QuantityId> {
        let of_body = |body: &ModelBody| {
            let centre = body.centre_of_mass_m.into_iter().flatten();
            body.mass_kg.into_iter().chain(centre).chain(body.inertia_kg_m2.clone())
        };
        self.gravity_m_s2.into_iter().flatten().chain(self.bodies.iter().flat_map(of_body))
    }
}

/// A body with its named points and axes.
#[derive(Debug, Clone)]
pub struct ModelBody {
    /// Its name.
    pub name: String,
    /// Its mass, kg.
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

/// A joint.
#[derive(Debug, Clone)]
pub struct ModelJoint {
    /// Its name.
    pub name: String,
    /// Its kind, with numbers that say nothing: those of the model are `numbers`.
    pub kind: SpatialKind,
    /// The numbers of its kind.
    pub numbers: Vec<QuantityId>,
    /// The marker of the bearing.
    pub bearing: ModelMarker,
    /// The marker of the journal.
    pub journal: ModelMarker,
    /// Its play; `None` for an ideal joint.
    pub play: Option<SpatialPlay<QuantityId>>,
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
