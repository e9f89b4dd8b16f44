//! What the page asks of each kind of model. Which one a file has is asked here alone.

use loosepin::model::Model;
use loosepin::result::kinematics::LoopProperties;
use loosepin::result::motion::MotionRecord;
use loosepin::result::simulation::Drawing;
use loosepin::space::SpatialModel;
use loosepin::study::StudyModel;

use crate::drawing::still::NamedPoses;
use crate::messages::{Outline, OutputView};
use crate::view::plane_view::{plane_outline, plane_points, plane_still};
use crate::view::space_view::space_outline;

/// What is known of a mechanism that moves, or stands.
#[derive(Clone, Copy)]
pub struct Moved<'d> {
    /// Its drawing.
    pub drawing: &'d Drawing,
    /// Its loops.
    pub loops: &'d [LoopProperties],
}

impl<'d> Moved<'d> {
    /// Of a motion.
    pub fn of(record: &'d MotionRecord) -> Self {
        Self { drawing: &record.drawing, loops: &record.kinematics.loops }
    }
}

/// A model as the page shows it.
pub trait SeenModel {
    /// What it consists of.
    fn outline(&self, moved: Moved<'_>, outputs: Vec<OutputView>) -> Outline;

    /// Whether its joints can be dragged on the page.
    fn takes_drags(&self) -> bool {
        false
    }

    /// The points among `names` whose paths can be traced.
    fn traced_points(&self, _names: &[String]) -> Vec<String> {
        Vec::new()
    }

    /// Its bodies where they were put; `None` where it is drawn in motion alone.
    fn still_drawing(&self, _poses: &NamedPoses) -> Option<Drawing> {
        None
    }
}

/// `model` as the page shows it.
pub fn seen(model: &StudyModel) -> &dyn SeenModel {
    match model {
        StudyModel::Planar(model) => &**model,
        StudyModel::Spatial(model) => &**model,
    }
}

impl SeenModel for Model {
    fn outline(&self, moved: Moved<'_>, outputs: Vec<OutputView>) -> Outline {
        plane_outline(self, moved.drawing, outputs, moved.loops)
    }

    fn takes_drags(&self) -> bool {
        true
    }

    fn traced_points(&self, names: &[String]) -> Vec<String> {
        plane_points(self, names)
    }

    fn still_drawing(&self, poses: &NamedPoses) -> Option<Drawing> {
        Some(plane_still(self, poses))
    }
}

impl SeenModel for SpatialModel {
    fn outline(&self, _moved: Moved<'_>, outputs: Vec<OutputView>) -> Outline {
        space_outline(self, outputs)
    }
}
