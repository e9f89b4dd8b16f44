//! A pin in a hole: the one contact of a revolute joint with clearance ([SC16] eqs. 1 to 7).

use crate::dynamics::play::contact::{Parts, Touch};
use crate::dynamics::play::contact_motion::{ContactMotion, GapMotion, Sliding};
use crate::mechanism::PinShape;
use crate::model::SlidingVelocity;
use loosepin_math::{Real, Vec2};

impl<T: Real> Parts<T> for PinShape<T> {
    /// Normal, penetration and its rate (eqs. 2-4, 6). n is undefined where e = 0: then the rate is zero.
    #[inline(always)]
    fn contact(&self, Touch { motion, play, .. }: Touch<'_, T>) -> ContactMotion<T> {
        let length_m = motion.eccentricity_m.length().max(T::from_f64(f64::MIN_POSITIVE)); // eq. (2)
        let normal = motion.eccentricity_m * (T::one() / length_m); // eq. (3)
        ContactMotion {
            normal,
            penetration_m: motion.penetration_m(play.clearance_m), // eq. (4)
            penetration_rate_m_s: motion.eccentricity_rate_m_s.dot(normal), // eq. (6)
            reaches_m: [Vec2::zero(); 2],
        }
    }

    #[inline(always)]
    fn penetration_m(&self, at: Touch<'_, T>) -> T {
        at.motion.penetration_m(at.play.clearance_m)
    }

    /// Sliding of the journal's surface on the bearing's at one common contact point, half way between the two surface points
    /// of eq. (5): arms R_j - δ/2 about P_j and R_i + δ/2 about P_i.
    #[inline(always)]
    fn sliding(
        &self,
        Touch { motion, play, .. }: Touch<'_, T>,
        _normal: Vec2<T>,
        tangent: Vec2<T>,
        penetration_m: T,
    ) -> Sliding<T> {
        let half_depth_m = penetration_m * T::from_f64(0.5);
        let bearing_arm_m = self.bearing_radius_m + half_depth_m;
        let journal_arm_m = self.bearing_radius_m - play.clearance_m - half_depth_m;
        let [spin_i, spin_j] = motion.spins_rad_s;
        let orbiting_m_s = motion.eccentricity_rate_m_s.dot(tangent);
        let material_m_s = orbiting_m_s + journal_arm_m * spin_j - bearing_arm_m * spin_i;
        let sliding_m_s = match play.sliding_velocity {
            SlidingVelocity::Material => material_m_s,
            SlidingVelocity::Literal => {
                let length_m = motion.eccentricity_m.length().max(T::from_f64(f64::MIN_POSITIVE));
                orbiting_m_s * (T::one() - play.clearance_m / length_m) // eq. (7)
            }
        };
        Sliding { sliding_m_s, material_m_s, arms_m: [bearing_arm_m, journal_arm_m] }
    }

    /// g = |e|² - c² and its derivatives; δ̈ from d²|e|²/dt² = 2(δ̇² + |e| δ̈).
    #[inline(always)]
    fn gap(
        &self,
        Touch { motion, play, .. }: Touch<'_, T>,
        acceleration_m_s2: Vec2<T>,
        _spin_rates_rad_s2: [T; 2],
    ) -> GapMotion<T> {
        let two = T::from_f64(2.0);
        let (e, rate) = (motion.eccentricity_m, motion.eccentricity_rate_m_s);
        let along = rate.length_squared() + e.dot(acceleration_m_s2);
        let length_m = e.length().max(T::from_f64(f64::MIN_POSITIVE));
        let speed = rate.dot(e * (T::one() / length_m));
        let gap = [motion.gap_m2(play.clearance_m), two * e.dot(rate), two * along];
        GapMotion::without_slot(gap, (along - speed * speed) / length_m)
    }
}
