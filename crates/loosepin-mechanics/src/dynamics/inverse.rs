//! Inverse dynamics: what inertia and weight need along the references of the controls.

use super::bodies::add_efforts;
use crate::mechanism::{Kinematics, KnownChain, Sample, TimeDual, TreeNumbers};
use crate::model::Model;
use loosepin_math::{Numbers, Real};

/// The open chain that the controllers know, with room for an evaluation.
#[derive(Debug, Clone)]
pub struct InverseDynamics<'a, T: Real> {
    chain: &'a KnownChain,
    geometry: TreeNumbers<T>,
    kinematics: Kinematics<T>,
    coordinates: Vec<T>,
    rates: Vec<T>,
    accelerations: Vec<T>,
    /// Force or torque along each coordinate.
    efforts: Vec<T>,
}

impl<'a, T: Real> InverseDynamics<'a, T> {
    /// Room for `chain`.
    pub fn new(chain: &'a KnownChain) -> Self {
        let count = chain.tree.coordinates();
        Self {
            chain,
            geometry: TreeNumbers::broadcast(&chain.geometry),
            kinematics: Kinematics::new(&chain.tree),
            coordinates: vec![T::zero(); count],
            rates: vec![T::zero(); count],
            accelerations: vec![T::zero(); count],
            efforts: vec![T::zero(); count],
        }
    }

    /// Follows the drives and references of `sample` to `time_s` and works out the efforts along them:
    /// Σ m (a - g)·∂v/∂q̇_k + I α ∂ω/∂q̇_k over all bodies.
    #[inline(never)]
    pub fn evaluate(&mut self, model: &Model, sample: &Sample<T>, time_s: T, workspace: &mut [TimeDual<T>]) {
        let tree = &self.chain.tree;
        for k in 0..tree.drives.len() {
            let motion = match self.chain.control_of(model, k) {
                Some(control) => sample.references.law_motion(control, time_s, workspace),
                None => sample.drives.motion(tree.drives[k], time_s, workspace),
            };
            [self.coordinates[k], self.rates[k], self.accelerations[k]] = motion;
        }
        self.kinematics.set_positions(tree, &self.geometry, &self.coordinates);
        self.kinematics.set_velocities(tree, &self.rates);
        self.kinematics.set_biases(tree, &self.geometry, &self.rates, &self.accelerations);
        self.efforts.fill(T::zero());
        add_efforts(tree, &self.geometry, &self.kinematics, &mut self.efforts);
    }

    /// The effort of the actuator of a control at the last evaluation, N m or N.
    #[inline(always)]
    pub fn effort(&self, model: &Model, control: usize) -> T {
        let tree = &self.chain.tree;
        let coordinate = (0..tree.drives.len()).find(|&k| self.chain.control_of(model, k) == Some(control));
        coordinate.map_or(T::zero(), |k| self.efforts[k])
    }
}
