//! A corner of a slider on a face of its guide: the four contacts of a prismatic joint with play (`docs/notation.md`).
//!
//! The slider is a block of half-length a and half-height b; y is the ordinate of its centre in the guide, whose line is the
//! axis of abscissas, and θ its angle. With the clearance c on each side the penetrations are, for both signs of a,
//! δ = y ± a sin θ + b cos θ - (b + c) at the upper face and δ = -y ∓ a sin θ + b cos θ - (b + c) at the lower one. The faces
//! go on without ends here: where a guide has ends, a run in which a corner leaves them fails.
//!
//! The functions stand out of line: not every mechanism has them, and the compiler takes many times as long for an evaluation that
//! holds them all.

use super::contact_motion::{ContactMotion, GapMotion, Sliding};
use super::play::PlayMotion;
use crate::mechanism::{PlayGeometry, SliderBlock};
use loosepin_math::{Real, Vec2};

/// A corner of the slider at the last state that was set.
struct Corner<T> {
    /// From the slider's centre to the corner, m.
    arm_m: Vec2<T>,
    /// From the guide's point to the corner, m.
    reach_m: Vec2<T>,
    /// n: out of the guide through the corner's face.
    normal: Vec2<T>,
    /// Velocity of the slider's material at the corner on the guide's, m/s.
    velocity_m_s: Vec2<T>,
}

/// The corner at `place`: rear and front one at the upper face (0, 1), rear and front one at the lower face (2, 3).
#[inline(always)]
fn corner<T: Real>(motion: &PlayMotion<T>, block: &SliderBlock<T>, place: usize) -> Corner<T> {
    let (is_front, is_upper) = (place % 2 == 1, place < 2);
    let signed = |vector: Vec2<T>, is_positive: bool| if is_positive { vector } else { -vector };
    let [line, axis] = motion.directions;
    let along = signed(axis, is_front);
    let across = signed(axis.turned(), is_upper);
    let arm_m = (along * block.half_length_m).plus(across, block.half_height_m);
    let reach_m = motion.eccentricity_m + arm_m;
    let [spin_i, spin_j] = motion.spins_rad_s;
    let velocity_m_s = motion.eccentricity_rate_m_s.plus(arm_m.turned(), spin_j).plus(reach_m.turned(), -spin_i);
    Corner { arm_m, reach_m, normal: signed(line.turned(), is_upper), velocity_m_s }
}

/// δ at `place`, m.
#[inline(never)]
pub(super) fn penetration_m<T: Real>(
    motion: &PlayMotion<T>,
    play: &PlayGeometry<T>,
    block: &SliderBlock<T>,
    place: usize,
) -> T {
    let corner = corner(motion, block, place);
    corner.normal.dot(corner.reach_m) - (block.half_height_m + play.clearance_m)
}

/// Normal, penetration and its rate.
#[inline(never)]
pub(super) fn contact<T: Real>(
    motion: &PlayMotion<T>,
    play: &PlayGeometry<T>,
    block: &SliderBlock<T>,
    place: usize,
) -> ContactMotion<T> {
    let Corner { arm_m, reach_m, normal, velocity_m_s } = corner(motion, block, place);
    ContactMotion {
        normal,
        penetration_m: normal.dot(reach_m) - (block.half_height_m + play.clearance_m),
        // The guide's material at the corner does not move along n against the face.
        penetration_rate_m_s: normal.dot(velocity_m_s),
        reaches_m: [reach_m, arm_m],
    }
}

/// Sliding of the slider's material on the guide's at the corner. Both forces act there, so friction has no arms of its own.
#[inline(never)]
pub(super) fn sliding<T: Real>(
    motion: &PlayMotion<T>,
    block: &SliderBlock<T>,
    place: usize,
    tangent: Vec2<T>,
) -> Sliding<T> {
    let material_m_s = tangent.dot(corner(motion, block, place).velocity_m_s);
    Sliding { sliding_m_s: material_m_s, material_m_s, arms_m: [T::zero(); 2] }
}

/// δ and its derivatives. With w the velocity of the slider's material at the corner on the guide's:
/// δ̇ = n·w and δ̈ = n·ẇ + ω_i t·w, since n turns with the guide.
#[inline(never)]
pub(super) fn gap<T: Real>(
    motion: &PlayMotion<T>,
    play: &PlayGeometry<T>,
    block: &SliderBlock<T>,
    place: usize,
    acceleration_m_s2: Vec2<T>,
    spin_rates_rad_s2: [T; 2],
) -> GapMotion<T> {
    let Corner { arm_m, reach_m, normal, velocity_m_s } = corner(motion, block, place);
    let [spin_i, spin_j] = motion.spins_rad_s;
    let [spin_rate_i, spin_rate_j] = spin_rates_rad_s2;
    let arm_rate_m_s = arm_m.turned() * spin_j;
    let reach_rate_m_s = motion.eccentricity_rate_m_s + arm_rate_m_s;
    let change_m_s2 = acceleration_m_s2
        .plus(arm_m.turned(), spin_rate_j)
        .plus(arm_rate_m_s.turned(), spin_j)
        .plus(reach_m.turned(), -spin_rate_i)
        .plus(reach_rate_m_s.turned(), -spin_i);
    let second = (spin_i * normal.turned().dot(velocity_m_s)) + normal.dot(change_m_s2);
    let penetration_m = normal.dot(reach_m) - (block.half_height_m + play.clearance_m);
    GapMotion { gap: [penetration_m, normal.dot(velocity_m_s), second], penetration_acceleration_m_s2: second }
}
