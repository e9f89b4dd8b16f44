//! How a run is integrated.

use loosepin_math::integrate::{DOP853, Tableau};
use loosepin_mechanics::mechanism::Mechanism;

/// Accuracy and limits of a run.
#[derive(Debug, Clone, Copy)]
pub struct Settings {
    /// Length that sets the error allowed in one step, m: the root mean square over all unknowns of the error estimates is at most
    /// [`STEP_SHARE`] of it. Contact amplifies errors; a second run measures how far (`Plan::second_run`). Default: 1e-9 m for one simulation, 1e-8 m in a study.
    pub tolerance_m: f64,
    /// The embedded pair. Default: DOP853 (`measured/integrators.md` has the measurement).
    pub method: &'static Tableau,
    /// Evaluations of the equations of motion after which a run is given up. Default: 3e8, a minute or so; the same
    /// in a study, so that a run that is given up there is given up again by itself.
    pub largest_evaluations: u64,
    /// Whether explicit or implicit steps. Default: explicit.
    pub integrator: Integrator,
}

/// Kind of steps.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Integrator {
    /// The embedded pair of [`Settings::method`].
    #[default]
    Explicit,
    /// Radau IIA of order five while all contacts are open, the embedded pair in contact: for flexible bodies in absolute nodal coordinates whose
    /// mesh has frequencies far above those of their motion.
    Implicit,
}

/// Local error allowed in a step over the tolerance asked for: measured on the reference cases (`measured/integrators.md`).
pub const STEP_SHARE: f64 = 5e-3;

/// Tolerance of a single simulation, m.
const SIMULATION_M: f64 = 1e-9;
/// Tolerance of the runs of a study, m.
const STUDY_M: f64 = 1e-8;
/// Largest [`Settings::lasting_share`], reached at 0.45 times the tolerance of a study: measured like [`STEP_SHARE`].
const LASTING_SHARE: f64 = 20.0;

/// Distance from δ = 0 at which a contact begins or ends over the tolerance asked for: measured like [`STEP_SHARE`].
pub const EVENT_SHARE: f64 = 1e-4;

/// Residual of the energy account over the largest exchange from which on a run has failed. Runs that are as accurate as they
/// were asked to be have 1e-12 to 1e-7.
pub const MAX_ENERGY_RESIDUAL: f64 = 1e-4;

impl Settings {
    /// Default settings for one simulation.
    pub fn for_simulation() -> Self {
        Self {
            tolerance_m: SIMULATION_M,
            method: &DOP853,
            largest_evaluations: 300_000_000,
            integrator: Integrator::Explicit,
        }
    }
    /// Default settings for the runs of a study.
    pub fn for_study() -> Self {
        Self { tolerance_m: STUDY_M, ..Self::for_simulation() }
    }

    /// Name of the method, for people.
    pub fn method_name(&self) -> String {
        match self.integrator {
            Integrator::Explicit => self.method.name.to_owned(),
            Integrator::Implicit => format!("Radau IIA of order 5, in contact {}", self.method.name),
        }
    }

    /// Local error allowed in a step of a lasting contact over that of other steps: what is wrong in an impact is carried into the flight behind it
    /// and grows in each further one, while most of what is wrong in a contact that holds dies away in it.
    ///
    /// 1 up to the tolerance of a single simulation, whose contacts are looked at; from there it grows with the square of the tolerance. It follows
    /// from the tolerance alone, so that `simulate --tolerance` makes the runs of a study again. Always 1 where bodies are flexible, since shapes
    /// that ring keep their errors; and for implicit steps, which keep their tolerance.
    pub fn lasting_share(&self, mechanism: &Mechanism) -> f64 {
        let tree = &mechanism.real;
        if tree.beams.is_empty() && tree.nodal_beams.is_empty() { self.lasting_share_of_rigid_bodies() } else { 1.0 }
    }

    fn lasting_share_of_rigid_bodies(&self) -> f64 {
        let ratio = self.tolerance_m / SIMULATION_M;
        (ratio * ratio).clamp(1.0, LASTING_SHARE)
    }

    /// A contact begins or ends where |δ| is below this, m.
    pub fn event_tolerance_m(&self) -> f64 {
        (self.tolerance_m * EVENT_SHARE).max(1e-15)
    }
}

/// The part of the motion that is recorded; the part from time zero to its start is transient.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Window {
    /// Start of the recorded part, s.
    pub start_s: f64,
    /// End of the run, s.
    pub end_s: f64,
}

impl Window {
    /// The same part of a run that begins at `begins_s` instead of time zero.
    pub fn later_by(self, begins_s: f64) -> Self {
        Self { start_s: begins_s + self.start_s, end_s: begins_s + self.end_s }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_contacts_that_last_err_more_in_a_study_and_not_in_one_simulation() {
        let share =
            |tolerance_m: f64| Settings { tolerance_m, ..Settings::for_study() }.lasting_share_of_rigid_bodies();
        assert_eq!(share(1e-12), 1.0);
        assert_eq!(Settings::for_simulation().lasting_share_of_rigid_bodies(), 1.0);
        assert!((share(2e-9) - 4.0).abs() < 1e-12, "{}", share(2e-9));
        assert_eq!(Settings::for_study().lasting_share_of_rigid_bodies(), LASTING_SHARE);
        assert_eq!(share(1e-6), LASTING_SHARE);
    }
}
