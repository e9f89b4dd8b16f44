//! The mechanism of a robot, for what has to be counted before its model is written.

use super::description::{JointSide, Robot, RobotJointKind};
use loosepin_space::{
    Body, Drive, Joint, JointCoordinate, Marker, MechanismError, Planar, Pose, Prismatic, Quaternion, Revolute, Rigid,
    SpatialKind, SpatialMechanism, Spherical,
};

/// The kind of a joint.
fn kind(kind: RobotJointKind) -> SpatialKind {
    match kind {
        RobotJointKind::Fixed => Rigid.into(),
        RobotJointKind::Hinge => Revolute.into(),
        RobotJointKind::Slide => Prismatic.into(),
        RobotJointKind::Ball => Spherical.into(),
        RobotJointKind::Planar => Planar.into(),
    }
}

/// The coordinate of a joint that a drive moves.
pub(super) fn coordinate(kind: RobotJointKind) -> Option<JointCoordinate> {
    match kind {
        RobotJointKind::Hinge => Some(JointCoordinate::Angle),
        RobotJointKind::Slide => Some(JointCoordinate::Slide),
        RobotJointKind::Fixed | RobotJointKind::Ball | RobotJointKind::Planar => None,
    }
}

/// The mechanism with drives of these joints, its bodies in the pose of the description.
pub(super) fn mechanism(robot: &Robot, driven: &[usize]) -> Result<SpatialMechanism, MechanismError> {
    let frames = robot.frames();
    let bodies = robot.links.iter().zip(&frames).enumerate().map(|(number, (link, frame))| {
        if number == 0 {
            return Body::ground();
        }
        Body::new(link.name.clone(), Pose::new(frame.origin_m, Quaternion::from_rotation(&frame.axes)))
    });
    let joints = robot
        .joints
        .iter()
        .map(|joint| Joint::new(joint.name.clone(), kind(joint.kind), marker(&joint.parent), marker(&joint.child)));
    let drives = driven.iter().filter_map(|&joint| {
        let kind = robot.joints.get(joint)?.kind;
        Some(Drive { joint, coordinate: coordinate(kind)? })
    });
    SpatialMechanism::new(bodies.collect(), joints.collect(), drives.collect())
}

fn marker(side: &JointSide) -> Marker {
    let frame = side.frame();
    Marker { body: side.link, point_m: frame.origin_m, axes: frame.axes }
}
