//! Where mechanisms and uncertainty meet: a study file, its runs, its results.

mod accuracy;
mod allow;
mod assemble;
mod columns;
mod complaint;
mod conduct;
mod contributors;
mod distribution_words;
mod file;
pub mod files;
mod further_outputs;
mod ideal_curve;
mod input_file;
mod inputs;
mod iso_286;
mod keep;
mod lanes;
mod rare;
mod recorder;
mod response;
pub mod result;
pub mod runs;
mod saved_surrogates;
mod simultaneous;
mod surrogate;

pub use conduct::{Conducted, Means, Progress, StudyError, conduct, plan_runs, time_a_run_s};
pub use distribution_words::distribution_words;
pub use file::{
    AccuracyProblem, AccuracyTarget, Allowance, AllowedInput, Ask, Budget, Correlation, CorrelationMeasure, Deviation,
    EpistemicInput, EpistemicSubject, Limit, RandomInput, RandomProblem, RareMethod, Reduction, Requirement, Sampling,
    StatedCorrelation, Study, StudyProblem, StudySurrogate, UncertainParameter, Where, study_schema,
};
pub use further_outputs::{FurtherOutputs, RecordedOutput};
pub use input_file::{InputFile, InputFileProblem};
pub use inputs::{add_model, add_study};
pub use iso_286::FitError;
pub use saved_surrogates::{SavedInput, SavedOutput, SavedSurrogateError, SavedSurrogates};
