//! A case as it is read: its mechanism, and the numbers that it must meet.

use super::reference::Reference;
use loosepin_mechanics::mechanism::{Mechanism, Sample};
use loosepin_mechanics::model::{Model, Values};
use loosepin_simulate::Column;
use loosepin_simulate::accuracy::{Scatter, ScatterCorrelation};
use loosepin_text::diagnostics::Place;
use loosepin_text::units::ReadableUnit;
use std::sync::Arc;

/// A mechanism whose answer is known.
#[derive(Debug, Clone)]
pub struct Case {
    /// Name of its folder.
    pub name: String,
    /// The mechanism as written.
    pub model: Model,
    /// The mechanism with its nominal values, compiled.
    pub(super) mechanism: Mechanism,
    /// The nominal values.
    pub(super) values: Values,
    /// Laid out for the mechanism.
    pub(super) sample: Sample<f64>,
    /// Scattering inputs, if the case has a study.
    pub(super) scatter: Vec<Scatter>,
    /// Correlations of the scatter.
    pub(super) correlations: Vec<ScatterCorrelation>,
    /// Its checks, in the order of the file.
    pub(super) checks: Vec<Check>,
}

/// One table of `expected.toml`.
#[derive(Debug, Clone)]
pub(super) struct Check {
    /// Its name.
    pub name: String,
    /// Source of the numbers: `analytic`, `published`, `peer` or `pinned`.
    pub origin: &'static str,
    /// The formula, the paper or the program.
    pub source: String,
    /// Place in the file.
    pub place: Place,
    /// The compared quantity.
    pub what: CheckSubject,
}

/// The compared quantity of a table of `expected.toml`.
#[derive(Debug, Clone)]
pub(super) enum CheckSubject {
    /// Numbers, one by one.
    Numbers(Numbers),
    /// Numbers of the first impacts of a joint; the largest difference counts.
    Impacts(Impacts),
    /// Histories; the largest difference over all rows counts.
    History(History),
}

/// Numbers that are obtained in the same way.
#[derive(Debug, Clone)]
pub(super) struct Numbers {
    /// How they are obtained.
    pub quantity: Quantity,
    /// The numbers.
    pub numbers: Vec<ExpectedNumber>,
    /// Largest accepted absolute difference, SI.
    pub tolerance_si: f64,
    /// The unit in which they are written.
    pub unit: ReadableUnit,
}

/// A number that is expected.
#[derive(Debug, Clone)]
pub(super) struct ExpectedNumber {
    /// The number, SI.
    pub value_si: f64,
    /// Settings `path=value` of the model under which it holds.
    pub settings: Vec<String>,
    /// Instant of the comparison, if it is not a whole run.
    pub at: Option<CheckInstant>,
    /// Its distinction from the others of its list, as written: `at 60 deg`, `with restitution=0.5`.
    pub words: Option<String>,
}

/// An instant of a motion, or a state of a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum CheckInstant {
    /// Angle of the drive that the cycle counts, rad.
    Angle(f64),
    /// Time from the start, s.
    Time(f64),
    /// Penetration of a contact at rest, m.
    Penetration(f64),
}

/// How a number is obtained.
#[derive(Debug, Clone)]
pub(super) struct Quantity {
    /// Which quantity.
    pub kind: QuantityKind,
    /// Index of the joint in [`Mechanism::plays`], for quantities of a joint with play.
    pub play: Option<usize>,
    /// The output or state, for quantities of one.
    pub column: Option<Column>,
    /// Reduction of a course in time.
    pub reduce: Option<Reduce>,
    /// Length of the run from its start, s.
    pub span_s: f64,
}

/// The quantities that a case can ask for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum QuantityKind {
    /// When the first, second, ... impact of a joint begins, s.
    ContactOnset,
    /// Its approach speed, m/s.
    ImpactSpeed,
    /// The speed at which the parts separate after it, m/s.
    SeparationSpeed,
    /// From its onset to the end of contact, s.
    ImpactDuration,
    /// Contacts of a joint that begin.
    Contacts,
    /// Largest normal force of a joint, N.
    PeakForce,
    /// Largest penetration of a joint, m.
    LargestPenetration,
    /// K of F = K δⁿ, N/mⁿ.
    ContactStiffness,
    /// Normal force of a contact at rest, N.
    StaticForce,
    /// Coefficient of restitution that a free impact gives.
    DeliveredRestitution,
    /// An output of the run.
    Output,
    /// An output of the mechanism without play.
    IdealOutput,
    /// Largest deviation of an output by play that is found, without dynamics.
    WorstCase,
    /// Sum of the first-order effects of all play on an output.
    FirstOrderPlay,
    /// First-order standard deviation of an output from what scatters in the study.
    DimensionalStandardDeviation,
    /// Largest residual of the energy account over the largest energy exchanged.
    EnergyResidual,
    /// Largest residual of the loops of ideal joints, m or rad.
    LoopDrift,
    /// Energy lost in normal contact, J.
    ContactLoss,
    /// Energy lost in friction, J.
    FrictionLoss,
    /// Work of the drives, J.
    DriveWork,
}

/// Reduction of a course in time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Reduce {
    /// Its smallest value.
    Minimum,
    /// Its largest value.
    Maximum,
    /// The angle of the drive at its smallest value.
    AngleOfMinimum,
    /// The angle of the drive at its largest value.
    AngleOfMaximum,
}

/// Numbers of the first impacts of a joint.
#[derive(Debug, Clone)]
pub(super) struct Impacts {
    /// Index of the joint in [`Mechanism::plays`].
    pub play: usize,
    /// Which number of an impact.
    pub of: ImpactNumber,
    /// The numbers, SI.
    pub expected_si: Vec<f64>,
    /// Largest accepted difference, SI.
    pub tolerance_si: f64,
    /// Length of the run, s.
    pub span_s: f64,
    /// Unit of the numbers.
    pub unit: ReadableUnit,
}

/// A number of an impact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum ImpactNumber {
    /// When it begins.
    Onset,
    /// Approach speed.
    Speed,
    /// Largest normal force.
    PeakForce,
    /// Speed at which the parts separate.
    SeparationSpeed,
    /// From onset to end.
    Duration,
}

/// Columns of a file of rows.
#[derive(Debug, Clone)]
pub(super) struct History {
    /// The file.
    pub reference: Arc<Reference>,
    /// The columns that count as one number, each with ours.
    pub columns: Vec<(usize, ComputedColumn)>,
    /// Largest accepted difference, SI.
    pub tolerance_si: f64,
    /// Unit of the numbers.
    pub unit: ReadableUnit,
}

/// A column of our run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum ComputedColumn {
    /// Index of an output column.
    Output(usize),
    /// Index in a row of the states of all bodies.
    State(usize),
}

impl Case {
    /// How many numbers and histories it must meet.
    pub fn count(&self) -> usize {
        let count =
            |check: &Check| if let CheckSubject::Numbers(numbers) = &check.what { numbers.numbers.len() } else { 1 };
        self.checks.iter().map(count).sum()
    }

    /// How many of these are histories.
    pub fn histories(&self) -> usize {
        self.checks.iter().filter(|check| matches!(check.what, CheckSubject::History(_))).count()
    }
}
