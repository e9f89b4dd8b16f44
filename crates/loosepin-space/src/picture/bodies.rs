//! Bodies between their points.

use super::hull::{Shape, shape};
use super::shapes::{face, line};
use super::sizes::Sizes;
use super::source::PictureSource;
use loosepin_math::Vec3;
use loosepin_result::spatial_picture::{PictureElement, PictureRole, PictureShape};

/// Points of a body that are closer than this share of the extent are one.
const SAME: f64 = 1e-6;

/// Bars and faces of all bodies but the ground: two points are the ends of a bar, more that lie in a plane the corners of a face, others those of
/// a solid.
pub(super) fn elements(source: &PictureSource<'_>, sizes: &Sizes) -> Vec<PictureElement> {
    let bodies = source.mechanism.bodies().iter().enumerate().skip(1);
    bodies
        .flat_map(|(number, body)| {
            let element = |role: PictureRole, shape: PictureShape| PictureElement {
                role,
                body: number,
                of: body.name.clone(),
                has_play: false,
                shape,
            };
            let points = points(source, number, SAME * sizes.extent_m);
            let at = |corners: &[usize]| corners.iter().filter_map(|k| points.get(*k).copied()).collect::<Vec<Vec3>>();
            let Shape { lines, faces } = shape(&points, SAME * sizes.extent_m);
            let lines: Vec<PictureElement> =
                lines.iter().map(|ends| element(PictureRole::Bar, line(&at(ends)))).collect();
            let faces = faces.iter().map(|corners| element(PictureRole::Plate, face(&at(corners))));
            faces.chain(lines).collect::<Vec<PictureElement>>()
        })
        .collect()
}

/// The points of a body's joints and its named ones, each once.
fn points(source: &PictureSource<'_>, body: usize, same_m: f64) -> Vec<Vec3> {
    let markers = source.mechanism.joints().iter().flat_map(|joint| [&joint.bearing, &joint.journal]);
    let of_joints = markers.filter(|marker| marker.body == body).map(|marker| marker.point_m);
    let named = source.points.get(body).into_iter().flatten().map(|(_, point)| *point);
    let mut points: Vec<Vec3> = Vec::new();
    for point in of_joints.chain(named) {
        if points.iter().all(|other| (*other - point).length() > same_m) {
            points.push(point);
        }
    }
    points
}
