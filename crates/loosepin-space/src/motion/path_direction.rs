//! The direction of the path of a point where its velocity may be zero.

use super::rates::motion;
use crate::closure::position::Position;
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use crate::output::PointOutput;
use loosepin_math::Vec3;

/// Speeds over the size of the mechanism in a turn, up to which a point rests.
pub(crate) const RESTING: f64 = 1e-9;

/// The direction of the path of a point: that of its velocity, or where the point turns back that of its acceleration. `None` where it rests.
pub(crate) fn path_direction(
    mechanism: &SpatialMechanism,
    position: &Position,
    point: &PointOutput,
    turn_s: f64,
) -> Option<Vec3> {
    let rates = motion(mechanism, position);
    let arm = position.poses[point.body].orientation.rotation().apply(point.point_m);
    let limit = RESTING * mechanism.characteristic_length_m() / turn_s;
    let [velocity, acceleration] =
        [rates.point_velocity_m_s(point.body, arm), rates.point_acceleration_m_s2(point.body, arm)];
    let along = if velocity.length() > limit { velocity } else { acceleration };
    let is_moving = velocity.length() > limit || acceleration.length() > limit / turn_s;
    along.normalised().filter(|_| is_moving)
}
