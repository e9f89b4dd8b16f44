//! Symmetric matrices by A = L D Lᵀ as long as their pivots are positive: the proof that a matrix is positive definite, on numbers and on intervals.

use crate::Real;

/// Replaces the lower triangle of the symmetric n × n matrix `a` (row by row, the upper one is not read) by L, without its ones, and D on the
/// diagonal. False as soon as `is_positive` refuses a pivot. On intervals, with pivots whose lower ends are positive, it is true of every symmetric
/// matrix in them.
///
/// Without fused multiply-adds, unlike [`crate::factor_ldl`]: the search for multipliers of [`crate::QuadraticOverBalls`] branches on the bits, and
/// other ones moved upper ends by up to 6e-10.
pub fn factor_definite<T: Real>(a: &mut [T], n: usize, is_positive: impl Fn(T) -> bool) -> bool {
    for j in 0..n {
        let pivot = a[j * n + j];
        if !is_positive(pivot) {
            return false;
        }
        // From the last row on: those above it still hold their entries of column j undivided.
        for i in (j + 1..n).rev() {
            let share = a[i * n + j] / pivot;
            for k in j + 1..=i {
                let product = share * a[k * n + j];
                a[i * n + k] -= product;
            }
            a[i * n + j] = share;
        }
    }
    true
}

/// Solves A x = b in place with the factors of [`factor_definite`].
pub fn solve_definite(factors: &[f64], n: usize, b: &mut [f64]) {
    for i in 0..n {
        for k in 0..i {
            b[i] -= factors[i * n + k] * b[k];
        }
    }
    for i in 0..n {
        b[i] /= factors[i * n + i];
    }
    for i in (0..n).rev() {
        for k in i + 1..n {
            b[i] -= factors[k * n + i] * b[k];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Interval;

    #[test]
    fn analytic_factors_solution_and_refusal() {
        // L = [[1, 0, 0], [0.5, 1, 0], [-0.25, 2, 1]], D = diag(4, 2, 8).
        let matrix = [4.0, 0.0, 0.0, 2.0, 3.0, 0.0, -1.0, 3.5, 16.25];
        let mut factors = matrix;
        assert!(factor_definite(&mut factors, 3, |pivot| pivot > 0.0));
        assert_eq!(factors, [4.0, 0.0, 0.0, 0.5, 2.0, 0.0, -0.25, 2.0, 8.0]);
        // A (1, 2, -1).
        let mut x = [9.0, 4.5, -10.25];
        solve_definite(&factors, 3, &mut x);
        assert_eq!(x, [1.0, 2.0, -1.0]);
        let held = |radius: f64| {
            let mut a = matrix.map(|entry| Interval::new(entry - radius, entry + radius));
            factor_definite(&mut a, 3, |pivot| pivot.low() > 0.0)
        };
        assert!(held(1e-3) && !held(1.0));
        assert!(!factor_definite(&mut [1.0, 0.0, 2.0, 1.0], 2, |pivot| pivot > 0.0));
    }
}
