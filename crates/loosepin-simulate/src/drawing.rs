//! Points, joints and poses of a mechanism, for drawings.

use loosepin_mechanics::mechanism::{Kinematics, Mechanism, Tree};
use loosepin_mechanics::model::{JointKind, Values};
use loosepin_result::simulation::{
    Drawing, DrawnBody, DrawnJoint, DrawnJointKind, DrawnPoint, PointReference, PoseTable,
};

/// Bodies, points and joints of `mechanism` with the numbers of one sample; the poses are still empty.
pub fn skeleton(mechanism: &Mechanism, values: &Values) -> Drawing {
    let model = &mechanism.model;
    let bodies = model
        .bodies
        .iter()
        .enumerate()
        .map(|(index, body)| DrawnBody {
            name: body.name.clone(),
            is_ground: index == 0,
            points: body
                .points
                .iter()
                .map(|point| DrawnPoint {
                    name: point.name.clone(),
                    x_m: values[point.position_m[0]],
                    y_m: values[point.position_m[1]],
                })
                .collect(),
        })
        .collect();
    let joints = model
        .joints
        .iter()
        .map(|joint| {
            let [first, second] =
                joint.kind.points().map(|point| PointReference { body: point.body.0, point: point.point });
            let (kind, guide_angle_rad, radial_clearance_m) = match &joint.kind {
                JointKind::Revolute { clearance, .. } => {
                    let clearance_m = clearance.as_ref().map_or(0.0, |c| values[c.radial_clearance_m]);
                    let kind = if clearance_m > 0.0 {
                        DrawnJointKind::RevoluteWithClearance
                    } else {
                        DrawnJointKind::Revolute
                    };
                    (kind, 0.0, clearance_m)
                }
                JointKind::Prismatic { guide_angle_rad, .. } => {
                    (DrawnJointKind::Prismatic, values[*guide_angle_rad], 0.0)
                }
                JointKind::Slot { slot_angle_rad, .. } => (DrawnJointKind::Slot, values[*slot_angle_rad], 0.0),
                JointKind::Rigid { .. } => (DrawnJointKind::Rigid, 0.0, 0.0),
            };
            DrawnJoint { name: joint.name.clone(), kind, first, second, guide_angle_rad, radial_clearance_m }
        })
        .collect();
    Drawing { bodies, joints, poses: empty_poses(mechanism), ideal_poses: empty_poses(mechanism) }
}

fn empty_poses(mechanism: &Mechanism) -> PoseTable {
    let bodies = mechanism.model.bodies.len();
    PoseTable {
        drive_angle_rad: Vec::new(),
        x_m: vec![Vec::new(); bodies],
        y_m: vec![Vec::new(); bodies],
        angle_rad: vec![Vec::new(); bodies],
    }
}

/// Adds the present poses of all bodies.
pub fn add_pose(poses: &mut PoseTable, tree: &Tree, kinematics: &Kinematics<f64>, drive_angle_rad: f64) {
    poses.drive_angle_rad.push(drive_angle_rad);
    for (body, &slot) in tree.slot_of_body.iter().enumerate() {
        let pose = &kinematics.poses[slot];
        poses.x_m[body].push(pose.position_m.x);
        poses.y_m[body].push(pose.position_m.y);
        poses.angle_rad[body].push(pose.angle_rad);
    }
}
