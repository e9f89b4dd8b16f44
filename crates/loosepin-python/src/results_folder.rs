//! A study in a folder of results: what the command `loosepin study` leaves there, and goes on with.

use std::path::PathBuf;
use std::time::SystemTime;

use loosepin::diagnostics::{Complaints, Problem};
use loosepin::report::study_page;
use loosepin::results::{Claim, InputsHash, InputsHasher, Place, REPORT_FILE, ResultKind, ResultsFolder};
use loosepin::store::{Beginning, RunStore, STORE_FILE, StoreIdentity, remove_store};
use loosepin::study::files::{
    BOUNDS_FILE, RUNS_FILE, SUMMARY_FILE, SURROGATES_FILE, TIMING_FILE, Timing, read_runs_parquet, read_summary,
    runs_parquet, surrogates_json, write_study,
};
use loosepin::study::runs::RunsTable;
use loosepin::study::{Conducted, Means, SavedSurrogates, Study, StudyError, add_model, add_study, conduct};

/// What beside the files goes into the hash of a study: texts that replace what the file says.
pub struct Settings {
    /// Accuracies.
    pub accuracy: Vec<String>,
    /// A budget.
    pub budget: Option<String>,
}

/// How a folder that holds something is met.
#[derive(Clone, Copy)]
pub struct Meeting {
    /// Finished runs of the same study are taken over.
    pub with_resume: bool,
    /// What is there is replaced.
    pub with_force: bool,
}

/// How a study ended.
pub enum Ended {
    /// It is finished.
    Finished(Box<Conducted>),
    /// It was interrupted; the words say what is kept.
    Interrupted(String),
}

/// The hash of everything that the result of `study` is computed from.
pub fn inputs(study: &Study, settings: &Settings) -> InputsHash {
    let mut hasher = InputsHasher::new(ResultKind::Study);
    add_study(&mut hasher, study);
    add_model(&mut hasher, &study.model);
    for accuracy in &settings.accuracy {
        hasher.add("accuracy", accuracy);
    }
    if let Some(budget) = &settings.budget {
        hasher.add("budget", budget);
    }
    hasher.finish()
}

/// Conducts `study` without leaving anything on disk.
pub fn conduct_in_memory(study: &Study, inputs: &InputsHash, means: &Means<'_>) -> Result<Ended, Complaints> {
    match conduct(study, &inputs.to_string(), means) {
        Ok(conducted) => Ok(Ended::Finished(conducted.into())),
        Err(StudyError::Interrupted { finished, most_runs }) => {
            let words = interrupted(&finished, most_runs);
            Ok(Ended::Interrupted(format!("{words}; nothing is kept without a folder")))
        }
        Err(error) => Err(error.complaint(study).into()),
    }
}

/// Conducts `study` in `folder`, or reads the finished result that is there.
pub fn conduct_in_folder(
    study: &Study,
    inputs: InputsHash,
    folder: PathBuf,
    meeting: Meeting,
    means: &Means<'_>,
) -> Result<Ended, Complaints> {
    let claim = Claim {
        kind: ResultKind::Study,
        name: study.name.clone(),
        inputs,
        place: Place::Folder(folder),
        with_force: meeting.with_force,
    };
    // Planned first, so that a study that cannot begin leaves no folder behind.
    loosepin::study::plan_runs(study).map_err(|error| error.complaint(study))?;
    let mut folder = claim.take().map_err(complain)?;
    if folder.is_finished() {
        remove_store(&folder.path().join(STORE_FILE)).map_err(complain)?;
        return Ok(Ended::Finished(read(&folder)?.into()));
    }
    let identity = StoreIdentity { version: loosepin::VERSION.to_owned(), inputs: claim.inputs.to_string() };
    let beginning = match (meeting.with_force, meeting.with_resume) {
        (true, _) => Beginning::Anew,
        (false, true) => Beginning::GoOn,
        (false, false) => Beginning::Empty,
    };
    let path = folder.path().join(STORE_FILE);
    let store = match RunStore::begin(&path, &identity, beginning) {
        Ok(store) => store,
        Err(error) => {
            // Where runs are kept, or another process is at work on them, the folder stays as it is.
            if !path.exists() {
                folder.abandon().map_err(complain)?;
            }
            return Err(complain(error));
        }
    };
    let started = SystemTime::now();
    match conduct(study, &claim.inputs.to_string(), &Means { store: Some(&store), ..*means }) {
        Ok(conducted) => {
            let made = store.settle().map_err(complain)?.saturating_sub(store.runs_at_start());
            write(&mut folder, &conducted, &Timing::since(started, made as usize, means.threads))?;
            store.remove().map_err(complain)?;
            Ok(Ended::Finished(conducted.into()))
        }
        Err(StudyError::Interrupted { finished, most_runs }) => {
            folder.write(RUNS_FILE, &runs_parquet(&finished).map_err(complain)?).map_err(complain)?;
            folder.leave_unfinished().map_err(complain)?;
            let (words, path) = (interrupted(&finished, most_runs), folder.path().display());
            Ok(Ended::Interrupted(format!("{words}; they are kept in {path}: the same call with resume=True goes on")))
        }
        Err(StudyError::TooManyFailed(failed)) => {
            folder.write(RUNS_FILE, &runs_parquet(&failed.runs).map_err(complain)?).map_err(complain)?;
            folder.leave_unfinished().map_err(complain)?;
            Err(StudyError::TooManyFailed(failed).complaint(study).into())
        }
        // The folder says since it was taken that it is not finished; there may be no room to say it again.
        Err(error @ StudyError::Store(_)) => Err(error.complaint(study).into()),
        Err(error) => {
            store.remove().map_err(complain)?;
            folder.abandon().map_err(complain)?;
            Err(error.complaint(study).into())
        }
    }
}

fn write(folder: &mut ResultsFolder, conducted: &Conducted, timing: &Timing) -> Result<(), Complaints> {
    if let Some(surrogates) = &conducted.surrogates {
        let text = surrogates_json(surrogates).map_err(complain)?;
        folder.write(SURROGATES_FILE, text.as_bytes()).map_err(complain)?;
    }
    write_study(folder.path(), &conducted.result, &conducted.runs, timing).map_err(complain)?;
    for file_name in [BOUNDS_FILE, RUNS_FILE, TIMING_FILE, SUMMARY_FILE] {
        folder.add_file(file_name);
    }
    folder.write(REPORT_FILE, study_page(&conducted.result).as_bytes()).map_err(complain)?;
    folder.finish().map_err(complain)
}

/// The finished result that is in `folder`.
fn read(folder: &ResultsFolder) -> Result<Conducted, Complaints> {
    let result = read_summary(folder.path()).map_err(complain)?;
    let path = folder.path().join(RUNS_FILE);
    let bytes =
        std::fs::read(&path).map_err(|source| complain(loosepin::results::ResultsError::Read { path, source }))?;
    let runs = read_runs_parquet(bytes).map_err(complain)?;
    let surrogates = match folder.path().join(SURROGATES_FILE).exists() {
        true => Some(SavedSurrogates::from_json(&folder.read(SURROGATES_FILE).map_err(complain)?).map_err(complain)?),
        false => None,
    };
    Ok(Conducted { result, runs, surrogates })
}

fn interrupted(finished: &RunsTable, most_runs: usize) -> String {
    let count = finished.columns.first().map_or(0, |column| column.data.len());
    // Small probabilities may take more than was expected.
    let of_most = if count < most_runs { format!(" of at most {most_runs}") } else { String::new() };
    format!("interrupted after {count}{of_most} runs")
}

fn complain(problem: impl Problem) -> Complaints {
    Complaints::one(&problem, None)
}
