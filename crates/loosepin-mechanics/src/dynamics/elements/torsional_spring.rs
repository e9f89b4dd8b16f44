//! A spring with its damper against the angle between two bodies.

use crate::dynamics::elements::element_force::SpringForce;
use crate::mechanism::{Kinematics, SpringGeometry};
use loosepin_math::{Real, Vec2};

/// Torque of the spring between the bodies in slots `[i, j]`: with θ = θ_j - θ_i, continuous over turns,
/// -(P + k (θ - θ0) + d θ̇) on the second one, the opposite on the first.
#[inline(always)]
pub fn torsional_spring<T: Real>(
    kinematics: &Kinematics<T>,
    [i, j]: [usize; 2],
    spring: &SpringGeometry<T>,
) -> SpringForce<T> {
    let angle_rad = kinematics.poses[j].angle_rad() - kinematics.poses[i].angle_rad();
    let rate_rad_s = kinematics.twists[j].angular - kinematics.twists[i].angular;
    SpringForce {
        arms_m: [Vec2::zero(); 2],
        on_second_n: Vec2::zero(),
        moment_on_second_n_m: -spring.pull(angle_rad, rate_rad_s),
        stored_j: spring.stored_energy_j(angle_rad),
        damping_loss_w: spring.damping_loss_w(rate_rad_s),
    }
}
