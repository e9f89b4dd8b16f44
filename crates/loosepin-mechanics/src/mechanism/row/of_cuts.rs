//! The constraints of the cut joints of a tree, in every geometry: residual, Jacobian and acceleration.

use super::form::{CutMotion, CutState, MOST_SCALARS, RowAt, RowGeometry};
use crate::mechanism::tree::cut_numbers::CutNumbers;
use crate::mechanism::tree::kinematics::{Kinematics, acceleration_at};
use crate::mechanism::tree::numbers::TreeNumbers;
use crate::mechanism::tree::spanning_tree::{Cut, Tree};
use crate::model::Row;
use loosepin_math::Real;

/// Calls `with` for each condition of the cut joints, with its first scalar constraint.
#[inline(always)]
fn for_each<T: Real, G: RowGeometry>(
    tree: &Tree<G>,
    numbers: &TreeNumbers<T, G>,
    mut with: impl FnMut(&Cut<G>, &CutNumbers<T, G>, G::Row, usize),
) {
    let mut first = 0;
    for (cut, numbers) in tree.cuts.iter().zip(&numbers.cuts) {
        for row in cut.rows {
            with(cut, numbers, *row, first);
            first += row.count();
        }
    }
}

/// Arms of the points of a cut from the origins of its bodies, in the ground's frame, m.
#[inline(always)]
pub(in crate::mechanism) fn arms_m<T: Real, G: RowGeometry>(
    cut: &Cut<G>,
    numbers: &CutNumbers<T, G>,
    kinematics: &Kinematics<T, G>,
) -> [G::Vector<T>; 2] {
    [0, 1].map(|side| kinematics.poses[cut.slots[side]].turn(numbers.arms_m[side]))
}

/// A cut joint where the bodies are, with the arms of its points.
#[inline(always)]
pub(in crate::mechanism) fn state<'a, T: Real, G: RowGeometry>(
    cut: &Cut<G>,
    numbers: &'a CutNumbers<T, G>,
    kinematics: &'a Kinematics<T, G>,
    arms_m: [G::Vector<T>; 2],
) -> CutState<'a, T, G> {
    let poses = cut.slots.map(|slot| &kinematics.poses[slot]);
    let gap_m = poses[1].position_m + arms_m[1] - poses[0].position_m - arms_m[0];
    CutState { numbers, poses, gap_m }
}

/// Residuals Φ in the order of the cut joints.
#[inline(always)]
pub fn cut_residuals<T: Real, G: RowGeometry>(
    tree: &Tree<G>,
    numbers: &TreeNumbers<T, G>,
    kinematics: &Kinematics<T, G>,
    out: &mut [T],
) {
    for_each(tree, numbers, |cut, numbers, row, first| {
        let poses = cut.slots.map(|slot| &kinematics.poses[slot]);
        let gap_m = poses[1].point_m(numbers.arms_m[1]) - poses[0].point_m(numbers.arms_m[0]);
        let state = CutState { numbers, poses, gap_m };
        G::row_at(row, &state).residuals(&mut out[first..first + row.count()]);
    });
}

/// dΦ for unit speeds, row-major, `tree.speeds()` columns, driven speeds last. Rows begin as zeros.
#[inline(always)]
pub fn cut_jacobian<T: Real, G: RowGeometry>(
    tree: &Tree<G>,
    numbers: &TreeNumbers<T, G>,
    kinematics: &Kinematics<T, G>,
    out: &mut [T],
) {
    let columns = tree.speeds();
    for_each(tree, numbers, |cut, numbers, row, first| {
        let arms_m = arms_m(cut, numbers, kinematics);
        let at = G::row_at(row, &state(cut, numbers, kinematics, arms_m));
        let mut rates = [T::zero(); MOST_SCALARS];
        let rates = &mut rates[..row.count()];
        for (side, sign) in [(0, -T::one()), (1, T::one())] {
            for column in kinematics.columns(tree, cut.slots[side]) {
                at.rates(|| column.at(arms_m[side]) * sign, side, G::spin(column.turning), rates);
                for (k, rate) in rates.iter().enumerate() {
                    out[(first + k) * columns + column.coordinate] += *rate;
                }
            }
        }
    });
}

/// dΦ for a motion of the bodies that `moves` names, each with a velocity of the origin of its frame and an angular velocity.
/// A cut both of whose bodies move does not feel it where they move as one.
#[inline(always)]
pub(in crate::mechanism) fn cut_gradient<T: Real, G: RowGeometry>(
    tree: &Tree<G>,
    numbers: &TreeNumbers<T, G>,
    kinematics: &Kinematics<T, G>,
    moves: impl Fn(usize) -> bool,
    motion: impl Fn(usize) -> (G::Vector<T>, G::Spin<T>),
    out: &mut [T],
) {
    for_each(tree, numbers, |cut, numbers, row, first| {
        let sides = cut.slots.map(&moves);
        if sides[0] == sides[1] {
            return;
        }
        let (side, sign) = if sides[1] { (1, T::one()) } else { (0, -T::one()) };
        let arms_m = arms_m(cut, numbers, kinematics);
        let at = G::row_at(row, &state(cut, numbers, kinematics, arms_m));
        let (linear, spin) = motion(cut.slots[side]);
        let velocity = || G::carried(linear, spin, arms_m[side]) * sign;
        at.rates(velocity, side, spin, &mut out[first..first + row.count()]);
    });
}

/// d²Φ/dt² when the free coordinates have no acceleration. Needs the biases of `kinematics`.
#[inline(always)]
pub fn cut_biases<T: Real, G: RowGeometry>(
    tree: &Tree<G>,
    numbers: &TreeNumbers<T, G>,
    kinematics: &Kinematics<T, G>,
    out: &mut [T],
) {
    for_each(tree, numbers, |cut, numbers, row, first| {
        let arms_m = arms_m(cut, numbers, kinematics);
        let [twists, changes] = [&kinematics.twists, &kinematics.biases].map(|of| cut.slots.map(|slot| of[slot]));
        let accelerations = [0, 1].map(|side| acceleration_at(&changes[side], &twists[side], arms_m[side]));
        let motion = CutMotion {
            velocity_m_s: twists[1].at(arms_m[1]) - twists[0].at(arms_m[0]),
            acceleration_m_s2: accelerations[1] - accelerations[0],
            spins: twists.map(|twist| twist.angular),
            spin_rates: changes.map(|change| change.angular),
        };
        let at = G::row_at(row, &state(cut, numbers, kinematics, arms_m));
        at.biases(&motion, &mut out[first..first + row.count()]);
    });
}
