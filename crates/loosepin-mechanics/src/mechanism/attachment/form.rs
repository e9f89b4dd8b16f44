//! What every kind of attachment adds to a tree.

use crate::model::{JointId, Row};
use core::fmt::Debug;
use core::ops::Range;
use loosepin_math::Geometry;

/// A geometry with the attachments and the conditions of joints that there are in it.
pub trait TreeGeometry: Geometry {
    /// All of them.
    type Attachment: FormOfAttachment<Self>;
    /// All conditions that joints put on two bodies.
    type Row: Row;
}

/// How a body hangs on its parent, before it moves.
pub trait FormOfAttachment<G: Geometry>: Copy + Debug {
    /// The joint by which the body hangs on its parent, and whether the parent is the joint's first body; `None` for a body that hangs on
    /// nothing or is a section of a beam.
    fn joint(&self) -> Option<(JointId, bool)> {
        None
    }

    /// How many coordinates, and how many speeds, it adds.
    fn counts(&self) -> [usize; 2];

    /// Which of its coordinates are lengths; none if not said otherwise.
    fn lengths(&self) -> Range<usize> {
        0..0
    }

    /// Which of its coordinates is the angle of the body from the ground, where one is.
    fn angle(&self) -> Option<usize> {
        None
    }

    /// Whether the body may turn against its parent, so that its orientation has sines and cosines of its own.
    fn turns(&self) -> bool {
        true
    }
}
