//! Results that are stored and read again.

use std::path::PathBuf;

use loosepin::result::json::Stored;
use loosepin::results::{Claim, InputsHash, Place, REPORT_FILE, ResultKind, ResultsFolder, SUMMARY_FILE};
use loosepin::store::RunStore;
use loosepin::units::counted_or_no;

use crate::arguments::OutputArguments;
use crate::console;
use crate::ending::{Done, Ending, Failure};

/// Folder below the present one in which results get a folder of their own.
const RESULTS_ROOT: &str = "results";

/// The folder that results of `inputs` ask for.
pub fn claim(kind: ResultKind, name: &str, inputs: InputsHash, output: &OutputArguments) -> Claim {
    let below = || Place::Below(PathBuf::from(RESULTS_ROOT));
    let place = output.folder.clone().map_or_else(below, Place::Folder);
    Claim { kind, name: name.to_owned(), inputs, place, with_force: output.force }
}

/// Says that finished runs are taken over.
pub fn tell_going_on(store: &RunStore) {
    if store.runs_at_start() > 0 {
        let runs = counted_or_no(store.runs_at_start() as usize, "finished run", "finished runs");
        console::message(&format!("continuing with {runs}"));
    }
}

/// Lets `write` make a result in `folder`, and gives the folder back as it was where that does not come to its end.
///
/// # Errors
/// That of `write`; what the file system refuses.
pub fn run_and_write(mut folder: ResultsFolder, write: impl FnOnce(&mut ResultsFolder) -> Ending) -> Ending {
    let ending = write(&mut folder);
    if ending.is_err() && !folder.is_finished() {
        folder.abandon()?;
    }
    ending
}

/// A result that is stored as `summary.json` and shown from it.
pub trait StoredResult: Stored {
    /// Its page.
    const PAGE: fn(&Self) -> String;

    /// Its tables for a terminal.
    const TEXT: fn(&Self) -> String;

    /// Reads it.
    ///
    /// # Errors
    /// A file that is not there, or that another version wrote.
    fn read(folder: &ResultsFolder) -> Result<Self, Failure> {
        let text = folder.read_text(SUMMARY_FILE)?;
        Self::from_json(&text).map_err(|error| folder.foreign_file(SUMMARY_FILE, error).into())
    }

    /// How a command that shows it ends.
    fn done(&self) -> Done {
        Done::Well
    }
}

/// Writes the record and its page, the last files of a result, and shows it.
///
/// # Errors
/// A value that has no form in JSON; what the file system refuses.
pub fn write_and_tell<R: StoredResult>(record: &R, folder: &mut ResultsFolder) -> Ending {
    let text = record.to_json().map_err(|error| folder.foreign_file(SUMMARY_FILE, error))?;
    folder.write(SUMMARY_FILE, text.as_bytes())?;
    folder.write(REPORT_FILE, R::PAGE(record).as_bytes())?;
    folder.finish()?;
    tell(record, folder)
}

/// Says that a result is there already, and shows it.
pub fn show_found<R: StoredResult>(mut folder: ResultsFolder) -> Ending {
    console::message(&format!(
        "{} already holds this {}: the report is written again (--force runs it again)",
        folder.path().display(),
        folder.kind().words()
    ));
    show_again::<R>(&mut folder)
}

/// Writes the page again from the stored result, and prints the tables.
pub fn show_again<R: StoredResult>(folder: &mut ResultsFolder) -> Ending {
    let result = R::read(folder)?;
    folder.write(REPORT_FILE, R::PAGE(&result).as_bytes())?;
    tell(&result, folder)
}

/// Prints the tables, and says where the page is.
pub fn tell<R: StoredResult>(result: &R, folder: &ResultsFolder) -> Ending {
    console::print(&R::TEXT(result))?;
    console::message(&format!("report: {}", folder.path().join(REPORT_FILE).display()));
    Ok(result.done())
}
