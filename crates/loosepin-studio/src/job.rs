//! One study, run as the command runs it: the same inputs, the same folder, the same bytes.

use std::path::Path;
use std::sync::atomic::AtomicBool;
use std::time::SystemTime;

use loosepin::diagnostics::Complaints;
use loosepin::report::{study_page, study_sentences, verdict_words};
use loosepin::results::{Claim, Place, ResultKind};
use loosepin::store::{Beginning, RunStore};
use loosepin::study::files::read_summary;
use loosepin::study::result::StudyResult;
use loosepin::study::{
    Begun, Concluded, Means, Progress, Study, begin_in_folder, conclude, conduct, plan_runs, store_identity,
    study_inputs,
};

use crate::folder::Folder;
use crate::texts::Texts;

/// Folder below the served one in which results get a folder of their own.
const RESULTS: &str = "results";

/// What became of a study.
pub enum Outcome {
    /// Its results stand in a folder.
    Finished {
        /// Path of the folder in the served one.
        result: String,
        /// The answer in sentences.
        words: Vec<String>,
        /// Over all requirements.
        verdict: Option<&'static str>,
    },
    /// It was stopped; its runs are kept.
    Stopped,
}

/// Reads a study that is saved in the folder.
///
/// # Errors
/// What is wrong with it, in words.
pub fn read_study(folder: &Folder, path: &str) -> Result<Study, Vec<String>> {
    let texts = Texts::of_study(folder, path).map_err(|refusal| vec![refusal.message])?;
    let file = texts.read().map_err(|complaints| words(&complaints))?;
    file.into_study().map_err(|complaints| words(&complaints))
}

/// Conducts a study, or finds the one that is there; runs that an earlier attempt has kept are taken over.
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
    // A link of that name may lead out of the folder.
    if folder.root().join(RESULTS).symlink_metadata().is_ok() {
        folder.existing(RESULTS).map_err(|refusal| vec![refusal.message])?;
    }
    conducted(folder, study, progress, stop, threads).map_err(|complaints| words(&complaints))
}

fn conducted(
    folder: &Folder,
    study: &Study,
    progress: &dyn Progress,
    stop: &AtomicBool,
    threads: usize,
) -> Result<Outcome, Complaints> {
    let inputs = study_inputs(study, &[], None);
    let place = Place::Below(folder.root().join(RESULTS));
    let claim = Claim { kind: ResultKind::Study, name: study.name.clone(), inputs, place, with_force: false };
    let is_there = claim.is_finished().map_err(|error| Complaints::one(&error, None))?;
    if !is_there {
        plan_runs(study).map_err(|error| error.complaint(study))?;
    }
    let identity = store_identity(&claim.inputs);
    let (results, store) = match begin_in_folder(&claim, |path| RunStore::begin(path, &identity, Beginning::GoOn))? {
        Begun::Open(results, store) => (results, store),
        Begun::Finished(results) => {
            let result = read_summary(&results).map_err(|error| Complaints::one(&error, None))?;
            return Ok(finished(folder, results.path(), &result));
        }
    };
    let started = SystemTime::now();
    let means = Means { threads, progress, stop, store: Some(&store) };
    let outcome = conduct(study, &claim.inputs.to_string(), &means);
    Ok(match conclude(study, results, store, outcome, &study_page, (started, threads))? {
        Concluded::Finished { conducted, folder: results } => finished(folder, results.path(), &conducted.result),
        Concluded::Interrupted { .. } => Outcome::Stopped,
    })
}

fn finished(folder: &Folder, results: &Path, result: &StudyResult) -> Outcome {
    let below = results.strip_prefix(folder.root()).unwrap_or(results);
    Outcome::Finished {
        result: below.display().to_string(),
        words: study_sentences(result),
        verdict: result.verdict().map(verdict_words),
    }
}

/// As the command prints them, one by one.
fn words(complaints: &Complaints) -> Vec<String> {
    complaints.sorted().into_iter().map(ToString::to_string).collect()
}
