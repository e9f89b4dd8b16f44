//! How the parts of a joint or coupling with play touch: what each shape answers, in a file of its own.

use super::contact_motion::{ContactForce, ContactMotion, GapMotion, Sliding};
use super::play::PlayMotion;
use crate::contact::NormalForce;
use crate::mechanism::PlayGeometry;
use loosepin_math::{Real, Vec2};

/// A place of a joint with play at the last state that was set.
#[derive(Clone, Copy)]
pub(super) struct Touch<'t, T: Real> {
    /// How the parts move against each other.
    pub motion: &'t PlayMotion<T>,
    /// The numbers of the joint.
    pub play: &'t PlayGeometry<T>,
    /// Which of its places.
    pub place: usize,
}

/// What the force of the contact's law is between these parts.
pub(super) struct Pressed<T> {
    /// Normal force over that of the law.
    pub share: T,
    /// Normal force, N.
    pub normal_n: T,
    /// Direction in which they slide, a unit vector.
    pub tangent: Vec2<T>,
    /// What pushes along the wall beside it, N; none where nothing does.
    pub push_n: Option<Vec2<T>>,
}

/// Parts that touch. The plain answers are those of a pin in a hole.
pub(super) trait Parts<T: Real> {
    /// Normal, penetration and its rate.
    fn contact(&self, at: Touch<'_, T>) -> ContactMotion<T>;

    /// δ, m, alone.
    fn penetration_m(&self, at: Touch<'_, T>) -> T;

    /// The elastic energy, J, where the law would store `of_law_j`.
    #[inline(always)]
    fn stored_energy_j(&self, motion: &PlayMotion<T>, of_law_j: T) -> T {
        let _ = motion;
        of_law_j
    }

    /// What the force of the law is between them; `force` is changed where they are stiffer than it.
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
