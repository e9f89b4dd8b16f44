//! Flexible links in absolute nodal coordinates in the tree.
//!
//! Its section at the root is a link that hangs on its parent like a rigid body. The section at the tip is a link that
//! hangs on nothing. Both have polar coordinates of the slope, r' = s (cos θ, sin θ): θ is the angle of the link, so that what is attached
//! there turns with it and a clamped end keeps its direction and stretches; s is a coordinate of the beam. Nodes between have x and y of
//! position and slope.

use crate::model::BodyId;
use loosepin_flexible::Mesh;
use std::ops::Range;
use std::sync::Arc;

/// A flexible body in absolute nodal coordinates in the tree.
#[derive(Debug, Clone)]
pub struct TreeNodalBeam {
    /// The body.
    pub body: BodyId,
    /// Indices of its `from` and its `to` among the points of the body.
    pub ends: [usize; 2],
    /// Slot of the section at its root.
    pub slot: usize,
    /// Slot of the section at its tip.
    pub tip_slot: usize,
    /// Whether its root is its `to`: it hangs on its parent there.
    pub is_reversed: bool,
    /// Its own coordinates: s of the root; x, y of position and slope of each node between; x, y, θ and s of the tip.
    pub coordinates: Range<usize>,
    /// Its elements.
    pub mesh: Arc<Mesh>,
    /// Whether it has damping.
    pub is_damped: bool,
}

impl TreeNodalBeam {
    /// Coordinate s of the slope at the root.
    pub fn root_stretch(&self) -> usize {
        self.coordinates.start
    }

    /// Coordinate s of the slope at the tip.
    pub fn tip_stretch(&self) -> usize {
        self.coordinates.end - 1
    }

    /// First of the four coordinates of a node, from 1 on; the last node is the tip.
    pub fn node(&self, node: usize) -> usize {
        self.coordinates.start + 4 * node - 3
    }

    /// The coordinates that are lengths: two for each node but the root.
    pub fn lengths(&self) -> impl Iterator<Item = Range<usize>> {
        (1..self.mesh.nodes()).map(|node| self.node(node)..self.node(node) + 2)
    }

    /// Indices of the points at root and tip.
    pub fn points(&self) -> [usize; 2] {
        if self.is_reversed { [self.ends[1], self.ends[0]] } else { self.ends }
    }

    /// Slot of the section at a point of the body, where the point is an end.
    pub fn section(&self, point: usize) -> Option<usize> {
        let [root, tip] = self.points();
        if point == root {
            Some(self.slot)
        } else if point == tip {
            Some(self.tip_slot)
        } else {
            None
        }
    }

    /// Lowers the first column of each row of a mass matrix to what the elements couple: each node with those beside it. `root`: the
    /// coordinates on which the frame of the body depends.
    pub(in crate::mechanism) fn widen(&self, root: impl Iterator<Item = usize>, first: &mut [usize]) {
        let free = first.len();
        let mut before: Vec<usize> =
            root.filter(|coordinate| *coordinate < free).chain([self.root_stretch()]).collect();
        for node in 1..self.mesh.nodes() {
            let own: Vec<usize> = (self.node(node)..self.node(node) + 4).collect();
            let coupled = || before.iter().chain(&own).copied();
            let least = coupled().min().unwrap_or(0);
            coupled().for_each(|coordinate| first[coordinate] = first[coordinate].min(least));
            before = own;
        }
    }
}
