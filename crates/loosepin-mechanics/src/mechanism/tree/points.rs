//! Points and directions of bodies in their own frames.

use crate::model::{Model, PointId, QuantityId, Values};
use loosepin_math::{Real, Vec2};

/// Cosine and sine of an angle.
pub(in crate::mechanism) fn direction<T: Real>(angle_rad: T) -> Vec2<T> {
    let (sine, cosine) = angle_rad.sin_cos();
    Vec2::new(cosine, sine)
}

/// Position of a point in its body's frame, m.
pub fn point_m<T: Real>(model: &Model, values: &Values, point: PointId) -> Vec2<T> {
    numbered_point_m(model, &|id| T::from_f64(values[id]), point)
}

/// Position of a point in its body's frame, m, from the numbers that `number` gives.
pub fn numbered_point_m<T: Real>(model: &Model, number: &dyn Fn(QuantityId) -> T, point: PointId) -> Vec2<T> {
    let [x, y] = model.bodies[point.body.0].points[point.point].position_m;
    Vec2::new(number(x), number(y))
}
