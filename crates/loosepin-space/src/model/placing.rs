//! Where bodies start that the file gives no guess of: on a tree of joints from the ground, as the drives have them at time zero.

use crate::kind::frames::Axis;
use crate::kind::row::Row;
use crate::mechanism::drive::JointCoordinate;
use crate::mechanism::joint::Joint;
use crate::mechanism::marker::Marker;
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use loosepin_math::{Pose, Quaternion, Rotation, Vec3, sin_cos};
use std::f64::consts::TAU;

/// Poses of all bodies: those of `guesses`, and else the pose in which a joint to a body that is placed already is closed.
///
/// Joints that leave the fewest freedoms come first. Where a joint keeps its axes parallel, those of both markers coincide, but for the start of
/// a drive; where it holds a point alone, the body is turned so that the point of another joint of it is towards its partner, if that is placed,
/// and stands as it is drawn otherwise. Bodies that nothing connects to the ground stay at the origin.
pub(super) fn placed(mechanism: &SpatialMechanism, guesses: &[Option<Pose>], starts: &[f64]) -> Vec<Pose> {
    let count = mechanism.bodies().len();
    let mut poses: Vec<Option<Pose>> = (0..count).map(|body| guesses.get(body).copied().flatten()).collect();
    if let Some(ground) = poses.first_mut() {
        *ground = Some(Pose::GROUND);
    }
    loop {
        let is_open =
            |joint: &&(usize, &Joint)| is_placed(&poses, &joint.1.bearing) != is_placed(&poses, &joint.1.journal);
        let joints: Vec<(usize, &Joint)> = mechanism.joints().iter().enumerate().collect();
        let next = joints.iter().filter(is_open).min_by_key(|(number, joint)| (joint.kind.freedoms(), *number));
        let Some(&(number, joint)) = next else { break };
        let (angle, slide) = driven(mechanism, number, starts);
        let (body, pose) = place(mechanism, &poses, joint, angle, slide);
        poses[body] = Some(pose);
    }
    poses.into_iter().map(|pose| pose.unwrap_or(Pose::GROUND)).collect()
}

fn is_placed(poses: &[Option<Pose>], marker: &Marker) -> bool {
    poses.get(marker.body).is_some_and(Option::is_some)
}

/// Angle and slide of a joint at the start, as far as they are driven.
fn driven(mechanism: &SpatialMechanism, joint: usize, starts: &[f64]) -> (f64, f64) {
    let of = |coordinate: JointCoordinate| {
        let drives = mechanism.drives().iter().zip(starts);
        let mut own = drives.filter(|(drive, _)| drive.joint == joint && drive.coordinate == coordinate);
        own.next().map(|(_, start)| *start)
    };
    let (angle, slide) = (of(JointCoordinate::Angle), of(JointCoordinate::Slide));
    let pitch = mechanism.joints().get(joint).and_then(|joint| joint.kind.pitch_m());
    // One coordinate of a screw gives the other one.
    match (pitch, angle, slide) {
        (Some(pitch_m), Some(angle), None) => (angle, pitch_m * angle / TAU),
        (Some(pitch_m), None, Some(slide)) => (TAU * slide / pitch_m, slide),
        _ => (angle.unwrap_or(0.0), slide.unwrap_or(0.0)),
    }
}

/// The body at the open end of a joint, with the pose that closes it.
fn place(
    mechanism: &SpatialMechanism,
    poses: &[Option<Pose>],
    joint: &Joint,
    angle_rad: f64,
    slide_m: f64,
) -> (usize, Pose) {
    let is_bearing_known = is_placed(poses, &joint.bearing);
    let (known, new) =
        if is_bearing_known { (&joint.bearing, &joint.journal) } else { (&joint.journal, &joint.bearing) };
    let base = poses[known.body].unwrap_or(Pose::GROUND);
    let axes = base.orientation.rotation().compose(&known.axes);
    let origin = base.point_m(known.point_m);
    let rows = joint.kind.rows();
    let has = |axis| rows.contains(&Row::Perpendicular(axis, Axis::Z));
    if !(has(Axis::X) && has(Axis::Y)) {
        return (new.body, towards_partner(mechanism, poses, new, origin));
    }
    // Seen from the journal, the bearing is turned and moved the other way.
    let (angle, slide) = if is_bearing_known { (angle_rad, slide_m) } else { (-angle_rad, -slide_m) };
    let (sine, cosine) = sin_cos(angle);
    let turned = Rotation { x: axes.x * cosine + axes.y * sine, y: axes.y * cosine - axes.x * sine, z: axes.z };
    // R_body R_marker = turned
    let rotation = turned.compose(&new.axes.transposed_times(&Rotation::IDENTITY));
    let position = origin + axes.z * slide - rotation.apply(new.point_m);
    (new.body, Pose::new(position, Quaternion::from_rotation(&rotation)))
}

/// The pose of a body with the point of a marker at `origin`, turned so that the point of another of its joints is towards its partner.
fn towards_partner(mechanism: &SpatialMechanism, poses: &[Option<Pose>], new: &Marker, origin: Vec3) -> Pose {
    let pairs = mechanism
        .joints()
        .iter()
        .flat_map(|joint| [(&joint.bearing, &joint.journal), (&joint.journal, &joint.bearing)]);
    let aim = pairs.filter(|(own, _)| own.body == new.body).find_map(|(own, other)| {
        let target = poses.get(other.body).copied().flatten()?.point_m(other.point_m) - origin;
        Some(((own.point_m - new.point_m).normalised()?, target.normalised()?))
    });
    let turn = aim.map_or(Quaternion::IDENTITY, |(from, to)| turn_between(from, to));
    Pose::new(origin - turn.rotation().apply(new.point_m), turn)
}

/// The shortest turn from one unit vector to another.
fn turn_between(from: Vec3, to: Vec3) -> Quaternion {
    let axis = from.cross(to).normalised().or_else(|| from.across()).unwrap_or(Vec3::X);
    Quaternion::from_rotation_vector(axis * libm::atan2(from.cross(to).length(), from.dot(to)))
}
