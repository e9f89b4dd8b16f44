//! Room for what the equations of motion need of a flexible body.

use crate::mechanism::TreeBeam;
use loosepin_flexible::Inertia;
use loosepin_math::Real;

/// Room for a flexible body.
#[derive(Debug, Clone)]
pub(in crate::dynamics) struct BeamWorkspace<T> {
    /// M and h at the last evaluation.
    pub(in crate::dynamics) inertia: Inertia<T>,
    /// M T, row by row of T: one for each coordinate on which the frame depends.
    pub(in crate::dynamics) carried: Vec<T>,
    /// Forces over (V, ω, q̇).
    pub(in crate::dynamics) forces: Vec<T>,
}

impl<T: Real> BeamWorkspace<T> {
    pub(in crate::dynamics) fn new(beam: &TreeBeam, dependences: usize) -> Self {
        let inertia = Inertia::new(&beam.shapes);
        let size = inertia.size;
        Self { inertia, carried: vec![T::zero(); dependences * size], forces: vec![T::zero(); size] }
    }
}
