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
//! | a study: its inputs, its questions, its time | `study.rs` |
//!
//! What is moved and run to know it: `trial.rs`.

#![cfg_attr(test, allow(clippy::disallowed_methods, reason = "tests make files of their own"))]

mod beams;
mod bending;
mod elements;
mod force_law;
mod joints;
mod mechanism;
mod names;
mod space;
mod study;
mod trial;

pub use space::check_space;

use std::sync::atomic::{AtomicBool, Ordering};

use loosepin_mechanics::mechanism::Mechanism;
use loosepin_mechanics::model::{Model, Values};
use loosepin_simulate::bodies_that_move;
use loosepin_space::{IsStopped, SpatialModel};
use loosepin_study::{InputFile, Study, plan_runs};
use loosepin_text::article::Article;
use loosepin_text::diagnostics::{Diagnostic, Diagnostics};
use loosepin_text::plausible::JudgedModel;

use trial::TrialResult;

/// Warnings about likely mistakes in a valid file, and about outputs that its mechanism never moves. A mechanism that cannot be moved is refused
/// elsewhere.
pub fn warnings(file: &InputFile) -> Vec<Diagnostic> {
    let still = match (file.model().planar(), file.model().spatial()) {
        (Some(model), _) => {
            let values = model.quantities.nominal();
            Mechanism::new(model, &values).map_or_else(|_| Vec::new(), |mechanism| never_moving(&mechanism, &values))
        }
        (None, Some(model)) => never_moving_in_space(model, &model.quantities.nominal(), &|| false),
        (None, None) => Vec::new(),
    };
    file.warnings().iter().cloned().chain(still).collect()
}

/// Warnings of outputs whose bodies stand still over the whole cycle.
pub fn never_moving(mechanism: &Mechanism, values: &Values) -> Vec<Diagnostic> {
    bodies_that_move(mechanism, values).map_or_else(Vec::new, |moved| mechanism.model.never_moving(moved))
}

/// The same of a mechanism in space, until it is stopped.
fn never_moving_in_space(model: &SpatialModel, values: &Values, is_stopped: IsStopped) -> Vec<Diagnostic> {
    model.bodies_that_move(values, is_stopped).map_or_else(Vec::new, |moved| model.never_moving(moved))
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
        InputFile::Model(model) => match model.spatial() {
            Some(model) => check_space(model, &|| stop.load(Ordering::Relaxed)),
            None => check_model(model.demand_planar()?, stop),
        },
        InputFile::Study(study) => check_study(study, stop),
    }
}

/// The errors of [`check_until`], without its report and without the time of a run; without any, warnings of outputs that never move. Of a
/// mechanism in space without a study there are no errors but those of its motion.
///
/// # Errors
/// As for [`check_until`].
pub fn try_until(file: &InputFile, stop: &AtomicBool) -> Result<Vec<Diagnostic>, Diagnostics> {
    let is_stopped = || stop.load(Ordering::Relaxed);
    let study = match file {
        InputFile::Model(model) => {
            return match model.spatial() {
                Some(model) => Ok(never_moving_in_space(model, &model.quantities.nominal(), &is_stopped)),
                None => {
                    try_model(model.demand_planar()?, stop).map(|tried| never_moving(&tried.mechanism, &tried.values))
                }
            };
        }
        InputFile::Study(study) => study,
    };
    let mut still = Vec::new();
    if let Some(model) = study.model.planar() {
        let tried = try_study(study, model, stop)?;
        still = never_moving(&tried.mechanism, &tried.values);
        if !model.missing_for_runs.is_empty() {
            return Ok(still);
        }
    } else if let Some(model) = study.model.spatial() {
        still = never_moving_in_space(model, &study::middle_values(study)?, &is_stopped);
    }
    if study.has_questions() {
        plan_runs(study).map_err(|error| error.diagnostic(study))?;
    }
    Ok(still)
}

/// A mechanism that has moved for the first time.
struct Tried {
    mechanism: Mechanism,
    values: Values,
    result: TrialResult,
}

fn check_model(model: &Model, stop: &AtomicBool) -> Result<Article, Diagnostics> {
    let Tried { mechanism, values, result } = try_model(model, stop)?;
    Ok(mechanism::article(&mechanism, &values, &result))
}

fn try_model(model: &Model, stop: &AtomicBool) -> Result<Tried, Diagnostics> {
    let values = model.quantities.nominal();
    let mechanism = Mechanism::new(model, &values).map_err(|error| error.diagnostic(model))?;
    if !mechanism.is_driven() {
        // Forces decide where it goes: without them nothing is known of it.
        model.demand_dynamics()?;
    }
    // A study has a cycle of its own, with limits of its own.
    trial::check_run(&mechanism, &values).map_err(|failure| failure.diagnostic(model))?;
    let result = trial::run_trial(&mechanism, &values, stop).map_err(|failure| failure.diagnostic(model))?;
    Ok(Tried { mechanism, values, result })
}

fn check_study(study: &Study, stop: &AtomicBool) -> Result<Article, Diagnostics> {
    if study.model.spatial().is_some() {
        study::middle_values(study)?;
        return study::article_in_space(study);
    }
    let model = study.model.demand_planar()?;
    let Tried { values, result, .. } = try_study(study, model, stop)?;
    study::article(study, model, &values, &result)
}

fn try_study(study: &Study, model: &Model, stop: &AtomicBool) -> Result<Tried, Diagnostics> {
    let values = study::middle_values(study)?;
    let mechanism = Mechanism::new(model, &values).map_err(|error| error.diagnostic(model))?;
    if study.needs_runs() || !mechanism.is_driven() {
        model.demand_dynamics()?;
    }
    let result = trial::run_trial(&mechanism, &values, stop).map_err(|failure| failure.diagnostic(model))?;
    Ok(Tried { mechanism, values, result })
}

#[cfg(test)]
mod tests;
