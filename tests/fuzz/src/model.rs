//! Reads a model file: diagnostics that can be shown, or a model.

use loosepin::diagnostics::{Colour, Diagnostic, Diagnostics, Source};
use loosepin::model::Model;

use super::files::Files;

/// The name by which diagnostics report the file.
pub const FILE: &str = "fuzzed.toml";

/// Reads a model file with its tables; what is read is possible.
pub fn read(bytes: &[u8]) -> Option<Model> {
    let read = match Files::of(bytes) {
        Some(files) => Model::from_source(source(&files)),
        None => Model::from_bytes(FILE, bytes.to_vec()),
    };
    let model = read.map_err(|diagnostics| show(&diagnostics)).ok()?;
    for warning in &model.warnings {
        assert!(!warning.to_string().is_empty());
    }
    let values = model.quantities.evaluate(&[]).unwrap_or_else(|error| panic!("accepted, and impossible: {error}"));
    for (id, quantity) in model.quantities.iter() {
        assert!(values[id].is_finite(), "{} is {}", quantity.path, values[id]);
    }
    Some(model)
}

/// The file with the tables that it may name.
pub fn source(files: &Files) -> std::sync::Arc<Source> {
    let tables = files.tables.iter().map(|(name, text)| Source::new(name, text)).collect();
    Source::with_files(FILE, &files.text, tables)
}

/// A picture of every diagnostic costs more than reading the file: of many diagnostics one file in this many has pictures.
const PICTURES: usize = 16;
/// So few always have them.
const FEW: usize = 2;

/// That diagnostics can be shown, and that one of them is an error.
pub fn show(diagnostics: &Diagnostics) {
    assert!(diagnostics.has_errors(), "refused without an error");
    let text = diagnostics.to_string();
    assert!(!text.is_empty());
    if diagnostics.len() <= FEW || text.bytes().map(usize::from).sum::<usize>() % PICTURES == 0 {
        assert!(!diagnostics.render(Colour::Never).is_empty());
    }
}

/// That a diagnostic about what was read can be shown.
pub fn show_one(diagnostic: Diagnostic) {
    show(&diagnostic.into());
}
