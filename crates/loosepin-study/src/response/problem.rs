//! Why a study cannot begin.

use crate::file::MAX_POSES;
use crate::response::limits::{MAX_COLUMNS, MAX_LAWS};
use loosepin_mechanics::mechanism::{MechanismError, SampleError};
use loosepin_mechanics::model::LawError;
use loosepin_simulate::RunFailure;
use loosepin_text::diagnostics::{Code, Diagnostic, Problem, problems};
use loosepin_text::numbers::QuantityError;

problems! {
    /// Why a study cannot begin.
    #[derive(Debug, Clone, PartialEq)]
    pub enum PrepareError | Mechanism(MechanismError) | Law(LawError) {
        /// The start of the drive is uncertain, so that samples would not be compared at the same input.
        UncertainStart { path: String } => Code::AskNotPossible,
            says("'{path}' is the start of the drive: every sample must start at the same position to be compared with \
                  the ideal motion"),
            hint("make the angle of a link uncertain instead, for example with the position of a point");
        /// Drives in space would be elsewhere at a place of the cycle.
        UncertainDrive { path: String } => Code::AskNotPossible,
            says("'{path}' changes where drives are at a place of the cycle: every sample must be at the same places to be compared with the \
                  ideal motion"),
            hint("where the cycle counts the turns of a single drive, its speed may be uncertain");
        /// Places of the journals are to be drawn one by one, and must meet conditions together.
        JournalsTogether { conditions: usize } => Code::AskNotPossible,
            says("constraints of this mechanism repeat each other, so that its journals must meet {conditions} {} together for the loops to \
                  close: their places cannot be drawn one by one", if *conditions == 1 { "condition" } else { "conditions" }),
            hint("leave 'journals' out, so that bounds hold wherever they are; or change the joints so that no constraint repeats others: \
                  `loosepin check` of the model names them");
        /// The speed of the drive may change its sign.
        SpeedThroughZero { path: String } => Code::AskNotPossible,
            says("'{path}' may be zero or change its sign: the turns of such a drive cannot be counted"),
            hint("keep the whole range on one side of zero");
        /// A pose that the recorded part does not reach.
        PoseNotRecorded { output: String, angle_deg: f64, recorded_turns: f64 } => Code::AskNotPossible,
            says("output '{output}' is asked at {angle_deg:.6} deg; the recorded {recorded_turns} turns do not pass there"),
            hint("record more turns, or ask for an angle that is passed");
        /// More poses than a study can bound.
        TooManyPoses { poses: f64 } => Code::AskNotPossible,
            says("the curves have {poses} poses; must be at most {MAX_POSES}"),
            hint("use fewer samples_per_turn in the [cycle] of the study; 180 give a good curve");
        /// More numbers of a run than a study can bound.
        TooManyColumns { columns: usize } => Code::TooMany,
            says("all questions together need {columns} numbers of each run; must be at most {MAX_COLUMNS}"),
            hint("use fewer poses, or fewer samples_per_turn in the [cycle] of the study");
        /// More turns than a run of a study may have; `key` of `table` says so.
        TooManyTurns { turns: f64, what: &'static str, most: f64, table: &'static str, key: &'static str } => Code::AskNotPossible,
            says("{turns} turns are {what}; must be at most {most}"),
            hint("transient_turns and recorded_turns stand in the [cycle] of the study, or of its model");
        /// More mechanisms than are made.
        TooManyLaws { combinations: usize } => Code::AskNotPossible,
            says("{combinations} combinations of contact laws; must be at most {MAX_LAWS}"),
            hint("shorten the lists of laws");
        /// A path whose point stands still somewhere.
        PathStandsStill { output: String, share_percent: f64 } => Code::AskNotPossible,
            says("output '{output}': its point hardly moves after {share_percent:.1} % of the recorded part; its path has no direction there"),
            hint("use component = \"magnitude\", or x and y");
        /// The nominal mechanism in space, where the file of the model is at fault: what `loosepin motion` says of it, with the place.
        InSpace { found: Box<Diagnostic> } => found.code,
            says("{}", found.message),
            hint_of(found.hint.clone());
        /// The nominal run, where it fails with the values of the model alone too: its file is at fault.
        OfModel { failure: RunFailure } => Problem::code(failure),
            says("{failure}"),
            hint_of(failure.hint());
        /// The nominal run.
        Nominal { failure: RunFailure } => Problem::code(failure),
            says("the nominal mechanism, with unknown inputs at the middle of their intervals: {failure}"),
            hint_of(failure.hint());
    }
}

impl From<SampleError> for PrepareError {
    fn from(error: SampleError) -> Self {
        RunFailure::from(error).into()
    }
}

impl From<RunFailure> for PrepareError {
    fn from(failure: RunFailure) -> Self {
        Self::Nominal { failure }
    }
}

impl From<QuantityError> for PrepareError {
    fn from(error: QuantityError) -> Self {
        Self::Mechanism(error.into())
    }
}
