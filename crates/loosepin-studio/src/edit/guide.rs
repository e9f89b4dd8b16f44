//! A guide or a slot that is turned by its line.

use std::f64::consts::PI;

use loosepin::model::{Line, Model};

use super::reshape::PosedMechanism;
use super::reshape::{Coordinate, length, minus};
use crate::drawing::still::Pose;

/// Angles of guides are multiples of this, rad.
const STEP_RAD: f64 = PI / 12.0;
/// The same where they need not be round, rad.
const FINE_STEP_RAD: f64 = PI / 180.0;
/// Nearer to its point a place says no direction, m.
const MIN_M: f64 = 1e-6;

/// The angle that a guide is to have, so that its line goes through a place; in steps of 15°, or of 1°.
///
/// # Errors
/// In words: the joint has no line, or the place is the point of the guide.
pub fn turned(
    model: &Model,
    poses: &[Pose],
    joint: usize,
    to_m: [f64; 2],
    is_free: bool,
) -> Result<Coordinate, String> {
    let Some(Line { point, angle_rad: angle }) = model.joints[joint].kind.line() else {
        return Err(format!("{} has no line that can be turned", model.joints[joint].name));
    };
    let way = minus(to_m, PosedMechanism::new(model, poses).at_m(point));
    if !(length(way) > MIN_M) {
        return Err("this place is the point of the guide, so it gives no direction".to_owned());
    }
    let step_rad = if is_free { FINE_STEP_RAD } else { STEP_RAD };
    let now_rad = model.quantities.nominal()[angle];
    let asked_rad = way[1].atan2(way[0]) - poses[point.body.0].angle_rad;
    // The nearest turn of it, so that a guide at 170° goes on to 185°.
    let near_rad = asked_rad + 2.0 * PI * ((now_rad - asked_rad) / (2.0 * PI)).round();
    Ok((angle, (near_rad / step_rad).round() * step_rad))
}
