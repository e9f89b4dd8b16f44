//! The interface of a kind of coupling, and its terms.

use super::play::CouplingPlay;
use super::reading::CouplingReader;
use super::teeth::{Mesh, Teeth};
use crate::model::ids::JointId;
use crate::model::words::part_names::Names;
use loosepin_math::Real;
use loosepin_text::document::{Entry, Keys, Table};
use loosepin_text::numbers::QuantityId;

/// A kind of coupling: how the coordinate of the second joint follows from that of the first, q_2 = f(q_1).
///
/// The rest of the program asks these questions, and knows no kind by its name.
pub trait KindOfCoupling: Sized {
    /// The numbers of f.
    type Curve<T: Real>: Curve<T>;

    /// Word in files; of a kind with tables of its own, their name.
    const WORD: &'static str;
    /// Keys of its table.
    const KEYS: &'static Keys;

    /// Reads it from its table at `entry`; `None` after a diagnostic.
    fn read(entry: &Entry<'_>, table: &Table<'_>, reader: &mut dyn CouplingReader) -> Option<Coupled<Self>>;

    /// The quantities that shape f.
    fn quantities(&self) -> Vec<QuantityId>;

    /// The numbers of f, with those that `number` gives for its quantities.
    fn curve<T: Real>(&self, number: &dyn Fn(QuantityId) -> T) -> Self::Curve<T>;

    /// The pitch circles that must touch where both wheels are in mesh; `None` where the model states no radii, and of other kinds.
    fn pitch_circles(&self) -> Option<PitchCircles> {
        None
    }

    /// How the second joint follows, behind "follows 'first'": `times 2.5`.
    fn words(&self, names: &dyn Names) -> String;
}

/// Two pitch circles in mesh.
#[derive(Debug, Clone, Copy)]
pub struct PitchCircles {
    /// Their radii, m.
    pub radii_m: [QuantityId; 2],
    /// How they mesh.
    pub mesh: Mesh,
}

/// The numbers of f: what the constraints evaluate.
pub trait Curve<T: Real> {
    /// f, f' and f'' at `coordinate`.
    fn at(&self, coordinate: T) -> [T; 3];

    /// The number that is added to f, where play may displace the second joint.
    fn offset(&self) -> Option<T>;

    /// The same number, to be changed.
    fn offset_mut(&mut self) -> Option<&mut T>;

    /// How much faster than the first coordinate the second one changes, about, where a unit of the second counts `scale` of the first.
    fn gain(&self, scale: T) -> T;
}

/// A coupling as read from a file.
#[derive(Debug, Clone)]
pub struct Coupled<K> {
    /// The joint that is followed and the one that follows.
    pub joints: [JointId; 2],
    /// How it follows.
    pub kind: K,
    /// Absent for a coupling that is always ideal.
    pub play: Option<CouplingPlay>,
    /// There where the joints feel the force of the teeth.
    pub teeth: Option<Teeth>,
}

impl<K> Coupled<K> {
    /// Without play and teeth.
    pub fn without_play(joints: [JointId; 2], kind: K) -> Self {
        Self { joints, kind, play: None, teeth: None }
    }
}
