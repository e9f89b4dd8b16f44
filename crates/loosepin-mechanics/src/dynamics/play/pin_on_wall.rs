//! A pin on the wall of a slot, straight or round.

use crate::dynamics::play::contact_motion::Sliding;
use crate::dynamics::play::motion::PlayMotion;
use loosepin_math::{Real, Vec2};

/// Sliding of the pin's material on the slot's at one common contact point, R_j - δ/2 from the pin's centre along n. The arm of the slot
/// is n·e + R_j - δ/2, negative where n points at its reference point.
#[inline(never)]
pub(in crate::dynamics) fn sliding_on_wall<T: Real>(
    motion: &PlayMotion<T>,
    pin_radius_m: T,
    [normal, tangent]: [Vec2<T>; 2],
    penetration_m: T,
) -> Sliding<T> {
    let pin_arm_m = pin_radius_m - penetration_m * T::from_f64(0.5);
    let slot_arm_m = normal.dot(motion.eccentricity_m) + pin_arm_m;
    let [spin_i, spin_j] = motion.spins_rad_s;
    let material_m_s = tangent.dot(motion.eccentricity_rate_m_s) + pin_arm_m * spin_j - slot_arm_m * spin_i;
    Sliding { sliding_m_s: material_m_s, material_m_s, arms_m: [slot_arm_m, pin_arm_m] }
}
