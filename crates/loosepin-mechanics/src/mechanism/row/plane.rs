//! The conditions of the plane.

use super::angle::Angle;
use super::coincident::Coincident;
use super::list::rows;
use super::on_circle::OnCircle;
use super::on_line::OnLine;
use crate::mechanism::tree::cut_numbers::CutNumbers;
use crate::mechanism::tree::points::direction;
use crate::model::{PlaneRow, Row};
use loosepin_math::{Plane, Real, Vec2};

rows! {
    Plane, PlaneRow, |state| {
        PlaneRow::Coincident => Coincident::at(state),
        PlaneRow::OnLine => OnLine::at(state),
        PlaneRow::OnCircle => OnCircle::at(state),
        PlaneRow::Angle => Angle::at(state),
    }
}

/// Displaces the second body of a cut joint from where it is in `centred`, the same numbers without a displacement: where points coincide by an
/// eccentricity in the ground's frame, m; on a line by an ordinate across it, m, and an angle, rad; on a circle by a length outwards, m.
pub(in crate::mechanism) fn displace<T: Real>(
    rows: &[PlaneRow],
    numbers: &mut CutNumbers<T>,
    displacement: Vec2<T>,
    centred: &CutNumbers<T>,
) {
    for row in rows {
        match row {
            PlaneRow::Coincident => numbers.eccentricity_m = displacement,
            PlaneRow::OnLine => {
                let Vec2 { x: ordinate_m, y: tilt_rad } = displacement;
                numbers.arms_m[0] = centred.arms_m[0].plus(direction(numbers.markers[0]).turned(), ordinate_m);
                numbers.markers[1] = centred.markers[1] - tilt_rad;
            }
            PlaneRow::OnCircle => numbers.radius_m = centred.radius_m + displacement.x,
            PlaneRow::Angle => {}
        }
    }
}
