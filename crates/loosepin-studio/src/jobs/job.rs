//! One study or one mechanism, run as the command runs it: the same inputs, the same folder, the same bytes.

use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::SystemTime;

use loosepin::diagnostics::{Diagnostics, Severity};
use loosepin::mechanism::Mechanism;
use loosepin::model::Model;
use loosepin::report::{simulation_page, study_page, study_sentences, witness_words};
use loosepin::results::{Claim, Destination, ResultKind, ResultsError};
use loosepin::simulate::{Plan, SmallestClearance};
use loosepin::store::{ExistingRuns, RunStore};
use loosepin::study::files::read_summary;
use loosepin::study::result::{StudyResult, Verdict};
use loosepin::study::{
    ClaimOutcome, Progress, RunOptions, Study, StudyOutcome, begin_in_folder, conclude, plan_runs, run_inputs,
    run_into, run_study, store_identity, study_inputs, witness_run,
};

use crate::files::folder::Folder;
use crate::files::stored::{stored_study, study_of};
use crate::messages::Shown;
use crate::network::refusal::Refusal;
use crate::view::texts::Texts;

/// Folder below the served one in which results get a folder of their own.
const RESULTS: &str = "results";

/// Outcome of a study.
pub enum Outcome {
    /// Its results stand in a folder.
    Finished {
        /// Path of the folder in the served one.
        result: String,
        /// The answer in sentences.
        words: Vec<String>,
        /// Over all requirements.
        verdict: Option<Verdict>,
    },
    /// The job was stopped; its runs are kept.
    Stopped,
}

/// Why a job came to no result.
pub struct Failure {
    /// In a sentence.
    pub reason: String,
    /// All that was found, as the command prints it.
    pub lines: Vec<String>,
}

impl From<Refusal> for Failure {
    fn from(Refusal { message, hint, .. }: Refusal) -> Self {
        Self { reason: message.clone(), lines: std::iter::once(message).chain(hint).collect() }
    }
}

impl From<Diagnostics> for Failure {
    fn from(found: Diagnostics) -> Self {
        let errors = found.sorted();
        let reason = errors.iter().find(|one| one.severity == Severity::Error).or(errors.first());
        Self { reason: reason.map(|one| one.message.clone()).unwrap_or_default(), lines: words(&found) }
    }
}

/// Reads a study of the folder: its texts as the page shows them, or those on the disk.
///
/// # Errors
/// What is wrong with it.
pub fn read_study(folder: &Folder, path: &str, shown: Option<&Shown>) -> Result<Study, Failure> {
    let texts = match shown {
        Some(shown) => Texts::shown(folder, shown),
        None => Texts::of_study(folder, path),
    };
    Ok(texts?.read_to_run()?.into_study()?)
}

/// Runs a study, or finds the one that is there; runs that an earlier attempt has kept are taken over.
///
/// # Errors
/// Why it came to no result.
pub fn run(
    folder: &Folder,
    study: &Study,
    progress: &dyn Progress,
    stop: &AtomicBool,
    threads: usize,
) -> Result<Outcome, Failure> {
    Ok(run_or_read(folder, study, progress, stop, threads)?)
}

/// Runs the mechanism at a witness of the finished study in the folder `path`, from the texts that the result holds, as its command does;
/// or finds an existing run. `named` hears what is run.
///
/// # Errors
/// Why it came to no result.
pub fn run_witness(
    folder: &Folder,
    path: &str,
    witness: usize,
    named: &dyn Fn(String),
    stop: &AtomicBool,
) -> Result<Outcome, Failure> {
    let result = stored_study(folder, path)?;
    let missing = || {
        let reason = format!("the result '{path}' has no witness {witness}");
        Failure { lines: vec![reason.clone()], reason }
    };
    let command = result.witness_commands.get(witness).ok_or_else(missing)?;
    let study = study_of(&result)?;
    let (settings, plan) = witness_run(&study, &command.witness).ok_or_else(missing)?;
    let values = witness_words(&result).into_iter().nth(witness).map(|words| words.values.join(", "));
    named(format!("{}: {}", study.model.name(), values.unwrap_or_default()));
    Ok(simulated(folder, study.model.demand_planar()?, &settings, &plan, stop)?)
}

fn simulated(
    folder: &Folder,
    model: &Model,
    settings: &[String],
    plan: &Plan,
    stop: &AtomicBool,
) -> Result<Outcome, Diagnostics> {
    let set = model.set_values(settings)?;
    if let Some(smallest) = SmallestClearance::of(&set.model, &set.values) {
        smallest.check(plan.settings.tolerance_m).map_err(|error| Diagnostics::one(&error, None))?;
    }
    let report = |error: ResultsError| Diagnostics::one(&error, None);
    let claim = Claim {
        kind: ResultKind::Simulation,
        name: model.name.clone(),
        inputs: run_inputs(model, settings, plan, &[]),
        destination: Destination::Within(folder.opened().clone(), RESULTS.into()),
        with_force: false,
    };
    let mechanism = Mechanism::new(&set.model, &set.values).map_err(|error| error.diagnostic(model))?;
    let mut results = claim.take().map_err(report)?;
    let finished = |results: &Path, words: Vec<String>| Outcome::Finished {
        result: results.strip_prefix(folder.root()).unwrap_or(results).display().to_string(),
        words,
        verdict: None,
    };
    if results.is_finished() {
        return Ok(finished(results.path(), Vec::new()));
    }
    match run_into(&mut results, (&mechanism, &set), plan, &[], &simulation_page, stop) {
        Ok(run) => {
            let mut failed = Diagnostics::new();
            run.failure.into_iter().for_each(|failure| failed.push(failure));
            Ok(finished(results.path(), words(&failed)))
        }
        Err(diagnostics) => {
            if !results.is_finished() {
                results.abandon().map_err(report)?;
            }
            if stop.load(Ordering::Relaxed) { Ok(Outcome::Stopped) } else { Err(diagnostics) }
        }
    }
}

fn run_or_read(
    folder: &Folder,
    study: &Study,
    progress: &dyn Progress,
    stop: &AtomicBool,
    threads: usize,
) -> Result<Outcome, Diagnostics> {
    let inputs = study_inputs(study, &[], None);
    let destination = Destination::Within(folder.opened().clone(), RESULTS.into());
    let claim = Claim { kind: ResultKind::Study, name: study.name.clone(), inputs, destination, with_force: false };
    let is_there = claim.is_finished().map_err(|error| Diagnostics::one(&error, None))?;
    if !is_there {
        plan_runs(study).map_err(|error| error.diagnostic(study))?;
    }
    let identity = store_identity(&claim.inputs);
    let (results, store) = match begin_in_folder(&claim, |lock| RunStore::begin(lock, &identity, ExistingRuns::GoOn))? {
        ClaimOutcome::Open(results, store) => (results, store),
        ClaimOutcome::Finished(results) => {
            let result = read_summary(&results.finished()).map_err(|error| Diagnostics::one(&error, None))?;
            return Ok(finished(folder, results.path(), &result));
        }
    };
    let started = SystemTime::now();
    let options = RunOptions { store: Some(&store), ..RunOptions::new(threads, progress, stop) };
    let outcome = run_study(study, &claim.inputs.to_string(), &options);
    Ok(match conclude(study, results, store, outcome, &study_page, (started, threads))? {
        StudyOutcome::Finished { run, folder: results } => finished(folder, results.path(), &run.result),
        StudyOutcome::Interrupted { .. } => Outcome::Stopped,
    })
}

fn finished(folder: &Folder, results: &Path, result: &StudyResult) -> Outcome {
    let below = results.strip_prefix(folder.root()).unwrap_or(results);
    Outcome::Finished { result: below.display().to_string(), words: study_sentences(result), verdict: result.verdict() }
}

/// As the command prints them, one by one.
fn words(diagnostics: &Diagnostics) -> Vec<String> {
    diagnostics.sorted().into_iter().map(ToString::to_string).collect()
}
