//! Where mechanisms and uncertainty meet: a study file, its runs, its results.

#![cfg_attr(test, allow(clippy::disallowed_methods, reason = "tests make files of their own"))]

pub mod cases;

mod assemble;
mod budget;
mod columns;
mod complaint;
mod distribution_words;
mod draft;
mod draft_curves;
mod elsewhere;
mod error;
mod evaluate;
mod export;
mod extras;
mod failures;
mod file;
pub mod files;
mod folder;
mod foresee;
mod foreseen;
mod further_outputs;
mod goals;
mod ideal_motion;
mod ideal_tables;
mod input_file;
mod input_limits;
mod inputs;
mod iso_286;
mod judge;
mod keep;
mod lanes;
mod memory_at_hand;
mod outputs;
mod part;
mod plans;
mod problem;
mod progress;
mod question;
mod recorder;
mod response;
pub use loosepin_result::study as result;
mod run_options;
mod run_rows;
mod runs;
mod runs_table;
mod sampled_feature;
mod simulate_command;
mod single_run;
mod study_run;
mod texts;
mod widest_play;

pub use distribution_words::distribution_words;
pub use elsewhere::{AskedRuns, RunMaker};
pub use error::{StudyError, TooManyFailed};
pub use export::{ExportError, export_networks};
pub use file::{
    AccuracyProblem, AccuracyTarget, Allowance, AllowedInput, Ask, Asked, Budget, Correlation, CorrelationMeasure,
    Deviation, EpistemicInput, EpistemicSubject, LEAST_SPECIMEN_ROWS, Limit, MOST_POSES, MOST_RUNS, Measured,
    MeasuredMotion, MeasuredProblem, MotionError, MotionProblem, MotionSubject, Push, RandomInput, RandomProblem,
    RareMethod, ReadingScatter, Reduction, Requirement, SampledFeature, Sampling, SpecimenProblem, SpecimenRows,
    StatedCorrelation, Study, StudyProblem, StudySurrogate, UncertainParameter, Where, named_model, number_and_unit,
    says_study, signed_parts, states_nominal, study_schema, takes_mean_of_model,
};
pub use folder::{Begun, Concluded, begin_in_folder, conclude, store_identity};
pub use foresee::foresee;
pub use foreseen::{Foreseen, ForeseenPromise};
pub use further_outputs::{FurtherOutputs, RecordedOutput};
pub use input_file::{InputFile, InputFileProblem};
pub use inputs::{add_model, add_study, study_inputs};
pub use iso_286::FitError;
pub use memory_at_hand::{ARENA_BYTES, ARENAS_PART, MAX_ARENAS, MemoryKind, STATED_BYTES};
pub use outputs::Seen;
pub use part::{OpenRound, Part};
pub use plans::{default_threads, plan_runs, plan_runs_on, plan_shards};
pub use progress::{Progress, Stage};
pub use question::{SavedInput, SavedOutput, SavedSurrogateError, SavedSurrogates, StudyRun};
pub use response::MOST_COLUMNS;
pub use run_options::RunOptions;
pub use run_rows::RunRows;
pub use runs_table::{RunColumn, RunData, RunsTable};
pub use sampled_feature::sampled_feature;
pub use single_run::{FinishedRun, run_inputs, run_into, witness_run};
pub use study_run::run_study;
pub use texts::{NamedText, StudyTexts};
