//! A corner of a slider on a face of its guide: the four contacts of a prismatic joint with play (`docs/notation.md`).
//!
//! The slider is a block of half-length a and half-height b; y is the ordinate of its centre in the guide, whose line is the
//! axis of abscissas, and θ its angle. With the clearance c on each side the penetrations are, for both signs of a,
//! δ = y ± a sin θ + b cos θ - (b + c) at the upper face and δ = -y ∓ a sin θ + b cos θ - (b + c) at the lower one.
//!
//! **Beyond an end.** Where the faces of the guide end and the corner is past the end s, the edge there touches the face of the
//! block instead. δ is then how far that face stands beyond the face of the guide at the abscissa s:
//! `δ = ±(y + (s - x) tan θ) + b/cos θ - (b + c)`, which is the corner's δ where its abscissa is s. The normal force is N times
//! the gradient of δ, so that the elastic force has a potential also over the change: along m = n ∓ d tan θ, the normal of the
//! block's face over cos θ, through the point of that face at s. The force itself is N |m| = N/cos θ, and friction goes by it.
//! Both bodies get their forces at that point.
//!
//! The functions stand out of line: not every mechanism has them, and the compiler takes many times as long for an evaluation that
//! holds them all.

use crate::contact::NormalForce;
use crate::dynamics::play::contact::{Parts, Pressed, Touch};
use crate::dynamics::play::contact_motion::{ContactForce, ContactMotion, GapMotion, Sliding};
use crate::dynamics::play::motion::PlayMotion;
use crate::mechanism::{SliderBlock, is_front_corner, is_upper_corner};
use loosepin_math::{Real, Vec2};

impl<T: Real> Parts<T> for SliderBlock<T> {
    /// Beyond an end the normal is m.
    #[inline(never)]
    fn contact(&self, Touch { motion, play, place }: Touch<'_, T>) -> ContactMotion<T> {
        let Corner { arm_m, reach_m, normal, push, velocity_m_s, .. } = corner(motion, self, place);
        ContactMotion {
            normal: push,
            penetration_m: normal.dot(reach_m) - (self.half_height_m + play.clearance_m),
            // Neither the guide's material at a corner nor the block's at an edge moves along m against its own face.
            penetration_rate_m_s: push.dot(velocity_m_s),
            reaches_m: [reach_m, arm_m],
        }
    }

    #[inline(never)]
    fn penetration_m(&self, Touch { motion, play, place }: Touch<'_, T>) -> T {
        let corner = corner(motion, self, place);
        corner.normal.dot(corner.reach_m) - (self.half_height_m + play.clearance_m)
    }

    /// Beyond an end of the guide the normal is not a unit vector.
    #[inline(always)]
    fn pressed(
        &self,
        at: Touch<'_, T>,
        contact: &ContactMotion<T>,
        _penetration_m: T,
        force: &mut NormalForce<T>,
    ) -> Pressed<T> {
        let mut tangent = contact.normal.turned();
        let mut share = T::one();
        if self.ends_m.is_some() {
            share = stretch(at.motion, self, at.place);
            tangent = tangent * (T::one() / share);
        }
        Pressed { share, normal_n: force.total_n * share, tangent, push_n: None }
    }

    /// Sliding of the slider's material on the guide's where they touch. Both forces act there, so friction has no arms of its own.
    #[inline(never)]
    fn sliding(&self, at: Touch<'_, T>, _normal: Vec2<T>, tangent: Vec2<T>, _penetration_m: T) -> Sliding<T> {
        let material_m_s = tangent.dot(corner(at.motion, self, at.place).velocity_m_s);
        Sliding { sliding_m_s: material_m_s, material_m_s, arms_m: [T::zero(); 2] }
    }

    #[inline(always)]
    fn finish(&self, at: Touch<'_, T>, contact: &ContactMotion<T>, force: &mut ContactForce<T>) {
        force.along_m = match self.ends_m {
            // The corner's own, wherever they touch.
            Some(_) => along_m(at.motion, self, at.place),
            None => at.motion.directions[0].dot(contact.reaches_m[0]),
        };
        // Both forces act at the corner, or at the end of the guide.
        force.moment_on_journal_n_m = contact.reaches_m[1].cross(force.on_journal_n);
        force.moment_on_bearing_n_m = -contact.reaches_m[0].cross(force.on_journal_n);
    }

    /// δ and its derivatives. With w the velocity of the slider's material at the corner on the guide's:
    /// δ̇ = n·w and δ̈ = n·ẇ + ω_i t·w, since n turns with the guide.
    ///
    /// Beyond an end δ̇ = m·w and δ̈ = m·ẇ + ω_j m⊥·w + (ω_j - ω_i) tan θ δ̇, since m turns with the block and grows as 1/cos θ. The
    /// point, at R from the guide's, stays at the end's abscissa: Ṙ = ω_i R⊥ + δ̇ n, and so moves on the block, A from its centre, with
    /// Ȧ = Ṙ - ė.
    #[inline(never)]
    fn gap(
        &self,
        Touch { motion, play, place }: Touch<'_, T>,
        acceleration_m_s2: Vec2<T>,
        [spin_rate_i, spin_rate_j]: [T; 2],
    ) -> GapMotion<T> {
        let Corner { arm_m, reach_m, normal, push, velocity_m_s, ends } = corner(motion, self, place);
        let [spin_i, spin_j] = motion.spins_rad_s;
        let rate_m_s = push.dot(velocity_m_s);
        let mut arm_rate_m_s = arm_m.turned() * spin_j;
        let mut reach_rate_m_s = motion.eccentricity_rate_m_s + arm_rate_m_s;
        let mut turning = spin_i * normal.turned().dot(velocity_m_s);
        if let Some(Ends { is_past, slope }) = ends {
            let held_m_s = (reach_m.turned() * spin_i).plus(normal, rate_m_s);
            let chosen = |past: Vec2<T>, before: Vec2<T>| {
                Vec2::new(T::select(is_past, past.x, before.x), T::select(is_past, past.y, before.y))
            };
            arm_rate_m_s = chosen(held_m_s - motion.eccentricity_rate_m_s, arm_rate_m_s);
            reach_rate_m_s = chosen(held_m_s, reach_rate_m_s);
            let growing = (spin_j - spin_i) * slope * rate_m_s;
            turning = T::select(is_past, spin_j * push.turned().dot(velocity_m_s) + growing, turning);
        }
        let change_m_s2 = acceleration_m_s2
            .plus(arm_m.turned(), spin_rate_j)
            .plus(arm_rate_m_s.turned(), spin_j)
            .plus(reach_m.turned(), -spin_rate_i)
            .plus(reach_rate_m_s.turned(), -spin_i);
        let second = turning + push.dot(change_m_s2);
        let penetration_m = normal.dot(reach_m) - (self.half_height_m + play.clearance_m);
        GapMotion::without_slot([penetration_m, rate_m_s, second], second)
    }
}

/// A contact of the slider at the last state that was set.
struct Corner<T: Real> {
    /// From the slider's centre to where they touch: the corner, or the point of the block's face at the end of the guide, m.
    arm_m: Vec2<T>,
    /// From the guide's point to there, m.
    reach_m: Vec2<T>,
    /// n: out of the guide through the corner's face.
    normal: Vec2<T>,
    /// m, along which the normal force acts: n, or beyond an end the normal of the block's face over cos θ.
    push: Vec2<T>,
    /// Velocity of the slider's material on the guide's where they touch, m/s.
    velocity_m_s: Vec2<T>,
    /// Ends of the guide, if it has any.
    ends: Option<Ends<T>>,
}

/// A corner against the ends of the guide.
struct Ends<T: Real> {
    /// Whether it is past one.
    is_past: T::Mask,
    /// tan θ where it is; zero where it is not.
    slope: T,
}

/// The corner at `place`: rear and front one at the upper face (0, 1), rear and front one at the lower face (2, 3).
#[inline(always)]
fn corner<T: Real>(motion: &PlayMotion<T>, block: &SliderBlock<T>, place: usize) -> Corner<T> {
    let is_upper = is_upper_corner(place);
    let [line, axis] = motion.directions;
    let mut arm_m = arm_m(motion, block, place);
    let mut reach_m = motion.eccentricity_m + arm_m;
    let normal = signed(line.turned(), is_upper);
    let mut push = normal;
    let mut ends = None;
    if let Some([first_m, last_m]) = block.ends_m {
        let along_m = line.dot(reach_m);
        let past_m = along_m - along_m.max(first_m).min(last_m);
        let is_past = T::zero().less_than(past_m.abs());
        // Back along the face by as much as the corner is past the end; not at all before it.
        let cosine = line.dot(axis);
        let back = axis * (past_m / cosine);
        arm_m -= back;
        reach_m -= back;
        let slope = T::select(is_past, line.cross(axis) / cosine, T::zero());
        push = normal.plus(line, if is_upper { -slope } else { slope });
        ends = Some(Ends { is_past, slope });
    }
    let [spin_i, spin_j] = motion.spins_rad_s;
    let velocity_m_s = motion.eccentricity_rate_m_s.plus(arm_m.turned(), spin_j).plus(reach_m.turned(), -spin_i);
    Corner { arm_m, reach_m, normal, push, velocity_m_s, ends }
}

#[inline(always)]
fn signed<T: Real>(vector: Vec2<T>, is_positive: bool) -> Vec2<T> {
    if is_positive { vector } else { -vector }
}

/// From the slider's centre to its corner, m.
#[inline(always)]
fn arm_m<T: Real>(motion: &PlayMotion<T>, block: &SliderBlock<T>, place: usize) -> Vec2<T> {
    let axis = motion.directions[1];
    let (along, across) = (signed(axis, is_front_corner(place)), signed(axis.turned(), is_upper_corner(place)));
    (along * block.half_length_m).plus(across, block.half_height_m)
}

/// Abscissa of the corner itself along the guide's line, m.
#[inline(never)]
fn along_m<T: Real>(motion: &PlayMotion<T>, block: &SliderBlock<T>, place: usize) -> T {
    motion.directions[0].dot(motion.eccentricity_m + arm_m(motion, block, place))
}

/// 1/cos θ beyond an end, one before it: the force over N.
#[inline(never)]
fn stretch<T: Real>(motion: &PlayMotion<T>, block: &SliderBlock<T>, place: usize) -> T {
    let slope = corner(motion, block, place).ends.map_or(T::zero(), |ends| ends.slope);
    (T::one() + slope.squared()).sqrt()
}
