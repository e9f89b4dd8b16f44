//! The start of a flexible body in absolute nodal coordinates.

use crate::mechanism::parts::nodal_geometry::NodalGeometry;
use crate::mechanism::tree::kinematics::{Pose, Twist};
use crate::mechanism::tree::nodal_beam::TreeNodalBeam;

/// Coordinates and rates of a beam that is undeformed, where its body moves as a rigid one with this pose and velocity.
pub(in crate::mechanism) fn set_undeformed(
    place: &TreeNodalBeam,
    numbers: &NodalGeometry<f64>,
    (pose, twist): (&Pose<f64>, &Twist<f64>),
    coordinates: &mut [f64],
    rates: &mut [f64],
) {
    let (root, axis) = (pose.turn(numbers.root_m), pose.turn(numbers.axis));
    let turning = axis.turned() * twist.angular;
    let last = place.mesh.elements();
    coordinates[place.root_stretch()] = 1.0;
    for node in 1..=last {
        let reach = root.plus(axis, numbers.beam.length_m * node as f64 / last as f64);
        let (position, velocity) = (pose.position_m + reach, twist.at(reach));
        let (slope, rate) = match node == last {
            true => ([pose.angle_rad(), 1.0], [twist.angular, 0.0]),
            false => ([axis.x, axis.y], [turning.x, turning.y]),
        };
        let first = place.node(node);
        coordinates[first..first + 4].copy_from_slice(&[position.x, position.y, slope[0], slope[1]]);
        rates[first..first + 4].copy_from_slice(&[velocity.x, velocity.y, rate[0], rate[1]]);
    }
}
