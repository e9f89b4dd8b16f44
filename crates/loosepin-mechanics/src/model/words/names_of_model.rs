//! The names of the parts of a model.

use crate::model::ids::{Actuator, BodyId, JointId, PointId};
use crate::model::parts::topology::Model;
use crate::model::words::part_names::PartNames;

impl PartNames for Model {
    fn point(&self, point: PointId) -> String {
        let body = &self.bodies[point.body.0];
        format!("{}.{}", body.name, body.points[point.point].name)
    }

    fn body(&self, body: BodyId) -> &str {
        &self.bodies[body.0].name
    }

    fn joint(&self, joint: JointId) -> &str {
        &self.joints[joint.0].name
    }

    fn actuator(&self, actuator: Actuator) -> String {
        match actuator {
            Actuator::Drive(id) => format!("drive {}", self.drives[id.0].name),
            Actuator::Control(id) => format!("control {}", self.controls[id.0].name),
        }
    }
}
