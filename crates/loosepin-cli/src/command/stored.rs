//! Results that are stored and read again.

use std::path::PathBuf;

use loosepin::results::{Place, REPORT_FILE, ResultsFolder, SUMMARY_FILE};
use loosepin::store::RunStore;
use loosepin::study::files;
use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::arguments::OutputArguments;
use crate::console;
use crate::ending::{Done, Ending, Failure};

/// Folder below the present one in which results get a folder of their own.
const RESULTS_ROOT: &str = "results";

/// Where results are to go.
pub fn place(output: &OutputArguments) -> Place {
    match &output.folder {
        Some(folder) => Place::Folder(folder.clone()),
        None => Place::Below(PathBuf::from(RESULTS_ROOT)),
    }
}

/// Says that a result is there already.
pub fn tell_again(folder: &ResultsFolder) {
    console::message(&format!(
        "{} already holds this {}: the report is written again (--force runs it again)",
        folder.path().display(),
        folder.kind().words()
    ));
}

/// Says that finished runs are taken over.
pub fn tell_going_on(store: &RunStore) {
    if store.runs_at_start() > 0 {
        let runs = console::counted(store.runs_at_start() as usize, "finished run", "finished runs");
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

/// A record as JSON.
///
/// # Errors
/// A value that has no form in JSON.
pub fn to_json<T: Serialize>(record: &T, folder: &ResultsFolder, file_name: &str) -> Result<String, Failure> {
    files::to_json(record).map_err(|error| folder.foreign_file(file_name, error).into())
}

/// A result that is stored as `summary.json` and shown from it.
pub trait StoredResult: Sized {
    /// Reads it.
    ///
    /// # Errors
    /// A file that is not there, or that another version wrote.
    fn read(folder: &ResultsFolder) -> Result<Self, Failure>;

    /// Its page.
    fn page(&self) -> String;

    /// Its tables for a terminal.
    fn text(&self) -> String;

    /// How a command that shows it ends.
    fn done(&self) -> Done {
        Done::Well
    }
}

/// Writes the page again from the stored result, and prints the tables.
pub fn show_again<R: StoredResult>(folder: &mut ResultsFolder) -> Ending {
    let result = R::read(folder)?;
    folder.write(REPORT_FILE, result.page().as_bytes())?;
    tell(&result, folder)
}

/// Prints the tables, and says where the page is.
pub fn tell<R: StoredResult>(result: &R, folder: &ResultsFolder) -> Ending {
    console::print(&result.text())?;
    console::message(&format!("report: {}", folder.path().join(REPORT_FILE).display()));
    Ok(result.done())
}

/// A record from `summary.json`.
///
/// # Errors
/// A file that is not there, or that another version wrote.
pub fn read_record<T: DeserializeOwned>(folder: &ResultsFolder) -> Result<T, Failure> {
    let text = folder.read(SUMMARY_FILE)?;
    serde_json::from_str(&text).map_err(|error| folder.foreign_file(SUMMARY_FILE, error).into())
}
