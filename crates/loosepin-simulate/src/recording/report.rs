//! Report of a finished run.

use crate::follow::Findings;
use loosepin_mechanics::dynamics::MechanicalEnergy;
use loosepin_mechanics::model::PlayId;
use loosepin_result::simulation::RunCounters;

/// Exchanges smaller than this share of all energy at the start are round-off: nothing is measured by them.
const ROUND_OFF_SHARE: f64 = 1e-6;

/// The exchange that the energy account begins with, for a mechanism with this energy at the start, J.
pub fn smallest_exchange_j(at_start: &MechanicalEnergy<f64>) -> f64 {
    let MechanicalEnergy { kinetic_j, potential_j, stored_j, .. } = at_start;
    ROUND_OFF_SHARE * (kinetic_j + potential_j.abs() + stored_j.abs())
}

/// Contacts and largest values of one joint with play, or of one of its contacts, in the recorded part of a run.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct PlaySummary {
    /// Contacts that began.
    pub contacts: u64,
    /// Contacts among them that began slower than the floor v_min of the law.
    pub floored_contacts: u64,
    /// Impacts faster than the law is meant for.
    pub impacts_beyond_validity: u64,
    /// Largest penetration, m.
    pub largest_penetration_m: f64,
    /// Largest normal force, N, looked for at a few points of each step: it may be a few thousandths too small.
    pub peak_force_n: f64,
}

impl PlaySummary {
    /// Takes in what another contact of the joint went through.
    pub fn take_in(&mut self, contact: &Self) {
        self.contacts += contact.contacts;
        self.floored_contacts += contact.floored_contacts;
        self.impacts_beyond_validity += contact.impacts_beyond_validity;
        self.largest_penetration_m = self.largest_penetration_m.max(contact.largest_penetration_m);
        self.peak_force_n = self.peak_force_n.max(contact.peak_force_n);
    }
}

/// Energy over a run, J.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct EnergyAccount {
    /// Mechanical energy (kinetic, potential, stored in contacts and springs) at the start.
    pub at_start_j: f64,
    /// Mechanical energy at the end.
    pub at_end_j: f64,
    /// Work of drives and loads.
    pub supplied_j: f64,
    /// Turned into heat by normal contact.
    pub contact_loss_j: f64,
    /// Turned into heat by friction and by films of oil.
    pub friction_loss_j: f64,
    /// Turned into heat by dampers.
    pub damping_loss_j: f64,
    /// Largest |energy + losses - supplied - energy at the start| over all steps.
    pub largest_residual_j: f64,
    /// Largest of: work of drives and loads, change of mechanical energy, losses, kinetic energy of the bodies that drives alone do
    /// not carry; and a millionth of all energy at the start.
    pub largest_exchange_j: f64,
}

impl EnergyAccount {
    /// The run's own check: largest residual over largest exchange.
    pub fn relative_residual(&self) -> f64 {
        if self.largest_exchange_j > 0.0 { self.largest_residual_j / self.largest_exchange_j } else { 0.0 }
    }
}

/// Heat by the friction of one joint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrictionLoss {
    /// The joint.
    pub joint: PlayId,
    /// Energy, J; below zero where friction gave more than it took.
    pub loss_j: f64,
}

/// The friction path of a joint with play over the recorded part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrictionPath {
    /// The joint: its index in [`loosepin_mechanics::mechanism::Mechanism::plays`].
    pub play: usize,
    /// W = ∫F_N |v_T| dt, J.
    pub path_j: f64,
}

/// Report of a finished run.
#[derive(Debug, Clone, PartialEq)]
pub struct RunReport {
    /// Counts.
    pub counters: RunCounters,
    /// One for each joint with play.
    pub plays: Vec<PlaySummary>,
    /// The energy account; a mechanism without play is not integrated and has none.
    pub energy: Option<EnergyAccount>,
    /// Losses of the joints whose friction may give more than it takes: with a memory, or by the literal sliding velocity.
    pub friction_losses: Vec<FrictionLoss>,
    /// Friction paths of the joints with play that wear.
    pub friction_paths: Vec<FrictionPath>,
    /// Findings of the followed quantities.
    pub findings: Findings,
}
