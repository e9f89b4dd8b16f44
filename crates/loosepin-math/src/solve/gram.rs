//! Gram matrices J M⁻¹ Jᵀ of constraints, whose rows may repeat each other or lose their rank on the way.

use super::ldl::{factor_ldl, solve_ldl};
use crate::Real;
use core::ops::Range;

/// Addition to the diagonal, as a share of the scale of its row. Round-off leaves 1e-16 of a sum that vanishes.
const REGULARISATION: f64 = 1e-10;
/// Passes of refinement. Each leaves the share `REGULARISATION`/s of what is still wrong in a direction of relative size s.
const PASSES: usize = 3;

/// Solves G λ = r for a Gram matrix G, positive definite or, where rows repeat each other, positive semidefinite with an r that
/// is consistent with it: then one of the many λ, which all give the same Jᵀ λ.
///
/// By (G + ε S) λ = r and refinement, S the scales of the rows: no choice of rows, so nothing switches when a row is independent
/// in one position and repeats others in the next (a plate on three cranks), or when the rows lose their rank in one position (a
/// change point: all bars in a line). There a direction narrower than √ε of its scale is left alone, and inertia decides.
///
/// Rows that share a scale are components of one vector (x and y of a point): a component that vanishes with its direction
/// has the scale of the other one.
#[derive(Debug, Clone)]
pub struct GramSystem<T> {
    /// G, row-major.
    matrix: Vec<T>,
    /// M⁻¹ Jᵀ, one row of n for each constraint.
    mobilities: Vec<T>,
    order: usize,
    /// The rows whose diagonal entries together are the scale of a row; of a row alone twice its own.
    scales: Vec<Range<usize>>,
    factors: Vec<T>,
    right: Vec<T>,
    change: Vec<T>,
}

impl<T: Real> GramSystem<T> {
    /// Room for constraints over `coordinates`: for each row, the rows that share its scale.
    pub fn new(scales: Vec<Range<usize>>, coordinates: usize) -> Self {
        let order = scales.len();
        Self {
            matrix: vec![T::zero(); order * order],
            mobilities: vec![T::zero(); order * coordinates],
            order,
            scales,
            factors: vec![T::zero(); order * order],
            right: vec![T::zero(); order],
            change: vec![T::zero(); order],
        }
    }

    /// Takes the first n columns of `jacobian`, whose rows have `columns` entries, and the factors of the n × n matrix M.
    #[inline(always)]
    pub fn set(&mut self, jacobian: &[T], columns: usize, mass: &[T], n: usize) {
        for row in 0..self.order {
            let mobility = &mut self.mobilities[row * n..(row + 1) * n];
            mobility.copy_from_slice(&jacobian[row * columns..row * columns + n]);
            solve_ldl(mass, n, mobility);
        }
        for row in 0..self.order {
            let gradient = &jacobian[row * columns..row * columns + n];
            for other in 0..self.order {
                let mut sum = T::zero();
                for (slope, mobility) in gradient.iter().zip(&self.mobilities[other * n..(other + 1) * n]) {
                    sum = slope.mul_add(*mobility, sum);
                }
                self.matrix[row * self.order + other] = sum;
            }
        }
        self.factor();
    }

    /// M⁻¹ Jᵀ, one row of n for each constraint.
    #[inline(always)]
    pub fn mobilities(&self) -> &[T] {
        &self.mobilities
    }

    /// Adds M⁻¹ Jᵀ λ to `change`.
    #[inline(always)]
    pub fn add_correction(&self, multipliers: &[T], change: &mut [T]) {
        let n = change.len();
        for (row, multiplier) in multipliers.iter().enumerate() {
            for (mobility, change) in self.mobilities[row * n..(row + 1) * n].iter().zip(change.iter_mut()) {
                *change = mobility.mul_add(*multiplier, *change);
            }
        }
    }

    /// Prepares for [`Self::solve`] with the matrix as it is now.
    #[inline(always)]
    fn factor(&mut self) {
        let n = self.order;
        self.factors.copy_from_slice(&self.matrix);
        for row in 0..n {
            let mut diagonal = self.scales[row].clone().map(|row| self.matrix[row * n + row]);
            let first = diagonal.next().unwrap_or(T::zero());
            let scale = diagonal.reduce(|sum, entry| sum + entry).map_or(first + first, |rest| first + rest);
            let raised = scale.mul_add(T::from_f64(REGULARISATION), self.matrix[row * n + row]);
            // Rows of zeros belong to driven coordinates alone: any pivot gives them λ = 0.
            self.factors[row * n + row] = T::select(T::zero().less_than(scale), raised, T::one());
        }
        factor_ldl(&mut self.factors, n);
    }

    /// Replaces `right` by λ, with the matrix that was set last.
    #[inline(always)]
    pub fn solve(&mut self, right: &mut [T]) {
        let n = self.order;
        self.right.copy_from_slice(right);
        right.fill(T::zero());
        for _ in 0..PASSES {
            for row in 0..n {
                let mut rest = self.right[row];
                for (entry, value) in self.matrix[row * n..(row + 1) * n].iter().zip(right.iter()) {
                    rest = (-*entry).mul_add(*value, rest);
                }
                self.change[row] = rest;
            }
            solve_ldl(&self.factors, n, &mut self.change);
            for (value, change) in right.iter_mut().zip(&self.change) {
                *value += *change;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::GramSystem;

    /// Round-off of systems of order one with four unknowns.
    const ROUND_OFF: f64 = 1e-13;

    fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
        a.iter().zip(b).map(|(a, b)| a * b).sum()
    }

    /// The x = Jᵀ λ that `rows` demand of a target.
    fn solution(rows: &[[f64; 3]], target: &[f64; 3]) -> [f64; 3] {
        let mut system = GramSystem::new((0..rows.len()).map(|row| row..row + 1).collect(), 3);
        let mut multipliers: Vec<f64> = rows.iter().map(|row| dot(row, target)).collect();
        let jacobian: Vec<f64> = rows.concat();
        system.set(&jacobian, 3, &[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0], 3);
        system.solve(&mut multipliers);
        std::array::from_fn(|k| rows.iter().zip(&multipliers).map(|(row, m)| row[k] * m).sum())
    }

    #[test]
    fn identity_rows_that_repeat_each_other_are_all_met() {
        // The third row is the sum of the first two; the last one belongs to driven coordinates alone.
        let rows = [[1.3, -0.4, 2.1], [0.7, 1.9, -0.6], [2.0, 1.5, 1.5], [0.0, 0.0, 0.0]];
        let target = [0.9, -1.4, 0.35];
        let x = solution(&rows, &target);
        for row in &rows {
            assert!((dot(row, &x) - dot(row, &target)).abs() < ROUND_OFF);
        }
    }

    #[test]
    fn identity_rows_may_come_close_to_each_other_where_a_third_one_does_not() {
        // Through the place where the second row repeats the first; the third makes up for it.
        for turn in [0.0, 1e-9, 1e-7, 1e-5, 1e-3] {
            let rows = [[1.0, 0.0, 0.0], [1.0, turn, 0.0], [0.3, 1.2, 0.0]];
            let target = [0.9, -1.4, 0.0];
            let x = solution(&rows, &target);
            assert!((x[0] - target[0]).abs() < ROUND_OFF && (x[1] - target[1]).abs() < ROUND_OFF, "{turn:e}: {x:?}");
        }
    }

    #[test]
    fn identity_a_direction_that_vanishes_is_left_alone() {
        // Both rows are components of one vector; the first one vanishes with its direction, its defect is round-off.
        let (small, round_off) = (1e-9, 1e-16);
        let mut system = GramSystem::new(vec![0..2, 0..2], 2);
        system.set(&[small, 0.0, 0.3, 1.2], 2, &[1.0, 0.0, 0.0, 1.0], 2);
        let mut multipliers = [round_off, 0.7];
        system.solve(&mut multipliers);
        let mut change = [0.0; 2];
        system.add_correction(&multipliers, &mut change);
        assert!((0.3 * change[0] + 1.2 * change[1] - 0.7).abs() < ROUND_OFF, "{change:?}");
        // With a scale of its own the first row would demand change[0] = round_off / small = 1e-7. Three passes take 3 small/ε of
        // what it misses, -0.137 small: 3e-9.
        assert!((change[0] - 0.3 * 0.7 / 1.53).abs() < 1e-8, "{change:?}");
    }
}
