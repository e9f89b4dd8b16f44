//! Whether the energy account bears a finished run out.

use crate::failure::RunFailure;
use crate::recording::report::RunReport;
use crate::settings::MAX_ENERGY_RESIDUAL;
use loosepin_mechanics::model::Model;

impl RunReport {
    /// Whether the energy account bears the run out: it closes, and no law gave more energy than it took.
    ///
    /// # Errors
    /// The first of both that does not hold.
    pub fn check_energy(&self, model: &Model) -> Result<(), RunFailure> {
        let Some(account) = &self.energy else { return Ok(()) };
        let exchange_j = account.largest_exchange_j;
        // Also where it is not a number.
        if !(account.relative_residual() <= MAX_ENERGY_RESIDUAL) {
            return Err(RunFailure::EnergyNotBalanced { residual_j: account.largest_residual_j, exchange_j });
        }
        let of_joints = self.friction_losses.iter().map(|friction| (Some(friction.joint), "friction", friction.loss_j));
        let of_all = [
            (None, "the normal force of contacts", account.contact_loss_j),
            (None, "friction", account.friction_loss_j),
            (None, "damping", account.damping_loss_j),
        ];
        for (joint, law, loss_j) in of_joints.chain(of_all) {
            if loss_j < -MAX_ENERGY_RESIDUAL * exchange_j {
                let joint = joint.map(|joint| model.play_name(joint).to_owned());
                return Err(RunFailure::LawGainsEnergy { law, joint, gained_j: -loss_j, exchange_j });
            }
        }
        Ok(())
    }
}
