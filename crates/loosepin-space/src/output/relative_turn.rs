//! The turn of a body from its ideal orientation: as it is, and enclosed over all places of the play.

use crate::enclosure::jet::{Jet, Number};
use crate::enclosure::position_box::PositionBox;
use crate::enclosure::vector::JetVector;
use crate::output::kind_of_output::OutputState;
use core::array::from_fn;
use loosepin_math::{Interval, Real, Rotation};

/// Axes of the ideal body, and R_idealᵀR.
pub(crate) fn relative_turn(body: usize, ideal: &OutputState, actual: &OutputState) -> (Rotation, Rotation) {
    let axes = ideal.poses[body].orientation.rotation();
    (axes, axes.transposed_times(&actual.poses[body].orientation.rotation()))
}

/// The axial vector of a body's turn, in ground axes, in which R_ideal u is the axis, and the numbers that it is by.
pub(crate) fn enclosed_sines<T: Number>(at: &PositionBox, body: usize) -> (Vec<usize>, JetVector<T>) {
    let (places, steps) = at.branch::<T>(body);
    let unit = |k: usize| {
        let axis: JetVector<T> = from_fn(|row| Jet::constant(Interval::from_f64(f64::from(u8::from(row == k)))));
        steps.iter().rev().fold(axis, |axis, step| step.axis(&axis))
    };
    let columns: [JetVector<T>; 3] = from_fn(unit);
    let half = |row: usize, column: usize| {
        (columns[column][row].clone() - &columns[row][column]).times(Interval::from_f64(0.5))
    };
    (places, [half(2, 1), half(0, 2), half(1, 0)])
}
