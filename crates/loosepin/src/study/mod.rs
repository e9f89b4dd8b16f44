//! Where mechanisms and uncertainty meet: a study file, its runs, its results.

pub mod files;
pub mod result;
pub mod runs;
