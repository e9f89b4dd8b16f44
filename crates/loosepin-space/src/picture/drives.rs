//! Arrows of drives.

use super::joints::bearing_length_m;
use super::shapes::{OfJoint, at};
use super::sizes::Sizes;
use super::source::PictureSource;
use crate::mechanism::drive::{Drive, JointCoordinate};
use crate::mechanism::marker::Marker;
use loosepin_math::{Vec3, sin_cos};
use loosepin_result::spatial_picture::{PictureElement, PictureRole};
use std::f64::consts::TAU;

/// Radius of the arrow around an axis and half the length of a straight one, over the extent.
const RADIUS: f64 = 0.045;
const HALF_LENGTH: f64 = 0.06;
/// Turn of a round arrow, in pieces.
const TURN_RAD: f64 = 0.75 * TAU;
const PIECES: usize = 24;
/// Length of a head over the extent, and half its width over its length.
const HEAD: f64 = 0.022;
const HEAD_WIDTH: f64 = 0.45;

/// An arrow for each drive that moves, in the sense in which its journal moves in the bearing; a bearing that moves on a journal of the ground
/// goes the other way.
pub(super) fn elements(source: &PictureSource<'_>, sizes: &Sizes) -> Vec<PictureElement> {
    let drives = source.mechanism.drives().iter().zip(source.speeds).filter(|(_, speed)| **speed != 0.0);
    drives.flat_map(|(drive, speed)| arrow(source, drive, *speed, sizes)).collect()
}

fn arrow(source: &PictureSource<'_>, drive: &Drive, speed: f64, sizes: &Sizes) -> Vec<PictureElement> {
    let Some(joint) = source.mechanism.joints().get(drive.joint) else { return Vec::new() };
    let is_reversed = joint.journal.body == 0;
    let marker = if is_reversed { &joint.journal } else { &joint.bearing };
    let sense = if is_reversed { -speed.signum() } else { speed.signum() };
    let points = match drive.coordinate {
        JointCoordinate::Angle => round(marker, 0.5 * bearing_length_m(joint, sizes), sense, sizes.extent_m),
        JointCoordinate::Slide => straight(marker, sense, sizes.extent_m),
    };
    let own = OfJoint(joint);
    let head = head(&points, marker.axes.z, sizes.extent_m);
    [points, head].map(|points| own.line(PictureRole::Drive, marker.body, &points)).to_vec()
}

/// An arc about the axis at the end of the bearing, from -x of the marker in the sense of the turn.
fn round(marker: &Marker, above_m: f64, sense: f64, extent_m: f64) -> Vec<Vec3> {
    let point = |piece: usize| {
        let (sine, cosine) = sin_cos(TURN_RAD * piece as f64 / PIECES as f64);
        let radius_m = RADIUS * extent_m;
        at(marker, -radius_m * cosine, -sense * radius_m * sine, above_m)
    };
    (0..=PIECES).map(point).collect()
}

/// A line beside the guide.
fn straight(marker: &Marker, sense: f64, extent_m: f64) -> Vec<Vec3> {
    [-1.0, 1.0].map(|end| at(marker, RADIUS * extent_m, 0.0, end * sense * HALF_LENGTH * extent_m)).to_vec()
}

/// Both barbs with the tip between them, in the plane of the last piece and a direction across it: of a round arrow away from the axis.
fn head(points: &[Vec3], axis: Vec3, extent_m: f64) -> Vec<Vec3> {
    let &[.., before, tip] = points else { return Vec::new() };
    let Some(along) = (tip - before).normalised() else { return Vec::new() };
    let across = axis.cross(along).normalised().or_else(|| along.across()).unwrap_or(Vec3::X);
    let barb = |side: f64| tip - along * (HEAD * extent_m) + across * (side * HEAD_WIDTH * HEAD * extent_m);
    vec![barb(-1.0), tip, barb(1.0)]
}
