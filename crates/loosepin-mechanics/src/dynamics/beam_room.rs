//! Room for what the equations of motion need of a flexible body.

use crate::mechanism::TreeBeam;
use loosepin_flexible::Inertia;
use loosepin_math::Real;

/// Room for a flexible body.
#[derive(Debug, Clone)]
pub(super) struct BeamRoom<T> {
    /// M and h at the last evaluation.
    pub(super) inertia: Inertia<T>,
    /// M T, row by row of T: one for each coordinate on which the frame depends.
    pub(super) carried: Vec<T>,
    /// Forces over (V, ω, q̇).
    pub(super) forces: Vec<T>,
}

impl<T: Real> BeamRoom<T> {
    pub(super) fn new(beam: &TreeBeam, dependences: usize) -> Self {
        let inertia = Inertia::new(&beam.shapes);
        let size = inertia.size;
        Self { inertia, carried: vec![T::zero(); dependences * size], forces: vec![T::zero(); size] }
    }
}
