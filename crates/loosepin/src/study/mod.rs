//! Where mechanisms and uncertainty meet: a study file, its runs, its results.

mod assemble;
mod columns;
mod complaint;
mod conduct;
mod file;
pub mod files;
mod ideal_curve;
mod input_file;
mod lanes;
mod recorder;
mod response;
pub mod result;
pub mod runs;

pub use conduct::{Conducted, Progress, StudyError, conduct, plan_runs, time_a_run_s};
pub use file::{
    Ask, Deviation, EpistemicInput, EpistemicSubject, RandomInput, Reduction, Requirement, Sampling, Study,
    StudyProblem, UncertainParameter, Where, study_schema,
};
pub use input_file::{InputFile, InputFileProblem};
