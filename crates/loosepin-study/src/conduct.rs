//! Conducting a study: its bounds, its questions one after the other, then its result.

use super::assemble::{assemble, pictures, witness_commands};
use super::draft::Drafting;
use super::elsewhere::RunMaker;
use super::error::StudyError;
use super::file::Study;
use super::goals::goals;
use super::keep::Keeping;
use super::part::Part;
use super::plans::{Plans, refuse_time};
use super::question::{Conclusion, DirectSteps, Found, Question, SavedSurrogates, SurrogateSteps, take_steps};
use super::response::StudyResponse;
use super::runs::RunsTable;
use super::sheet::{Drafts, Progress, Runner, Sheet, Stage};
use loosepin_bounds::{DoubleLoop, SampleTable, TableError};
use loosepin_result::study::StudyResult;
use loosepin_store::RunStore;
use std::sync::atomic::{AtomicBool, AtomicUsize};

/// With what a study is conducted.
#[derive(Clone, Copy)]
pub struct Means<'a> {
    /// Number of threads; the result is the same for any.
    pub threads: usize,
    /// Hears how far it is.
    pub progress: &'a dyn Progress,
    /// Stops it when set.
    pub stop: &'a AtomicBool,
    /// Where finished runs are kept and found again; nowhere if left out.
    pub store: Option<&'a RunStore>,
}

/// A finished study.
pub struct Conducted {
    /// Everything for pages and files.
    pub result: StudyResult,
    /// Every run.
    pub runs: RunsTable,
    /// The surrogates, to be saved; nothing where the study asks for none.
    pub surrogates: Option<SavedSurrogates>,
}

/// Conducts `study`. The result is the same for any number of threads, and whatever of it was found in a store.
///
/// # Errors
/// See [`StudyError`]; failed runs are no error as long as some succeed.
pub fn conduct(study: &Study, input_hash: &str, means: &Means<'_>) -> Result<Conducted, StudyError> {
    conduct_part(study, input_hash, means, Part::Whole)
}

/// Conducts `study` as far as its rounds are complete, with what is in the store and the runs that `part` makes. A part that is not
/// the whole needs a store.
///
/// # Errors
/// See [`StudyError`]; [`StudyError::RoundOpen`] where runs are missing that are made elsewhere.
pub fn conduct_part(study: &Study, input_hash: &str, means: &Means<'_>, part: Part) -> Result<Conducted, StudyError> {
    if part != Part::Whole {
        refuse_time(study)?;
    }
    conduct_with(study, input_hash, means, part, None)
}

/// [`conduct`] with runs that `maker` makes outside of this process. The result is the same.
///
/// # Errors
/// See [`StudyError`]; [`StudyError::NotMade`] where `maker` does not go on.
pub fn conduct_elsewhere(
    study: &Study,
    input_hash: &str,
    means: &Means<'_>,
    maker: &dyn RunMaker,
) -> Result<Conducted, StudyError> {
    conduct_with(study, input_hash, means, Part::Whole, Some(maker))
}

fn conduct_with(
    study: &Study,
    input_hash: &str,
    means: &Means<'_>,
    part: Part,
    maker: Option<&dyn RunMaker>,
) -> Result<Conducted, StudyError> {
    let Means { threads, progress, stop, store } = *means;
    if !study.has_questions() {
        return Err(StudyError::NothingAsked);
    }
    let response = StudyResponse::new(study)?;
    let plans = Plans::new(study, &response, store.is_some(), threads)?;
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build()?;
    let (before, keeping) = (AtomicUsize::new(0), Keeping::new(store));
    let runner = Runner { pool: &pool, progress, stop, before, keeping, part, maker };
    let (table, note) = plans.table(store.and_then(|store| store.path().parent()));
    if let Some(note) = &note {
        progress.note(note);
    }
    let mut sheet = Sheet::new(&runner, study, &response, table, plans.limits.most_runs());
    // A surrogate that stands alone has rounds of its own.
    let is_told = progress.wants_drafts() && !plans.is_surrogate_alone;
    let drafting = is_told.then(|| Drafting::new(study, &response, plans.refinement.plan(&sheet.table)));
    sheet.drafts = drafting.as_ref().map(|drafting| drafting as &dyn Drafts);
    progress.runs(0, sheet.most_runs);
    let mut found = bounds_of(&plans, &mut sheet)?;
    let mut questions = plans.questions;
    for question in &mut questions {
        question.run(&mut sheet, &mut found)?;
    }
    conclude(&sheet, found, &questions, input_hash)
}

/// The bounds of a study: of its double loop, or of the surrogate where it stands alone.
///
/// # Errors
/// Those of the runs; the budget does not suffice; every run failed.
fn bounds_of(plans: &Plans, sheet: &mut Sheet<'_>) -> Result<Found, StudyError> {
    let found = match &plans.surrogate {
        Some(plan) if plans.is_surrogate_alone => {
            let goals = goals(sheet.study, &sheet.response.shared.plan);
            let steps = SurrogateSteps::new(plan, goals, plans.limits.budget)?;
            let (learned, ended) = take_steps(steps, sheet, Some(&plans.limits))?;
            let bounds = learned.bounds.to_bounds(&learned.plan, sheet.table.rounds());
            let mut found = Found::new(sheet.study.clone(), bounds, ended);
            found.surrogate = Some(learned);
            found
        }
        _ => {
            let steps = DirectSteps::new(plans.refinement.clone(), plans.limits.budget);
            let direct = take_steps(steps, sheet, Some(&plans.limits))?;
            let mut found = Found::new(grown(sheet.study, &direct.plan), direct.bounds, direct.ended);
            found.double_loop = Some(direct.plan);
            found
        }
    };
    if sheet.table.failed() < sheet.table.len() { Ok(found) } else { Err(all_failed(sheet.response, &sheet.table)) }
}

/// `study` with the samples that its double loop came to have.
fn grown(study: &Study, double_loop: &DoubleLoop) -> Study {
    let sampling = double_loop.problem().sampling;
    let mut grown = study.clone();
    grown.sampling.outer = sampling.outer;
    grown.sampling.inner = sampling.inner;
    grown.sampling.replicates = sampling.replicates;
    grown
}

/// Puts the result together: the bounds, then what each question writes into it.
fn conclude(
    sheet: &Sheet<'_>,
    mut found: Found,
    questions: &[Box<dyn Question>],
    input_hash: &str,
) -> Result<Conducted, StudyError> {
    let Runner { pool, progress, .. } = *sheet.runner;
    progress.stage(Stage::Assembling);
    found.complete(sheet)?;
    let (found, material) = (&found, found.material(sheet));
    progress.stage(Stage::Pictures);
    let pictures = pool.install(|| pictures(&material));
    progress.stage(Stage::Assembling);
    let result = pool.install(|| assemble(found, &material, input_hash, pictures));
    let mut conclusion = Conclusion { material, found, input_hash, result, surrogates: None };
    for question in questions {
        pool.install(|| question.record(&mut conclusion))?;
    }
    let Conclusion { mut result, surrogates, .. } = conclusion;
    result.witness_commands = witness_commands(&found.study, &result);
    let runs = sheet.runs_table();
    progress.stage(Stage::Finished);
    Ok(Conducted { result, runs, surrogates })
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
