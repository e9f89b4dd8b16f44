//! Feet: where joints stand on the ground.

use super::joints::{bearing_length_m, travel_m};
use super::shapes::{OfJoint, at, face};
use super::sizes::Sizes;
use super::source::PictureSource;
use loosepin_math::Vec3;
use loosepin_result::spatial_picture::{PictureElement, PictureRole};

/// Height of a foot and half the side of its plate, over the extent.
const HEIGHT: f64 = 0.05;
const HALF_SIDE: f64 = 0.032;
/// Lines of the hatching of a plate, as places along two of its sides.
const HATCHES: [f64; 5] = [-1.2, -0.6, 0.0, 0.6, 1.2];

/// The feet of a joint, which stand below its points on the ground, along -z; none of a joint between moving bodies.
pub(super) fn elements(source: &PictureSource<'_>, number: usize, sizes: &Sizes) -> Vec<PictureElement> {
    let Some(joint) = source.mechanism.joints().get(number) else { return Vec::new() };
    let Some(marker) = [&joint.bearing, &joint.journal].into_iter().find(|marker| marker.body == 0) else {
        return Vec::new();
    };
    let (own, sign) = (OfJoint(joint), joint.kind.sign());
    let is_rail = sign.has_rails() && joint.bearing.body == 0;
    let tops = if is_rail {
        let [least_m, most_m] = travel_m(source, joint);
        let ends = [least_m - sizes.margin_m, most_m + sizes.margin_m];
        ends.map(|along| at(marker, 0.0, 0.0, along)).to_vec()
    } else {
        vec![marker.point_m]
    };
    // An upright bearing reaches down itself.
    let below_m = if sign.has_bearing() { 0.5 * bearing_length_m(joint, sizes) * marker.axes.z.z.abs() } else { 0.0 };
    tops.into_iter().flat_map(|top| foot(&own, top, below_m + HEIGHT * sizes.extent_m, sizes)).collect()
}

fn foot(own: &OfJoint<'_>, top: Vec3, height_m: f64, sizes: &Sizes) -> Vec<PictureElement> {
    let middle = top - Vec3::Z * height_m;
    let half_m = HALF_SIDE * sizes.extent_m;
    let on_plate = |x: f64, y: f64| middle + Vec3::new(x * half_m, y * half_m, 0.0);
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[x, y]| on_plate(x, y));
    let mut elements =
        vec![own.line(PictureRole::Foot, 0, &[top, middle]), own.element(PictureRole::Foot, 0, face(&corners))];
    elements.extend(HATCHES.map(|place| {
        // x + y is constant along a line, from side to side of the plate.
        let (least, most) = ((place - 1.0).max(-1.0), (place + 1.0).min(1.0));
        own.line(PictureRole::Hatch, 0, &[on_plate(least, place - least), on_plate(most, place - most)])
    }));
    elements
}
