//! A spring with its damper along the line between two points.

use crate::dynamics::elements::element_force::SpringForce;
use crate::mechanism::{Kinematics, SpringGeometry};
use loosepin_math::Real;

/// Force of the spring between points of the bodies in slots `[i, j]`: with the line d = r_j - r_i, its length L = |d| and
/// n = d/L, the pull P + k (L - L0) + d L̇ draws the points together: -n times it on the second one, +n on the first.
///
/// Where both points meet the line has no direction: within [`SpringGeometry::shortest_m`] nothing is a number, and a run ends there.
#[inline(always)]
pub fn linear_spring<T: Real>(
    kinematics: &Kinematics<T>,
    [i, j]: [usize; 2],
    spring: &SpringGeometry<T>,
) -> SpringForce<T> {
    let arms_m = [kinematics.poses[i].turn(spring.arms_m[0]), kinematics.poses[j].turn(spring.arms_m[1])];
    let line_m = kinematics.poses[j].position_m + arms_m[1] - kinematics.poses[i].position_m - arms_m[0];
    let line_rate_m_s = kinematics.twists[j].at(arms_m[1]) - kinematics.twists[i].at(arms_m[0]);
    let length_m = line_m.length().max(T::from_f64(f64::MIN_POSITIVE));
    let length_m = T::select(length_m.less_than(spring.shortest_m), T::from_f64(f64::NAN), length_m);
    let direction = line_m * (T::one() / length_m);
    let rate_m_s = line_rate_m_s.dot(direction);
    SpringForce {
        arms_m,
        on_second_n: direction * -spring.pull(length_m, rate_m_s),
        moment_on_second_n_m: T::zero(),
        stored_j: spring.stored_energy_j(length_m),
        damping_loss_w: spring.damping_loss_w(rate_m_s),
    }
}
