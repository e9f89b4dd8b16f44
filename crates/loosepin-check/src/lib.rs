//! The report of `check`: what each part is, whether the loops close, whether the first steps of a run succeed, how long a study takes. As
//! an article, which a terminal or a page shows.
//!
//! | Words on | File |
//! |---|---|
//! | bodies, degrees of freedom, the start, a run | `mechanism.rs` |
//! | joints with their drives, their play and what touches in it | `joints.rs` |
//! | flexible bodies | `beams.rs`; how far they bend `bending.rs` |
//! | couplings, springs, loads, controls | `elements.rs` |
//! | the law behind a force that is asked about | `force_law.rs` |
//! | names and numbers of a model | `names.rs` |
//! | a mechanism in space | `space.rs` |
//! | what is done with each kind of model | `checked_model.rs` |
//! | a study: its inputs, its questions, its time | `study.rs` |
//!
//! What is moved and run to know it: `trial.rs`.

#![cfg_attr(test, allow(clippy::disallowed_methods, reason = "tests make files of their own"))]

mod beams;
mod bending;
mod checked_model;
mod elements;
mod force_law;
mod joints;
mod mechanism;
mod names;
mod space;
mod study;
mod trial;

pub use checked_model::never_moving;
pub use space::check_space;

use std::sync::atomic::AtomicBool;

use checked_model::checked;
use loosepin_study::{InputFile, plan_runs};
use loosepin_text::article::Article;
use loosepin_text::diagnostics::{Diagnostic, Diagnostics};

/// Warnings about likely mistakes in a valid file, and about outputs that its mechanism never moves. A mechanism that cannot be moved is refused
/// elsewhere.
pub fn warnings(file: &InputFile) -> Vec<Diagnostic> {
    let model = file.model();
    let still = checked(model).standing_still(&model.quantities().nominal(), &|| false);
    file.warnings().iter().cloned().chain(still).collect()
}

/// Moves the mechanism of a file for the first time, and reports its loops, limits and first steps.
///
/// # Errors
/// What keeps it from running.
pub fn check(file: &InputFile) -> Result<Article, Diagnostics> {
    check_until(file, &AtomicBool::new(false))
}

/// As [`check`], until `stop` is set: it is looked at before each position and in the first steps of a run.
///
/// # Errors
/// As for [`check`]; that it was stopped.
pub fn check_until(file: &InputFile, stop: &AtomicBool) -> Result<Article, Diagnostics> {
    match file {
        InputFile::Model(model) => checked(model).describe(stop),
        InputFile::Study(study) => checked(&study.model).describe_study(study, stop),
    }
}

/// The errors of [`check_until`], without its report and without the time of a run; without any, warnings of outputs that never move. Of a
/// mechanism in space without a study there are no errors but those of its motion.
///
/// # Errors
/// As for [`check_until`].
pub fn try_until(file: &InputFile, stop: &AtomicBool) -> Result<Vec<Diagnostic>, Diagnostics> {
    let study = match file {
        InputFile::Model(model) => return checked(model).try_alone(stop),
        InputFile::Study(study) => study,
    };
    let still = checked(&study.model).try_study(study, stop)?;
    // What is missing for runs was asked for where the study needs any.
    if study.has_questions() && study.model.demand_complete().is_ok() {
        plan_runs(study).map_err(|error| error.diagnostic(study))?;
    }
    Ok(still)
}

#[cfg(test)]
mod tests;
