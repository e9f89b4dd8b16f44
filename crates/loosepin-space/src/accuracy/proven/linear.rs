//! Linear systems on intervals.

use loosepin_math::Interval;

/// Y times some columns of a matrix with `n` rows.
pub(super) fn product(
    inverse: &[Interval],
    matrix: &[Interval],
    n: usize,
    columns: usize,
    of: core::ops::Range<usize>,
) -> Vec<Interval> {
    let mut found = vec![Interval::ZERO; n * of.len()];
    for k in 0..n {
        for (place, column) in of.clone().enumerate() {
            let entry = matrix[k * columns + column];
            // Most entries are zero.
            if entry != Interval::ZERO {
                for row in 0..n {
                    found[row * of.len() + place] += inverse[row * n + k] * entry;
                }
            }
        }
    }
    found
}

/// Solves a system near the identity with `m` right-hand sides, row by row; `None` if a pivot may be zero.
pub(super) fn solve_near_identity(
    mut matrix: Vec<Interval>,
    n: usize,
    mut right: Vec<Interval>,
    m: usize,
) -> Option<Vec<Interval>> {
    for j in 0..n {
        if !(matrix[j * n + j].low() > 0.0) {
            return None;
        }
        for i in j + 1..n {
            let factor = matrix[i * n + j] / matrix[j * n + j];
            if factor == Interval::ZERO {
                continue;
            }
            for k in j + 1..n {
                let product = factor * matrix[j * n + k];
                matrix[i * n + k] -= product;
            }
            for k in 0..m {
                let product = factor * right[j * m + k];
                right[i * m + k] -= product;
            }
        }
    }
    for j in (0..n).rev() {
        for k in 0..m {
            let mut sum = right[j * m + k];
            for i in j + 1..n {
                sum -= matrix[j * n + i] * right[i * m + k];
            }
            right[j * m + k] = sum / matrix[j * n + j];
        }
    }
    Some(right)
}
