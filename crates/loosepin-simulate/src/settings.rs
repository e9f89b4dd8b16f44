//! How a run is integrated.

use loosepin_math::integrate::{DOP853, Tableau};

/// Accuracy and limits of a run.
#[derive(Debug, Clone, Copy)]
pub struct Settings {
    /// Error of the positions over the first half turn, m. The error allowed in one step is smaller by
    /// [`STEP_SHARE`]: contact amplifies errors. Default: 1e-9 m for one simulation, 1e-8 m in a study.
    pub tolerance_m: f64,
    /// The embedded pair. Default: DOP853 (`docs/integrators.md` has the measurement).
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

/// Local error allowed in a step over the tolerance asked for: measured on the reference cases (`docs/integrators.md`).
pub const STEP_SHARE: f64 = 5e-3;

/// Distance from δ = 0 at which a contact begins or ends over the tolerance asked for: measured like [`STEP_SHARE`].
pub const EVENT_SHARE: f64 = 1e-4;

/// Residual of the energy account over the largest exchange from which on a run has failed. Runs that are as accurate as they
/// were asked to be have 1e-12 to 1e-7.
pub const LARGEST_ENERGY_RESIDUAL: f64 = 1e-4;

impl Settings {
    /// Default settings for one simulation.
    pub fn for_simulation() -> Self {
        Self { tolerance_m: 1e-9, method: &DOP853, largest_evaluations: 300_000_000, integrator: Integrator::Explicit }
    }
    /// Default settings for the runs of a study.
    pub fn for_study() -> Self {
        Self { tolerance_m: 1e-8, ..Self::for_simulation() }
    }

    /// Name of the method, for people.
    pub fn method_name(&self) -> String {
        match self.integrator {
            Integrator::Explicit => self.method.name.to_owned(),
            Integrator::Implicit => format!("Radau IIA of order 5, in contact {}", self.method.name),
        }
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
