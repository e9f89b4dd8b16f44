//! `loosepin study`.

use std::path::Path;
use std::time::SystemTime;

use loosepin::report::{study_page, study_text};
use loosepin::results::{Claim, InputsHash, InputsHasher, REPORT_FILE, ResultKind, ResultsFolder};
use loosepin::store::{Beginning, RunStore, STORE_FILE, StoreIdentity, remove_store};
use loosepin::study::files::{
    BOUNDS_FILE, RUNS_FILE, SUMMARY_FILE, SURROGATES_FILE, TIMING_FILE, Timing, read_summary, runs_parquet,
    surrogates_json, write_study,
};
use loosepin::study::result::{StudyResult, Verdict};
use loosepin::study::runs::RunsTable;
use loosepin::study::{Conducted, Means, Study, StudyError, conduct};

use super::inputs::{add_model, add_study, read_study};
use super::shard;
use super::signals::stop_on_signals;
use super::stored::{StoredResult, place, show_again, tell, tell_again};
use super::threads::threads;
use crate::arguments::StudyArguments;
use crate::console;
use crate::ending::{Done, Ending, Failure};
use crate::progress::Bar;

/// Conducts the study, or shows the one that is there.
pub fn run(arguments: &StudyArguments) -> Ending {
    let (mut study, inputs) = read_stated(&arguments.study, &arguments.accuracy, arguments.budget.as_deref())?;
    // No input of the results: it says only when the study is given up.
    study.sampling.most_failed = arguments.most_failed.unwrap_or(study.sampling.most_failed);
    let claim = Claim {
        kind: ResultKind::Study,
        name: study.name.clone(),
        inputs,
        place: place(&arguments.output),
        with_force: arguments.output.force,
    };
    if let Some(shard) = arguments.shard {
        return shard::run(arguments, shard, &study, claim);
    }
    // Planned first, so that a study that cannot begin leaves no folder behind.
    loosepin::study::plan_runs(&study).map_err(|error| error.complaint(&study))?;
    let stop = stop_on_signals("Ctrl-C will end the study at once; what was finished until a moment before is kept");
    let mut folder = claim.take()?;
    if folder.is_finished() {
        remove_store(&folder.path().join(STORE_FILE)).map_err(|error| Failure::of(&error))?;
        tell_again(&folder);
        return show_again::<StudyResult>(&mut folder);
    }
    let store = match open_store(&folder, None, &claim, arguments.resume) {
        Ok(store) => store,
        Err(failure) => {
            // Where runs are kept, or another process is at work on them, the folder stays as it is.
            if !folder.path().join(STORE_FILE).exists() {
                folder.abandon()?;
            }
            return Err(failure);
        }
    };
    let threads = threads(arguments.threads);
    let started = SystemTime::now();
    let bar = Bar::going_on(store.runs_at_start() as usize);
    let means = Means { threads, progress: &bar, stop: &stop, store: Some(&store) };
    let outcome = conduct(&study, &claim.inputs.to_string(), &means);
    bar.finish();
    conclude(&study, folder, store, outcome, &|| Timing::since(started, bar.made(), threads))
}

/// Reads a study with what the command line states beside the file; also gives the hash of all inputs.
///
/// # Errors
/// Everything that is wrong with them.
pub fn read_stated(path: &Path, accuracy: &[String], budget: Option<&str>) -> Result<(Study, InputsHash), Failure> {
    let mut study = read_study(path)?;
    let mut hasher = InputsHasher::new(ResultKind::Study);
    add_study(&mut hasher, &study);
    add_model(&mut hasher, &study.model);
    for accuracy in accuracy {
        study.add_accuracy(accuracy)?;
        hasher.add("accuracy", accuracy);
    }
    if let Some(budget) = budget {
        study.set_budget(budget)?;
        hasher.add("budget", budget);
    }
    Ok((study, hasher.finish()))
}

/// Writes what came of a study, or keeps what there is of it.
///
/// # Errors
/// Why it has no result, or cannot be written.
pub fn conclude(
    study: &Study,
    mut folder: ResultsFolder,
    store: RunStore,
    outcome: Result<Conducted, StudyError>,
    timing: &dyn Fn() -> Timing,
) -> Ending {
    match outcome {
        Ok(Conducted { result, runs, surrogates }) => {
            if let Some(surrogates) = &surrogates {
                let text = surrogates_json(surrogates).map_err(|error| Failure::of(&error))?;
                folder.write(SURROGATES_FILE, text.as_bytes())?;
            }
            write(&mut folder, &result, &runs, &timing())?;
            store.remove().map_err(|error| Failure::of(&error))?;
            tell(&result, &folder)
        }
        Err(StudyError::Interrupted { finished, most_runs }) => keep(&mut folder, &finished, most_runs),
        Err(StudyError::TooManyFailed(failed)) => {
            let parquet = runs_parquet(&failed.runs).map_err(|error| Failure::of(&error))?;
            folder.write(RUNS_FILE, &parquet)?;
            folder.leave_unfinished()?;
            Err(StudyError::TooManyFailed(failed).complaint(study).into())
        }
        // The folder says since it was taken that it is not finished; there may be no room to say it again.
        Err(error @ StudyError::Store(_)) => Err(error.complaint(study).into()),
        Err(error) => {
            store.remove().map_err(|error| Failure::of(&error))?;
            folder.abandon()?;
            Err(error.complaint(study).into())
        }
    }
}

/// Whose runs the store of a study holds.
pub fn identity(claim: &Claim) -> StoreIdentity {
    StoreIdentity { version: loosepin::VERSION.to_owned(), inputs: claim.inputs.to_string() }
}

/// The store of finished runs in `folder`: an empty one, or what an earlier command has left of the same study. What was
/// `published` is found in it as well.
///
/// # Errors
/// It cannot be used, or holds runs and nobody said what is to become of them.
pub fn open_store(
    folder: &ResultsFolder,
    published: Option<&Path>,
    claim: &Claim,
    with_resume: bool,
) -> Result<RunStore, Failure> {
    let path = folder.path().join(STORE_FILE);
    let beginning = match (claim.with_force, with_resume) {
        (true, _) => Beginning::Anew,
        (false, true) => Beginning::GoOn,
        (false, false) => Beginning::Empty,
    };
    let store = RunStore::begin_beside(&path, published, &identity(claim), beginning);
    let store = store.map_err(|error| Failure::of(&error))?;
    if store.runs_at_start() > 0 {
        let runs = console::counted(store.runs_at_start() as usize, "finished run", "finished runs");
        console::message(&format!("going on with {runs}"));
    }
    Ok(store)
}

impl StoredResult for StudyResult {
    fn read(folder: &ResultsFolder) -> Result<Self, Failure> {
        read_summary(folder.path()).map_err(|error| Failure::of(&error))
    }

    fn page(&self) -> String {
        study_page(self)
    }

    fn text(&self) -> String {
        study_text(self)
    }

    fn done(&self) -> Done {
        let is_met = self.requirements.iter().all(|requirement| requirement.verdict == Verdict::Met);
        if is_met { Done::Well } else { Done::RequirementNotMet }
    }
}

fn write(folder: &mut ResultsFolder, result: &StudyResult, runs: &RunsTable, timing: &Timing) -> Result<(), Failure> {
    write_study(folder.path(), result, runs, timing).map_err(|error| Failure::of(&error))?;
    for file_name in [BOUNDS_FILE, RUNS_FILE, TIMING_FILE, SUMMARY_FILE] {
        folder.add_file(file_name);
    }
    folder.write(REPORT_FILE, study_page(result).as_bytes())?;
    Ok(folder.finish()?)
}

/// Shows the runs that were finished when the study was interrupted; the store keeps them.
fn keep(folder: &mut ResultsFolder, finished: &RunsTable, most_runs: usize) -> Ending {
    let count = finished.columns.first().map_or(0, |column| column.data.len());
    let parquet = runs_parquet(finished).map_err(|error| Failure::of(&error))?;
    folder.write(RUNS_FILE, &parquet)?;
    folder.leave_unfinished()?;
    console::message(&format!(
        "interrupted after {count} of at most {most_runs} runs; they are kept in {}\n\
         hint: the same command with --resume goes on",
        folder.path().join(STORE_FILE).display()
    ));
    Ok(Done::Interrupted)
}
