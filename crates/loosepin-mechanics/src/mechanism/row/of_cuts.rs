//! The constraints of the cut joints of a tree, in every geometry: residual, Jacobian and acceleration.

use super::form::{CutMotion, CutState, MOST_SCALARS, RowAt, RowGeometry};
use crate::mechanism::tree::cut_numbers::CutNumbers;
use crate::mechanism::tree::kinematics::{Kinematics, acceleration_at};
use crate::mechanism::tree::numbers::TreeNumbers;
use crate::mechanism::tree::spanning_tree::{Cut, Tree};
use crate::model::Row;
use core::ops::Range;
use loosepin_math::{Real, Vector};

/// Calls `with` for each cut joint, with its first scalar constraint.
#[inline(always)]
fn for_each<T: Real, G: RowGeometry>(
    tree: &Tree<G>,
    numbers: &TreeNumbers<T, G>,
    mut with: impl FnMut(&Cut<G>, &CutNumbers<T, G>, usize),
) {
    let mut first = 0;
    for (cut, numbers) in tree.cuts.iter().zip(&numbers.cuts) {
        with(cut, numbers, first);
        first += cut.count();
    }
}

/// Calls `with` for each condition of a cut joint at a state, with its scalar constraints.
#[inline(always)]
fn for_each_row<T: Real, G: RowGeometry>(
    cut: &Cut<G>,
    state: &CutState<'_, T, G>,
    mut first: usize,
    mut with: impl FnMut(G::RowAt<T>, Range<usize>),
) {
    for row in cut.rows {
        with(G::row_at(*row, state), first..first + row.count());
        first += row.count();
    }
}

/// Arms of the points of a cut from the origins of its bodies, in the ground's frame, m.
#[inline(always)]
fn arms_m<T: Real, G: RowGeometry>(
    cut: &Cut<G>,
    numbers: &CutNumbers<T, G>,
    kinematics: &Kinematics<T, G>,
) -> [G::Vector<T>; 2] {
    [0, 1].map(|side| kinematics.poses[cut.slots[side]].turn(numbers.arms_m[side]))
}

/// A cut joint where the bodies are. Positions alone ask for no arms: the way is the difference of the points, whose last digits are others than
/// those of [`state_of_arms`].
#[inline(always)]
fn state<'a, T: Real, G: RowGeometry>(
    cut: &Cut<G>,
    numbers: &'a CutNumbers<T, G>,
    kinematics: &'a Kinematics<T, G>,
) -> CutState<'a, T, G> {
    let poses = cut.slots.map(|slot| &kinematics.poses[slot]);
    let gap_m = poses[1].point_m(numbers.arms_m[1]) - poses[0].point_m(numbers.arms_m[0]);
    CutState { numbers, poses, gap_m }
}

/// The same with the arms of its points.
#[inline(always)]
fn state_of_arms<'a, T: Real, G: RowGeometry>(
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
    for_each(tree, numbers, |cut, numbers, first| {
        for_each_row(cut, &state(cut, numbers, kinematics), first, |row, own| row.residuals(&mut out[own]));
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
    for_each(tree, numbers, |cut, numbers, first| {
        let arms_m = arms_m(cut, numbers, kinematics);
        for_each_row(cut, &state_of_arms(cut, numbers, kinematics, arms_m), first, |row, own| {
            let mut rates = [T::zero(); MOST_SCALARS];
            let rates = &mut rates[..own.len()];
            for (side, sign) in [(0, -T::one()), (1, T::one())] {
                for column in kinematics.columns(tree, cut.slots[side]) {
                    row.rates(|| column.at(arms_m[side]) * sign, side, G::spin(column.turning), rates);
                    for (scalar, rate) in own.clone().zip(rates.iter()) {
                        out[scalar * columns + column.coordinate] += *rate;
                    }
                }
            }
        });
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
    for_each(tree, numbers, |cut, numbers, first| {
        let sides = cut.slots.map(&moves);
        if sides[0] == sides[1] {
            return;
        }
        let (side, sign) = if sides[1] { (1, T::one()) } else { (0, -T::one()) };
        let arms_m = arms_m(cut, numbers, kinematics);
        let (linear, spin) = motion(cut.slots[side]);
        for_each_row(cut, &state_of_arms(cut, numbers, kinematics, arms_m), first, |row, own| {
            row.rates(|| G::carried(linear, spin, arms_m[side]) * sign, side, spin, &mut out[own]);
        });
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
    for_each(tree, numbers, |cut, numbers, first| {
        let arms_m = arms_m(cut, numbers, kinematics);
        let [twists, changes] = [&kinematics.twists, &kinematics.biases].map(|of| cut.slots.map(|slot| of[slot]));
        let accelerations = [0, 1].map(|side| acceleration_at(&changes[side], &twists[side], arms_m[side]));
        let motion = CutMotion {
            velocity_m_s: twists[1].at(arms_m[1]) - twists[0].at(arms_m[0]),
            acceleration_m_s2: accelerations[1] - accelerations[0],
            spins: twists.map(|twist| twist.angular),
            spin_rates: changes.map(|change| change.angular),
        };
        let state = state_of_arms(cut, numbers, kinematics, arms_m);
        for_each_row(cut, &state, first, |row, own| row.biases(&motion, &mut out[own]));
    });
}

/// Forces of the cut joints on their second bodies at their points, N, for the multipliers of all constraints.
pub fn cut_forces_n<T: Real, G: RowGeometry>(
    tree: &Tree<G>,
    numbers: &TreeNumbers<T, G>,
    kinematics: &Kinematics<T, G>,
    multipliers: &[T],
) -> Vec<G::Vector<T>> {
    let mut forces_n = Vec::with_capacity(tree.cuts.len());
    for_each(tree, numbers, |cut, numbers, first| {
        let mut sum: Option<G::Vector<T>> = None;
        for_each_row(cut, &state(cut, numbers, kinematics), first, |row, own| {
            let force_n = row.force_n(&multipliers[own]);
            sum = Some(sum.map_or(force_n, |sum| sum + force_n));
        });
        forces_n.push(sum.unwrap_or(G::Vector::zero()));
    });
    forces_n
}
