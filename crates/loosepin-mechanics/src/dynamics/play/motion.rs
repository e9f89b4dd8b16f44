//! Motion of the two bodies of a joint with play against each other ([SC16] eqs. 1 to 6).

use crate::mechanism::{Kinematics, PlayGeometry};
use loosepin_math::{Real, Vec2};

/// Position and motion of the journal in its bearing, or of the slider in its guide.
#[derive(Debug, Clone, Copy)]
pub struct PlayMotion<T> {
    /// Eccentricity e = r_j - r_i of the journal's centre from the bearing's (the slider's from the guide's point), m, in the
    /// ground's frame; of a coupling the length x by which it deviates, and zero.
    pub eccentricity_m: Vec2<T>,
    /// ė, m/s.
    pub eccentricity_rate_m_s: Vec2<T>,
    /// Bearing centre from the bearing body's origin, m, in the ground's frame.
    pub bearing_arm_m: Vec2<T>,
    /// Journal centre from the journal body's origin, m, in the ground's frame.
    pub journal_arm_m: Vec2<T>,
    /// Angular velocities ω_i (bearing) and ω_j (journal), rad/s.
    pub spins_rad_s: [T; 2],
    /// Angles θ_i and θ_j of both bodies, rad; zero for a coupling.
    pub angles_rad: [T; 2],
    /// Directions of the guide's or slot's line and of the slider's axis in the ground's frame; zero where there is none.
    pub directions: [Vec2<T>; 2],
}

impl<T: Real> PlayMotion<T> {
    /// Reads the motion between the bodies in slots `[i, j]` (bearing's, journal's) from their kinematics.
    #[inline(never)]
    pub fn between(kinematics: &Kinematics<T>, [i, j]: [usize; 2], play: &PlayGeometry<T>) -> Self {
        if let Some(flanks) = play.shape.flanks() {
            let [x_m, rate_m_s] = flanks.deviation_m(kinematics);
            return Self {
                eccentricity_m: Vec2::new(x_m, T::zero()),
                eccentricity_rate_m_s: Vec2::new(rate_m_s, T::zero()),
                bearing_arm_m: Vec2::zero(),
                journal_arm_m: Vec2::zero(),
                spins_rad_s: [T::zero(); 2],
                angles_rad: [T::zero(); 2],
                directions: [Vec2::zero(); 2],
            };
        }
        let bearing_arm_m = kinematics.poses[i].turn(play.bearing_arm_m);
        let journal_arm_m = kinematics.poses[j].turn(play.journal_arm_m);
        let (twist_i, twist_j) = (kinematics.twists[i], kinematics.twists[j]);
        let r_i = kinematics.poses[i].position_m + bearing_arm_m;
        let r_j = kinematics.poses[j].position_m + journal_arm_m;
        Self {
            eccentricity_m: r_j - r_i, // eq. (1)
            eccentricity_rate_m_s: twist_j.at(journal_arm_m) - twist_i.at(bearing_arm_m),
            bearing_arm_m,
            journal_arm_m,
            spins_rad_s: [twist_i.angular, twist_j.angular],
            angles_rad: [kinematics.poses[i].angle_rad(), kinematics.poses[j].angle_rad()],
            directions: {
                let [line, axis] = play.shape.directions();
                [(line, i), (axis, j)]
                    .map(|(own, slot)| own.map_or(Vec2::zero(), |own| kinematics.poses[slot].turn(own)))
            },
        }
    }

    /// |e|² - c², m²: positive in contact, smooth also where e = 0.
    #[inline(always)]
    pub fn gap_m2(&self, clearance_m: T) -> T {
        self.eccentricity_m.length_squared() - clearance_m.squared()
    }

    /// δ = |e| - c, m (eqs. 2, 4), computed so that it keeps its digits near zero.
    #[inline(always)]
    pub fn penetration_m(&self, clearance_m: T) -> T {
        self.gap_m2(clearance_m) / (self.eccentricity_m.length() + clearance_m)
    }
}
