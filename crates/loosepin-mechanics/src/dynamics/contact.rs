//! Forces where the two bodies of a joint with play touch.

use super::contact_motion::{ContactForce, ContactMotion, ContactUnknowns, GapMotion, Sliding};
use super::parts::{Parts, Pressed, Touch};
use super::play::PlayMotion;
use super::{film, foundation_contact};
use crate::contact::{NormalContact, PlayState};
use crate::mechanism::{PlayGeometry, ask_shape};
use loosepin_math::{Real, Vec2};

impl<T: Real> PlayMotion<T> {
    /// How the two bodies come near each other at `place`.
    #[inline(always)]
    pub fn contact(&self, play: &PlayGeometry<T>, place: usize) -> ContactMotion<T> {
        if let Some(foundation) = &play.foundation {
            return foundation_contact::contact(self, foundation);
        }
        let at = Touch { motion: self, play, place };
        ask_shape!(&play.shape, parts => parts.contact(at))
    }

    /// δ at `place`, m, alone.
    #[inline(always)]
    pub fn penetration_at_m(&self, play: &PlayGeometry<T>, place: usize) -> T {
        if let Some(foundation) = &play.foundation {
            return foundation_contact::contact(self, foundation).penetration_m;
        }
        let at = Touch { motion: self, play, place };
        ask_shape!(&play.shape, parts => parts.penetration_m(at))
    }

    /// The elastic energy at `place` where the penetration is `penetration_m`, J.
    #[inline(always)]
    pub fn stored_energy_j(&self, play: &PlayGeometry<T>, penetration_m: T) -> T {
        if let Some(foundation) = &play.foundation {
            return foundation_contact::stored_energy_j(self, foundation, penetration_m);
        }
        let stored_j = play.normal.stored_energy_j(penetration_m);
        ask_shape!(&play.shape, parts => parts.stored_energy_j(self, stored_j))
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
        if let Some(foundation) = &play.foundation {
            return foundation_contact::force(self, foundation, state);
        }
        let at = Touch { motion: self, play, place };
        ask_shape!(&play.shape, parts => force_between(parts, at, state, unknowns))
    }

    /// The gap function at `place` for the acceleration ë of P_j from P_i, m/s², in the ground's frame (of a coupling ẍ and zero),
    /// and the rates of both spins, rad/s².
    #[inline(always)]
    pub fn gap(
        &self,
        play: &PlayGeometry<T>,
        place: usize,
        acceleration_m_s2: Vec2<T>,
        spin_rates_rad_s2: [T; 2],
    ) -> GapMotion<T> {
        if let Some(foundation) = &play.foundation {
            return foundation_contact::gap(self, foundation, acceleration_m_s2, spin_rates_rad_s2);
        }
        let at = Touch { motion: self, play, place };
        ask_shape!(&play.shape, parts => parts.gap(at, acceleration_m_s2, spin_rates_rad_s2))
    }
}

/// The force between these parts.
#[inline(always)]
fn force_between<T: Real>(
    parts: &impl Parts<T>,
    at: Touch<'_, T>,
    state: &PlayState<T>,
    unknowns: &ContactUnknowns<T>,
) -> ContactForce<T> {
    let play = at.play;
    let contact = parts.contact(at);
    let penetration_m = contact.penetration_m * state.contact; // eq. (4)
    let rate_m_s = contact.penetration_rate_m_s; // eq. (6)
    let mut force = match &unknowns.root {
        None => play.normal.force(penetration_m, rate_m_s, state), // eq. (8)
        Some(unknown) if !unknown.may_be_read => play.normal.force_at_root(unknown.root, rate_m_s, state),
        Some(unknown) => {
            let depth_root = penetration_m.max(T::zero()).sqrt();
            let is_unknown = T::from_f64(0.5).less_than(unknown.is_unknown);
            play.normal.force_at_root(T::select(is_unknown, unknown.root, depth_root), rate_m_s, state)
        }
    };
    let Pressed { share, normal_n, tangent, push_n } = parts.pressed(at, &contact, penetration_m, &mut force); // eq. (3)
    let mut on_journal_n = contact.normal * -force.total_n;
    if let Some(push_n) = push_n {
        on_journal_n += push_n;
    }
    let moment_on_bearing_n_m = parts.moment_on_bearing_n_m(&contact, on_journal_n);
    let mut result = ContactForce {
        on_journal_n,
        moment_on_journal_n_m: T::zero(),
        moment_on_bearing_n_m: moment_on_bearing_n_m.unwrap_or(T::zero()),
        contact_loss_w: (force.total_n - force.elastic_n) * rate_m_s,
        friction_loss_w: T::zero(),
        film_loss_w: T::zero(),
        normal_n,
        penetration_rate_m_s: rate_m_s,
        bristle_rate_m_s: T::zero(),
        sliding_m_s: T::zero(),
        spread_path_w: None,
        force_share: share,
        along_m: T::zero(),
    };
    if play.friction.acts() || play.wears {
        let Sliding { sliding_m_s, material_m_s, arms_m } = parts.sliding(at, contact.normal, tangent, penetration_m);
        result.sliding_m_s = sliding_m_s;
        if play.friction.acts() {
            let friction_n = match unknowns.bristle_m {
                None => play.friction.force_n(sliding_m_s, normal_n),
                Some(bristle_m) => {
                    let friction = play.friction.force_with_bristle(sliding_m_s, normal_n, bristle_m);
                    result.bristle_rate_m_s = friction.rate_m_s;
                    friction.force_n
                }
            };
            result.on_journal_n += tangent * friction_n;
            result.moment_on_journal_n_m = arms_m[1] * friction_n;
            let of_friction_n_m = arms_m[0] * friction_n;
            result.moment_on_bearing_n_m = match moment_on_bearing_n_m {
                Some(of_normal_n_m) => of_normal_n_m - of_friction_n_m,
                None => -of_friction_n_m,
            };
            result.friction_loss_w = -(friction_n * material_m_s);
        }
    }
    if let Some(film) = &play.film {
        film::add(at.motion, film, play.clearance_m, &mut result);
    }
    parts.finish(at, &contact, &mut result);
    result
}
