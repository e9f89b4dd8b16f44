//! How well the drives transmit motion in a position.

use loosepin_math::{determinant, inverse};
use loosepin_mechanics::mechanism::{IdealMotion, Mechanism, RowOwner};
use loosepin_text::units::Dimension;

/// Whether the determinant of the loop matrix dΦ/dq is positive at the present position of `motion`. Its sign changes
/// where the mechanism passes through a singular position.
pub fn is_positive(mechanism: &Mechanism, motion: &IdealMotion<'_>) -> bool {
    determinant(&mut motion.loop_matrix(), mechanism.ideal.free) > 0.0
}

/// The measure of how far positions are from singular, for one cycle.
///
/// The columns of the loop matrix dΦ/dq are the velocities with which the free coordinates open the loops. Each is divided
/// by its largest length over the cycle, and angles count as lengths times the size of the mechanism. Then 1/|row of the
/// inverse| is the distance of a column from the span of the others; the smallest one is the sine of transmission: 1 where
/// all columns are as long as they get and at right angles, 0 in a singular position. For a loop of two links it is the
/// sine of the transmission angle, for a slider-crank its cosine of the rod's obliquity.
#[derive(Debug, Clone)]
pub struct Transmission<'m> {
    mechanism: &'m Mechanism,
    /// Largest length of each column over the cycle, m.
    largest_m: Vec<f64>,
}

impl<'m> Transmission<'m> {
    /// The measure for the cycle through `states`.
    pub fn over(mechanism: &'m Mechanism, states: &[IdealMotion<'_>]) -> Self {
        let n = mechanism.ideal.free;
        let mut largest_m = vec![0.0_f64; n];
        for state in states {
            let matrix = scaled_matrix(mechanism, state);
            for (column, largest_m) in largest_m.iter_mut().enumerate() {
                let length_m = (0..n).map(|row| matrix[row * n + column].powi(2)).sum::<f64>().sqrt();
                *largest_m = largest_m.max(length_m);
            }
        }
        Self { mechanism, largest_m }
    }

    /// Sine of transmission at the present position of `motion`.
    pub fn sine(&self, motion: &IdealMotion<'_>) -> f64 {
        let n = self.largest_m.len();
        let mut matrix = scaled_matrix(self.mechanism, motion);
        for row in matrix.chunks_mut(n.max(1)) {
            row.iter_mut().zip(&self.largest_m).for_each(|(entry, largest_m)| *entry /= largest_m);
        }
        let Some(inverse) = inverse(matrix, n) else { return 0.0 };
        let squares = inverse.chunks(n.max(1)).map(|row| row.iter().fold(0.0, |sum, entry| sum + entry * entry));
        1.0 / squares.fold(1.0_f64, f64::max).sqrt()
    }
}

/// The loop matrix with every row in metres: rows that say that two bodies do not turn against each other are multiplied
/// by the size of the mechanism.
fn scaled_matrix(mechanism: &Mechanism, motion: &IdealMotion<'_>) -> Vec<f64> {
    let n = mechanism.ideal.free;
    let mut matrix = motion.loop_matrix();
    for (row, &independent) in mechanism.ideal_rows().iter().enumerate() {
        if is_angle_row(mechanism, independent) {
            matrix[row * n..(row + 1) * n].iter_mut().for_each(|entry| *entry *= mechanism.size_m);
        }
    }
    matrix
}

fn is_angle_row(mechanism: &Mechanism, row: usize) -> bool {
    let mut first = 0;
    for cut in &mechanism.ideal.cuts {
        let end = first + cut.count();
        if row < end {
            return cut.is_angle(row - first);
        }
        first = end;
    }
    RowOwner::of(&mechanism.ideal, row).dimension(&mechanism.model) == Dimension::ANGLE
}
