//! Outputs as columns of numbers, read off the state of a mechanism.

use loosepin_mechanics::model::{Axis, Model, Motion, OutputKind, Position, Reading};
use loosepin_text::units::SiUnit;

/// One number that a model file asks for; a path is two of them.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// Index in [`loosepin_mechanics::model::Model::outputs`].
    pub output: usize,
    /// Name of the output; paths add ` x` and ` y`.
    pub name: String,
    /// Its quantity in words, for example `x of slider.pin`.
    pub words: String,
    /// Its unit.
    pub unit: SiUnit,
    /// The quantity that is read.
    pub reading: Reading,
}

/// All columns of a model, in file order.
pub fn columns(model: &Model) -> Vec<Column> {
    let mut columns = Vec::new();
    for (output, written) in model.outputs.iter().enumerate() {
        for (reading, suffix) in readings(&written.kind) {
            let (name, words) = (format!("{}{suffix}", written.name), reading.words(model));
            columns.push(Column { output, name, words, unit: SiUnit::of_dimension(written.kind.dimension()), reading });
        }
    }
    columns
}

/// The quantities of an output, each with what is added to its name.
pub(crate) fn readings(kind: &OutputKind) -> Vec<(Reading, &'static str)> {
    let of_path = kind.path().into_iter().flat_map(|point| {
        let coordinate = |axis| Motion::position(Position::Point(point, axis)).into();
        [(coordinate(Axis::X), " x"), (coordinate(Axis::Y), " y")]
    });
    kind.reading().map(|reading| (reading, "")).into_iter().chain(of_path).collect()
}
