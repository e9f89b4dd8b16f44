//! Factors of small matrices most of whose entries are zero, for many right-hand sides.
//!
//! A row of a loop equation has entries of two bodies, of the turn of one often alone: factors with their zeros left out are solved with in a third
//! of the time of dense ones.

/// Rows without their zeros.
#[derive(Debug, Clone, Default)]
struct SparseRows {
    /// Where each row ends.
    ends: Vec<usize>,
    /// Columns and values; behind the last row there is no more than room.
    entries: Vec<(usize, f64)>,
}

impl SparseRows {
    /// No rows, and room for so many entries.
    fn clear(&mut self, room: usize) {
        self.ends.clear();
        self.entries.resize(room, (0, 0.0));
    }

    /// Adds a row, whose entries begin at a column.
    fn push(&mut self, first: usize, entries: &[f64]) {
        let mut end = self.ends.last().copied().unwrap_or(0);
        for (k, value) in entries.iter().enumerate() {
            // Without a branch: half of the entries are zero, in no order.
            self.entries[end] = (first + k, *value);
            end += usize::from(*value != 0.0);
        }
        self.ends.push(end);
    }

    #[inline(always)]
    fn row(&self, number: usize) -> &[(usize, f64)] {
        let start = if number > 0 { self.ends[number - 1] } else { 0 };
        &self.entries[start..self.ends[number]]
    }
}

/// Factors P A = L U with row exchanges, L with ones on its diagonal.
#[derive(Debug, Clone, Default)]
pub(super) struct SparseLu {
    order: usize,
    /// The matrix, row by row; then its factors.
    matrix: Vec<f64>,
    exchanges: Vec<usize>,
    lower: SparseRows,
    upper: SparseRows,
    inverse_pivots: Vec<f64>,
}

impl SparseLu {
    /// A matrix of zeros to be filled, row by row.
    pub(super) fn cleared(&mut self, order: usize) -> &mut [f64] {
        self.order = order;
        self.matrix.clear();
        self.matrix.resize(order * order, 0.0);
        &mut self.matrix
    }

    /// Number of rows.
    pub(super) fn order(&self) -> usize {
        self.order
    }

    /// Factors what was filled in.
    pub(super) fn factor(&mut self) {
        let (n, a) = (self.order, &mut self.matrix);
        self.exchanges.clear();
        self.inverse_pivots.clear();
        for j in 0..n {
            let mut best = j;
            for i in j + 1..n {
                // What is not a number is no pivot, and stays in the matrix.
                if a[i * n + j].abs() > a[best * n + j].abs() {
                    best = i;
                }
            }
            self.exchanges.push(best);
            let (above, below) = a.split_at_mut((j + 1) * n);
            let pivot_row = &mut above[j * n..];
            if best != j {
                pivot_row.swap_with_slice(&mut below[(best - j - 1) * n..(best - j) * n]);
            }
            let inverse = 1.0 / pivot_row[j];
            self.inverse_pivots.push(inverse);
            for row in below.chunks_exact_mut(n) {
                if row[j] != 0.0 {
                    let factor = row[j] * inverse;
                    row[j] = factor;
                    let pairs = row[j + 1..].iter_mut().zip(&pivot_row[j + 1..]);
                    pairs.for_each(|(entry, pivot)| *entry -= factor * pivot);
                }
            }
        }
        self.lower.clear(n * n + 1);
        self.upper.clear(n * n + 1);
        for (i, row) in a.chunks_exact(n.max(1)).enumerate() {
            self.lower.push(0, &row[..i]);
            self.upper.push(i + 1, &row[i + 1..]);
        }
    }

    /// Solves A x = b in place of b.
    pub(super) fn solve(&self, right: &mut [f64]) {
        for (j, other) in self.exchanges.iter().enumerate() {
            right.swap(j, *other);
        }
        for i in 0..self.order {
            let sum: f64 = self.lower.row(i).iter().map(|(k, value)| value * right[*k]).sum();
            right[i] -= sum;
        }
        for i in (0..self.order).rev() {
            let sum: f64 = self.upper.row(i).iter().map(|(k, value)| value * right[*k]).sum();
            right[i] = (right[i] - sum) * self.inverse_pivots[i];
        }
    }

    /// Solves Aᵀx = b in place of b.
    pub(super) fn solve_transposed(&self, right: &mut [f64]) {
        for i in 0..self.order {
            let value = right[i] * self.inverse_pivots[i];
            right[i] = value;
            self.upper.row(i).iter().for_each(|(k, entry)| right[*k] -= entry * value);
        }
        for i in (0..self.order).rev() {
            let value = right[i];
            self.lower.row(i).iter().for_each(|(k, entry)| right[*k] -= entry * value);
        }
        for (j, other) in self.exchanges.iter().enumerate().rev() {
            right.swap(j, *other);
        }
    }

    /// Sign of the determinant; 0 where the matrix is singular, or not of numbers.
    pub(super) fn determinant_sign(&self) -> f64 {
        let exchanges = self.exchanges.iter().enumerate().filter(|(j, other)| j != *other).count();
        let start = if exchanges % 2 == 0 { 1.0 } else { -1.0 };
        let is_pivot = |inverse: &f64| inverse.is_finite() && *inverse != 0.0;
        if !self.inverse_pivots.iter().all(is_pivot) {
            return 0.0;
        }
        self.inverse_pivots.iter().fold(start, |sign, inverse| sign * inverse.signum())
    }

    /// Size of the smallest pivot over that of the largest; 0 where the matrix is singular, or not of numbers.
    pub(super) fn pivot_ratio(&self) -> f64 {
        if self.determinant_sign() == 0.0 {
            return 0.0;
        }
        let sizes = || self.inverse_pivots.iter().map(|inverse| inverse.abs());
        sizes().fold(f64::INFINITY, f64::min) / sizes().fold(0.0, f64::max)
    }
}

#[cfg(test)]
mod tests {
    use super::SparseLu;

    fn lu(order: usize, matrix: &[f64]) -> SparseLu {
        let mut lu = SparseLu::default();
        // What was there before does not matter.
        lu.cleared(order + 1).fill(7.0);
        lu.factor();
        lu.cleared(order).copy_from_slice(matrix);
        lu.factor();
        lu
    }

    #[test]
    fn analytic_both_solutions_and_the_sign() {
        // 0 (1·7 - 4·0) - 2 (3·7 - 4·5) + 0 = -2.
        let matrix = [0.0, 2.0, 0.0, 3.0, 1.0, 4.0, 5.0, 0.0, 7.0];
        let own = lu(3, &matrix);
        assert_eq!((own.order(), own.determinant_sign()), (3, -1.0));
        let solution = [0.7, -1.3, 2.9];
        let mut straight: Vec<f64> = (0..3).map(|i| (0..3).map(|j| matrix[3 * i + j] * solution[j]).sum()).collect();
        let mut transposed: Vec<f64> = (0..3).map(|j| (0..3).map(|i| matrix[3 * i + j] * solution[i]).sum()).collect();
        own.solve(&mut straight);
        own.solve_transposed(&mut transposed);
        for found in [straight, transposed] {
            assert!(found.iter().zip(solution).all(|(a, b)| (a - b).abs() < 1e-14), "{found:?}");
        }
        assert!(own.pivot_ratio() > 0.0 && own.pivot_ratio() < 1.0);
        for matrix in [[1.0, 2.0, 2.0, 4.0], [0.0; 4], [f64::NAN; 4]] {
            let singular = lu(2, &matrix);
            assert_eq!((singular.determinant_sign(), singular.pivot_ratio()), (0.0, 0.0));
        }
        assert_eq!(lu(2, &[0.0, 1.0, 1.0, 0.0]).determinant_sign(), -1.0);
        assert_eq!(lu(0, &[]).determinant_sign(), 1.0);
    }
}
