//! `loosepin import`.

use std::path::PathBuf;

use loosepin::diagnostics::Diagnostic;
use loosepin::import::{ImportError, ImportOptions, import_dxf, read_drawing, write_model};
use loosepin::model::{Rule, measured_argument};
use loosepin::units::Dimension;

use crate::arguments::ImportArguments;
use crate::console;
use crate::ending::{Done, Ending, Failure};

/// Writes the model of a drawing.
pub fn run(arguments: &ImportArguments) -> Ending {
    let tolerance_m = measured_argument("--tolerance", &arguments.tolerance, Dimension::LENGTH, Rule::Positive)?;
    let options = ImportOptions { unit: arguments.unit.clone(), tolerance_m };
    // A position in a drawing is given by coordinates, not by a line of its file.
    let report = |error: &ImportError| {
        let mut diagnostic = Diagnostic::error(error, None);
        diagnostic.message = format!("{}: {}", arguments.drawing.display(), diagnostic.message);
        Failure::from(diagnostic)
    };
    let bytes = read_drawing(&arguments.drawing)?;
    let name = arguments.drawing.file_stem().map_or("drawing".into(), |stem| stem.to_string_lossy());
    let imported = import_dxf(&name, &bytes, &options).map_err(|error| report(&error))?;
    let folder = arguments.folder.clone().unwrap_or_else(|| PathBuf::from(&*name));
    let model = write_model(&folder, &imported.model).map_err(|error| Failure::of(&error))?;
    for note in &imported.notes {
        console::message(note);
    }
    let model = model.display();
    console::message(&format!("wrote {model}; fill in every \"?\" in it\nnext: loosepin check {model}"));
    Ok(Done::Well)
}
