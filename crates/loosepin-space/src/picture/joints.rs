//! Joints by the signs of their kinds.

use super::shapes::{OfJoint, at};
use super::sizes::Sizes;
use super::source::PictureSource;
use crate::kind::SpatialPlay;
use crate::kind::sign::JointSign;
use crate::mechanism::joint::Joint;
use loosepin_math::Vec3;
use loosepin_result::spatial_picture::{PictureElement, PictureRole, PictureShape};

/// A pin is longer than its bearing by this share at either end.
const PIN_BEYOND: f64 = 0.3;
/// Half sides of a block across and along its guide, and the place of a rail, in radii of a bearing.
const BLOCK: [f64; 3] = [1.2, 1.2, 2.2];
const RAIL: f64 = 1.2;
/// Half side of a plate in radii of a bearing, and half the length of a pin of a cross in radii of a ball.
const PLATE: f64 = 3.0;
const CROSS: f64 = 2.4;

/// What is drawn of a joint.
pub(super) fn elements(source: &PictureSource<'_>, number: usize, sizes: &Sizes) -> Vec<PictureElement> {
    let Some(joint) = source.mechanism.joints().get(number) else { return Vec::new() };
    let own = OfJoint(joint);
    let length_m = bearing_length_m(joint, sizes);
    let (bearing, journal) = (&joint.bearing, &joint.journal);
    let axis = |from_m: f64, to_m: f64| {
        let ends = [from_m - sizes.beyond_m, to_m + sizes.beyond_m].map(|along| at(bearing, 0.0, 0.0, along));
        own.line(PictureRole::Axis, bearing.body, &ends)
    };
    match joint.kind.sign() {
        JointSign::Pin => {
            // What the bearing hides is not drawn: which end is in front depends on the view.
            let stub = |side: f64| {
                let ends = [0.5, 0.5 + PIN_BEYOND].map(|share| at(journal, 0.0, 0.0, side * share * length_m));
                let shape = PictureShape::Cylinder { ends_m: ends.map(Vec3::to_array), radius_m: sizes.pin_m };
                own.element(PictureRole::Pin, journal.body, shape)
            };
            let hole = own.cylinder(PictureRole::Bearing, bearing, length_m, sizes.radius_m);
            vec![axis(-0.5 * length_m, 0.5 * length_m), hole, stub(-1.0), stub(1.0)]
        }
        JointSign::Sleeve => {
            // The shaft reaches through the bearing wherever that is on it.
            let [least_m, most_m] = travel_m(source, joint);
            let [from_m, to_m] = [-most_m - 0.5 * length_m, -least_m + 0.5 * length_m];
            let ends_m = [from_m - sizes.margin_m, to_m + sizes.margin_m].map(|along| at(journal, 0.0, 0.0, along));
            let shaft = PictureShape::Cylinder { ends_m: ends_m.map(Vec3::to_array), radius_m: sizes.pin_m };
            vec![
                axis(-0.5 * length_m, 0.5 * length_m),
                own.element(PictureRole::Pin, journal.body, shaft),
                own.cylinder(PictureRole::Bearing, bearing, length_m, sizes.radius_m),
            ]
        }
        JointSign::Guide => {
            let [least_m, most_m] = travel_m(source, joint);
            let half_sides = BLOCK.map(|share| share * sizes.radius_m);
            let ends = [least_m - half_sides[2] - 0.5 * sizes.margin_m, most_m + half_sides[2] + 0.5 * sizes.margin_m];
            let rail = |side: f64| {
                let points = ends.map(|along| at(bearing, side * (BLOCK[0] + RAIL) * sizes.radius_m, 0.0, along));
                own.line(PictureRole::Guide, bearing.body, &points)
            };
            let mut elements = vec![axis(ends[0], ends[1]), rail(-1.0), rail(1.0)];
            elements.extend(own.block(PictureRole::Block, journal, half_sides));
            elements
        }
        JointSign::Ball => {
            let ball = PictureShape::Ball { centre_m: journal.point_m.to_array(), radius_m: sizes.ball_m };
            vec![own.element(PictureRole::Ball, journal.body, ball)]
        }
        JointSign::Cross => [bearing, journal]
            .map(|marker| own.cylinder(PictureRole::Pin, marker, 2.0 * CROSS * sizes.ball_m, 0.6 * sizes.pin_m))
            .to_vec(),
        JointSign::Plate => [own.plate(PictureRole::Block, bearing, PLATE * sizes.radius_m), axis(0.0, 0.0)].to_vec(),
        JointSign::Weld => own.block(PictureRole::Block, bearing, [0.8 * sizes.ball_m; 3]),
    }
}

/// Length of the bearing of a joint, or of one that has none of its own, m.
pub(super) fn bearing_length_m(joint: &Joint, sizes: &Sizes) -> f64 {
    joint.play.as_ref().and_then(SpatialPlay::bearing_length_m).unwrap_or(sizes.bearing_m)
}

/// The least and the largest place of the journal along the axis of the bearing, m: z·(P_j - P_i) over all positions.
pub(super) fn travel_m(source: &PictureSource<'_>, joint: &Joint) -> [f64; 2] {
    let (bearing, journal) = (&joint.bearing, &joint.journal);
    let places = source.poses.iter().filter_map(|poses| {
        let (carrier, slider) = (poses.get(bearing.body)?, poses.get(journal.body)?);
        let axis = carrier.orientation.rotation().apply(bearing.axes.z);
        Some(axis.dot(slider.point_m(journal.point_m) - carrier.point_m(bearing.point_m)))
    });
    let [least, most] =
        places.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], at| [least.min(at), most.max(at)]);
    if least <= most { [least, most] } else { [0.0; 2] }
}
