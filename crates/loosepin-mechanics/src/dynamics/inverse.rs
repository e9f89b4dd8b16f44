//! Inverse dynamics: what inertia and weight need along the references of the controls.

use crate::mechanism::{Geometry, Kinematics, KnownChain, Sample, TimeDual, acceleration_at, moved, turned_by};
use crate::model::Model;
use loosepin_math::{Numbers, Real, Vec2};

/// The open chain that the controllers know, with room for an evaluation.
#[derive(Debug, Clone)]
pub struct InverseDynamics<'a, T> {
    chain: &'a KnownChain,
    geometry: Geometry<T>,
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
            geometry: Geometry::broadcast(&chain.geometry),
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
        for (index, (link, numbers)) in tree.links.iter().zip(&self.geometry.links).enumerate() {
            let slot = index + 1;
            let arm = self.kinematics.poses[slot].turn(numbers.centre_of_mass_m);
            let bias = self.kinematics.biases[slot];
            let acceleration = acceleration_at(&bias, &self.kinematics.twists[slot], arm);
            let force: Vec2<T> = (acceleration - self.geometry.gravity_m_s2) * numbers.mass_kg;
            let moment = numbers.inertia_kg_m2 * bias.angular;
            for (dependence, partial) in link.dependences.iter().zip(self.kinematics.partials(slot)) {
                let velocity = moved(*partial, arm.turned(), dependence.turning);
                let to = &mut self.efforts[dependence.coordinate];
                let sum = turned_by(*to, moment, dependence.turning);
                *to = force.x.mul_add(velocity.x, force.y.mul_add(velocity.y, sum));
            }
        }
    }

    /// The effort of the actuator of a control at the last evaluation, N m or N.
    #[inline(always)]
    pub fn effort(&self, model: &Model, control: usize) -> T {
        let tree = &self.chain.tree;
        let coordinate = (0..tree.drives.len()).find(|&k| self.chain.control_of(model, k) == Some(control));
        coordinate.map_or(T::zero(), |k| self.efforts[k])
    }
}
