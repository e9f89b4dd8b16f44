//! From a robot description to a model in space.

use super::drives::planned;
use super::model_names::ModelNames;
use super::model_text::model;
use super::problem::RobotProblem;
use super::xml::{Element, parse};
use super::{mjcf, urdf};
use crate::imported::Imported;
use loosepin_space::SpatialModel;
use loosepin_text::diagnostics::{Diagnostics, Source};
use loosepin_text::units::counted;
use std::sync::Arc;

/// Names that were changed and are listed one by one, at most.
const MAX_LISTED_NAMES: usize = 5;

/// Reads a robot description, URDF or MJCF by its root element, and writes a model in space: links are bodies, the root is the ground, each joint
/// can be given play, and all that can be driven is.
///
/// # Errors
/// The first mistake of the file with its place: [`RobotProblem`].
pub fn import_robot(source: &Arc<Source>) -> Result<Imported, Diagnostics> {
    let document = parse(source)?;
    let root = Element::root(&document, source);
    let robot = match root.tag() {
        "robot" => urdf::read(root)?,
        "mujoco" => mjcf::read(root)?,
        other => return Err(root.error(&RobotProblem::OtherRoot { found: other.to_owned() })),
    };
    let mut notes =
        vec![format!("{}, {}", counted(robot.links.len() - 1, "moving link"), counted(robot.joints.len(), "joint"))];
    notes.extend(robot.notes.iter().cloned());
    let names = ModelNames::new(&robot);
    let drives = planned(&robot, &mut notes);
    let text = model(&robot, &names, &drives, &mut notes);
    for (from, to) in names.changed.iter().take(MAX_LISTED_NAMES) {
        notes.push(format!("'{from}' is called {to}"));
    }
    if names.changed.len() > MAX_LISTED_NAMES {
        notes.push(format!("{} more called otherwise", counted(names.changed.len() - MAX_LISTED_NAMES, "name")));
    }
    // What is written is what `check` reads: too many bodies, and what else a model may not have.
    match SpatialModel::from_text("model.toml", &text) {
        Ok(_) => Ok(Imported { model: text, notes }),
        Err(refused) => {
            let first = refused.sorted().first().map_or(String::new(), |diagnostic| diagnostic.message.clone());
            Err(root.error(&RobotProblem::NotAccepted { why: first }))
        }
    }
}
