//! Flexible links: bodies that bend and stretch between two of their points.

use super::quantity::QuantityId;
use loosepin_flexible::Frame;

/// What makes a body flexible. Its mass, its inertia and its centre of mass follow from it.
#[derive(Debug, Clone)]
pub struct Beam {
    /// Indices of its ends in [`crate::model::Body::points`]: `from`, then `to`.
    pub ends: [usize; 2],
    /// Length L between them, m, > 0.
    pub length_m: QuantityId,
    /// EA/L, N/m, > 0.
    pub axial_stiffness_n_m: QuantityId,
    /// EI/L, N m/rad, > 0.
    pub bending_stiffness_n_m: QuantityId,
    /// Damping ratio of every shape, >= 0; absent for a beam without damping.
    pub damping_ratio: Option<QuantityId>,
    /// The frame in which it is described.
    pub frame: Frame,
    /// Number of axial shapes.
    pub axial_shapes: usize,
    /// Number of lateral shapes.
    pub lateral_shapes: usize,
    /// Whether it becomes shorter where it bends.
    pub foreshortening: bool,
}
