//! A pin in a straight slot with round ends: the one contact of such a joint with play (`docs/notation.md`).
//!
//! With e from the middle of the slot to the pin, ξ = e·d along the slot's line d and h the half-length between the centres
//! of the ends, the pin is off the line by `w = e - d clamp(ξ, -h, h)`. At the faces w stands across the line, in the ends it
//! goes out from their centre; δ = |w| - c and n = w/|w| in both, with no jump where they meet.
//!
//! **Stiffness.** K is that of a cylinder on a plane at the faces, K_f, and that of a pin in a hole in the ends, K_f (1 + κ).
//! Where faces and ends meet K grows with the angle φ of n from the face's normal, over the first 30°:
//! `K = K_f (1 + κ q² (3 - 2 q))`, q = min(4 sin² φ, 1). The elastic force is the gradient of the stored energy, so that a pin
//! that rolls from the face into the end neither gains nor loses energy: beside F_el along -n it has the small part
//! `-(∂K/∂φ)/K V/|w|` along the wall. This growth is our choice; eq. (9) says nothing between a plane and a hole.
//!
//! The functions stand out of line: not every mechanism has them, and the compiler takes many times as long for an evaluation that
//! holds them all.

use crate::contact::{NormalContact, NormalForce};
use crate::dynamics::play::contact::{Parts, Pressed, Touch};
use crate::dynamics::play::contact_motion::{ContactMotion, GapMotion, Sliding};
use crate::dynamics::play::motion::PlayMotion;
use crate::dynamics::play::pin_on_wall::sliding_on_wall;
use crate::mechanism::SlotShape;
use loosepin_math::{Real, Vec2};

impl<T: Real> Parts<T> for SlotShape<T> {
    /// The normal force acts at the pin's centre on both bodies.
    #[inline(never)]
    fn contact(&self, at: Touch<'_, T>) -> ContactMotion<T> {
        let PinInSlot { normal, velocity_m_s, .. } = place(at.motion, self);
        ContactMotion {
            normal,
            penetration_m: self.penetration_m(at),
            penetration_rate_m_s: normal.dot(velocity_m_s),
            reaches_m: [at.motion.eccentricity_m, Vec2::zero()],
        }
    }

    /// δ = |w| - c, m, computed so that it keeps its digits near zero.
    #[inline(never)]
    fn penetration_m(&self, Touch { motion, play, .. }: Touch<'_, T>) -> T {
        let PinInSlot { off_m, length_m, .. } = place(motion, self);
        (off_m.length_squared() - play.clearance_m.squared()) / (length_m + play.clearance_m)
    }

    #[inline(always)]
    fn stored_energy_j(&self, at: Touch<'_, T>, of_law_j: T) -> T {
        of_law_j * stiffening(at.motion, self).share
    }

    /// The ends are stiffer than the faces, and the wall pulls towards the softer one.
    #[inline(always)]
    fn pressed(
        &self,
        at: Touch<'_, T>,
        contact: &ContactMotion<T>,
        penetration_m: T,
        force: &mut NormalForce<T>,
    ) -> Pressed<T> {
        let tangent = contact.normal.turned();
        let Stiffening { share, pull_1_m } = stiffening(at.motion, self);
        force.scale(share);
        let push_n = tangent * (pull_1_m * at.play.normal.stored_energy_j(penetration_m));
        Pressed { share, normal_n: force.total_n, tangent, push_n: Some(push_n) }
    }

    #[inline(always)]
    fn moment_on_bearing_n_m(&self, contact: &ContactMotion<T>, on_journal_n: Vec2<T>) -> Option<T> {
        Some(-contact.reaches_m[0].cross(on_journal_n))
    }

    #[inline(always)]
    fn sliding(&self, at: Touch<'_, T>, normal: Vec2<T>, tangent: Vec2<T>, penetration_m: T) -> Sliding<T> {
        sliding_on_wall(at.motion, self.end_radius_m - at.play.clearance_m, [normal, tangent], penetration_m)
    }

    /// g = |w|² - c² and its derivatives; δ̈ from d²|w|²/dt² = 2(δ̇² + |w| δ̈). With v the pin's velocity seen from the slot and ω, α
    /// those of the slot's body, its acceleration seen from there is ë - α e⊥ + ω² e - 2 ω v⊥; g̈ jumps where faces and ends meet.
    #[inline(never)]
    fn gap(
        &self,
        Touch { motion, play, .. }: Touch<'_, T>,
        acceleration_m_s2: Vec2<T>,
        [spin_rate_rad_s2, _]: [T; 2],
    ) -> GapMotion<T> {
        let two = T::from_f64(2.0);
        let PinInSlot { off_m, length_m, normal, velocity_m_s, off_rate_m_s } = place(motion, self);
        let (e, line, spin) = (motion.eccentricity_m, motion.directions[0], motion.spins_rad_s[0]);
        let seen_m_s2 = acceleration_m_s2
            .plus(e.turned(), -spin_rate_rad_s2)
            .plus(e, spin.squared())
            .plus(velocity_m_s.turned(), -(two * spin));
        let along = off_rate_m_s.length_squared() + off_m.dot(seen_m_s2);
        let speed = normal.dot(velocity_m_s);
        GapMotion {
            gap: [off_m.length_squared() - play.clearance_m.squared(), two * off_m.dot(velocity_m_s), two * along],
            penetration_acceleration_m_s2: (along - speed * speed) / length_m,
            along: [line.dot(e), line.dot(velocity_m_s), line.dot(seen_m_s2)],
        }
    }
}

/// Position and motion of the pin in its slot.
struct PinInSlot<T> {
    /// w: from the nearest point of the slot's line between both ends to the pin, m.
    off_m: Vec2<T>,
    /// |w|, m.
    length_m: T,
    /// n = w/|w|; zero where w = 0.
    normal: Vec2<T>,
    /// Velocity of the pin's centre seen from the slot's body, m/s, in the ground's frame.
    velocity_m_s: Vec2<T>,
    /// The part of it that changes w: across the line at the faces, all of it in the ends.
    off_rate_m_s: Vec2<T>,
}

#[inline(always)]
fn place<T: Real>(motion: &PlayMotion<T>, slot: &SlotShape<T>) -> PinInSlot<T> {
    let e = motion.eccentricity_m;
    let line = motion.directions[0];
    let along_m = line.dot(e);
    let held_m = along_m.max(-slot.half_length_m).min(slot.half_length_m);
    let off_m = e.plus(line, -held_m);
    let length_m = off_m.length().max(T::from_f64(f64::MIN_POSITIVE));
    let velocity_m_s = motion.eccentricity_rate_m_s.plus(e.turned(), -motion.spins_rad_s[0]);
    let is_at_face = along_m.abs().less_than(slot.half_length_m);
    let held_m_s = T::select(is_at_face, line.dot(velocity_m_s), T::zero());
    PinInSlot {
        off_m,
        length_m,
        normal: off_m * (T::one() / length_m),
        velocity_m_s,
        off_rate_m_s: velocity_m_s.plus(line, -held_m_s),
    }
}

/// The stiffness between faces and ends.
#[derive(Debug, Clone, Copy)]
struct Stiffening<T> {
    /// K/K_f.
    share: T,
    /// Elastic force along t over the energy that the face's stiffness would store, 1/m.
    pull_1_m: T,
}

/// K/K_f, and what pulls towards the softer wall over the energy, (∂K/∂φ)/(K_f |w|): with n = (n_x, n_y) along and across the line,
/// ∂(q² (3 - 2 q))/∂φ = 48 q (1 - q) |n_x n_y|; φ grows against t where n_x n_y > 0, so that the pull goes along t there.
#[inline(never)]
fn stiffening<T: Real>(motion: &PlayMotion<T>, slot: &SlotShape<T>) -> Stiffening<T> {
    let PinInSlot { length_m, normal, .. } = place(motion, slot);
    let line = motion.directions[0];
    let (along, across) = (normal.dot(line), normal.dot(line.turned()));
    let q = (T::from_f64(4.0) * along * along).min(T::one());
    let share = (slot.end_stiffening * q * q).mul_add(T::from_f64(3.0) - (q + q), T::one());
    let slope = slot.end_stiffening * T::from_f64(48.0) * q * (T::one() - q);
    Stiffening { share, pull_1_m: slope * along * across / length_m }
}
