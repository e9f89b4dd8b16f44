//! The file.

use super::export_robot::{Exported, RobotFormat};
use super::problem::ExportProblem;
use crate::robot::Names;
use loosepin_files::{io_error_words, replace_named, write_new_files};
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// Writes a robot description into a folder, which is made where there is none, under the name of its model; gives its path.
///
/// # Errors
/// The file is there already, and is not to be replaced; the file system refuses.
pub fn write_robot(
    folder: &Path,
    model_name: &str,
    format: RobotFormat,
    exported: &Exported,
    with_force: bool,
) -> Result<PathBuf, ExportProblem> {
    let name = format!("{}.{}", Names::default().claim(model_name), format.extension());
    let path = folder.join(&name);
    let contents = exported.text.as_bytes();
    match write_new_files(folder, &[(name, contents)]) {
        Err(error) if error.kind() == ErrorKind::AlreadyExists && with_force => replace_named(&path, contents),
        written => written,
    }
    .map_err(|error| match error.kind() {
        ErrorKind::AlreadyExists => ExportProblem::Exists { path: path.clone() },
        _ => ExportProblem::NotWritten { path: path.clone(), why: io_error_words(&error) },
    })?;
    Ok(path)
}
