//! Forces where the two bodies of a joint with play touch.

use super::play::PlayMotion;
use super::{corner, film, pin, slot};
use crate::contact::{NormalContact, PlayState};
use crate::mechanism::{PlayGeometry, PlayShape};
use loosepin_math::{Real, Vec2};

/// The root u = √δ of a penetration as an unknown of its own, for contact that is smooth from its beginning to its end.
#[derive(Debug, Clone, Copy)]
pub struct DepthRoot<T> {
    /// One where the root is an unknown, zero where the penetration is read off the positions.
    pub is_unknown: T,
    /// u, √m, where it is an unknown.
    pub root: T,
}

/// What a contact takes from the state vector beside the motion of its bodies.
#[derive(Debug, Clone, Copy)]
pub struct ContactUnknowns<T> {
    /// The root of the penetration, where the contact has one.
    pub root: Option<DepthRoot<T>>,
    /// Mean deflection z of the bristles, m, where the friction law has them.
    pub bristle_m: Option<T>,
}

impl<T> ContactUnknowns<T> {
    /// Nothing: the penetration is read off the positions, and bristles have settled.
    pub fn none() -> Self {
        Self { root: None, bristle_m: None }
    }
}

/// How the two bodies of a joint with play come near each other at one place.
#[derive(Debug, Clone, Copy)]
pub struct ContactMotion<T> {
    /// n, in the ground's frame: the second body (journal, slider) is pushed back along -n.
    pub normal: Vec2<T>,
    /// δ, m: positive in contact.
    pub penetration_m: T,
    /// δ̇, m/s.
    pub penetration_rate_m_s: T,
    /// From the joint's points P_i and P_j to where the normal force acts on their bodies, m, in the ground's frame.
    pub reaches_m: [Vec2<T>; 2],
}

/// How the two surfaces slide on each other where they touch.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sliding<T> {
    /// v_T that friction goes by, m/s.
    pub sliding_m_s: T,
    /// Sliding velocity of the second body's material on the first's, m/s.
    pub material_m_s: T,
    /// Moment arms of a force along t about P_i on the first body (from it, not on it) and about P_j on the second, m.
    pub arms_m: [T; 2],
}

/// The force of one contact.
#[derive(Debug, Clone, Copy)]
pub struct ContactForce<T> {
    /// F_j: force on the second body (journal), N, in the ground's frame; the first one (bearing) gets the opposite.
    pub on_journal_n: Vec2<T>,
    /// Moment about the journal centre P_j on the journal's body, N m.
    pub moment_on_journal_n_m: T,
    /// Moment about the bearing centre P_i on the bearing's body, N m.
    pub moment_on_bearing_n_m: T,
    /// Power that the normal contact turns into heat: -(F_el - F_N) δ̇ = (F_N - F_el) δ̇, W.
    pub contact_loss_w: T,
    /// Power that friction turns into heat, -F_T v_T with the material sliding velocity, and a film of oil, W.
    pub friction_loss_w: T,
    /// Normal force F_N, N.
    pub normal_n: T,
    /// Penetration rate δ̇, m/s.
    pub penetration_rate_m_s: T,
    /// Rate ż of the deflection of the bristles, m/s; zero without any.
    pub bristle_rate_m_s: T,
    /// Sliding velocity v_T that friction goes by, m/s; zero where there is no friction.
    pub sliding_m_s: T,
    /// Stiffness at this place over that of the contact's law; one but for the ends of a slot.
    pub stiffness_share: T,
    /// Abscissa of the corner along the guide's line, m; zero but for a slider.
    pub along_m: T,
}

/// The gap function of a contact, positive in contact, and the second derivative of the penetration.
#[derive(Debug, Clone, Copy)]
pub struct GapMotion<T> {
    /// g and its first two derivatives over the time; [`crate::mechanism::GapMeasure`] says what it measures.
    pub gap: [T; 3],
    /// δ̈, m/s².
    pub penetration_acceleration_m_s2: T,
}

impl<T: Real> PlayMotion<T> {
    /// How the two bodies come near each other at `place`.
    #[inline(always)]
    pub fn contact(&self, play: &PlayGeometry<T>, place: usize) -> ContactMotion<T> {
        match &play.shape {
            PlayShape::Pin { .. } => pin::contact(self, play),
            PlayShape::Slider(block) => corner::contact(self, play, block, place),
            PlayShape::Slot(shape) => slot::contact(self, play, shape),
        }
    }

    /// δ at `place`, m, alone.
    #[inline(always)]
    pub fn penetration_at_m(&self, play: &PlayGeometry<T>, place: usize) -> T {
        match &play.shape {
            PlayShape::Pin { .. } => self.penetration_m(play.clearance_m),
            PlayShape::Slider(block) => corner::penetration_m(self, play, block, place),
            PlayShape::Slot(shape) => slot::penetration_m(self, play, shape),
        }
    }

    /// The elastic energy at `place` where the penetration is `penetration_m`, J.
    #[inline(always)]
    pub fn stored_energy_j(&self, play: &PlayGeometry<T>, penetration_m: T) -> T {
        let stored_j = play.normal.stored_energy_j(penetration_m);
        match &play.shape {
            PlayShape::Slot(shape) => stored_j * slot::stiffening(self, shape).share,
            PlayShape::Pin { .. } | PlayShape::Slider(_) => stored_j,
        }
    }

    /// The force at `place` with the penetration and the bristles read off the motion. In flight (`state.contact` zero)
    /// everything is zero but the film of oil, where there is one.
    #[inline(always)]
    pub fn force(&self, play: &PlayGeometry<T>, place: usize, state: &PlayState<T>) -> ContactForce<T> {
        self.force_with_unknowns(play, place, state, &ContactUnknowns::none())
    }

    /// The force at `place` with the root of the penetration and the deflection of the bristles as unknowns, where they are.
    ///
    /// Both forces act at one common point, so that energy and angular momentum are exact.
    #[inline(always)]
    pub fn force_with_unknowns(
        &self,
        play: &PlayGeometry<T>,
        place: usize,
        state: &PlayState<T>,
        unknowns: &ContactUnknowns<T>,
    ) -> ContactForce<T> {
        let contact = self.contact(play, place);
        let tangent = contact.normal.turned(); // eq. (3)
        let penetration_m = contact.penetration_m * state.contact; // eq. (4)
        let rate_m_s = contact.penetration_rate_m_s; // eq. (6)
        let mut force = match &unknowns.root {
            None => play.normal.force(penetration_m, rate_m_s, state), // eq. (8)
            Some(unknown) => {
                let depth_root = penetration_m.max(T::zero()).sqrt();
                let is_unknown = T::from_f64(0.5).less_than(unknown.is_unknown);
                play.normal.force_at_root(T::select(is_unknown, unknown.root, depth_root), rate_m_s, state)
            }
        };
        let mut push_n = Vec2::zero();
        let mut stiffness_share = T::one();
        if let PlayShape::Slot(shape) = &play.shape {
            let stiffening = slot::stiffening(self, shape);
            stiffness_share = stiffening.share;
            force.total_n *= stiffness_share;
            force.elastic_n *= stiffness_share;
            push_n = tangent * (stiffening.pull_1_m * play.normal.stored_energy_j(penetration_m));
        }
        let contact_loss_w = (force.total_n - force.elastic_n) * rate_m_s;
        let mut result = ContactForce {
            on_journal_n: contact.normal * -force.total_n,
            moment_on_journal_n_m: T::zero(),
            moment_on_bearing_n_m: T::zero(),
            contact_loss_w,
            friction_loss_w: T::zero(),
            normal_n: force.total_n,
            penetration_rate_m_s: rate_m_s,
            bristle_rate_m_s: T::zero(),
            sliding_m_s: T::zero(),
            stiffness_share,
            along_m: T::zero(),
        };
        if let PlayShape::Slot(_) = play.shape {
            result.on_journal_n += push_n;
            result.moment_on_bearing_n_m = -contact.reaches_m[0].cross(result.on_journal_n);
        }
        if play.friction.acts() {
            let Sliding { sliding_m_s, material_m_s, arms_m } = match &play.shape {
                PlayShape::Pin { bearing_radius_m } => {
                    pin::sliding(self, play, *bearing_radius_m, tangent, penetration_m)
                }
                PlayShape::Slider(block) => corner::sliding(self, block, place, tangent),
                PlayShape::Slot(shape) => slot::sliding(self, play, shape, contact.normal, penetration_m),
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
            result.moment_on_journal_n_m = arms_m[1] * friction_n;
            match play.shape {
                PlayShape::Slot(_) => result.moment_on_bearing_n_m -= arms_m[0] * friction_n,
                _ => result.moment_on_bearing_n_m = -(arms_m[0] * friction_n),
            }
            result.friction_loss_w = -(friction_n * material_m_s);
        }
        if let Some(film) = &play.film {
            film::add(self, film, play.clearance_m, &mut result);
        }
        if let PlayShape::Slider(_) = play.shape {
            result.along_m = self.directions[0].dot(contact.reaches_m[0]);
            // Both forces act at the corner.
            result.moment_on_journal_n_m = contact.reaches_m[1].cross(result.on_journal_n);
            result.moment_on_bearing_n_m = -contact.reaches_m[0].cross(result.on_journal_n);
        }
        result
    }

    /// The gap function at `place` for the acceleration ë of P_j from P_i, m/s², in the ground's frame, and the rates of both
    /// spins, rad/s².
    #[inline(always)]
    pub fn gap(
        &self,
        play: &PlayGeometry<T>,
        place: usize,
        acceleration_m_s2: Vec2<T>,
        spin_rates_rad_s2: [T; 2],
    ) -> GapMotion<T> {
        match &play.shape {
            PlayShape::Pin { .. } => pin::gap(self, play, acceleration_m_s2),
            PlayShape::Slider(block) => corner::gap(self, play, block, place, acceleration_m_s2, spin_rates_rad_s2),
            PlayShape::Slot(shape) => slot::gap(self, play, shape, acceleration_m_s2, spin_rates_rad_s2[0]),
        }
    }
}
