//! Conducting a study: its questions one after the other, then its result.

use super::allow::{allocation, allowances};
use super::allow_together::together;
use super::assemble::{Answers, Material, assemble, pictures, saved_surrogates};
use super::contributors::ContributorQuestion;
use super::double_loop::{Direct, DirectQuestion};
use super::draft::Drafting;
use super::elsewhere::RunMaker;
use super::error::StudyError;
use super::file::Study;
use super::further_turns::further_turns;
use super::goals::goals;
use super::keep::Keeping;
use super::learned::{LearnedBounds, SurrogateQuestion};
use super::part::Part;
use super::plans::{Plans, refuse_time};
use super::promise::{PromiseQuestion, Promised};
use super::question::ask;
use super::rare::{Rare, RareQuestion};
use super::response::StudyResponse;
use super::runs::RunsTable;
use super::saved_surrogates::SavedSurrogates;
use super::sheet::{Drafts, Progress, Runner, Sheet, Stage};
use super::simultaneous::curve_bands;
use loosepin_bounds::{Bounds, PromisedBound, SampleTable, TableError};
use loosepin_result::study::{AllocationRecord, AllowanceRecord, StudyResult, TogetherRecord};
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
    let direct = direct(&plans, &mut sheet)?;
    let refined = direct.as_ref().map_or_else(|| study.clone(), |direct| grown(study, direct));
    let rare = match &direct {
        Some(direct) => around(&plans, &refined, direct, &mut sheet)?,
        None => Vec::new(),
    };
    let learned = learned(&plans, &mut sheet)?;
    let rounds = sheet.table.rounds();
    let promised = match &plans.promise {
        Some(plan) => ask(PromiseQuestion::new(plan, rounds), &mut sheet, None)?,
        None => Vec::new(),
    };
    let loosened = inverse_question(&sheet)?;
    let found = Found { refined, direct, rare, learned, rounds, promised, loosened };
    tell(&sheet, plans, found, input_hash)
}

/// Answers of the questions.
struct Found {
    /// The study with the samples that it came to have.
    refined: Study,
    direct: Option<Direct>,
    rare: Vec<Rare>,
    learned: Option<LearnedBounds>,
    /// Rounds of the bounds, without that of the promise.
    rounds: u32,
    promised: Vec<PromisedBound>,
    loosened: LoosestValues,
}

/// How loose inputs may be.
struct LoosestValues {
    one_at_a_time: Vec<AllowanceRecord>,
    together: Option<TogetherRecord>,
    cheapest: Option<AllocationRecord>,
}

/// The direct double loop; nothing where the surrogate stands alone.
fn direct(plans: &Plans, sheet: &mut Sheet<'_>) -> Result<Option<Direct>, StudyError> {
    if plans.is_surrogate_alone {
        return Ok(None);
    }
    let question = DirectQuestion::new(plans.refinement.clone(), plans.limits.budget);
    let direct = ask(question, sheet, Some(&plans.limits))?;
    refuse_all_failed(sheet)?;
    Ok(Some(direct))
}

/// `study` with the samples that its double loop came to have.
fn grown(study: &Study, direct: &Direct) -> Study {
    let sampling = direct.plan.problem().sampling;
    let mut grown = study.clone();
    grown.sampling.outer = sampling.outer;
    grown.sampling.inner = sampling.inner;
    grown.sampling.replicates = sampling.replicates;
    grown
}

/// The questions around the double loop: contributors, and small probabilities that it leaves to be estimated.
fn around(plans: &Plans, study: &Study, direct: &Direct, sheet: &mut Sheet<'_>) -> Result<Vec<Rare>, StudyError> {
    if let Some(contributors) = &plans.contributors {
        ask(ContributorQuestion::new(contributors, direct), sheet, None)?;
    }
    ask(RareQuestion::new(study, &sheet.response.shared.plan.asks, direct), sheet, None)
}

/// The surrogates, where the study asks for them: towards its goals where they stand alone.
fn learned(plans: &Plans, sheet: &mut Sheet<'_>) -> Result<Option<LearnedBounds>, StudyError> {
    let Some(plan) = &plans.surrogate else { return Ok(None) };
    let is_alone = plans.is_surrogate_alone;
    let goals = if is_alone { goals(sheet.study, &sheet.response.shared.plan) } else { Vec::new() };
    let question = SurrogateQuestion::new(plan, goals, is_alone, plans.limits.budget)?;
    let learned = ask(question, sheet, Some(&plans.limits).filter(|_| is_alone))?;
    refuse_all_failed(sheet)?;
    Ok(Some(learned))
}

/// How loose inputs may be. Its studies have sheets of their own; what is in `sheet` is kept whatever happens to them.
fn inverse_question(sheet: &Sheet<'_>) -> Result<LoosestValues, StudyError> {
    sheet.close();
    let answers = || {
        let together = together(sheet)?;
        let one_at_a_time = if together.is_some() { Vec::new() } else { allowances(sheet)? };
        Ok(LoosestValues { one_at_a_time, together, cheapest: allocation(sheet)? })
    };
    answers().map_err(|error| match error {
        StudyError::Interrupted { most_runs, .. } => {
            StudyError::Interrupted { finished: Box::new(sheet.runs_table()), most_runs }
        }
        error => error,
    })
}

/// Puts the result together.
fn tell(sheet: &Sheet<'_>, plans: Plans, found: Found, input_hash: &str) -> Result<Conducted, StudyError> {
    let Found { refined, direct, rare, learned, rounds, promised, loosened } = found;
    let LoosestValues { one_at_a_time: allowances, together, cheapest: allocation } = loosened;
    let (study, table, pool, progress) = (sheet.study, &sheet.table, sheet.runner.pool, sheet.runner.progress);
    progress.stage(Stage::Assembling);
    let (plan, mut ended, bounds) = match direct {
        Some(Direct { plan, bounds, ended }) => (Some(plan), Some(ended), Some(bounds)),
        None => (None, None, None),
    };
    let (mut learned, mut bounds) = (learned, bounds);
    if let Some(learned) = learned.as_mut() {
        // The bounds that the study states are those of the surrogate that stands alone.
        ended = learned.ended.take().or(ended);
        bounds = bounds.or_else(|| Some(learned.bounds.to_bounds(&learned.plan, rounds)));
    }
    let (Some(ended), Some(bounds)) = (ended, bounds) else { return Err(all_failed(sheet.response, table)) };
    let material = Material {
        study: &refined,
        response: sheet.response,
        table,
        bounds: &bounds,
        pairs: &bounds.pairs,
        rare: &rare,
    };
    let (mut beside, mut bands): (Vec<Bounds>, _) = (Vec::new(), Vec::new());
    if let Some(plan) = &plan {
        for &reading in &study.readings[1..] {
            beside.push(pool.install(|| plan.read_as(reading).statistics_alone().results(table))?);
        }
        bands = pool.install(|| curve_bands(&material, plan))?;
    }
    let surrogates =
        learned.as_ref().map(|learned| saved_surrogates(&material, input_hash, &learned.plan, &learned.bounds));
    let contributors = plans.contributors;
    let promise = plans.promise.map(|plan| Promised::new(plan, promised, &bands, table)).transpose()?;
    progress.stage(Stage::Pictures);
    let drawn = pool.install(|| pictures(&material));
    progress.stage(Stage::Assembling);
    let curve_bands = bands;
    let further_turns = further_turns(sheet)?;
    let answers = Answers {
        plan,
        ended,
        contributors,
        learned,
        promise,
        allowances,
        together,
        allocation,
        curve_bands,
        further_turns,
        beside,
        pictures: drawn,
    };
    let result = pool.install(|| assemble(&material, input_hash, answers));
    let runs = sheet.runs_table();
    progress.stage(Stage::Finished);
    Ok(Conducted { result, runs, surrogates })
}

fn refuse_all_failed(sheet: &Sheet<'_>) -> Result<(), StudyError> {
    if sheet.table.failed() < sheet.table.len() { Ok(()) } else { Err(all_failed(sheet.response, &sheet.table)) }
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
