//! Running a study: its bounds, its questions one after the other, then its result.

use super::assemble::{assemble, pictures, witness_commands};
use super::error::StudyError;
use super::file::Study;
use super::question::{DirectSteps, Found, Question, StudyRun, SurrogateSteps, take_steps};
use super::run_options::RunOptions;
use crate::drafts::draft::Drafting;
use crate::drafts::progress::{Drafts, Stage};
use crate::planning::goals::goals;
use crate::planning::plans::{Plans, refuse_time};
use crate::response::study_response::StudyResponse;
use crate::runs::all_runs::Runs;
use crate::runs::run_subset::RunSubset;
use crate::runs::table::RunsTable;
use loosepin_bounds::{SampleTable, TableError};

/// Runs `study` as far as its rounds are complete, with what is in the store and the runs that `options` make. The result is the same for any
/// number of threads, for runs that are made elsewhere, and whatever of it was found in a store.
///
/// # Errors
/// See [`StudyError`]; failed runs are no error as long as some succeed. [`StudyError::RoundOpen`] where runs are missing that are made
/// elsewhere, [`StudyError::NotMade`] if their provider stops.
pub fn run_study(study: &Study, input_hash: &str, options: &RunOptions<'_>) -> Result<StudyRun, StudyError> {
    let RunOptions { threads, progress, store, run_subset, .. } = *options;
    if run_subset != RunSubset::Whole {
        refuse_time(study)?;
    }
    if !study.has_questions() {
        return Err(StudyError::NothingAsked);
    }
    let response = StudyResponse::new(study)?;
    let plans = Plans::new(study, &response, store.is_some(), threads)?;
    let (table, note) = plans.table(store.and_then(|store| store.path().parent()));
    if let Some(note) = &note {
        progress.note(note);
    }
    let mut runs = Runs::new(options, (study, &response), table, (0, plans.limits.most_runs()))?;
    // A surrogate that stands alone has rounds of its own.
    let wants_drafts = progress.wants_drafts() && !plans.is_surrogate_alone;
    let drafting = wants_drafts.then(|| Drafting::new(study, &response, plans.refinement.plan(&runs.table)));
    runs.drafts = drafting.as_ref().map(|drafting| drafting as &dyn Drafts);
    progress.runs(0, runs.most_runs);
    let mut found = bounds_of(&plans, &mut runs)?;
    let mut questions = plans.questions;
    for question in &mut questions {
        question.run(&mut runs, &mut found)?;
    }
    conclude(&runs, found, &questions, input_hash)
}

/// The bounds of a study: of its double loop, or of the surrogate where it stands alone.
///
/// # Errors
/// Those of the runs; the budget does not suffice; every run failed.
fn bounds_of(plans: &Plans, runs: &mut Runs<'_>) -> Result<Found, StudyError> {
    let found = match &plans.surrogate {
        Some(plan) if plans.is_surrogate_alone => {
            let goals = goals(runs.study, runs.response.plan());
            let steps = SurrogateSteps::new(plan, goals, plans.limits.budget)?;
            let (learned, ended) = take_steps(steps, runs, Some(&plans.limits))?;
            let bounds = learned.bounds.to_bounds(&learned.plan, runs.table.rounds());
            let mut found = Found::new(bounds, ended);
            found.surrogate = Some(learned);
            found
        }
        _ => {
            let steps = DirectSteps::new(plans.refinement.clone(), plans.limits.budget);
            let direct = take_steps(steps, runs, Some(&plans.limits))?;
            let mut found = Found::new(direct.bounds, direct.ended);
            found.double_loop = Some(direct.plan);
            found
        }
    };
    if runs.table.failed() < runs.table.len() { Ok(found) } else { Err(all_failed(runs.response, &runs.table)) }
}

/// Puts the result together: the bounds, then what each question writes into it.
fn conclude(
    runs: &Runs<'_>,
    mut found: Found,
    questions: &[Box<dyn Question>],
    input_hash: &str,
) -> Result<StudyRun, StudyError> {
    let (pool, progress) = (&runs.pool, runs.options.progress);
    progress.stage(Stage::Assembling);
    found.complete(runs)?;
    let (found, material) = (&found, found.material(runs));
    progress.stage(Stage::Pictures);
    let pictures = pool.install(|| pictures(&material));
    progress.stage(Stage::Assembling);
    let result = pool.install(|| assemble(found, &material, input_hash, pictures));
    let mut run = StudyRun { result, runs: RunsTable::default(), surrogates: None };
    for question in questions {
        pool.install(|| question.record(&material, found, &mut run))?;
    }
    run.result.witness_commands = witness_commands(runs.study, &run.result);
    run.runs = runs.runs_table();
    progress.stage(Stage::Finished);
    Ok(run)
}

/// That every run of `table` failed, with the reason of the first one.
pub(super) fn all_failed(response: &StudyResponse, table: &SampleTable) -> StudyError {
    let first = &table.inputs()[0];
    let mut row = vec![f64::NAN; response.row_length()];
    match response.run(&first.random, &first.epistemic, &mut row) {
        Err(reason) => StudyError::AllFailed { runs: table.len(), reason },
        // The same inputs give the same run; were it otherwise, the table would hold a finished run.
        Ok(()) => StudyError::Table(TableError::WrongColumns { run: 0, found: 0, expected: row.len() }),
    }
}
