//! Holding the loops of ideal joints after every step.

use crate::stepping::motion::Motion;
use loosepin_math::{GramSystem, Real};
use loosepin_mechanics::mechanism::Mechanism;

/// Newton steps on the positions; the first leaves the square of an error that is tiny already.
const STEPS: usize = 2;

/// Pulls coordinates and rates back onto the loops of ideal joints along the smallest change in the sense of kinetic energy:
/// q += M⁻¹Jᵀ(J M⁻¹ Jᵀ)⁻¹(-Φ), and the same for the rates with J q̇ + J_d ż_d.
pub struct Projection<T> {
    /// Factors of the mass matrix at the end of the step.
    mass: Vec<T>,
    residuals: Vec<T>,
    jacobian: Vec<T>,
    /// Defects of all rows, then their multipliers.
    defects: Vec<T>,
    gram: GramSystem<T>,
    correction: Vec<T>,
}

impl<T: Real> Projection<T> {
    /// Room for `mechanism`.
    pub fn new(mechanism: &Mechanism) -> Self {
        let tree = &mechanism.real;
        let rows = tree.constraint_rows();
        Self {
            mass: vec![T::zero(); tree.free * tree.free],
            residuals: vec![T::zero(); rows],
            jacobian: vec![T::zero(); rows * tree.coordinates()],
            defects: vec![T::zero(); rows],
            gram: GramSystem::new(tree.constraint_scales(), tree.free),
            correction: vec![T::zero(); tree.free],
        }
    }

    /// Whether there is anything to hold.
    pub fn is_needed(mechanism: &Mechanism) -> bool {
        mechanism.real.constraint_rows() > 0
    }

    /// Projects the state in place, with the mass matrix at the state itself.
    pub fn hold(&mut self, motion: &mut Motion<'_, T>, time_s: T, state: &mut [T]) {
        motion.evaluate(time_s, state);
        self.mass.copy_from_slice(motion.dynamics.factored_mass());
        let n = motion.freedoms();
        for _ in 0..STEPS {
            motion.set_state(time_s, state);
            motion.dynamics.constraint_residuals(&mut self.residuals);
            motion.dynamics.constraint_jacobian(&mut self.jacobian);
            self.defects.copy_from_slice(&self.residuals);
            self.smallest_change(motion);
            for k in 0..n {
                state[k] -= self.correction[k];
            }
        }
        motion.set_state(time_s, state);
        motion.dynamics.constraint_jacobian(&mut self.jacobian);
        motion.dynamics.constraint_rates(&self.jacobian, &mut self.defects);
        self.smallest_change(motion);
        for k in 0..n {
            state[n + k] -= self.correction[k];
        }
    }

    /// M⁻¹Jᵀ(J M⁻¹ Jᵀ)⁻¹ · defects.
    #[inline(always)]
    fn smallest_change(&mut self, motion: &Motion<'_, T>) {
        let columns = motion.dynamics.mechanism().real.coordinates();
        self.gram.set(&self.jacobian, columns, &self.mass, motion.freedoms());
        self.gram.solve(&mut self.defects);
        self.correction.fill(T::zero());
        self.gram.add_correction(&self.defects, &mut self.correction);
    }
}
