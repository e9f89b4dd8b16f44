//! Teeth between flanks, and a follower on its cam: contacts of a coupling with play (`docs/notation.md`).
//!
//! Everything goes by one length, x = r (q_2 - f(q_1)): how far the second joint is from where the first would have it. With the
//! clearance c (half the backlash) the two flanks meet at δ = -x - c (second behind) and δ = x - c (second ahead); a cam meets its
//! follower at δ = -x. The normal force N acts along x. Its power is -N δ̇, so that the second joint gets the torque (or force)
//! r N_x and the first one -f'(q_1) r N_x with N_x = ±N: energy is exact whatever f is.
//!
//! [`PlayMotion`] holds x as the first part of an eccentricity, without directions in the plane.
//!
//! The functions stand out of line, as those of a slot do.

use crate::dynamics::play::contact::{Parts, Touch};
use crate::dynamics::play::contact_motion::{ContactMotion, GapMotion, Sliding};
use crate::mechanism::{Flanks, Kinematics};
use loosepin_math::{Real, Vec2};

impl<T: Real> Parts<T> for Flanks<T> {
    #[inline(always)]
    fn contact(&self, Touch { motion, play, place }: Touch<'_, T>) -> ContactMotion<T> {
        let sign = sign::<T>(place);
        ContactMotion {
            normal: Vec2::new(sign, T::zero()),
            penetration_m: sign * motion.eccentricity_m.x - play.clearance_m,
            penetration_rate_m_s: sign * motion.eccentricity_rate_m_s.x,
            reaches_m: [Vec2::zero(); 2],
        }
    }

    /// Its contact has no friction.
    #[inline(always)]
    fn sliding(&self, _at: Touch<'_, T>, _normal: Vec2<T>, _tangent: Vec2<T>, _penetration_m: T) -> Sliding<T> {
        Sliding { sliding_m_s: T::zero(), material_m_s: T::zero(), arms_m: [T::zero(); 2] }
    }

    #[inline(always)]
    fn gap(&self, at: Touch<'_, T>, acceleration_m_s2: Vec2<T>, _spin_rates_rad_s2: [T; 2]) -> GapMotion<T> {
        let ContactMotion { normal, penetration_m, penetration_rate_m_s, .. } = self.contact(at);
        let bent_m_s2 = normal.x * acceleration_m_s2.x;
        GapMotion::without_slot([penetration_m, penetration_rate_m_s, bent_m_s2], bent_m_s2)
    }
}

/// Direction of x in which the flank `place` is pressed: behind first, then ahead.
fn sign<T: Real>(place: usize) -> T {
    if place == 0 { -T::one() } else { T::one() }
}

/// Torques or forces along the coordinates of both joints that a force of one newton along x is.
#[inline(always)]
pub(in crate::dynamics) fn shares<T: Real>(kinematics: &Kinematics<T>, flanks: &Flanks<T>) -> [T; 2] {
    let lever = flanks.coupling.lever;
    [-(flanks.coupling.slope(&flanks.places, kinematics) * lever), lever]
}
