//! Results that are stored and read again.

use std::path::PathBuf;

use loosepin::results::{Place, ResultsFolder};
use loosepin::study::files;
use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::arguments::OutputArguments;
use crate::console;
use crate::ending::{Ending, Failure};

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
        "{} holds this {} already: the report is written again (--force runs it anew)",
        folder.path().display(),
        folder.kind().words()
    ));
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

/// A record from a stored file.
///
/// # Errors
/// A file that is not there, or that another version wrote.
pub fn read_json<T: DeserializeOwned>(folder: &ResultsFolder, file_name: &str) -> Result<T, Failure> {
    let text = folder.read(file_name)?;
    serde_json::from_str(&text).map_err(|error| folder.foreign_file(file_name, error).into())
}
