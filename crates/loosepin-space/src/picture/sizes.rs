//! Sizes of what is drawn, as shares of the mechanism.

use super::source::PictureSource;
use loosepin_math::Vec3;

/// Sizes over the diagonal of the box around all points in all positions.
const RADIUS: f64 = 0.017;
const PIN: f64 = 0.55;
const BALL: f64 = 0.016;
const BEARING: f64 = 0.07;
const AXIS_BEYOND: f64 = 0.055;
const MARGIN: f64 = 0.055;

/// What signs are measured by, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Sizes {
    /// Diagonal of the box around all points in all positions.
    pub extent_m: f64,
    /// Radius of a bearing.
    pub radius_m: f64,
    /// Radius of a pin.
    pub pin_m: f64,
    /// Radius of a ball.
    pub ball_m: f64,
    /// Length of a bearing that has none of its own.
    pub bearing_m: f64,
    /// How far an axis reaches beyond a bearing.
    pub beyond_m: f64,
    /// How far a rail or shaft reaches beyond where it is needed.
    pub margin_m: f64,
}

impl Sizes {
    pub fn of(source: &PictureSource<'_>) -> Self {
        let extent_m = extent_m(source);
        let share = |share: f64| share * extent_m;
        Self {
            extent_m,
            radius_m: share(RADIUS),
            pin_m: PIN * share(RADIUS),
            ball_m: share(BALL),
            bearing_m: share(BEARING),
            beyond_m: share(AXIS_BEYOND),
            margin_m: share(MARGIN),
        }
    }
}

/// Diagonal of the box around the points of all joints and all named points in all positions; 1 m where they are one point.
fn extent_m(source: &PictureSource<'_>) -> f64 {
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    let mut add = |point: Vec3| {
        for (axis, value) in point.to_array().into_iter().enumerate() {
            (low[axis], high[axis]) = (low[axis].min(value), high[axis].max(value));
        }
    };
    for poses in source.poses {
        for (body, pose) in poses.iter().enumerate() {
            source.points.get(body).into_iter().flatten().for_each(|(_, point)| add(pose.point_m(*point)));
        }
        for marker in source.mechanism.joints().iter().flat_map(|joint| [&joint.bearing, &joint.journal]) {
            poses.get(marker.body).into_iter().for_each(|pose| add(pose.point_m(marker.point_m)));
        }
    }
    let size = (Vec3::from(high) - Vec3::from(low)).length();
    if size > 0.0 && size.is_finite() { size } else { 1.0 }
}
