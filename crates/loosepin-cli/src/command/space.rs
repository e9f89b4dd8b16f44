//! Models in space, as far as commands know them.

use std::io::ErrorKind;
use std::path::Path;

use loosepin::files::{io_error_words, write_new_files};
use loosepin::report::{spatial_motion_page, spatial_motion_picture, spatial_motion_text};
use loosepin::result::spatial_motion::SpatialMotionRecord;
use loosepin::result::spatial_motion_summary;
use loosepin::results::{MOTION_FILE, REPORT_FILE, SUMMARY_FILE};
use loosepin::simulate::spatial_motion_csv;
use loosepin::space::{SpatialModel, SpatialMotionProblem};
use loosepin::study::InputFile;

use crate::arguments::MotionArguments;
use crate::console;
use crate::ending::{Done, Ending, Failure};

/// The isometric picture of a motion in space.
const PICTURE_FILE: &str = "motion.svg";

/// Shows the ideal motion in space and the worst cases of play; with `--out`, a folder has them as a table, a page, a picture and a summary.
pub fn move_in_space(arguments: &MotionArguments, file: &InputFile, model: &SpatialModel) -> Ending {
    let options = [("--path", !arguments.path.is_empty()), ("--force", arguments.output.force)];
    if let Some((option, _)) = options.into_iter().find(|(_, is_given)| *is_given) {
        return Err(Failure::of(&SpatialMotionProblem::OptionNotInSpace { option }));
    }
    let folder = arguments.output.folder.as_ref();
    let names = [MOTION_FILE, REPORT_FILE, PICTURE_FILE, SUMMARY_FILE];
    // Before anything is computed.
    let mut paths = names.iter().flat_map(|name| folder.map(|folder| folder.join(name)));
    if let Some(path) = paths.find(|path| path.symlink_metadata().is_ok()) {
        return Err(Failure::of(&SpatialMotionProblem::Exists { file: path.display().to_string() }));
    }
    // The page and the summary have proven ends; the tables alone are there at once.
    let record = file.motion_in_space(model, &arguments.set, folder.is_some())?;
    console::print(&spatial_motion_text(&record))?;
    let Some(folder) = folder else { return Ok(Done::Well) };
    write_motion(&record, folder)?;
    names.iter().for_each(|name| console::message(&format!("wrote {}", folder.join(name).display())));
    Ok(Done::Well)
}

fn write_motion(record: &SpatialMotionRecord, folder: &Path) -> Result<(), Failure> {
    let not_written =
        |why: String| Failure::of(&SpatialMotionProblem::NotWritten { file: folder.display().to_string(), why });
    let summary = spatial_motion_summary(record).map_err(|error| not_written(error.to_string()))?;
    let texts = [
        (MOTION_FILE, spatial_motion_csv(record)),
        (REPORT_FILE, spatial_motion_page(record)),
        (PICTURE_FILE, spatial_motion_picture(record)),
        (SUMMARY_FILE, summary),
    ];
    let files: Vec<(&str, &[u8])> = texts.iter().map(|(name, text)| (*name, text.as_bytes())).collect();
    write_new_files(folder, &files).map_err(|error| match error.kind() {
        ErrorKind::AlreadyExists => {
            let names = files.iter().map(|(name, _)| folder.join(name));
            let there = names.into_iter().find(|path| path.symlink_metadata().is_ok());
            let file = there.unwrap_or_else(|| folder.to_owned()).display().to_string();
            Failure::of(&SpatialMotionProblem::Exists { file })
        }
        _ => not_written(io_error_words(&error)),
    })
}
