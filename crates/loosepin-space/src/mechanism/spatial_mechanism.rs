//! A mechanism, checked.

use crate::mechanism::body::Body;
use crate::mechanism::drive::{Drive, JointCoordinate};
use crate::mechanism::error::MechanismError;
use crate::mechanism::joint::Joint;
use crate::mechanism::marker::Marker;
use loosepin_math::{Pose, Vec3};

/// Largest departure of axes and quaternions from unit length and right angles.
const UNIT_TOLERANCE: f64 = 1e-9;

/// Bodies, the joints between them and their drives. Body 0 is the ground.
#[derive(Debug, Clone, PartialEq)]
pub struct SpatialMechanism {
    bodies: Vec<Body>,
    joints: Vec<Joint>,
    drives: Vec<Drive>,
    length_m: f64,
}

impl SpatialMechanism {
    /// Checks what was given. Start poses need not close the loops; they are where [`crate::assemble`] begins.
    ///
    /// # Errors
    ///
    /// The first mistake, of bodies, then joints, then drives: [`MechanismError`].
    pub fn new(bodies: Vec<Body>, joints: Vec<Joint>, drives: Vec<Drive>) -> Result<Self, MechanismError> {
        if bodies.first().is_none_or(|ground| ground.start != Pose::GROUND) {
            return Err(MechanismError::NoGround);
        }
        if let Some(body) = bodies.iter().find(|body| !is_pose(&body.start)) {
            return Err(MechanismError::BadPose { body: body.name.clone() });
        }
        for joint in &joints {
            check_joint(joint, &bodies)?;
        }
        for (number, drive) in drives.iter().enumerate() {
            check_drive(number, drive, &drives, &joints)?;
        }
        let length_m = characteristic_length(&bodies, &joints);
        Ok(Self { bodies, joints, drives, length_m })
    }

    /// The bodies, the ground first.
    pub fn bodies(&self) -> &[Body] {
        &self.bodies
    }

    /// The joints.
    pub fn joints(&self) -> &[Joint] {
        &self.joints
    }

    /// The drives.
    pub fn drives(&self) -> &[Drive] {
        &self.drives
    }

    /// The length that makes lengths comparable with angles: the largest distance between two markers of one body; 1 m where all coincide.
    pub fn characteristic_length_m(&self) -> f64 {
        self.length_m
    }

    /// The start poses.
    pub fn start_poses(&self) -> Vec<Pose> {
        self.bodies.iter().map(|body| body.start).collect()
    }

    /// The same mechanism with other start poses, one for each body. Those of the ground and what exceeds the bodies are left out.
    pub fn with_start_poses(&self, poses: &[Pose]) -> Self {
        let mut other = self.clone();
        other.bodies.iter_mut().zip(poses).skip(1).for_each(|(body, pose)| body.start = *pose);
        other
    }
}

fn is_pose(pose: &Pose) -> bool {
    pose.position_m.is_finite() && (pose.orientation.size() - 1.0).abs() <= UNIT_TOLERANCE
}

fn is_marker(marker: &Marker) -> bool {
    marker.point_m.is_finite() && marker.axes.is_orthonormal(UNIT_TOLERANCE)
}

fn check_joint(joint: &Joint, bodies: &[Body]) -> Result<(), MechanismError> {
    let name = || joint.name.clone();
    for marker in [&joint.bearing, &joint.journal] {
        if marker.body >= bodies.len() {
            return Err(MechanismError::NoBody { joint: name(), body: marker.body });
        }
        if !is_marker(marker) {
            return Err(MechanismError::BadMarker { joint: name() });
        }
    }
    if joint.bearing.body == joint.journal.body {
        return Err(MechanismError::SameBody { joint: name(), body: bodies[joint.bearing.body].name.clone() });
    }
    if let Some(rule) = joint.kind.mistake() {
        return Err(MechanismError::BadKind { joint: name(), rule });
    }
    let Some(play) = &joint.play else { return Ok(()) };
    if play.joint_word() != joint.kind.word() {
        let (kind, play, play_of) = (joint.kind.word(), play.word(), play.joint_word());
        return Err(MechanismError::PlayOfAnotherJoint { joint: name(), kind, play, play_of });
    }
    play.mistake()
        .map_or(Ok(()), |(quantity, value, rule)| Err(MechanismError::BadPlay { joint: name(), quantity, value, rule }))
}

fn check_drive(number: usize, drive: &Drive, drives: &[Drive], joints: &[Joint]) -> Result<(), MechanismError> {
    let Some(joint) = joints.get(drive.joint) else {
        return Err(MechanismError::NoJoint { drive: number, joint: drive.joint });
    };
    let has_coordinate = match drive.coordinate {
        JointCoordinate::Angle => joint.kind.turns(),
        JointCoordinate::Slide => joint.kind.slides(),
    };
    if !has_coordinate {
        return Err(MechanismError::NoSuchCoordinate { joint: joint.name.clone(), kind: joint.kind.word() });
    }
    if drives[..number].contains(drive) {
        return Err(MechanismError::DrivenTwice { joint: joint.name.clone() });
    }
    Ok(())
}

fn characteristic_length(bodies: &[Body], joints: &[Joint]) -> f64 {
    let mut largest: f64 = 0.0;
    for body in 0..bodies.len() {
        let markers = joints.iter().flat_map(|joint| [&joint.bearing, &joint.journal]);
        let points: Vec<Vec3> = markers.filter(|marker| marker.body == body).map(|marker| marker.point_m).collect();
        for (k, a) in points.iter().enumerate() {
            largest = points[k + 1..].iter().fold(largest, |largest, b| largest.max((*a - *b).length()));
        }
    }
    if largest > 0.0 { largest } else { 1.0 }
}
