//! Forces where the two bodies of a joint or coupling with play touch ([`force_between`]), and what the parts of each shape answer to
//! find them ([`Parts`], in a file a shape).

use super::{film, foundation_contact};
use crate::contact::{NormalContact, NormalForce, NormalLaw, PlayState};
use crate::dynamics::play::contact_motion::{
    ContactForce, ContactMotion, ContactUnknowns, DepthRoot, GapMotion, Sliding,
};
use crate::dynamics::play::motion::PlayMotion;
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
    pub fn stored_energy_j(&self, play: &PlayGeometry<T>, place: usize, penetration_m: T) -> T {
        if let Some(foundation) = &play.foundation {
            return foundation_contact::stored_energy_j(self, foundation, penetration_m);
        }
        let stored_j = play.normal.stored_energy_j(penetration_m);
        let at = Touch { motion: self, play, place };
        ask_shape!(&play.shape, parts => parts.stored_energy_j(at, stored_j))
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
    #[inline(never)]
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
#[inline(never)]
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
    let mut force = force_of_law(&play.normal, penetration_m, rate_m_s, state, unknowns.root); // eq. (8)
    let Pressed { share, normal_n, tangent, push_n } = parts.pressed(at, &contact, penetration_m, &mut force); // eq. (3)
    let mut on_journal_n = contact.normal * -force.total_n;
    if let Some(push_n) = push_n {
        on_journal_n += push_n;
    }
    let of_normal_n_m = parts.moment_on_bearing_n_m(&contact, on_journal_n);
    let mut result = ContactForce {
        on_journal_n,
        moment_on_journal_n_m: T::zero(),
        moment_on_bearing_n_m: of_normal_n_m.unwrap_or(T::zero()),
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
        let sliding = parts.sliding(at, contact.normal, tangent, penetration_m);
        result.sliding_m_s = sliding.sliding_m_s;
        if play.friction.acts() {
            add_friction(play, &sliding, tangent, unknowns.bristle_m, of_normal_n_m, &mut result);
        }
    }
    if let Some(film) = &play.film {
        film::add(at.motion, film, play.clearance_m, &mut result);
    }
    parts.finish(at, &contact, &mut result);
    result
}

/// The force of the law, at the root of the penetration where that is an unknown.
#[inline(always)]
fn force_of_law<T: Real>(
    normal: &NormalLaw<T>,
    penetration_m: T,
    rate_m_s: T,
    state: &PlayState<T>,
    root: Option<DepthRoot<T>>,
) -> NormalForce<T> {
    let Some(DepthRoot { is_unknown, root, may_be_read }) = root else {
        return normal.force(penetration_m, rate_m_s, state);
    };
    if !may_be_read {
        return normal.force_at_root(root, rate_m_s, state);
    }
    let depth_root = penetration_m.max(T::zero()).sqrt();
    let is_unknown = T::from_f64(0.5).less_than(is_unknown);
    normal.force_at_root(T::select(is_unknown, root, depth_root), rate_m_s, state)
}

/// Adds friction with its moments to the force of a contact whose normal force has the moment `of_normal_n_m` about the first point, where
/// it does not act there.
#[inline(always)]
fn add_friction<T: Real>(
    play: &PlayGeometry<T>,
    sliding: &Sliding<T>,
    tangent: Vec2<T>,
    bristle_m: Option<T>,
    of_normal_n_m: Option<T>,
    to: &mut ContactForce<T>,
) {
    let friction_n = match bristle_m {
        None => play.friction.force_n(sliding.sliding_m_s, to.normal_n),
        Some(bristle_m) => {
            let friction = play.friction.force_with_bristle(sliding.sliding_m_s, to.normal_n, bristle_m);
            to.bristle_rate_m_s = friction.rate_m_s;
            friction.force_n
        }
    };
    to.on_journal_n += tangent * friction_n;
    to.moment_on_journal_n_m = sliding.arms_m[1] * friction_n;
    let of_friction_n_m = sliding.arms_m[0] * friction_n;
    to.moment_on_bearing_n_m = of_normal_n_m.map_or(-of_friction_n_m, |of_normal_n_m| of_normal_n_m - of_friction_n_m);
    to.friction_loss_w = -(friction_n * sliding.material_m_s);
}

/// A place of a joint with play at the last state that was set.
#[derive(Clone, Copy)]
pub(in crate::dynamics) struct Touch<'t, T: Real> {
    /// How the parts move against each other.
    pub motion: &'t PlayMotion<T>,
    /// The numbers of the joint.
    pub play: &'t PlayGeometry<T>,
    /// Which of its places.
    pub place: usize,
}

/// The force of the contact's law between these parts.
pub(in crate::dynamics) struct Pressed<T> {
    /// Normal force over that of the law.
    pub share: T,
    /// Normal force, N.
    pub normal_n: T,
    /// Direction in which they slide, a unit vector.
    pub tangent: Vec2<T>,
    /// Additional push along the wall, N; `None` if there is none.
    pub push_n: Option<Vec2<T>>,
}

/// Parts that touch. The plain answers are those of a pin in a hole.
pub(in crate::dynamics) trait Parts<T: Real> {
    /// Normal, penetration and its rate.
    fn contact(&self, at: Touch<'_, T>) -> ContactMotion<T>;

    /// δ, m, alone.
    #[inline(always)]
    fn penetration_m(&self, at: Touch<'_, T>) -> T {
        self.contact(at).penetration_m
    }

    /// The elastic energy, J, where the law would store `of_law_j`.
    #[inline(always)]
    fn stored_energy_j(&self, at: Touch<'_, T>, of_law_j: T) -> T {
        let _ = at;
        of_law_j
    }

    /// What the force of the law is between them; `force` is changed where their stiffness is not that of the law.
    #[inline(always)]
    fn pressed(
        &self,
        at: Touch<'_, T>,
        contact: &ContactMotion<T>,
        penetration_m: T,
        force: &mut NormalForce<T>,
    ) -> Pressed<T> {
        let _ = (at, penetration_m);
        Pressed { share: T::one(), normal_n: force.total_n, tangent: contact.normal.turned(), push_n: None }
    }

    /// Moment of the normal force about the first body's point, N m, where it does not act there.
    #[inline(always)]
    fn moment_on_bearing_n_m(&self, contact: &ContactMotion<T>, on_journal_n: Vec2<T>) -> Option<T> {
        let _ = (contact, on_journal_n);
        None
    }

    /// How the surfaces slide on each other.
    fn sliding(&self, at: Touch<'_, T>, normal: Vec2<T>, tangent: Vec2<T>, penetration_m: T) -> Sliding<T>;

    /// What is left to say of the whole force.
    #[inline(always)]
    fn finish(&self, at: Touch<'_, T>, contact: &ContactMotion<T>, force: &mut ContactForce<T>) {
        let _ = (at, contact, force);
    }

    /// The gap function for the acceleration of the second point from the first, m/s², in the ground's frame (of a coupling ẍ and zero),
    /// and the rates of both spins, rad/s².
    fn gap(&self, at: Touch<'_, T>, acceleration_m_s2: Vec2<T>, spin_rates_rad_s2: [T; 2]) -> GapMotion<T>;
}
