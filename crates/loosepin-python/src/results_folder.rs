//! A study in a folder of results, as the command `loosepin study` writes and resumes it.

use std::path::PathBuf;
use std::time::SystemTime;

use loosepin::diagnostics::{Diagnostics, Problem};
use loosepin::report::study_page;
use loosepin::results::{Claim, Destination, InputsHash, ResultKind};
use loosepin::store::{ExistingRuns, RunStore};
use loosepin::study::RunsTable;
use loosepin::study::{
    ClaimOutcome, RunOptions, Study, StudyError, StudyOutcome, StudyRun, begin_in_folder, conclude, read_study,
    run_study, store_identity,
};

/// How a folder that holds something is met.
#[derive(Clone, Copy)]
pub struct ExistingFolderOptions {
    /// Finished runs of the same study are taken over.
    pub with_resume: bool,
    /// Whether existing results are replaced.
    pub with_force: bool,
}

/// How a study ended.
pub enum StudyEnd {
    /// The study is finished.
    Finished(Box<StudyRun>),
    /// The study was interrupted; the words say what is kept.
    Interrupted(String),
}

/// Runs `study` without leaving anything on disk.
pub fn run_in_memory(study: &Study, inputs: &InputsHash, options: &RunOptions<'_>) -> Result<StudyEnd, Diagnostics> {
    match run_study(study, &inputs.to_string(), options) {
        Ok(run) => Ok(StudyEnd::Finished(run.into())),
        Err(StudyError::Interrupted { finished, most_runs }) => {
            let words = interrupted(&finished, most_runs);
            Ok(StudyEnd::Interrupted(format!("{words}; nothing is kept without a folder")))
        }
        Err(error) => Err(error.diagnostic(study).into()),
    }
}

/// Runs `study` in `folder`, or reads the finished result that is there.
pub fn run_in_folder(
    study: &Study,
    inputs: InputsHash,
    folder: PathBuf,
    meeting: ExistingFolderOptions,
    options: &RunOptions<'_>,
) -> Result<StudyEnd, Diagnostics> {
    let claim = Claim {
        kind: ResultKind::Study,
        name: study.name.clone(),
        inputs,
        destination: Destination::Folder(folder),
        with_force: meeting.with_force,
    };
    // Planned first, so that a study that cannot begin leaves no folder behind.
    if !claim.is_finished().map_err(report)? {
        loosepin::study::plan_runs(study).map_err(|error| error.diagnostic(study))?;
    }
    let beginning = ExistingRuns::from_options(meeting.with_force, meeting.with_resume);
    let begun = begin_in_folder(&claim, |lock| RunStore::begin(lock, &store_identity(&claim.inputs), beginning))?;
    let (folder, store) = match begun {
        ClaimOutcome::Open(folder, store) => (folder, store),
        ClaimOutcome::Finished(folder) => return Ok(StudyEnd::Finished(read_study(&folder.finished())?.into())),
    };
    let started = SystemTime::now();
    let outcome = run_study(study, &claim.inputs.to_string(), &RunOptions { store: Some(&store), ..*options });
    match conclude(study, folder, store, outcome, &study_page, (started, options.threads))? {
        StudyOutcome::Finished { run, .. } => Ok(StudyEnd::Finished(run)),
        StudyOutcome::Interrupted { finished, most_runs, folder } => {
            let (words, path) = (interrupted(&finished, most_runs), folder.display());
            Ok(StudyEnd::Interrupted(format!(
                "{words}; they are kept in {path}: the same call with resume=True continues"
            )))
        }
    }
}

fn interrupted(finished: &RunsTable, most_runs: usize) -> String {
    let count = finished.columns.first().map_or(0, |column| column.data.len());
    // Small probabilities may take more than was expected.
    let of_most = if count < most_runs { format!(" of at most {most_runs}") } else { String::new() };
    format!("interrupted after {count}{of_most} runs")
}

fn report(problem: impl Problem) -> Diagnostics {
    Diagnostics::one(&problem, None)
}
