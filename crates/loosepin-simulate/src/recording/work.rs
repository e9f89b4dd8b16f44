//! Work along a motion that is solved instead of integrated.

use crate::recording::report::{EnergyAccount, smallest_exchange_j};
use crate::stepping::motion::{EnergyTotals, Motion};
use loosepin_mechanics::dynamics::MechanicalEnergy;
use loosepin_mechanics::mechanism::{IdealMotion, SampleError};

/// Nodes and weights of Gauss and Legendre's rule with five points over [0, 1]: exact for polynomials up to the ninth degree.
pub(crate) const NODES: [(f64, f64); 5] = [
    (0.046_910_077_030_668_004, 0.118_463_442_528_094_54),
    (0.230_765_344_947_158_45, 0.239_314_335_249_683_23),
    (0.5, 0.284_444_444_444_444_44),
    (0.769_234_655_052_841_5, 0.239_314_335_249_683_23),
    (0.953_089_922_969_332, 0.118_463_442_528_094_54),
];

/// The energy account of a mechanism that follows its drives exactly.
///
/// Needed where springs, loads or friction act: without them the work of the drives is the change of mechanical energy.
#[derive(Debug, Clone, Copy)]
pub struct KinematicAccount {
    /// Energy supplied and lost up to the start of the step.
    before: EnergyTotals<f64>,
    total: EnergyAccount,
}

impl KinematicAccount {
    /// Whether `motion` needs one.
    pub fn is_needed(motion: &Motion<'_, f64>) -> bool {
        let model = &motion.dynamics.mechanism().model;
        !model.springs.is_empty()
            || !model.loads.is_empty()
            || model.joints.iter().any(|joint| joint.friction.is_some())
    }

    /// Begins where `ideal` is.
    pub fn new(motion: &mut Motion<'_, f64>, ideal: &IdealMotion<'_>) -> Self {
        let energy = energy(motion, ideal);
        let nothing = EnergyTotals { supplied_j: 0.0, contact_loss_j: 0.0, friction_loss_j: 0.0, damping_loss_j: 0.0 };
        let total = EnergyAccount {
            at_start_j: energy.total_j(),
            at_end_j: energy.total_j(),
            largest_exchange_j: energy.free_kinetic_j.max(smallest_exchange_j(&energy)),
            ..EnergyAccount::default()
        };
        Self { before: nothing, total }
    }

    /// Energy supplied and lost up to `time_s` in the step that begins at `start_s`.
    ///
    /// # Errors
    /// The loops cannot close on the way.
    pub fn until(
        &self,
        motion: &mut Motion<'_, f64>,
        ideal: &mut IdealMotion<'_>,
        start_s: f64,
        time_s: f64,
    ) -> Result<EnergyTotals<f64>, SampleError> {
        let (mut account, span_s) = (self.before, time_s - start_s);
        for (node, weight) in NODES {
            ideal.move_to(start_s + node * span_s)?;
            evaluate(motion, ideal);
            let powers = motion.dynamics.powers();
            account.supplied_j += weight * span_s * (powers.drives_w + powers.loads_w);
            account.damping_loss_j += weight * span_s * powers.damping_loss_w;
            account.friction_loss_j += weight * span_s * powers.friction_loss_w;
        }
        Ok(account)
    }

    /// Takes the step from `start_s` to `end_s` into the account.
    ///
    /// # Errors
    /// As [`Self::until`].
    pub fn close_step(
        &mut self,
        motion: &mut Motion<'_, f64>,
        ideal: &mut IdealMotion<'_>,
        start_s: f64,
        end_s: f64,
    ) -> Result<(), SampleError> {
        self.before = self.until(motion, ideal, start_s, end_s)?;
        ideal.move_to(end_s)?;
        let energy = energy(motion, ideal);
        let total = &mut self.total;
        total.at_end_j = energy.total_j();
        total.supplied_j = self.before.supplied_j;
        total.damping_loss_j = self.before.damping_loss_j;
        total.friction_loss_j = self.before.friction_loss_j;
        let losses_j = total.damping_loss_j + total.friction_loss_j;
        let change_j = total.at_end_j - total.at_start_j;
        let residual_j = (change_j + losses_j - total.supplied_j).abs();
        let exchange_j = change_j.abs().max(total.supplied_j.abs()).max(losses_j.abs()).max(energy.free_kinetic_j);
        total.largest_residual_j = total.largest_residual_j.max(residual_j);
        total.largest_exchange_j = total.largest_exchange_j.max(exchange_j);
        Ok(())
    }

    /// The account of the run so far.
    pub fn total(&self) -> EnergyAccount {
        self.total
    }
}

fn evaluate(motion: &mut Motion<'_, f64>, ideal: &IdealMotion<'_>) {
    let (coordinates, rates) = ideal.real_state();
    let n = motion.freedoms();
    motion.dynamics.evaluate(ideal.time_s(), &coordinates[..n], &rates[..n], &motion.states);
}

fn energy(motion: &mut Motion<'_, f64>, ideal: &IdealMotion<'_>) -> MechanicalEnergy<f64> {
    evaluate(motion, ideal);
    motion.dynamics.energy(|_| false)
}
