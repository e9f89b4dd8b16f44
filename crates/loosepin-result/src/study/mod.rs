//! Result of a study: every bound, and the data of the report. Plain data in SI; `summary.json` is this type. No computation, and no words
//! for people.

pub(crate) mod accuracy;
mod allowances;
mod answer;
mod bound;
mod contributors;
mod draft;
mod figures;
mod further_turns;
mod inputs;
mod path_error;
mod promise;
mod rare;
mod requirement;
mod surrogate;
mod verdict;

use crate::motion::MotionRecord;
use crate::point_path::CyclePaths;
use crate::repeat::Repeat;
use serde::{Deserialize, Serialize};

pub use accuracy::{AccuracyOutcome, AccuracyRecord, AccuracyStep, AccuracyStop, Budget};
pub use allowances::{
    AllocatedInput, AllocationRecord, AllocationStop, AllowanceCheck, AllowanceRecord, CheckAnswer, Loosened,
    LoosenedInput, Together, TogetherCheck, TogetherRecord,
};
pub use answer::{AnswerPart, QuestionAnswer};
pub use bound::{BoundEnd, BoundRecord, NumericalError, ResponsePoint, Witness, WitnessCommand, WitnessValue};
pub use contributors::{Contributors, EpistemicContributor, RandomContributor, ShareRange};
pub use draft::{Draft, DraftCurve};
pub use figures::{
    CoveragePoint, CurveRange, DeviationCurve, EnergyResiduals, HistogramBin, JointImpacts, PathCurve, ProbabilityBox,
    SimultaneousCurve, StudiedLaw, TreatmentBand, TreatmentComparison, TreatmentEnd, ValueBand,
};
pub use further_turns::{FurtherOutput, FurtherTurns};
pub use inputs::{
    CorrelationDescription, CutDescription, CycleDescription, ElementDescription, ExampleRun, FailureGroup, GapRecord,
    InputDescription, InputKind, OutputDescription, PathOutput, PurposeRuns, RunCounts,
};

pub use loosepin_terms::{
    Course, CourseEnds, Deviation, Event, Guarantee, NumberKind, Purpose, Reading, Reduction, Reference, Side,
    Statistic, SurrogateVerdict, Treatment,
};
pub use path_error::PathError;
pub use promise::{PromiseRecord, PromisedBand, PromisedEnd};
pub use rare::{RareEnd, RareMethodUsed, RareRecord};
pub use requirement::{CountedMechanisms, RequirementOutcome};
pub use surrogate::{SurrogateAlong, SurrogateLearning, SurrogateOutput, SurrogatePicture, SurrogateRecord};
pub use verdict::{KnownShare, Verdict};

use crate::simulation::{Drawing, JournalOrbit, Trust};
use loosepin_text::units::{DisplayUnits, extended};

/// Bounds over what is possible to at least some degree, in the order of [`StudyResult::bounds`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CutBounds {
    /// The degree, in [0, 1].
    pub alpha: f64,
    /// The bounds.
    pub bounds: Vec<BoundRecord>,
}

/// A percentile of every statistic that is itself random, in the order of [`StudyResult::bounds`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PercentileBounds {
    /// With this probability the parameters are such that a statistic does not exceed the percentile, in (0, 1).
    pub percentile: f64,
    /// The percentile of each statistic, from the least to the greatest over the other epistemic inputs.
    pub bounds: Vec<BoundRecord>,
}

/// The finished study. Keys are written in this order, the bulky ones last.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StudyResult {
    /// Version of this layout; rises when a reader must change.
    pub format: u32,
    /// Name of the study.
    pub name: String,
    /// Name of the model.
    pub model: String,
    /// Version of the program, `major.minor.patch`.
    pub version: String,
    /// Hash of all inputs, hexadecimal.
    pub input_hash: String,
    /// Seed of the random numbers.
    pub seed: u64,
    /// The uncertain inputs, in file order.
    pub inputs: Vec<InputDescription>,
    /// Rank correlations between random inputs.
    pub correlations: Vec<CorrelationDescription>,
    /// The recorded part of the cycle of each sample.
    pub cycle: CycleDescription,
    /// The outputs asked for.
    pub outputs: Vec<OutputDescription>,
    /// How many runs, and how many of them failed.
    pub counts: RunCounts,
    /// How finely the box of the epistemic inputs was seen; absent where there is one value, and in records of older versions.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gaps: Option<GapRecord>,
    /// How near the bounds were to be and are; absent where neither accuracy nor budget was stated.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub accuracy: Option<AccuracyRecord>,
    /// The failed runs by reason, most frequent first.
    pub failures: Vec<FailureGroup>,
    /// Share of the runs whose motion had settled into a period, 0 to 1; absent where it was not examined.
    #[serde(with = "extended")]
    pub settled_share: Option<f64>,
    /// Changes by turns after the recorded ones, if the motion does not repeat itself in every run; absent if it was not examined.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub further_turns: Option<FurtherTurns>,
    /// Requirements and whether they are met.
    pub requirements: Vec<RequirementOutcome>,
    /// How far inputs may be loosened, one at a time.
    #[serde(default)]
    pub allowances: Vec<AllowanceRecord>,
    /// How far inputs may be loosened together; absent where that is not asked.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub together: Option<TogetherRecord>,
    /// The cheapest combination of offers; absent where none has a price.
    #[serde(default)]
    pub allocation: Option<AllocationRecord>,
    /// Every bound.
    pub bounds: Vec<BoundRecord>,
    /// The same bounds for what is possible to at least each degree, where an input is a fuzzy number.
    #[serde(default)]
    pub cuts: Vec<CutBounds>,
    /// Percentiles of the statistics, where parameters of distributions have distributions themselves.
    #[serde(default)]
    pub percentiles: Vec<PercentileBounds>,
    /// Small probabilities that were not counted but estimated by other means; their bounds stand among the others.
    #[serde(default)]
    pub rare: Vec<RareRecord>,
    /// Bounds that a share of the box keeps; absent where none was asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub promise: Option<PromiseRecord>,
    /// Bounds by surrogates beside the direct ones; absent where none was asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub surrogate: Option<SurrogateRecord>,
    /// Contributions to the answers for which they were requested.
    #[serde(default)]
    pub contributors: Vec<Contributors>,
    /// Answers of questions that have no place of their own above.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub answers: Vec<QuestionAnswer>,
    /// The three treatments side by side.
    pub treatments: Vec<TreatmentComparison>,
    /// Energy residuals of the runs: their own check.
    pub energy: Option<EnergyResiduals>,
    /// Impacts in each clearance joint.
    pub impacts: Vec<JointImpacts>,
    /// How long the positions of the run with nominal dimensions, unknown values in the middle, can be trusted.
    #[serde(default)]
    pub nominal_trust: Trust,
    /// How it is made again; empty in records of older versions.
    #[serde(default, skip_serializing_if = "Repeat::is_empty")]
    pub repeat: Repeat,
    /// Commands that run one mechanism at witnesses of requirements and of single bounds, the most important first.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub witness_commands: Vec<WitnessCommand>,
    /// Units that pages and tables use.
    pub display_units: DisplayUnits,
    /// Deviation curves over the cycle.
    pub curves: Vec<DeviationCurve>,
    /// Probability boxes.
    pub boxes: Vec<ProbabilityBox>,
    /// Paths of journals in their bearings.
    pub orbits: Vec<JournalOrbit>,
    /// Ideal paths of outputs with the zones about them, to first order: unknown clearances where there is most play. Absent where no output
    /// is a path, and in records of older versions.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub paths: Option<CyclePaths>,
    /// Of a study without runs in time: the motion without dynamics, unknown clearances where there is most play, with what each joint contributes
    /// and the mechanism as it is drawn.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub motion: Option<MotionRecord>,
    /// Whether pins with play lean out of the plane, which runs do not know.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub leans: bool,
    /// The mechanism and its poses.
    pub drawing: Drawing,
}

impl StudyResult {
    /// Verdict over all requirements; `None` if nothing is required.
    pub fn verdict(&self) -> Option<Verdict> {
        Verdict::of_all(self.requirements.iter().map(|requirement| requirement.verdict))
    }
}

/// The layout that this version of the program writes.
pub const FORMAT: u32 = 2;
