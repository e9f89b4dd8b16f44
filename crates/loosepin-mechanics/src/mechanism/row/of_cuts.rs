//! The constraints of the cut joints of a tree, in every geometry: residual, Jacobian and acceleration.

use super::form::{CutColumns, CutMotion, CutState, RowGeometry};
use crate::mechanism::tree::cut_numbers::CutNumbers;
use crate::mechanism::tree::kinematics::{Kinematics, acceleration_at};
use crate::mechanism::tree::numbers::TreeNumbers;
use crate::mechanism::tree::spanning_tree::{Cut, Tree};
use crate::model::Row;
use core::ops::Range;
use loosepin_math::{Real, Vector};

/// The conditions of a cut joint with their scalar constraints, from `first` on, which ends after the last.
#[inline(always)]
fn rows<'a, G: RowGeometry>(
    cut: &'a Cut<G>,
    first: &'a mut usize,
) -> impl Iterator<Item = (G::Row, Range<usize>)> + 'a {
    cut.rows.iter().map(|row| {
        let own = *first..*first + row.count();
        *first = own.end;
        (*row, own)
    })
}

/// Arms of the points of a cut from the origins of its bodies, in the ground's frame, m.
#[inline(always)]
fn arms_m<T: Real, G: RowGeometry>(
    cut: &Cut<G>,
    numbers: &CutNumbers<T, G>,
    kinematics: &Kinematics<T, G>,
) -> [G::Vector<T>; 2] {
    let ([first, second], poses) = (cut.slots, &kinematics.poses);
    [poses[first].turn(numbers.arms_m[0]), poses[second].turn(numbers.arms_m[1])]
}

/// A cut joint where the bodies are. Positions alone ask for no arms: the way is the difference of the points, whose last digits are others than
/// those of [`state_of_arms`].
#[inline(always)]
fn state<'a, T: Real, G: RowGeometry>(
    cut: &Cut<G>,
    numbers: &'a CutNumbers<T, G>,
    kinematics: &'a Kinematics<T, G>,
) -> CutState<'a, T, G> {
    let poses = [&kinematics.poses[cut.slots[0]], &kinematics.poses[cut.slots[1]]];
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
    let poses = [&kinematics.poses[cut.slots[0]], &kinematics.poses[cut.slots[1]]];
    let gap_m = poses[1].position_m + arms_m[1] - poses[0].position_m - arms_m[0];
    CutState { numbers, poses, gap_m }
}

/// Residuals Φ in the order of the cut joints. How many they are.
#[inline(always)]
pub fn cut_residuals<T: Real, G: RowGeometry>(
    tree: &Tree<G>,
    numbers: &TreeNumbers<T, G>,
    kinematics: &Kinematics<T, G>,
    out: &mut [T],
) -> usize {
    let mut first = 0;
    for (cut, numbers) in tree.cuts.iter().zip(&numbers.cuts) {
        let state = state(cut, numbers, kinematics);
        for (row, own) in rows(cut, &mut first) {
            G::residuals(row, &state, &mut out[own]);
        }
    }
    first
}

/// dΦ for unit speeds, row-major, `tree.speeds()` columns, driven speeds last. Rows begin as zeros. How many they are.
#[inline(always)]
pub fn cut_jacobian<T: Real, G: RowGeometry>(
    tree: &Tree<G>,
    numbers: &TreeNumbers<T, G>,
    kinematics: &Kinematics<T, G>,
    out: &mut [T],
) -> usize {
    let (speeds, mut first) = (tree.speeds(), 0);
    for (cut, numbers) in tree.cuts.iter().zip(&numbers.cuts) {
        let arms_m = arms_m(cut, numbers, kinematics);
        let state = state_of_arms(cut, numbers, kinematics, arms_m);
        let columns = CutColumns { tree, kinematics, slots: cut.slots, arms_m, speeds };
        for (row, own) in rows(cut, &mut first) {
            G::add_columns(row, &state, &columns, &mut out[own.start * speeds..own.end * speeds]);
        }
    }
    first
}

/// dΦ for a motion of the bodies that `moves` names, each with a velocity of the origin of its frame and an angular velocity.
/// A cut both of whose bodies move does not feel it where they move as one. How many constraints there are.
#[inline(always)]
pub(in crate::mechanism) fn cut_gradient<T: Real, G: RowGeometry>(
    tree: &Tree<G>,
    numbers: &TreeNumbers<T, G>,
    kinematics: &Kinematics<T, G>,
    moves: impl Fn(usize) -> bool,
    motion: impl Fn(usize) -> (G::Vector<T>, G::Spin<T>),
    out: &mut [T],
) -> usize {
    let mut first = 0;
    for (cut, numbers) in tree.cuts.iter().zip(&numbers.cuts) {
        let sides = cut.slots.map(&moves);
        if sides[0] == sides[1] {
            first += cut.count();
            continue;
        }
        let (side, sign) = if sides[1] { (1, T::one()) } else { (0, -T::one()) };
        let arms_m = arms_m(cut, numbers, kinematics);
        let state = state_of_arms(cut, numbers, kinematics, arms_m);
        let (linear, spin) = motion(cut.slots[side]);
        for (row, own) in rows(cut, &mut first) {
            let velocity = || G::carried(linear, spin, arms_m[side]) * sign;
            G::rates(row, &state, velocity, (side, spin), &mut out[own]);
        }
    }
    first
}

/// d²Φ/dt² when the free coordinates have no acceleration. Needs the biases of `kinematics`. How many they are.
#[inline(always)]
pub fn cut_biases<T: Real, G: RowGeometry>(
    tree: &Tree<G>,
    numbers: &TreeNumbers<T, G>,
    kinematics: &Kinematics<T, G>,
    out: &mut [T],
) -> usize {
    let mut first = 0;
    for (cut, numbers) in tree.cuts.iter().zip(&numbers.cuts) {
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
        for (row, own) in rows(cut, &mut first) {
            G::biases(row, &state, &motion, &mut out[own]);
        }
    }
    first
}

/// Forces of the cut joints on their second bodies at their points, N, for the multipliers of all constraints.
pub fn cut_forces_n<T: Real, G: RowGeometry>(
    tree: &Tree<G>,
    numbers: &TreeNumbers<T, G>,
    kinematics: &Kinematics<T, G>,
    multipliers: &[T],
) -> Vec<G::Vector<T>> {
    let mut first = 0;
    let of_cut = |(cut, numbers): (&Cut<G>, &CutNumbers<T, G>)| {
        let state = state(cut, numbers, kinematics);
        let forces_n = rows(cut, &mut first).map(|(row, own)| G::force_n(row, &state, &multipliers[own]));
        forces_n.reduce(|sum, force_n| sum + force_n).unwrap_or(G::Vector::zero())
    };
    tree.cuts.iter().zip(&numbers.cuts).map(of_cut).collect()
}
