//! Forces where the two bodies of a joint with play touch.

use super::contact_motion::{ContactForce, ContactMotion, ContactUnknowns, GapMotion, Sliding};
use super::play::PlayMotion;
use super::{corner, film, flanks, foundation_contact, pin, slot};
use crate::contact::{NormalContact, PlayState};
use crate::mechanism::{PlayGeometry, PlayShape};
use loosepin_math::{Real, Vec2};

impl<T: Real> PlayMotion<T> {
    /// How the two bodies come near each other at `place`.
    #[inline(always)]
    pub fn contact(&self, play: &PlayGeometry<T>, place: usize) -> ContactMotion<T> {
        if let Some(foundation) = &play.foundation {
            return foundation_contact::contact(self, foundation);
        }
        match &play.shape {
            PlayShape::Pin { .. } => pin::contact(self, play),
            PlayShape::Slider(block) => corner::contact(self, play, block, place),
            PlayShape::Slot(shape) => slot::contact(self, play, shape),
            PlayShape::Flanks(_) => flanks::contact(self, play, place),
        }
    }

    /// δ at `place`, m, alone.
    #[inline(always)]
    pub fn penetration_at_m(&self, play: &PlayGeometry<T>, place: usize) -> T {
        if let Some(foundation) = &play.foundation {
            return foundation_contact::contact(self, foundation).penetration_m;
        }
        match &play.shape {
            PlayShape::Pin { .. } => self.penetration_m(play.clearance_m),
            PlayShape::Slider(block) => corner::penetration_m(self, play, block, place),
            PlayShape::Slot(shape) => slot::penetration_m(self, play, shape),
            PlayShape::Flanks(_) => flanks::contact(self, play, place).penetration_m,
        }
    }

    /// The elastic energy at `place` where the penetration is `penetration_m`, J.
    #[inline(always)]
    pub fn stored_energy_j(&self, play: &PlayGeometry<T>, penetration_m: T) -> T {
        if let Some(foundation) = &play.foundation {
            return foundation_contact::stored_energy_j(self, foundation, penetration_m);
        }
        let stored_j = play.normal.stored_energy_j(penetration_m);
        match &play.shape {
            PlayShape::Slot(shape) => stored_j * slot::stiffening(self, shape).share,
            PlayShape::Pin { .. } | PlayShape::Slider(_) | PlayShape::Flanks(_) => stored_j,
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
        if let Some(foundation) = &play.foundation {
            return foundation_contact::force(self, foundation, state);
        }
        let contact = self.contact(play, place);
        let mut tangent = contact.normal.turned(); // eq. (3)
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
        let mut force_share = T::one();
        if let PlayShape::Slider(block) = &play.shape
            && block.ends_m.is_some()
        {
            // Beyond an end of the guide the normal is not a unit vector.
            let stretch = corner::stretch(self, block, place);
            force_share = stretch;
            tangent = tangent * (T::one() / stretch);
        }
        let mut push_n = Vec2::zero();
        let mut normal_n = force.total_n * force_share;
        if let PlayShape::Slot(shape) = &play.shape {
            let stiffening = slot::stiffening(self, shape);
            force_share = stiffening.share;
            force.total_n *= force_share;
            force.elastic_n *= force_share;
            normal_n = force.total_n;
            push_n = tangent * (stiffening.pull_1_m * play.normal.stored_energy_j(penetration_m));
        }
        let contact_loss_w = (force.total_n - force.elastic_n) * rate_m_s;
        let mut result = ContactForce {
            on_journal_n: contact.normal * -force.total_n,
            moment_on_journal_n_m: T::zero(),
            moment_on_bearing_n_m: T::zero(),
            contact_loss_w,
            friction_loss_w: T::zero(),
            film_loss_w: T::zero(),
            normal_n,
            penetration_rate_m_s: rate_m_s,
            bristle_rate_m_s: T::zero(),
            sliding_m_s: T::zero(),
            spread_path_w: None,
            force_share,
            along_m: T::zero(),
        };
        if let PlayShape::Slot(_) = play.shape {
            result.on_journal_n += push_n;
            result.moment_on_bearing_n_m = -contact.reaches_m[0].cross(result.on_journal_n);
        }
        if play.friction.acts() || play.wears {
            let Sliding { sliding_m_s, material_m_s, arms_m } = match &play.shape {
                PlayShape::Pin { bearing_radius_m } => {
                    pin::sliding(self, play, *bearing_radius_m, tangent, penetration_m)
                }
                PlayShape::Slider(block) => corner::sliding(self, block, place, tangent),
                PlayShape::Slot(shape) => slot::sliding(self, play, shape, contact.normal, penetration_m),
                // Its contact has no friction.
                PlayShape::Flanks(_) => {
                    Sliding { sliding_m_s: T::zero(), material_m_s: T::zero(), arms_m: [T::zero(); 2] }
                }
            };
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
                match play.shape {
                    PlayShape::Slot(_) => result.moment_on_bearing_n_m -= arms_m[0] * friction_n,
                    _ => result.moment_on_bearing_n_m = -(arms_m[0] * friction_n),
                }
                result.friction_loss_w = -(friction_n * material_m_s);
            }
        }
        if let Some(film) = &play.film {
            film::add(self, film, play.clearance_m, &mut result);
        }
        if let PlayShape::Slider(block) = &play.shape {
            result.along_m = match block.ends_m {
                // The corner's own, wherever they touch.
                Some(_) => corner::along_m(self, block, place),
                None => self.directions[0].dot(contact.reaches_m[0]),
            };
            // Both forces act at the corner, or at the end of the guide.
            result.moment_on_journal_n_m = contact.reaches_m[1].cross(result.on_journal_n);
            result.moment_on_bearing_n_m = -contact.reaches_m[0].cross(result.on_journal_n);
        }
        result
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
        match &play.shape {
            PlayShape::Pin { .. } => pin::gap(self, play, acceleration_m_s2),
            PlayShape::Slider(block) => corner::gap(self, play, block, place, acceleration_m_s2, spin_rates_rad_s2),
            PlayShape::Flanks(_) => flanks::gap(self, play, place, acceleration_m_s2.x),
            PlayShape::Slot(shape) => slot::gap(self, play, shape, acceleration_m_s2, spin_rates_rad_s2[0]),
        }
    }
}
