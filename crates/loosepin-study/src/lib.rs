//! Mechanisms with uncertainty: a study file, its runs, its results.

#![cfg_attr(test, allow(clippy::disallowed_methods, reason = "tests make files of their own"))]

pub mod cases;
mod written;
pub use written::tables as files;

mod assemble;
mod diagnostic;
mod distribution_words;
mod drafts;
mod error;
mod file;
mod model;
mod places;
mod planning;
mod question;
pub use loosepin_result::study as result;
mod response;
mod run_options;
mod runs;
mod study_run;
mod without_runs;

pub use assemble::describe::inputs as describe_inputs;
pub use distribution_words::distribution_words;
pub use drafts::progress::{Progress, Stage};
pub use error::{StudyError, TooManyFailed};
pub use file::{
    AccuracyProblem, AccuracyTarget, Allowance, AllowedInput, Ask, Asked, Budget, Correlation, CorrelationMeasure,
    Deviation, EpistemicInput, EpistemicSubject, EvaluatedModel, EvaluationProblem, Limit, MAX_POSES, MAX_RUNS,
    MIN_SPECIMEN_ROWS, MeantLimit, Measured, MeasuredMotion, MeasuredProblem, MotionError, MotionProblem,
    MotionSubject, NameProblem, NamedPlace, NamedQuestion, Push, RandomInput, RandomProblem, RandomSubject, RareMethod,
    ReadingScatter, Reduction, Requirement, SampledFeature, Sampling, SpecimenProblem, SpecimenRows, StatedCorrelation,
    Study, StudyProblem, StudySurrogate, UncertainParameter, journal_words, named_model, says_study, study_schema,
    takes_mean_of_model,
};
pub use loosepin_text::tolerance::{FitError, number_and_unit, signed_parts, states_nominal};
pub use model::outputs::OutputSource;
pub use model::{
    Clearance, DeviationProofs, KindOfModel, MotionRequest, PLAY, PlayProofs, ProvenDeviations, StudyModel,
    ValuesUnderSettings,
};
pub use places::Where;
pub use planning::cost_estimate::{CostEstimate, PromiseCost};
pub use planning::estimate_cost::estimate_cost;
pub use planning::plans::{default_threads, plan_runs, plan_runs_on, plan_shards};
pub use question::{SavedInput, SavedOutput, SavedSurrogateError, SavedSurrogates, StudyRun};
pub use response::further_outputs::FurtherOutputs;
pub use response::limits::MAX_COLUMNS;
pub use response::recorded_output::RecordedOutput;
pub use response::sampled_feature::sampled_feature;
pub use run_options::RunOptions;
pub use runs::design_runs::{DesignRuns, DesignTable, argument_of};
pub use runs::external_runs::{RequestedRuns, RunProvider};
pub use runs::memory_at_hand::{ARENA_BYTES, ARENAS_PART, MAX_ARENAS, MemoryKind, STATED_BYTES};
pub use runs::run_rows::RunRows;
pub use runs::run_subset::{OpenRound, RunSubset};
pub use runs::table::{RunColumn, RunData, RunsTable};
pub use study_run::run_study;
pub use written::export::{ExportError, export_networks};
pub use written::folder::{ClaimOutcome, StudyOutcome, begin_in_folder, conclude, read_study, store_identity};
pub use written::input_file::{InputFile, InputFileProblem};
pub use written::inputs::{add_model, add_planar_model, add_study, study_inputs};
pub use written::simulate_command::exact_value;
pub use written::single_run::{FinishedRun, check_measured, run_and_compare, run_inputs, run_into, witness_run};
pub use written::stored_records::{RecordFiles, read_record, read_run, run_tables};
pub use written::texts::{NamedText, StudyTexts, model_from_texts, model_texts};
