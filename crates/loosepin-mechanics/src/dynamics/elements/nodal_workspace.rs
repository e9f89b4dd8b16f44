//! Room for what the equations of motion need of a flexible body in absolute nodal coordinates.

use loosepin_flexible::Nodal;
use loosepin_math::{Real, Vec2};

/// Partial derivatives of position and slope of an end by a coordinate.
#[derive(Debug, Clone, Copy)]
pub(in crate::dynamics) struct Column<T> {
    pub(in crate::dynamics) coordinate: usize,
    pub(in crate::dynamics) position: Vec2<T>,
    pub(in crate::dynamics) slope: Vec2<T>,
}

/// Room for a flexible body.
#[derive(Debug, Clone)]
pub(in crate::dynamics) struct NodalWorkspace<T> {
    /// Nodes at the last state that was set.
    pub(in crate::dynamics) nodes: Vec<Nodal<T>>,
    /// Rates of the nodes.
    pub(in crate::dynamics) rates: Vec<Nodal<T>>,
    /// Forces on the nodes without those of accelerations of the free coordinates.
    pub(in crate::dynamics) forces: Vec<Nodal<T>>,
    /// Columns of root and tip.
    pub(in crate::dynamics) ends: [Vec<Column<T>>; 2],
}

impl<T: Real> NodalWorkspace<T> {
    /// For a number of nodes, with the number of coordinates on which the frame depends.
    pub(in crate::dynamics) fn new(nodes: usize, dependences: usize) -> Self {
        let of = |count: usize| vec![Column { coordinate: 0, position: Vec2::zero(), slope: Vec2::zero() }; count];
        let workspace = || vec![Nodal::zero(); nodes];
        Self { nodes: workspace(), rates: workspace(), forces: workspace(), ends: [of(dependences + 1), of(4)] }
    }
}
