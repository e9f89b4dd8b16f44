//! What every kind of response says of itself, and all that is asked of one. A kind without a capability leaves its method out.

use crate::file::Study;
use crate::response::columns::ColumnPlan;
use crate::response::extras::RunExtras;
use crate::response::linear_scatter::LinearScatter;
use loosepin_mechanics::model::{Cycle, JointId, PlayId};
use loosepin_result::motion::MotionRecord;
use loosepin_result::simulation::Drawing;
use loosepin_result::study::StudiedLaw;
use loosepin_simulate::accuracy::MotionPlan;
use loosepin_simulate::{Execution, Reading, RunFailure, Settings, Simulation};
use loosepin_text::numbers::{QuantityError, Values};
use std::fmt::Debug;
use std::sync::atomic::AtomicBool;
use std::time::Duration;

/// A run that waits: its index, its random and its epistemic inputs.
pub type WaitingRun<'i> = (usize, &'i [f64], &'i [f64]);

/// How the runs of a response are integrated through time.
pub struct Stepping<'r> {
    /// Their method and tolerances.
    pub settings: &'r Settings,
    /// Multiplications of one evaluation of the equations of motion.
    pub multiplications: f64,
    /// Whether drives alone decide the ideal motion.
    pub is_driven: bool,
    /// Time at the end of the nominal run, s.
    pub nominal_end_s: f64,
}

/// A prepared study: a function from uncertain inputs to numbers.
pub trait KindOfResponse: Debug + Send + Sync {
    /// The columns of a run.
    fn plan(&self) -> &ColumnPlan;

    /// Nominal values with the epistemic inputs in the middle.
    fn nominal(&self) -> &Values;

    /// Nominal ideal value of each column's output at its pose; NaN for reduced columns.
    fn nominal_at_pose(&self) -> &[f64];

    /// Turns that a run records.
    fn recorded_turns(&self) -> f64;

    /// Names of the joints with play that have extras in a row.
    fn joints(&self) -> &[String] {
        &[]
    }

    /// Extras of a run, read from its row.
    fn extras(&self, row: &[f64]) -> RunExtras {
        RunExtras::read(row, self.joints().len())
    }

    /// Numbers of a row: columns, then extras.
    fn row_length(&self) -> usize {
        self.plan().columns.len() + RunExtras::count(self.joints().len())
    }

    /// How many kinds of runs there are: combinations of laws.
    fn variants(&self) -> usize {
        1
    }

    /// Which of them runs with these epistemic inputs.
    fn variant(&self, _epistemic: &[f64]) -> usize {
        0
    }

    /// The values of the model for these inputs.
    ///
    /// # Errors
    /// A value breaks its rule.
    fn values(&self, random: &[f64], epistemic: &[f64]) -> Result<Values, QuantityError>;

    /// One run, alone.
    ///
    /// # Errors
    /// The one reason why the run failed.
    fn run(&self, random: &[f64], epistemic: &[f64], row: &mut [f64]) -> Result<(), RunFailure>;

    /// Runs until `next` gives no more inputs, as `StudyResponse::run_all_until` says.
    fn run_waiting<'i>(
        &self,
        variant: usize,
        execution: Execution,
        stop: &AtomicBool,
        next: &mut dyn FnMut() -> Option<WaitingRun<'i>>,
        finished: &mut dyn FnMut(usize, Result<Vec<f64>, RunFailure>),
    ) -> Vec<Duration>;

    /// How its runs are integrated; `None` where they are not.
    fn stepping(&self) -> Option<Stepping<'_>> {
        None
    }

    /// Gives every run up after this many evaluations, where it has any.
    fn limit_evaluations(&mut self, _largest_evaluations: u64) {}

    /// The joints and couplings with contacts; none where nothing is integrated.
    fn plays(&self) -> &[PlayId] {
        &[]
    }

    /// Name of a joint whose force is that of a contact.
    fn name_of_contact(&self, _joint: JointId) -> Option<&str> {
        None
    }

    /// The contact laws of a joint with play, each once, in the order of the kinds of runs.
    fn laws_of_play(&self, _play: usize) -> Vec<StudiedLaw> {
        Vec::new()
    }

    /// The parts of the mechanism at its nominal values, without a motion.
    fn skeleton(&self) -> Drawing {
        Drawing::default()
    }

    /// A run over `cycle` as it is drawn; `None` if it fails, and where runs are not drawn.
    fn drawn_run(
        &self,
        _random: &[f64],
        _epistemic: &[f64],
        _cycle: &Cycle,
        _has_second_run: bool,
    ) -> Option<Simulation> {
        None
    }

    /// The nominal ideal values of two readings at a share of the recorded part, each with its first two derivatives by that share.
    fn ideal_jets(&self, _readings: [Reading; 2], _share: f64) -> Option<[[f64; 3]; 2]> {
        None
    }

    /// The nominal ideal motion with its answer without dynamics; `None` where there is none.
    fn nominal_motion(&self, _plan: &MotionPlan) -> Option<MotionRecord> {
        None
    }

    /// What random quantities do to first order, without play; `None` where nothing scatters, or where it is not known.
    fn linear_scatter(&self, _study: &Study) -> Option<LinearScatter> {
        None
    }

    /// The variance of a column by each random quantity of [`Self::linear_scatter`].
    fn variances(&self, _scatter: &LinearScatter, _column: usize) -> Vec<f64> {
        Vec::new()
    }

    /// The row of a run with all random quantities at the values of the model; `None` if it fails, and where such a row says nothing of the others.
    fn without_scatter(&self, _epistemic: &[f64]) -> Option<Vec<f64>> {
        None
    }
}
