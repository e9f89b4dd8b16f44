//! `loosepin import`.

use std::path::PathBuf;

use loosepin::diagnostics::Diagnostic;
use loosepin::document::source_from_bytes;
use loosepin::import::{
    FileKind, ImportError, ImportOptions, Imported, KnownBy, import_dxf, import_robot, read_drawing, write_model,
};
use loosepin::model::{Rule, measured_argument};
use loosepin::units::Dimension;

use crate::arguments::ImportArguments;
use crate::console;
use crate::ending::{Done, Ending, Failure};

/// Writes the model of a drawing, or of a robot description.
pub fn run(arguments: &ImportArguments) -> Ending {
    let bytes = read_drawing(&arguments.file)?;
    let (kind, known_by) = FileKind::of(&arguments.file, &bytes);
    if known_by == KnownBy::Content {
        console::message(kind.note_of_content());
    }
    let imported = match kind {
        FileKind::Robot => of_robot(arguments, bytes),
        FileKind::Drawing => of_drawing(arguments, &bytes),
    }?;
    let folder = arguments.folder.clone().unwrap_or_else(|| PathBuf::from(name(arguments)));
    let model = write_model(&folder, &imported.model).map_err(|error| Failure::of(&error))?;
    for note in &imported.notes {
        console::message(note);
    }
    let model = model.display();
    let fill_in = if kind == FileKind::Robot { "" } else { "; fill in every \"?\" in it" };
    console::message(&format!("wrote {model}{fill_in}\nnext: loosepin check {model}"));
    Ok(Done::Well)
}

fn name(arguments: &ImportArguments) -> String {
    arguments.file.file_stem().map_or("drawing".into(), |stem| stem.to_string_lossy()).into_owned()
}

fn of_drawing(arguments: &ImportArguments, bytes: &[u8]) -> Result<Imported, Failure> {
    let tolerance_m = measured_argument("--tolerance", &arguments.tolerance, Dimension::LENGTH, Rule::Positive)?;
    let options = ImportOptions { unit: arguments.unit.clone(), tolerance_m };
    import_dxf(&name(arguments), bytes, &options).map_err(|error| {
        // A position in a drawing is given by coordinates, not by a line of its file.
        let mut diagnostic = Diagnostic::error(&error, None);
        diagnostic.message = format!("{}: {}", arguments.file.display(), diagnostic.message);
        Failure::from(diagnostic)
    })
}

fn of_robot(arguments: &ImportArguments, bytes: Vec<u8>) -> Result<Imported, Failure> {
    if arguments.unit.is_some() {
        return Err(Failure::of(&ImportError::OptionOfDrawings { option: "--unit" }));
    }
    let source = source_from_bytes(&arguments.file.display().to_string(), bytes)?;
    Ok(import_robot(&source)?)
}
