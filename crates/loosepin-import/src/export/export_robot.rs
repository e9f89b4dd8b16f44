//! A model in a format of robot descriptions.

use super::closed_model::Export;
use super::problem::ExportProblem;
use super::{mjcf, urdf};
use loosepin_space::{BodyTree, Frame, SpatialModel, assemble};
use loosepin_text::diagnostics::{Diagnostic, Diagnostics};
use loosepin_text::units::quoted;

/// A format of robot descriptions.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RobotFormat {
    /// URDF: links that hang on each other.
    Urdf,
    /// MJCF: bodies inside each other, loops closed by constraints.
    Mjcf,
}

impl RobotFormat {
    /// Ending of the names of its files.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Urdf => "urdf",
            Self::Mjcf => "xml",
        }
    }
}

/// A robot description of a model.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Exported {
    /// Text of the file.
    pub text: String,
    /// What it does not say, in words, one sentence each.
    pub notes: Vec<String>,
}

/// Writes the robot description of a model in space with its nominal values.
///
/// # Errors
/// The mechanism of the model; loops that do not close; joints that the format does not know, each at its place: [`ExportProblem`].
pub fn export_robot(model: &SpatialModel, format: RobotFormat) -> Result<Exported, Diagnostics> {
    let values = model.quantities.nominal();
    let mechanism = model.mechanism(&values).map_err(|error| model.diagnostic(&error))?;
    let refused = |problem: &ExportProblem| Diagnostics::from(diagnostic(model, problem));
    let tree = BodyTree::of_stiff_joints(&mechanism);
    if let Some(body) = tree.unconnected() {
        return Err(refused(&ExportProblem::NotConnected { body: mechanism.bodies()[body].name.clone() }));
    }
    let position = assemble(&mechanism, &model.drive_values(&values, 0.0)).map_err(|error| model.not_closed(&error))?;
    let frames: Vec<Frame> = position.poses.iter().map(Frame::from).collect();
    let export = Export { model, values: &values, mechanism: &mechanism, tree: &tree, frames: &frames };
    let mut notes = Vec::new();
    let with_play: Vec<&String> =
        model.joints.iter().filter(|joint| joint.play.is_some()).map(|joint| &joint.name).collect();
    if !with_play.is_empty() {
        let joints = if with_play.len() == 1 { "joint" } else { "joints" };
        notes.push(format!("the play of {joints} {} is not exported", quoted(&with_play)));
    }
    let text = match format {
        RobotFormat::Urdf => urdf::robot(&export, &mut notes),
        RobotFormat::Mjcf => mjcf::robot(&export, &mut notes),
    };
    let text = text.map_err(|problem| refused(&problem))?.with_comments(&notes).document();
    Ok(Exported { text, notes })
}

/// A problem at the joint or the body that it names.
fn diagnostic(model: &SpatialModel, problem: &ExportProblem) -> Diagnostic {
    let path = match problem {
        ExportProblem::Kind { joint, .. }
        | ExportProblem::ClosesLoop { joint, .. }
        | ExportProblem::LoopKind { joint, .. } => format!("joint.{joint}"),
        ExportProblem::NotConnected { body } => format!("body.{body}"),
        ExportProblem::NotInSpace { .. } | ExportProblem::Exists { .. } | ExportProblem::NotWritten { .. } => {
            String::new()
        }
    };
    Diagnostic::error(problem, model.place(&path))
}
