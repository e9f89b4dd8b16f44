//! Report of a finished run.

/// Counters of a run.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Counters {
    /// Accepted steps.
    pub steps: u64,
    /// Rejected steps.
    pub rejections: u64,
    /// Evaluations of the equations of motion.
    pub evaluations: u64,
    /// Contacts that began or ended.
    pub events: u64,
}

/// Contacts and largest values of one joint with play, or of one of its contacts, in the recorded part of a run.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct PlaySummary {
    /// Contacts that began.
    pub contacts: u64,
    /// Those among them that began slower than the floor v_min of the law.
    pub floored_contacts: u64,
    /// Impacts faster than the law is meant for.
    pub impacts_beyond_validity: u64,
    /// Largest penetration, m. The step in which the recorded part begins counts as a whole, also what lies before it.
    pub largest_penetration_m: f64,
    /// Largest normal force, N, over the same steps, looked for at a few points of each: it may be a few thousandths too small.
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
    /// Largest of: work of drives and loads, change of mechanical energy, losses; and change of kinetic energy where the drives
    /// do not move the mechanism alone.
    pub largest_exchange_j: f64,
}

impl EnergyAccount {
    /// The run's own check: largest residual over largest exchange.
    pub fn relative_residual(&self) -> f64 {
        if self.largest_exchange_j > 0.0 { self.largest_residual_j / self.largest_exchange_j } else { 0.0 }
    }
}

/// Report of a finished run.
#[derive(Debug, Clone, PartialEq)]
pub struct RunReport {
    /// Counts.
    pub counters: Counters,
    /// One for each joint with play.
    pub plays: Vec<PlaySummary>,
    /// The energy account; a mechanism without play is not integrated and has none.
    pub energy: Option<EnergyAccount>,
}
