//! A pin in a slot along a circle: a contact at each flank (`docs/notation.md`).
//!
//! With e from the centre of the circle to the pin and u = e/|e|, the pin is off the middle of the slot by |e| - R. It touches the
//! outer flank where that is above c, with δ = |e| - R - c and n = u, and the inner one where it is below -c, with δ = R - |e| - c
//! and n = -u. The normal force goes through the centre of the circle.
//!
//! **Stiffness.** With the pin's radius R_j = b - c, eq. (9) for a pin in a hole of radius R_i = R + b is K of the outer flank. At the
//! inner one, a cylinder of radius R_i = R - b, it is the same equation with R_i + R_j below the root in place of R_i - R_j.
//!
//! The functions stand out of line, as those of a straight slot do.

use crate::contact::NormalForce;
use crate::dynamics::play::contact::{Parts, Pressed, Touch};
use crate::dynamics::play::contact_motion::{ContactMotion, GapMotion, Sliding};
use crate::dynamics::play::pin_on_wall::sliding_on_wall;
use crate::mechanism::CircularSlotShape;
use loosepin_math::{Real, Vec2};

impl<T: Real> Parts<T> for CircularSlotShape<T> {
    /// The normal force acts at the circle's centre on the slot's body, at the pin's on the other.
    #[inline(never)]
    fn contact(&self, Touch { motion, play, place }: Touch<'_, T>) -> ContactMotion<T> {
        let sign = T::from_f64(if is_outer(place) { 1.0 } else { -1.0 });
        let distance_m = motion.eccentricity_m.length().max(T::from_f64(f64::MIN_POSITIVE));
        let normal = motion.eccentricity_m * (sign / distance_m);
        ContactMotion {
            normal,
            penetration_m: sign * (distance_m - self.radius_m) - play.clearance_m,
            penetration_rate_m_s: normal.dot(motion.eccentricity_rate_m_s),
            reaches_m: [Vec2::zero(); 2],
        }
    }

    #[inline(always)]
    fn stored_energy_j(&self, at: Touch<'_, T>, of_law_j: T) -> T {
        of_law_j * share(self, at.place)
    }

    /// The inner flank is less stiff.
    #[inline(always)]
    fn pressed(
        &self,
        at: Touch<'_, T>,
        contact: &ContactMotion<T>,
        _penetration_m: T,
        force: &mut NormalForce<T>,
    ) -> Pressed<T> {
        let share = share(self, at.place);
        force.scale(share);
        Pressed { share, normal_n: force.total_n, tangent: contact.normal.turned(), push_n: None }
    }

    #[inline(always)]
    fn sliding(&self, at: Touch<'_, T>, normal: Vec2<T>, tangent: Vec2<T>, penetration_m: T) -> Sliding<T> {
        sliding_on_wall(at.motion, self.half_width_m - at.play.clearance_m, [normal, tangent], penetration_m)
    }

    /// d²|e|/dt² = u·ë + (u×ė)²/|e|.
    #[inline(never)]
    fn gap(&self, at: Touch<'_, T>, acceleration_m_s2: Vec2<T>, _spin_rates_rad_s2: [T; 2]) -> GapMotion<T> {
        let ContactMotion { normal, penetration_m, penetration_rate_m_s, .. } = self.contact(at);
        let around_m_s = normal.cross(at.motion.eccentricity_rate_m_s);
        // n·e is |e| at the outer flank and -|e| at the inner one.
        let second_m_s2 = normal.dot(acceleration_m_s2) + around_m_s.squared() / normal.dot(at.motion.eccentricity_m);
        GapMotion::without_slot([penetration_m, penetration_rate_m_s, second_m_s2], second_m_s2)
    }
}

/// Whether the contact at `place` is that of the outer flank.
fn is_outer(place: usize) -> bool {
    place == 0
}

/// K of the flank at `place` over that of the contact's law, which is that of the outer one.
#[inline(always)]
fn share<T: Real>(slot: &CircularSlotShape<T>, place: usize) -> T {
    if is_outer(place) { T::one() } else { slot.inner_share }
}
