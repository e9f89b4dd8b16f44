//! The files of a model, for the command by which a result is made again.

use loosepin_mechanics::model::Model;
use loosepin_result::repeat::InputRole;
use loosepin_text::diagnostics::Source;

/// The file of `model` and the tables that it names.
pub fn input_files(model: &Model) -> impl Iterator<Item = (InputRole, &Source)> {
    let tables = model.tables().iter().map(|table| (InputRole::Table, &**table));
    std::iter::once((InputRole::Model, &**model.source())).chain(tables)
}
