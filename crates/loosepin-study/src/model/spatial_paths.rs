//! Paths of quantities of a model in space: what is found, and what is said where nothing is.

use super::kind::PLAY;
use loosepin_mechanics::model::PathError;
use loosepin_space::{ModelJoint, SpatialModel};
use loosepin_text::diagnostics::nearest_name;
use loosepin_text::numbers::QuantityId;

/// Errors of manufacture of a joint, each with a line of a file that writes it.
const ERRORS: [(&str, &str); 4] = [
    ("bearing_tilt", "bearing_tilt = [\"0 mrad\", \"0 mrad\", \"0 mrad\"]"),
    ("journal_tilt", "journal_tilt = [\"0 mrad\", \"0 mrad\", \"0 mrad\"]"),
    ("bearing_shift", "bearing_shift = [\"0 mm\", \"0 mm\", \"0 mm\"]"),
    ("journal_shift", "journal_shift = [\"0 mm\", \"0 mm\", \"0 mm\"]"),
];

/// The quantity with this path, if it can be set.
///
/// # Errors
/// No such quantity; a quantity given by an expression.
pub(super) fn find(model: &SpatialModel, path: &str) -> Result<QuantityId, PathError> {
    match model.quantities.id(path) {
        Some(id) => PathError::demand_settable(&model.quantities, id),
        None => Err(unknown(model, path)),
    }
}

fn unknown(model: &SpatialModel, path: &str) -> PathError {
    let (why, hint) = if path == PLAY {
        of_play(model)
    } else if let Some(hint) = not_written(model, path) {
        (None, hint)
    } else {
        let all =
            model.quantities.iter().filter(|(_, known)| known.is_settable()).map(|(_, known)| known.path.as_str());
        let hint = match nearest_name(path, all) {
            Some(near) => format!("did you mean '{near}'?"),
            None => "paths follow the model file, for example joint.main.radial_clearance".to_owned(),
        };
        (None, hint)
    };
    PathError::Unknown { path: path.to_owned(), why, hint }
}

/// The input that a study adds has the name of no quantity.
fn of_play(model: &SpatialModel) -> (Option<String>, String) {
    let why = "a study adds the input 'play' by itself, for the places of the journals".to_owned();
    let parameter = format!("parameter.{PLAY}");
    let hint = match model.quantities.id(&parameter) {
        Some(_) => format!("write '{parameter}' for the parameter of that name"),
        None => "remove it; clearances of joints have paths such as joint.main.radial_clearance".to_owned(),
    };
    (Some(why), hint)
}

/// What to add where a path is that of a tilt or a shift that the file does not write; `None` for other paths.
fn not_written(model: &SpatialModel, path: &str) -> Option<String> {
    let mut parts = path.strip_prefix("joint.")?.split('.');
    let (joint, error) = (named_joint(model, parts.next()?)?, parts.next()?);
    let error = nearest_name(error, ERRORS.iter().map(|(name, _)| *name))?;
    let (_, line) = ERRORS.iter().find(|(name, _)| *name == error)?;
    let name = &joint.name;
    if model.quantities.id(&format!("joint.{name}.{error}.x")).is_some() {
        return None;
    }
    if joint.kind.word() == "spherical" && error.ends_with("tilt") {
        return Some(format!("joint '{name}' is spherical: it has shifts, and no tilts"));
    }
    Some(format!(
        "tilts and shifts are quantities only where the model file has them: add {line} to [joint.{name}]; its numbers are then \
         joint.{name}.{error}.x, .y and .z"
    ))
}

/// The joint with this name, or with the nearest one.
fn named_joint<'m>(model: &'m SpatialModel, name: &str) -> Option<&'m ModelJoint> {
    let of = |name: &str| model.joints.iter().find(|joint| joint.name == name);
    of(name).or_else(|| of(nearest_name(name, model.joints.iter().map(|joint| joint.name.as_str()))?))
}
