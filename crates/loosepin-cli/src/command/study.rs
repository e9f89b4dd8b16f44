//! `loosepin study`.

use std::time::SystemTime;

use loosepin::report::{study_page, study_text};
use loosepin::results::{Claim, InputsHash, InputsHasher, REPORT_FILE, ResultKind, ResultsFolder};
use loosepin::study::files::{
    BOUNDS_FILE, RUNS_FILE, SUMMARY_FILE, TIMING_FILE, Timing, read_summary, runs_parquet, write_study,
};
use loosepin::study::result::{StudyResult, Verdict};
use loosepin::study::runs::RunsTable;
use loosepin::study::{Conducted, Study, StudyError, conduct};

use super::inputs::{add_model, add_study, read_study};
use super::signals::stop_on_signals;
use super::stored::{place, tell_again};
use super::threads::threads;
use crate::arguments::StudyArguments;
use crate::console;
use crate::ending::{Done, Ending, Failure};
use crate::progress::Bar;

/// Conducts the study, or shows the one that is there.
pub fn run(arguments: &StudyArguments) -> Ending {
    let mut study = read_study(&arguments.study)?;
    for accuracy in &arguments.accuracy {
        study.add_accuracy(accuracy)?;
    }
    if let Some(budget) = &arguments.budget {
        study.set_budget(budget)?;
    }
    let claim = Claim {
        kind: ResultKind::Study,
        name: study.name.clone(),
        inputs: inputs(arguments, &study),
        place: place(&arguments.output),
        with_force: arguments.output.force,
    };
    // Planned first, so that a study that cannot begin leaves no folder behind.
    loosepin::study::plan_runs(&study).map_err(|error| error.complaint(&study))?;
    let stop = stop_on_signals("Ctrl-C will end the study without keeping its runs");
    let mut folder = claim.take()?;
    if folder.is_finished() {
        tell_again(&folder);
        return show_again(&mut folder);
    }
    let threads = threads(arguments.threads);
    let started = SystemTime::now();
    let bar = Bar::new();
    let outcome = conduct(&study, &claim.inputs.to_string(), threads, &bar, &stop);
    bar.finish();
    match outcome {
        Ok(Conducted { result, runs }) => {
            let count = runs.columns.first().map_or(0, |column| column.data.len());
            write(&mut folder, &result, &runs, &Timing::since(started, count, threads))?;
            tell(&result, &folder)
        }
        Err(StudyError::Interrupted { finished, most_runs }) => keep(&mut folder, &finished, most_runs),
        Err(error) => {
            folder.abandon()?;
            Err(error.complaint(&study).into())
        }
    }
}

/// Writes the page again from the stored result, and prints the tables.
pub fn show_again(folder: &mut ResultsFolder) -> Ending {
    let result = read_summary(folder.path()).map_err(|error| Failure::of(&error))?;
    folder.write(REPORT_FILE, study_page(&result).as_bytes())?;
    tell(&result, folder)
}

fn write(folder: &mut ResultsFolder, result: &StudyResult, runs: &RunsTable, timing: &Timing) -> Result<(), Failure> {
    write_study(folder.path(), result, runs, timing).map_err(|error| Failure::of(&error))?;
    for file_name in [BOUNDS_FILE, RUNS_FILE, TIMING_FILE, SUMMARY_FILE] {
        folder.add_file(file_name);
    }
    folder.write(REPORT_FILE, study_page(result).as_bytes())?;
    Ok(folder.finish()?)
}

/// Keeps the runs that were finished when the study was interrupted.
fn keep(folder: &mut ResultsFolder, finished: &RunsTable, most_runs: usize) -> Ending {
    let count = finished.columns.first().map_or(0, |column| column.data.len());
    let parquet = runs_parquet(finished).map_err(|error| Failure::of(&error))?;
    folder.write(RUNS_FILE, &parquet)?;
    folder.leave_unfinished()?;
    console::message(&format!(
        "interrupted after {count} of at most {most_runs} runs; they are kept in {}\n\
         hint: the same command begins again",
        folder.path().join(RUNS_FILE).display()
    ));
    Ok(Done::Interrupted)
}

fn tell(result: &StudyResult, folder: &ResultsFolder) -> Ending {
    console::print(&study_text(result))?;
    console::message(&format!("report: {}", folder.path().join(REPORT_FILE).display()));
    let is_met = result.requirements.iter().all(|requirement| requirement.verdict == Verdict::Met);
    Ok(if is_met { Done::Well } else { Done::RequirementNotMet })
}

fn inputs(arguments: &StudyArguments, study: &Study) -> InputsHash {
    let mut hasher = InputsHasher::new(ResultKind::Study);
    add_study(&mut hasher, study);
    add_model(&mut hasher, &study.model);
    for accuracy in &arguments.accuracy {
        hasher.add("accuracy", accuracy);
    }
    if let Some(budget) = &arguments.budget {
        hasher.add("budget", budget);
    }
    hasher.finish()
}
