//! A point and three axes on a body.

use loosepin_math::{Frame, Pose, Rotation, Vec3};

/// A point with orthonormal axes, fixed to a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Marker {
    /// Number of the body; 0 is the ground.
    pub body: usize,
    /// The point in body axes, m.
    pub point_m: Vec3,
    /// Its axes in body axes.
    pub axes: Rotation,
}

impl Marker {
    /// A marker with z along `z_axis` and x along the part of `x_axis` across it; the lengths of both do not matter. `None` if they are
    /// parallel, or one is zero.
    pub fn new(body: usize, point_m: Vec3, z_axis: Vec3, x_axis: Vec3) -> Option<Self> {
        let z = z_axis.normalised()?;
        let x_axis = x_axis.normalised()?;
        let across = x_axis - z * x_axis.dot(z);
        if across.length() < MIN_SINE {
            return None;
        }
        let x = across.normalised()?;
        Some(Self { body, point_m, axes: Rotation { x, y: z.cross(x), z } })
    }

    /// A marker with z along `z_axis`, its x axis anywhere across: for joints in which no other axis has a meaning.
    pub fn along(body: usize, point_m: Vec3, z_axis: Vec3) -> Option<Self> {
        Self::new(body, point_m, z_axis, z_axis.across()?)
    }

    /// The marker at a point of the ground's frame with axes of the ground's frame, on a body in this pose.
    pub fn in_pose(body: usize, pose: &Pose, point_m: Vec3, z_axis: Vec3, x_axis: Vec3) -> Option<Self> {
        let turn = pose.orientation.rotation();
        let local = |vector| turn.apply_transposed(vector);
        Self::new(body, local(point_m - pose.position_m), local(z_axis), local(x_axis))
    }
}

impl From<&Marker> for Frame {
    /// The marker's frame in that of its body.
    fn from(marker: &Marker) -> Self {
        Self { origin_m: marker.point_m, axes: marker.axes }
    }
}

/// Sine of the angle below which two axes count as parallel.
const MIN_SINE: f64 = 1e-9;
