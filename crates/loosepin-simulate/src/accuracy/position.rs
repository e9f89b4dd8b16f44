//! Outputs of which the quasi-static answer speaks: coordinates of points and angles of bodies.

use crate::ideal::column;
use loosepin_mechanics::mechanism::Mechanism;
use loosepin_mechanics::model::{Derivative, Motion, OutputKind, Position, Reading, relative_words};
use loosepin_text::units::SiUnit;

/// A coordinate of a point or the angle of a body.
#[derive(Debug, Clone, PartialEq)]
pub struct PositionOutput {
    /// Name of the output of the model; paths add ` x` and ` y`.
    pub name: String,
    /// Its quantity in words, for example `x of slider.pin`.
    pub words: String,
    /// Unit of its values.
    pub unit: SiUnit,
    /// The quantity that is read.
    pub reading: Position,
    /// The path that it is a coordinate of.
    pub path: Option<ModelPath>,
}

/// A path of the model.
#[derive(Debug, Clone, PartialEq)]
pub struct ModelPath {
    /// Name of the output.
    pub name: String,
    /// Its point in words, for example `slider.pin`.
    pub point: String,
}

/// The position outputs of a model in file order, each once.
///
/// A velocity or acceleration stands for the position that it is the derivative of, unless another output names that
/// position already. Other outputs, such as forces, belong to no position.
pub fn position_outputs(mechanism: &Mechanism) -> Vec<PositionOutput> {
    let outputs = &mechanism.model.outputs;
    let is_position =
        |kind: &OutputKind| kind.path().is_some() || kind.reading().is_some_and(|reading| reading.is_position());
    let mut found: Vec<(usize, PositionOutput)> = Vec::new();
    for derivatives in [false, true] {
        for (index, output) in outputs.iter().enumerate().filter(|(_, o)| is_position(&o.kind) != derivatives) {
            for (reading, suffix) in readings(&output.kind) {
                let is_known = found.iter().any(|(_, known)| known.reading == reading);
                if derivatives && is_known {
                    continue;
                }
                let (words, unit) = describe(mechanism, reading);
                let name = format!("{}{suffix}", output.name);
                let path = output.kind.path().map(|point| ModelPath {
                    name: output.name.clone(),
                    point: relative_words(&mechanism.model, point),
                });
                found.push((index, PositionOutput { name, words, unit, reading, path }));
            }
        }
    }
    found.sort_by_key(|(index, _)| *index);
    found.into_iter().map(|(_, output)| output).collect()
}

/// The positions behind an output, with what is added to its name.
fn readings(kind: &OutputKind) -> impl Iterator<Item = (Position, &'static str)> {
    column::readings(kind).into_iter().filter_map(|(reading, suffix)| Some((reading.motion_of()?, suffix)))
}

fn describe(mechanism: &Mechanism, reading: Position) -> (String, SiUnit) {
    let unit = SiUnit::of_dimension(reading.dimension(Derivative::Position));
    (Reading::from(Motion::position(reading)).words(&mechanism.model), unit)
}
