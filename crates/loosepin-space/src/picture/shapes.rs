//! Simple shapes at a marker.

use crate::mechanism::joint::Joint;
use crate::mechanism::marker::Marker;
use loosepin_math::Vec3;
use loosepin_result::spatial_picture::{PictureElement, PictureRole, PictureShape};

/// What a joint is drawn of.
#[derive(Debug, Clone, Copy)]
pub(super) struct OfJoint<'a>(pub &'a Joint);

impl OfJoint<'_> {
    pub fn element(&self, role: PictureRole, body: usize, shape: PictureShape) -> PictureElement {
        PictureElement { role, body, of: self.0.name.clone(), has_play: self.0.play.is_some(), shape }
    }

    /// A line through points.
    pub fn line(&self, role: PictureRole, body: usize, points: &[Vec3]) -> PictureElement {
        self.element(role, body, line(points))
    }

    /// A cylinder along the axis of a marker, its middle there.
    pub fn cylinder(&self, role: PictureRole, marker: &Marker, length_m: f64, radius_m: f64) -> PictureElement {
        let ends_m = [-0.5, 0.5].map(|share| at(marker, 0.0, 0.0, share * length_m).to_array());
        self.element(role, marker.body, PictureShape::Cylinder { ends_m, radius_m })
    }

    /// The six faces of a block about a marker with these half sides along its axes.
    pub fn block(&self, role: PictureRole, marker: &Marker, [x, y, z]: [f64; 3]) -> Vec<PictureElement> {
        let corners = |signs: [[f64; 3]; 4]| face(&signs.map(|[a, b, c]| at(marker, a * x, b * y, c * z)));
        let faces = [-1.0, 1.0].into_iter().flat_map(|s| {
            [
                [[s, -1.0, -1.0], [s, 1.0, -1.0], [s, 1.0, 1.0], [s, -1.0, 1.0]],
                [[-1.0, s, -1.0], [1.0, s, -1.0], [1.0, s, 1.0], [-1.0, s, 1.0]],
                [[-1.0, -1.0, s], [1.0, -1.0, s], [1.0, 1.0, s], [-1.0, 1.0, s]],
            ]
        });
        faces.map(|signs| self.element(role, marker.body, corners(signs))).collect()
    }

    /// A square about a marker, across its axis.
    pub fn plate(&self, role: PictureRole, marker: &Marker, half_m: f64) -> PictureElement {
        let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
        let corners = corners.map(|[a, b]| at(marker, a * half_m, b * half_m, 0.0));
        self.element(role, marker.body, face(&corners))
    }
}

/// A point in the frame of a marker, in that of its body.
pub(super) fn at(marker: &Marker, x: f64, y: f64, z: f64) -> Vec3 {
    marker.point_m + marker.axes.apply(Vec3::new(x, y, z))
}

pub(super) fn line(points: &[Vec3]) -> PictureShape {
    PictureShape::Line { points_m: points.iter().map(|point| point.to_array()).collect() }
}

pub(super) fn face(corners: &[Vec3]) -> PictureShape {
    PictureShape::Face { corners_m: corners.iter().map(|corner| corner.to_array()).collect() }
}
