//! Motion and forces in a revolute joint with clearance ([SC16] eqs. 1-9; method, section 2).

use crate::contact::{Film, NormalContact, PlayState};
use crate::math::{Real, Vec2};
use crate::mechanism::{Kinematics, PlayGeometry};
use crate::model::SlidingVelocity;

/// The root u = √δ of a penetration as an unknown of its own, for contact that is smooth from its beginning to its end.
#[derive(Debug, Clone, Copy)]
pub struct DepthRoot<T> {
    /// One where the root is an unknown, zero where the penetration is read off the positions.
    pub is_unknown: T,
    /// u, √m, where it is an unknown.
    pub root: T,
}

/// What a joint with play takes from the state vector beside the motion of its bodies.
#[derive(Debug, Clone, Copy)]
pub struct PlayUnknowns<T> {
    /// The root of the penetration, where the joint has one.
    pub root: Option<DepthRoot<T>>,
    /// Mean deflection z of the bristles, m, where the friction law has them.
    pub bristle_m: Option<T>,
}

impl<T> PlayUnknowns<T> {
    /// Nothing: the penetration is read off the positions, and bristles have settled.
    pub fn none() -> Self {
        Self { root: None, bristle_m: None }
    }
}

/// Where the journal is in its bearing and how it moves.
#[derive(Debug, Clone, Copy)]
pub struct PlayMotion<T> {
    /// Eccentricity e = r_j - r_i, m, in the ground's frame.
    pub eccentricity_m: Vec2<T>,
    /// ė, m/s.
    pub eccentricity_rate_m_s: Vec2<T>,
    /// Bearing centre from the bearing body's origin, m, in the ground's frame.
    pub bearing_arm_m: Vec2<T>,
    /// Journal centre from the journal body's origin, m, in the ground's frame.
    pub journal_arm_m: Vec2<T>,
    /// Angular velocities ω_i (bearing) and ω_j (journal), rad/s.
    pub spins_rad_s: [T; 2],
}

/// The force in a joint with play.
#[derive(Debug, Clone, Copy)]
pub struct PlayForce<T> {
    /// F_j: force on the journal, N, in the ground's frame; the bearing gets the opposite.
    pub on_journal_n: Vec2<T>,
    /// Moment about the journal centre P_j on the journal's body, N m.
    pub moment_on_journal_n_m: T,
    /// Moment about the bearing centre P_i on the bearing's body, N m.
    pub moment_on_bearing_n_m: T,
    /// Power that the normal contact turns into heat: -(F_el - F_N) δ̇ = (F_N - F_el) δ̇, W.
    pub contact_loss_w: T,
    /// Power that friction turns into heat: -F_T v_T with the material sliding velocity, W.
    pub friction_loss_w: T,
    /// Normal force F_N, N.
    pub normal_n: T,
    /// Penetration rate δ̇, m/s.
    pub penetration_rate_m_s: T,
    /// Rate ż of the deflection of the bristles, m/s; zero without any.
    pub bristle_rate_m_s: T,
    /// Sliding velocity v_T that friction goes by, m/s; zero where there is no friction.
    pub sliding_m_s: T,
}

impl<T: Real> PlayMotion<T> {
    /// Reads the motion between the bodies in slots `[i, j]` (bearing's, journal's) from their kinematics.
    #[inline(always)]
    pub fn between(kinematics: &Kinematics<T>, [i, j]: [usize; 2], play: &PlayGeometry<T>) -> Self {
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

    /// δ̇ = ė·n, m/s (eq. 6); zero where e = 0 and n is undefined.
    #[inline(always)]
    pub fn penetration_rate_m_s(&self) -> T {
        let length_m = self.eccentricity_m.length().max(T::from_f64(f64::MIN_POSITIVE));
        self.eccentricity_rate_m_s.dot(self.eccentricity_m) / length_m
    }

    /// The contact force at this motion. In flight (`state.contact` zero) everything is zero.
    ///
    /// Both forces act at one common contact point, half way between the two surface points of eq. (5), so that energy and
    /// angular momentum are exact: arms R_j - δ/2 about P_j and R_i + δ/2 about P_i.
    #[inline(always)]
    pub fn force(&self, play: &PlayGeometry<T>, state: &PlayState<T>) -> PlayForce<T> {
        self.force_with_unknowns(play, state, &PlayUnknowns::none())
    }

    /// The contact force with the root of the penetration and the deflection of the bristles as unknowns, where they are.
    #[inline(always)]
    pub fn force_with_unknowns(
        &self,
        play: &PlayGeometry<T>,
        state: &PlayState<T>,
        unknowns: &PlayUnknowns<T>,
    ) -> PlayForce<T> {
        let length_m = self.eccentricity_m.length().max(T::from_f64(f64::MIN_POSITIVE)); // eq. (2)
        let normal = self.eccentricity_m * (T::one() / length_m); // eq. (3)
        let tangent = normal.turned(); // eq. (3)
        let penetration_m = self.penetration_m(play.clearance_m) * state.contact; // eq. (4)
        let rate_m_s = self.eccentricity_rate_m_s.dot(normal); // eq. (6)
        let force = match &unknowns.root {
            None => play.normal.force(penetration_m, rate_m_s, state), // eq. (8)
            Some(unknown) => {
                let depth_root = penetration_m.max(T::zero()).sqrt();
                let is_unknown = T::from_f64(0.5).less_than(unknown.is_unknown);
                play.normal.force_at_root(T::select(is_unknown, unknown.root, depth_root), rate_m_s, state)
            }
        };
        let contact_loss_w = (force.total_n - force.elastic_n) * rate_m_s;
        let mut result = PlayForce {
            on_journal_n: normal * -force.total_n,
            moment_on_journal_n_m: T::zero(),
            moment_on_bearing_n_m: T::zero(),
            contact_loss_w,
            friction_loss_w: T::zero(),
            normal_n: force.total_n,
            penetration_rate_m_s: rate_m_s,
            bristle_rate_m_s: T::zero(),
            sliding_m_s: T::zero(),
        };
        if play.friction.acts() {
            let half_depth_m = penetration_m * T::from_f64(0.5);
            let bearing_arm_m = play.bearing_radius_m + half_depth_m;
            let journal_arm_m = play.bearing_radius_m - play.clearance_m - half_depth_m;
            let [spin_i, spin_j] = self.spins_rad_s;
            let orbiting_m_s = self.eccentricity_rate_m_s.dot(tangent);
            let material_m_s = orbiting_m_s + journal_arm_m * spin_j - bearing_arm_m * spin_i;
            let sliding_m_s = match play.sliding_velocity {
                SlidingVelocity::Material => material_m_s,
                SlidingVelocity::Literal => orbiting_m_s * (T::one() - play.clearance_m / length_m), // eq. (7)
            };
            let friction_n = match unknowns.bristle_m {
                None => play.friction.force_n(sliding_m_s, force.total_n),
                Some(bristle_m) => {
                    let friction = play.friction.force_with_bristle(sliding_m_s, force.total_n, bristle_m);
                    result.bristle_rate_m_s = friction.rate_m_s;
                    friction.force_n
                }
            };
            result.sliding_m_s = sliding_m_s;
            result.on_journal_n += tangent * friction_n;
            result.moment_on_journal_n_m = journal_arm_m * friction_n;
            result.moment_on_bearing_n_m = -(bearing_arm_m * friction_n);
            result.friction_loss_w = -(friction_n * material_m_s);
        }
        if let Some(film) = &play.film {
            self.add_film(film, play.clearance_m, &mut result);
        }
        result
    }

    /// Adds the force and the moments of a film of oil. What it loses counts as friction.
    #[inline(always)]
    fn add_film(&self, film: &Film<T>, clearance_m: T, to: &mut PlayForce<T>) {
        /// Below this, m, the journal is centred and n has any direction.
        const CENTRED_M: f64 = 1e-150;
        let length_m = self.eccentricity_m.length();
        let is_centred = length_m.less_than(T::from_f64(CENTRED_M));
        let inverse_1_m = T::one() / length_m.max(T::from_f64(CENTRED_M));
        let normal = Vec2::new(
            T::select(is_centred, T::one(), self.eccentricity_m.x * inverse_1_m),
            T::select(is_centred, T::zero(), self.eccentricity_m.y * inverse_1_m),
        );
        let tangent = normal.turned();
        let [spin_i, spin_j] = self.spins_rad_s;
        // q = ė - ½(ω_i + ω_j) k × e.
        let mean_spin = T::from_f64(0.5) * (spin_i + spin_j);
        let velocity_m_s = self.eccentricity_rate_m_s.plus(self.eccentricity_m.turned(), -mean_spin);
        let along = [velocity_m_s.dot(normal), velocity_m_s.dot(tangent)];
        let load = film.load(clearance_m, length_m, along, self.spins_rad_s);
        to.on_journal_n += normal * load.force.radial_n + tangent * load.force.tangential_n;
        to.moment_on_bearing_n_m += load.moments_n_m[0];
        to.moment_on_journal_n_m += load.moments_n_m[1];
        to.friction_loss_w += load.loss_w;
    }
}
