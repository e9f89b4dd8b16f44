//! A study in its folder of results: opening it before the runs, and writing it after them.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::SystemTime;

use crate::error::StudyError;
use crate::file::Study;
use crate::question::{SavedSurrogates, StudyRun};
use crate::runs::table::RunsTable;
use crate::written::tables::{
    RUNS_FILE, SURROGATES_FILE, Timing, read_runs_parquet, read_summary, runs_parquet, surrogates_json, write_study,
};
use loosepin_files::FolderLock;
use loosepin_result::study::StudyResult;
use loosepin_store::results::{Claim, FinishedResult, InputsHash, REPORT_FILE, ResultKind, ResultsFolder};
use loosepin_store::{RunStore, STORE_COMPANIONS, STORE_FILE, StoreError, StoreIdentity, remove_store};
use loosepin_text::diagnostics::{Diagnostics, Problem};

/// Outcome of a study in a folder.
pub enum StudyOutcome {
    /// Its results stand in the folder.
    Finished {
        /// The results.
        run: Box<StudyRun>,
        /// The folder.
        folder: ResultsFolder,
    },
    /// The study was interrupted: its store and `runs.parquet` stand in the folder.
    Interrupted {
        /// The finished runs.
        finished: Box<RunsTable>,
        /// Upper limit of its runs.
        most_runs: usize,
        /// The folder.
        folder: PathBuf,
    },
}

/// Identity of the store of a study with these inputs.
pub fn store_identity(inputs: &InputsHash) -> StoreIdentity {
    StoreIdentity { version: loosepin_text::VERSION.to_owned(), inputs: inputs.to_string() }
}

/// The outcome of claiming the folder of a study.
pub enum ClaimOutcome {
    /// Its results are there already.
    Finished(ResultsFolder),
    /// The folder is taken, and the store is open.
    Open(ResultsFolder, RunStore),
}

/// Takes the folder that `claim` asks for, and opens the store of finished runs in it by `open`. The store comes before the result is
/// begun: whoever is refused by it has changed nothing in the folder.
///
/// # Errors
/// The folder holds something else; the store cannot be used, or holds runs and nobody said what is to become of them.
pub fn begin_in_folder(
    claim: &Claim,
    open: impl Fn(&Arc<FolderLock>) -> Result<RunStore, StoreError>,
) -> Result<ClaimOutcome, Diagnostics> {
    let store_files: Vec<&str> = STORE_COMPANIONS.into_iter().chain([STORE_FILE]).collect();
    let folder = claim.lock(&store_files).map_err(report)?;
    if folder.is_finished() {
        remove_store(folder.lock()).map_err(report)?;
        return Ok(ClaimOutcome::Finished(folder.begin().map_err(report)?));
    }
    // A store that cannot be looked at is one that is there.
    let was_there = folder.lock().folder().find(Path::new(STORE_FILE)).map_or(true, |found| found.is_some());
    let store = open(folder.lock()).map_err(|error| {
        // What was made and cannot be used goes; what another process has made is his.
        if !was_there && !matches!(error, StoreError::InUse { .. }) {
            let _ = remove_store(folder.lock());
        }
        report(error)
    })?;
    match folder.begin() {
        Ok(folder) => Ok(ClaimOutcome::Open(folder, store)),
        Err(error) => {
            if !was_there {
                let _ = store.remove();
            }
            Err(report(error))
        }
    }
}

/// The finished study that a folder holds: its result, its runs, and surrogates where it asked for them.
///
/// # Errors
/// It holds another kind of result; a file that is not as it was written, or that another version wrote.
pub fn read_study(folder: &FinishedResult) -> Result<StudyRun, Diagnostics> {
    folder.demand(ResultKind::Study).map_err(report)?;
    let result = read_summary(folder).map_err(report)?;
    let runs = read_runs_parquet(&folder.read(RUNS_FILE).map_err(report)?).map_err(report)?;
    let surrogates = if folder.has(SURROGATES_FILE) {
        let text = folder.read_text(SURROGATES_FILE).map_err(report)?;
        Some(SavedSurrogates::from_json(&text).map_err(report)?)
    } else {
        None
    };
    Ok(StudyRun { result, runs, surrogates })
}

/// Writes the outcome of a study that began at `started` into its folder, or keeps the finished runs there; `page` makes its report.
///
/// # Errors
/// Why it has no result, or cannot be written.
pub fn conclude(
    study: &Study,
    mut folder: ResultsFolder,
    store: RunStore,
    outcome: Result<StudyRun, StudyError>,
    page: &dyn Fn(&StudyResult) -> String,
    (started, threads): (SystemTime, usize),
) -> Result<StudyOutcome, Diagnostics> {
    match outcome {
        Ok(run) => {
            let made = store.flush().map_err(report)?.saturating_sub(store.runs_at_start());
            let timing = Timing::since(started, made as usize, threads);
            write(&mut folder, &run, page, &timing)?;
            store.remove().map_err(report)?;
            Ok(StudyOutcome::Finished { run: run.into(), folder })
        }
        Err(StudyError::Interrupted { finished, most_runs }) => {
            keep(&mut folder, &finished)?;
            Ok(StudyOutcome::Interrupted { finished, most_runs, folder: folder.path().to_owned() })
        }
        Err(StudyError::TooManyFailed(failed)) => {
            keep(&mut folder, &failed.runs)?;
            Err(StudyError::TooManyFailed(failed).diagnostic(study).into())
        }
        // The folder says since it was taken that it is not finished; there may be no room to say it again.
        Err(error @ (StudyError::Store(_) | StudyError::NotMade { .. })) => Err(error.diagnostic(study).into()),
        Err(error) => {
            if store.flush().map_err(report)? > 0 {
                // Runs were made: they are not lost for what came after them.
                folder.leave_unfinished().map_err(report)?;
            } else {
                store.remove().map_err(report)?;
                folder.abandon().map_err(report)?;
            }
            Err(error.diagnostic(study).into())
        }
    }
}

fn write(
    folder: &mut ResultsFolder,
    run: &StudyRun,
    page: &dyn Fn(&StudyResult) -> String,
    timing: &Timing,
) -> Result<(), Diagnostics> {
    if let Some(surrogates) = &run.surrogates {
        let text = surrogates_json(surrogates).map_err(report)?;
        folder.write(SURROGATES_FILE, text.as_bytes()).map_err(report)?;
    }
    write_study(folder, &run.result, &run.runs, timing).map_err(report)?;
    folder.write(REPORT_FILE, page(&run.result).as_bytes()).map_err(report)?;
    folder.finish().map_err(report)
}

/// Shows the runs that were finished; the store keeps them.
fn keep(folder: &mut ResultsFolder, finished: &RunsTable) -> Result<(), Diagnostics> {
    let parquet = runs_parquet(finished).map_err(report)?;
    folder.write(RUNS_FILE, &parquet).map_err(report)?;
    folder.leave_unfinished().map_err(report)
}

fn report(problem: impl Problem) -> Diagnostics {
    Diagnostics::one(&problem, None)
}
