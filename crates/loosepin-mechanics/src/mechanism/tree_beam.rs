//! Flexible links in the tree.
//!
//! The frame of a flexible body is a link like that of a rigid one. The sections at its ends are links of their own that hang on it: each
//! is the frame of the body as that section carries it, so that a point of the body at an end is where it was in a rigid body. Joints,
//! springs and forces at an end act on the link of its section; that a force on it bends the beam follows from its partial velocities.

use crate::model::{Beam, BodyId, Model};
use loosepin_flexible::{Shapes, Station, stations};
use std::ops::Range;
use std::sync::Arc;

/// An end of a beam, counted from where it hangs on its parent.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BeamEnd {
    /// x = 0.
    Root,
    /// x = L.
    Tip,
}

/// A flexible body in the tree.
#[derive(Debug, Clone)]
pub struct TreeBeam {
    /// The body.
    pub body: BodyId,
    /// Indices of its `from` and its `to` among the points of the body.
    pub ends: [usize; 2],
    /// Slot of its frame.
    pub slot: usize,
    /// Slots of the sections at its `from` and at its `to`; of a tangent frame the section at the root is the frame itself.
    pub sections: [usize; 2],
    /// Whether its root is its `to`: it hangs on its parent there.
    pub is_reversed: bool,
    /// Coordinates of the shapes: axial ones, m, then lateral ones, rad.
    pub coordinates: Range<usize>,
    /// The shapes.
    pub shapes: Arc<Shapes>,
    /// Whether it has damping.
    pub is_damped: bool,
}

impl TreeBeam {
    /// The shapes at an end.
    pub fn station(&self, end: BeamEnd) -> &Station {
        match end {
            BeamEnd::Root => &self.shapes.root,
            BeamEnd::Tip => &self.shapes.tip,
        }
    }

    /// The coordinates that are lengths.
    pub fn axial(&self) -> Range<usize> {
        self.coordinates.start..self.coordinates.start + self.shapes.axial()
    }

    /// φ/L of each lateral shape at `count` >= 2 places evenly from root to tip.
    pub fn lateral_shapes(&self, model: &Model, count: usize) -> Vec<Vec<f64>> {
        let Some(beam) = &model.bodies[self.body.0].beam else { return Vec::new() };
        let shares: Vec<f64> = (0..count).map(|place| place as f64 / (count - 1) as f64).collect();
        let places = stations(beam.frame, beam.axial_shapes, beam.lateral_shapes, &shares);
        (0..beam.lateral_shapes).map(|shape| places.iter().map(|place| place.lateral[shape]).collect()).collect()
    }

    /// Indices of the points at root and tip.
    pub fn points(&self) -> [usize; 2] {
        if self.is_reversed { [self.ends[1], self.ends[0]] } else { self.ends }
    }
}

/// The shapes of a beam of the model.
pub(super) fn shapes_of(beam: &Beam) -> Shapes {
    Shapes::new(beam.frame, beam.axial_shapes, beam.lateral_shapes)
}
