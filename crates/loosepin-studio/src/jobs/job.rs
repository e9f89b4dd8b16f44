//! One study or one mechanism, run as the command runs it: the same inputs, the same folder, the same bytes.

use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::SystemTime;

use loosepin::diagnostics::Diagnostics;
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

/// Reads a study of the folder: its texts as the page shows them, or those on the disk.
///
/// # Errors
/// What is wrong with it, in words.
pub fn read_study(folder: &Folder, path: &str, shown: Option<&Shown>) -> Result<Study, Vec<String>> {
    let texts = match shown {
        Some(shown) => Texts::shown(folder, shown),
        None => Texts::of_study(folder, path),
    };
    let texts = texts.map_err(message_and_hint)?;
    let file = texts.read_to_run().map_err(|diagnostics| words(&diagnostics))?;
    file.into_study().map_err(|diagnostics| words(&diagnostics))
}

/// Runs a study, or finds the one that is there; runs that an earlier attempt has kept are taken over.
///
/// # Errors
/// Why it came to no result, in words.
pub fn run(
    folder: &Folder,
    study: &Study,
    progress: &dyn Progress,
    stop: &AtomicBool,
    threads: usize,
) -> Result<Outcome, Vec<String>> {
    run_or_read(folder, study, progress, stop, threads).map_err(|diagnostics| words(&diagnostics))
}

fn message_and_hint(refusal: Refusal) -> Vec<String> {
    std::iter::once(refusal.message).chain(refusal.hint).collect()
}

/// Runs the mechanism at a witness of the finished study in the folder `path`, from the texts that the result holds, as its command does;
/// or finds an existing run. `named` hears what is run.
///
/// # Errors
/// Why it came to no result, in words.
pub fn run_witness(
    folder: &Folder,
    path: &str,
    witness: usize,
    named: &dyn Fn(String),
    stop: &AtomicBool,
) -> Result<Outcome, Vec<String>> {
    let result = stored_study(folder, path).map_err(message_and_hint)?;
    let missing = || vec![format!("the result '{path}' has no witness {witness}")];
    let command = result.witness_commands.get(witness).ok_or_else(missing)?;
    let study = study_of(&result).map_err(message_and_hint)?;
    let (settings, plan) = witness_run(&study, &command.witness).ok_or_else(missing)?;
    let values = witness_words(&result).into_iter().nth(witness).map(|words| words.values.join(", "));
    named(format!("{}: {}", study.model.name(), values.unwrap_or_default()));
    let model = study.model.demand_planar().map_err(|diagnostics| words(&diagnostics))?;
    simulated(folder, model, &settings, &plan, stop).map_err(|diagnostics| words(&diagnostics))
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
