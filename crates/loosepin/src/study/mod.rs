//! Where mechanisms and uncertainty meet: a study file, its runs, its results.

mod file;
pub mod files;
mod input_file;
pub mod result;
pub mod runs;

pub use file::{
    Ask, Deviation, EpistemicInput, RandomInput, Reduction, Requirement, Sampling, Study, StudyProblem, Where,
    study_schema,
};
pub use input_file::{InputFile, InputFileProblem};
