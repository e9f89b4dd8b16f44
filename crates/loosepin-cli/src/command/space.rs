//! Models in space, as far as commands know them.

use std::io::ErrorKind;

use loosepin::files::{io_error_words, write_new_files};
use loosepin::report::spatial_motion_text;
use loosepin::results::MOTION_FILE;
use loosepin::simulate::spatial_motion_csv;
use loosepin::space::{SpatialModel, SpatialMotionProblem};
use loosepin::study::InputFile;

use crate::arguments::MotionArguments;
use crate::console;
use crate::ending::{Done, Ending, Failure};

/// Shows the ideal motion in space and the worst cases of play; with `--out`, `motion.csv` in a new folder has them at each position.
pub fn move_in_space(arguments: &MotionArguments, file: &InputFile, model: &SpatialModel) -> Ending {
    let options = [("--path", !arguments.path.is_empty()), ("--force", arguments.output.force)];
    if let Some((option, _)) = options.into_iter().find(|(_, is_given)| *is_given) {
        return Err(Failure::of(&SpatialMotionProblem::OptionNotInSpace { option }));
    }
    let values = file.model().spatial_values(&file.with_widest_play(&arguments.set))?;
    let file = arguments.output.folder.as_ref().map(|folder| folder.join(MOTION_FILE));
    // Before anything is computed.
    if let Some(file) = file.as_ref().filter(|file| file.symlink_metadata().is_ok()) {
        return Err(Failure::of(&SpatialMotionProblem::Exists { file: file.display().to_string() }));
    }
    let record = model.motion_record(&values)?;
    console::print(&spatial_motion_text(&record))?;
    if let Some((folder, file)) = arguments.output.folder.as_ref().zip(file) {
        let file = file.display().to_string();
        write_new_files(folder, &[(MOTION_FILE, spatial_motion_csv(&record).as_bytes())]).map_err(|error| {
            Failure::of(&match error.kind() {
                ErrorKind::AlreadyExists => SpatialMotionProblem::Exists { file: file.clone() },
                _ => SpatialMotionProblem::NotWritten { file: file.clone(), why: io_error_words(&error) },
            })
        })?;
        console::message(&format!("wrote {file}"));
    }
    Ok(Done::Well)
}
