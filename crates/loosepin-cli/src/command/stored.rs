//! Results that are stored and read again.

use std::path::PathBuf;

use loosepin::result::json::Stored;
use loosepin::results::{Claim, Destination, InputsHash, REPORT_FILE, ResultKind, ResultsFolder, SUMMARY_FILE};
use loosepin::store::RunStore;
use loosepin::units::counted_or_no;

use crate::arguments::{OutputArguments, ShownArguments};
use crate::console;
use crate::ending::{Done, Ending, Failure};

/// Subfolder of the current folder in which each result gets its own folder.
const RESULTS_ROOT: &str = "results";

/// The folder for the results of `inputs`.
pub fn claim(kind: ResultKind, name: &str, inputs: InputsHash, output: &OutputArguments) -> Claim {
    let below = || Destination::Below(PathBuf::from(RESULTS_ROOT));
    let destination = output.folder.clone().map_or_else(below, Destination::Folder);
    Claim { kind, name: name.to_owned(), inputs, destination, with_force: output.force }
}

/// Shows how many finished runs are reused.
pub fn show_reused_runs(store: &RunStore) {
    if store.runs_at_start() > 0 {
        let runs = counted_or_no(store.runs_at_start() as usize, "finished run", "finished runs");
        console::message(&format!("continuing with {runs}"));
    }
}

/// Lets `write` make a result in `folder`, and restores the folder if `write` fails.
///
/// # Errors
/// The error of `write`, or an error of the file system.
pub fn run_and_write(mut folder: ResultsFolder, write: impl FnOnce(&mut ResultsFolder) -> Ending) -> Ending {
    let ending = write(&mut folder);
    if ending.is_err() && !folder.is_finished() {
        folder.abandon()?;
    }
    ending
}

/// The first screen of a result, and what is left out of it.
pub type FirstScreen<R> = (fn(&R) -> String, fn(&R) -> &'static str);

/// A result that is stored as `summary.json` and shown from it.
pub trait StoredResult: Stored {
    /// The page of the result.
    const PAGE: fn(&Self) -> String;

    /// All of the result for a terminal.
    const TEXT: fn(&Self) -> String;

    /// The first screen of [`Self::TEXT`], and what is left out of it; `None` where all is shown at once.
    const SHORT: Option<FirstScreen<Self>> = None;

    /// Reads the result.
    ///
    /// # Errors
    /// The file does not exist, or another version wrote it.
    fn read(folder: &ResultsFolder) -> Result<Self, Failure> {
        let text = folder.read_text(SUMMARY_FILE)?;
        Self::from_json(&text).map_err(|error| folder.foreign_file(SUMMARY_FILE, error).into())
    }

    /// The outcome of a command that shows the result.
    fn done(&self) -> Done {
        Done::Well
    }
}

/// Writes the record and the page, the last files of a result, and shows the result.
///
/// # Errors
/// A value that JSON cannot represent, or an error of the file system.
pub fn write_and_print<R: StoredResult>(record: &R, folder: &mut ResultsFolder, shown: ShownArguments) -> Ending {
    let text = record.to_json().map_err(|error| folder.foreign_file(SUMMARY_FILE, error))?;
    folder.write(SUMMARY_FILE, text.as_bytes())?;
    folder.write(REPORT_FILE, R::PAGE(record).as_bytes())?;
    folder.finish()?;
    print_result(record, folder, shown)
}

/// Reports that the result already exists, and shows it.
pub fn show_found<R: StoredResult>(mut folder: ResultsFolder, shown: ShownArguments) -> Ending {
    console::message(&format!(
        "{} already holds this {}: the report is written again (--force runs it again)",
        folder.path().display(),
        folder.kind().words()
    ));
    show_stored::<R>(&mut folder, shown)
}

/// Writes the page again from the stored result, and prints its text.
pub fn show_stored<R: StoredResult>(folder: &mut ResultsFolder, shown: ShownArguments) -> Ending {
    let result = R::read(folder)?;
    folder.write(REPORT_FILE, R::PAGE(&result).as_bytes())?;
    print_result(&result, folder, shown)
}

/// Prints the first screen of a result, or all of it, and the path of the page.
pub fn print_result<R: StoredResult>(result: &R, folder: &ResultsFolder, shown: ShownArguments) -> Ending {
    match R::SHORT.filter(|_| !shown.all) {
        Some((short, left_out)) => {
            let short = short(result);
            console::print(&short)?;
            if short != R::TEXT(result) {
                console::message(&format!("--all adds {}", left_out(result)));
            }
        }
        None => console::print(&R::TEXT(result))?,
    }
    console::message(&format!("report: {}", folder.path().join(REPORT_FILE).display()));
    Ok(result.done())
}
