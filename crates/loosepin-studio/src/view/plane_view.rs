//! A mechanism in the plane as the page shows it.

use loosepin::model::Model;
use loosepin::result::kinematics::LoopProperties;
use loosepin::result::simulation::{Drawing, DrawnBody, DrawnJoint, DrawnPoint};
use loosepin::units::{Dimension, format_value};

use crate::drawing::dimensions::dimensions;
use crate::drawing::forces::forces;
use crate::drawing::still::{NamedPoses, placed, still_drawing};
use crate::messages::{BodyView, JointView, Outline, OutputView, PinView, PointView};

const MM_PER_M: f64 = 1e3;
/// Points that are traced, at most.
const MAX_TRACED: usize = 16;

/// The points among `names` that the model has, as many as are traced.
pub fn plane_points(model: &Model, names: &[String]) -> Vec<String> {
    let known = names.iter().filter(|name| model.points_of_paths(std::slice::from_ref(name)).is_ok());
    known.take(MAX_TRACED).cloned().collect()
}

/// Its bodies where they were put.
pub fn plane_still(model: &Model, poses: &NamedPoses) -> Drawing {
    still_drawing(model, &placed(model, poses))
}

/// What it consists of.
pub fn plane_outline(model: &Model, drawing: &Drawing, outputs: Vec<OutputView>, loops: &[LoopProperties]) -> Outline {
    let point =
        |point: &DrawnPoint| PointView { name: point.name.clone(), x: point.x_m * MM_PER_M, y: point.y_m * MM_PER_M };
    let part = |body: &DrawnBody| BodyView { name: body.name.clone(), points: body.points.iter().map(point).collect() };
    Outline {
        bodies: drawing.bodies.iter().filter(|body| !body.is_ground).map(|body| body.name.clone()).collect(),
        joints: drawing.joints.iter().map(|joint| seen_joint(drawing, joint)).collect(),
        drives: drawing.drives.iter().map(|drive| drive.name.clone()).collect(),
        outputs,
        forces: forces(model),
        parts: drawing.bodies.iter().map(part).collect(),
        dimensions: dimensions(model),
        loops: loops.iter().map(LoopProperties::words).collect(),
    }
}

fn seen_joint(drawing: &Drawing, joint: &DrawnJoint) -> JointView {
    let has_play = joint.radial_clearance_m > 0.0;
    let is_pin = joint.kind.turns();
    let point = drawing.bodies.get(joint.first.body).and_then(|body| body.points.get(joint.first.point));
    JointView {
        name: joint.name.clone(),
        kind: joint.kind.words(),
        play: has_play.then(|| format!("c = {}", format_value(joint.radial_clearance_m, Dimension::LENGTH))),
        takes_play: is_pin,
        pin: point.filter(|_| is_pin).map(|point| PinView {
            body: joint.first.body,
            x: point.x_m * MM_PER_M,
            y: point.y_m * MM_PER_M,
        }),
        points: [joint.first, joint.second].map(|end| {
            let body = drawing.bodies.get(end.body);
            let point = body.and_then(|body| body.points.get(end.point));
            body.zip(point).map(|(body, point)| format!("{}.{}", body.name, point.name)).unwrap_or_default()
        }),
    }
}
