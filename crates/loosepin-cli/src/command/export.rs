//! `loosepin export`.

use std::path::{Path, PathBuf};

use loosepin::import::{ExportProblem, RobotFormat, export_robot, write_robot};
use loosepin::study::{InputFile, StudyModel, export_networks};

use super::inputs::warn;
use crate::arguments::{ExportArguments, RobotFormatArgument};
use crate::console;
use crate::ending::{Done, Ending, Failure};

/// Writes the networks of a study, or the robot description of a model, and lists what is not exported.
pub fn run(arguments: &ExportArguments) -> Ending {
    let ExportArguments { source, folder, to, outputs, force } = arguments;
    let folder = |default: &str| folder.clone().unwrap_or_else(|| PathBuf::from(default));
    match to {
        None => networks(source, outputs, &folder("onnx"), *force),
        Some(RobotFormatArgument::Urdf) => robot(source, RobotFormat::Urdf, &folder("urdf"), *force),
        Some(RobotFormatArgument::Mjcf) => robot(source, RobotFormat::Mjcf, &folder("mjcf"), *force),
    }
}

fn networks(results: &Path, outputs: &[String], folder: &Path, with_force: bool) -> Ending {
    let files = export_networks(results, outputs, folder, with_force).map_err(|error| Failure::of(&error))?;
    for file in &files {
        console::message(&format!("wrote {}", file.display()));
    }
    console::message("the errors and the noise are not exported; outside the training range the values are NaN");
    Ok(Done::Well)
}

fn robot(path: &Path, format: RobotFormat, folder: &Path, with_force: bool) -> Ending {
    let read = InputFile::from_path(path)?;
    let StudyModel::Spatial(model) = read.model() else {
        return Err(Failure::of(&ExportProblem::NotInSpace { file: path.display().to_string() }));
    };
    warn(&model.warnings);
    let exported = export_robot(model, format)?;
    let file =
        write_robot(folder, &model.name, format, &exported, with_force).map_err(|problem| Failure::of(&problem))?;
    for note in &exported.notes {
        console::message(note);
    }
    console::message(&format!("wrote {}", file.display()));
    Ok(Done::Well)
}
