//! Robot descriptions: what is read, held against closed forms and products of matrices; what is refused; what is written and read again.

mod export;
mod file_kind;
mod matrices;
mod mjcf;
mod refused;
mod urdf;

use loosepin_import::{Imported, import_robot};
use loosepin_space::{DriveValue, Position, SpatialMechanism, SpatialModel, assemble};
use loosepin_text::diagnostics::Source;

/// Round-off of positions after closing, m, and of components of axes.
pub const ROUND_OFF: f64 = 1e-12;

/// What a text becomes.
pub fn imported(name: &str, text: &str) -> Imported {
    import_robot(&Source::new(name, text)).unwrap_or_else(|diagnostics| panic!("{diagnostics}"))
}

/// The model that a text becomes, read again.
pub fn model_of(text: &str) -> SpatialModel {
    let imported = imported("robot.xml", text);
    SpatialModel::from_text("model.toml", &imported.model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"))
}

/// The mechanism of a model with its drives at these values.
pub fn position(model: &SpatialModel, drives: &[f64]) -> (SpatialMechanism, Position) {
    let mechanism = model.mechanism(&model.quantities.nominal()).unwrap();
    let held: Vec<DriveValue> = drives.iter().map(|value| DriveValue::held(*value)).collect();
    let position = assemble(&mechanism, &held).unwrap_or_else(|error| panic!("{error}"));
    (mechanism, position)
}

/// The pose of a body as a matrix of four columns.
pub fn pose_of(model: &SpatialModel, position: &Position, body: &str) -> matrices::Matrix {
    let number = model.bodies.iter().position(|own| own.name == body).unwrap();
    let pose = &position.poses[number];
    let (axes, at) = (pose.orientation.rotation(), pose.position_m);
    [
        [axes.x.x, axes.y.x, axes.z.x, at.x],
        [axes.x.y, axes.y.y, axes.z.y, at.y],
        [axes.x.z, axes.y.z, axes.z.z, at.z],
        [0.0, 0.0, 0.0, 1.0],
    ]
}
