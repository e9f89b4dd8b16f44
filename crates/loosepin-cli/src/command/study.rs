//! `loosepin study`.

use std::path::Path;
use std::time::SystemTime;

use loosepin::report::{short_study_text, study_page, study_text};
use loosepin::results::{InputsHash, ResultKind, ResultsFolder};
use loosepin::store::{ExistingRuns, RunStore, STORE_FILE};
use loosepin::study::files::read_summary;
use loosepin::study::result::{StudyResult, Verdict};
use loosepin::study::{
    ClaimOutcome, RunOptions, Study, StudyOutcome, begin_in_folder, conclude, run_study, store_identity, study_inputs,
};

use super::inputs::read_study;
use super::shard;
use super::signals::stop_on_signals;
use super::stored::{FirstScreen, StoredResult, claim, print_result, show_found, show_reused_runs};
use super::threads::threads;
use crate::arguments::{ShownArguments, StudyArguments};
use crate::console;
use crate::ending::{Done, Ending, Failure};
use crate::progress::Bar;

/// Runs the study, or shows the stored one.
pub fn run(arguments: &StudyArguments) -> Ending {
    let beside = [&arguments.set, &arguments.accuracy, &arguments.path].map(Vec::as_slice);
    let (mut study, inputs) = read_study_with_options(&arguments.study, beside, arguments.budget.as_deref())?;
    // Not an input of the results: it only decides when the study ends with an error.
    if let Some(share) = arguments.most_failed {
        study.set_most_failed(share);
    }
    let claim = claim(ResultKind::Study, &study.name, inputs, &arguments.output);
    if let Some(shard) = arguments.shard {
        return shard::run(arguments, shard, &study, claim);
    }
    // Planned first, so that no folder is created for a study that cannot start.
    if !claim.is_finished()? {
        loosepin::study::plan_runs_on(&study, threads(arguments.threads)).map_err(|error| error.diagnostic(&study))?;
    }
    let stop = stop_on_signals("Ctrl-C ends the study at once; saved runs are kept");
    let beginning = ExistingRuns::from_options(claim.with_force, arguments.resume);
    let begun = begin_in_folder(&claim, |lock| RunStore::begin(lock, &store_identity(&claim.inputs), beginning))?;
    let (folder, store) = match begun {
        ClaimOutcome::Open(folder, store) => (folder, store),
        ClaimOutcome::Finished(folder) => return show_found::<StudyResult>(folder, arguments.shown),
    };
    show_reused_runs(&store);
    let threads = threads(arguments.threads);
    let started = SystemTime::now();
    let bar = Bar::resumed(store.runs_at_start() as usize);
    let options = RunOptions { store: Some(&store), ..RunOptions::new(threads, &bar, &stop) };
    let outcome = run_study(&study, &claim.inputs.to_string(), &options);
    bar.finish();
    let concluded = conclude(&study, folder, store, outcome, &study_page, (started, threads))?;
    show_outcome(concluded, "continue with the same command and --resume", arguments.shown)
}

/// Reads a study file and the options of the command line that change it, its settings, accuracies and paths; also returns the hash of all inputs.
///
/// # Errors
/// All errors in the file and in the options.
pub fn read_study_with_options(
    path: &Path,
    [set, accuracy, paths]: [&[String]; 3],
    budget: Option<&str>,
) -> Result<(Study, InputsHash), Failure> {
    let mut study = read_study(path, set)?;
    for accuracy in accuracy {
        study.add_accuracy(accuracy)?;
    }
    if let Some(budget) = budget {
        study.set_budget(budget)?;
    }
    study.add_paths(paths)?;
    let inputs = study_inputs(&study, accuracy, budget);
    Ok((study, inputs))
}

/// Shows the outcome of a study; `hint` describes how to continue an interrupted one.
///
/// # Errors
/// Standard output cannot be written.
pub fn show_outcome(concluded: StudyOutcome, hint: &str, shown: ShownArguments) -> Ending {
    match concluded {
        StudyOutcome::Finished { run, folder } => print_result(&run.result, &folder, shown),
        StudyOutcome::Interrupted { finished, most_runs, folder } => {
            let count = finished.columns.first().map_or(0, |column| column.data.len());
            console::message(&format!(
                "interrupted after {count} of at most {most_runs} runs; they are kept in {}\nhint: {hint}",
                folder.join(STORE_FILE).display()
            ));
            Ok(Done::Interrupted)
        }
    }
}

impl StoredResult for StudyResult {
    const PAGE: fn(&Self) -> String = study_page;
    const TEXT: fn(&Self) -> String = study_text;
    const SHORT: Option<FirstScreen<Self>> = Some((
        short_study_text,
        |_| "every bound and where it is attained, the three treatments, runs and assumptions",
    ));

    fn read(folder: &ResultsFolder) -> Result<Self, Failure> {
        read_summary(&folder.finished()).map_err(|error| Failure::of(&error))
    }

    fn done(&self) -> Done {
        match self.verdict() {
            None | Some(Verdict::Met | Verdict::Promised) => Done::Well,
            Some(Verdict::NotMet | Verdict::Undecided) => Done::RequirementNotMet,
        }
    }
}
