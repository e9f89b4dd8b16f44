//! The state vector of a run and its derivative.

use crate::dynamics::{Dynamics, PlayForce, PlayState};
use crate::integrate::System;
use crate::math::{factor_ldl, solve_ldl};
use crate::mechanism::{Attachment, Mechanism, Sample};

/// Unknowns of the energy account after coordinates and rates: work of the drives, contact loss, friction loss, J.
pub const ACCOUNT: usize = 3;

/// Equations of motion plus the energy account as a system: y = (q, q̇, work, contact loss, friction loss).
pub struct Motion<'a> {
    /// The equations.
    pub dynamics: Dynamics<'a, f64>,
    /// Contact states of the joints with play.
    pub states: Vec<PlayState<f64>>,
    freedoms: usize,
}

impl<'a> Motion<'a> {
    /// With every joint in flight.
    pub fn new(mechanism: &'a Mechanism, sample: &'a Sample<f64>) -> Self {
        Self {
            dynamics: Dynamics::new(mechanism, sample),
            states: vec![PlayState::flight(); mechanism.plays.len()],
            freedoms: mechanism.real.free,
        }
    }

    /// Number of free coordinates.
    pub fn freedoms(&self) -> usize {
        self.freedoms
    }

    /// Sets positions and velocities from the state vector, without forces.
    pub fn set_state(&mut self, time_s: f64, state: &[f64]) {
        let n = self.freedoms;
        self.dynamics.set_state(time_s, &state[..n], &state[n..2 * n]);
    }

    /// Sets positions and velocities and evaluates all forces and accelerations.
    pub fn evaluate(&mut self, time_s: f64, state: &[f64]) {
        let n = self.freedoms;
        self.dynamics.evaluate(time_s, &state[..n], &state[n..2 * n], &self.states);
    }

    /// Force in the joint with play `play` at the state set last.
    pub fn play_force(&self, play: usize) -> PlayForce<f64> {
        self.dynamics.play_force(play, &self.states[play])
    }
}

impl System for Motion<'_> {
    fn derivative(&mut self, time_s: f64, state: &[f64], slope: &mut [f64]) {
        let n = self.freedoms;
        self.evaluate(time_s, state);
        slope[..n].copy_from_slice(&state[n..2 * n]);
        slope[n..2 * n].copy_from_slice(self.dynamics.accelerations());
        let powers = self.dynamics.powers();
        slope[2 * n] = powers.drives_w;
        slope[2 * n + 1] = powers.contact_loss_w;
        slope[2 * n + 2] = powers.friction_loss_w;
    }
}

/// Local error tolerances of all unknowns for a local error of `local_m` in lengths.
///
/// Angles: divided by the size of the mechanism. Velocities: times the rate of the fastest drive. Energies: the same
/// share of `energy_j` as a length has of the size.
pub fn tolerances(mechanism: &Mechanism, local_m: f64, rate_1_s: f64, energy_j: f64) -> Vec<f64> {
    let tree = &mechanism.real;
    let n = tree.free;
    let local_rad = local_m / mechanism.size_m;
    let mut tolerances = vec![local_rad; 2 * n + ACCOUNT];
    for link in &tree.links {
        match link.attachment {
            Attachment::Prismatic { coordinate, .. } if coordinate < n => tolerances[coordinate] = local_m,
            Attachment::Free { first } => tolerances[first..first + 2].fill(local_m),
            _ => {}
        }
    }
    for k in 0..n {
        tolerances[n + k] = tolerances[k] * rate_1_s;
    }
    tolerances[2 * n..].fill(local_rad * energy_j);
    tolerances
}

/// Pulls coordinates and rates back onto the loops of ideal joints along the smallest change in the sense of kinetic energy:
/// q += M⁻¹Jᵀ(J M⁻¹ Jᵀ)⁻¹(-Φ), and the same for the rates with J q̇ + J_d ż_d. Gives the largest residual Φ that was left.
pub struct Projection {
    residuals: Vec<f64>,
    jacobian: Vec<f64>,
}

impl Projection {
    /// Room for `mechanism`.
    pub fn new(mechanism: &Mechanism) -> Self {
        let tree = &mechanism.real;
        Self {
            residuals: vec![0.0; tree.constraint_rows()],
            jacobian: vec![0.0; tree.constraint_rows() * tree.coordinates()],
        }
    }

    /// Whether there is anything to hold.
    pub fn is_needed(mechanism: &Mechanism) -> bool {
        mechanism.real.constraint_rows() > 0
    }

    /// Projects the state in place.
    pub fn apply(&mut self, motion: &mut Motion<'_>, time_s: f64, state: &mut [f64]) {
        /// Newton steps; the first leaves the square of an error that is tiny already.
        const STEPS: usize = 3;
        let n = motion.freedoms;
        for _ in 0..STEPS {
            motion.set_state(time_s, state);
            motion.dynamics.constraint_residuals(&mut self.residuals);
            motion.dynamics.constraint_jacobian(&mut self.jacobian);
            let defects: Vec<f64> = motion.dynamics.independent(&self.residuals);
            if defects.iter().all(|defect| *defect == 0.0) {
                break;
            }
            let correction = self.smallest_change(motion, &defects);
            for k in 0..n {
                state[k] -= correction[k];
            }
        }
        motion.set_state(time_s, state);
        motion.dynamics.constraint_jacobian(&mut self.jacobian);
        let defects = motion.dynamics.constraint_rates(&self.jacobian);
        let correction = self.smallest_change(motion, &defects);
        for k in 0..n {
            state[n + k] -= correction[k];
        }
    }

    /// M⁻¹Jᵀ(J M⁻¹ Jᵀ)⁻¹ · defects.
    fn smallest_change(&self, motion: &Motion<'_>, defects: &[f64]) -> Vec<f64> {
        let n = motion.freedoms;
        let mass = motion.dynamics.factored_mass();
        let gradients = motion.dynamics.independent_gradients(&self.jacobian);
        let m = defects.len();
        let mobilities: Vec<Vec<f64>> = gradients
            .iter()
            .map(|gradient| {
                let mut column = gradient.to_vec();
                solve_ldl(mass, n, &mut column);
                column
            })
            .collect();
        let mut schur: Vec<f64> = gradients
            .iter()
            .flat_map(|gradient| {
                mobilities.iter().map(|mobility| gradient.iter().zip(mobility).map(|(g, v)| g * v).sum::<f64>())
            })
            .collect();
        factor_ldl(&mut schur, m);
        let mut multipliers = defects.to_vec();
        solve_ldl(&schur, m, &mut multipliers);
        (0..n).map(|k| (0..m).map(|r| mobilities[r][k] * multipliers[r]).sum()).collect()
    }
}
