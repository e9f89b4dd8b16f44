//! Factors of small matrices most of whose entries are zero, for many right-hand sides.
//!
//! A row of a loop equation has entries of two bodies, of the turn of one often alone: factors with their zeros left out are solved with in a third
//! of the time of dense ones.

use std::ops::Range;

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
        // One beyond the last, which may be written though it is zero.
        if self.entries.len() <= room {
            self.entries.resize(room + 1, (0, 0.0));
        }
    }

    /// Begins another row.
    fn begin(&mut self) {
        self.ends.push(self.ends.last().copied().unwrap_or(0));
    }

    /// Adds entries to the last row, which begin at a column.
    fn push(&mut self, first: usize, entries: &[f64]) {
        let Some(last) = self.ends.last_mut() else { return };
        let room = &mut self.entries[*last..=*last + entries.len()];
        let mut count = 0;
        for (k, value) in entries.iter().enumerate() {
            // Without a branch: half of the entries are zero, in no order.
            room[count] = (first + k, *value);
            count += usize::from(*value != 0.0);
        }
        *last += count;
    }

    #[inline(always)]
    fn row(&self, number: usize) -> &[(usize, f64)] {
        let start = if number > 0 { self.ends[number - 1] } else { 0 };
        &self.entries[start..self.ends[number]]
    }
}

/// Most blocks of columns: bits of a number.
const MAX_BLOCKS: usize = 64;
/// Columns of a block, those of a body; more where there are more columns than bits.
const BLOCK: usize = 6;
/// Order up to which there is one block: most of its columns have entries.
const ONE_BLOCK: usize = 24;

/// Factors P A = L U with row exchanges, L with ones on its diagonal. Blocks of columns in which rows have no entries are passed over.
#[derive(Debug, Clone, Default)]
pub(crate) struct SparseLu {
    order: usize,
    /// Columns of a block, and the block of each column.
    width: usize,
    block_of: Vec<u8>,
    /// The matrix, row by row; then its factors.
    matrix: Vec<f64>,
    /// The blocks of each row that have entries.
    blocks: Vec<u64>,
    exchanges: Vec<usize>,
    lower: SparseRows,
    upper: SparseRows,
    inverse_pivots: Vec<f64>,
    /// Room for the rows that a pivot is subtracted from, and for its columns.
    below: Vec<usize>,
    runs: Vec<Range<usize>>,
}

/// The columns of blocks, those side by side together, as far as they are within some.
fn put_runs(runs: &mut Vec<Range<usize>>, blocks: u64, width: usize, within: Range<usize>) {
    runs.clear();
    let mut start = 0;
    while let Some(left) = blocks.checked_shr(start).filter(|left| *left != 0) {
        start += left.trailing_zeros();
        let count = (!(blocks >> start)).trailing_zeros();
        let end = start + count;
        let columns = (start as usize * width).max(within.start)..(end as usize * width).min(within.end);
        if !columns.is_empty() {
            runs.push(columns);
        }
        start = end;
    }
}

impl SparseLu {
    /// A matrix of zeros, to be filled by [`Self::add`].
    pub(crate) fn clear(&mut self, order: usize) {
        if self.order != order {
            self.order = order;
            let width = if order <= ONE_BLOCK { order } else { order.div_ceil(MAX_BLOCKS).max(BLOCK) };
            self.width = width;
            self.block_of.clear();
            self.block_of.extend((0..order).map(|column| (column / width) as u8));
            for room in [&mut self.exchanges, &mut self.lower.ends, &mut self.upper.ends] {
                room.reserve(order);
            }
            self.below.resize(order, 0);
            self.inverse_pivots.reserve(order);
            self.runs.reserve(MAX_BLOCKS / 2);
        }
        self.matrix.clear();
        self.matrix.resize(order * order, 0.0);
        self.blocks.clear();
        self.blocks.resize(order, 0);
    }

    /// Adds entries to a row, from a column on.
    pub(crate) fn add(&mut self, row: usize, first: usize, values: &[f64]) {
        let start = row * self.order + first;
        self.matrix[start..start + values.len()].iter_mut().zip(values).for_each(|(entry, value)| *entry += value);
        let blocks = &self.block_of[first..first + values.len()];
        if let (Some(from), Some(to)) = (blocks.first(), blocks.last()) {
            self.blocks[row] |= (2_u64 << to).wrapping_sub(1 << from);
        }
    }

    /// Number of rows.
    pub(crate) fn order(&self) -> usize {
        self.order
    }

    /// Factors what was filled in.
    pub(crate) fn factor(&mut self) {
        let (n, width, a) = (self.order, self.width, &mut self.matrix);
        let is_one_block = width == n;
        self.exchanges.clear();
        self.inverse_pivots.clear();
        for j in 0..n {
            let block = self.block_of[j];
            let (mut best, mut most, mut count) = (j, a[j * n + j].abs(), 0);
            if is_one_block {
                for i in j + 1..n {
                    // What is not a number is no pivot, and stays in the matrix.
                    if a[i * n + j].abs() > most {
                        (best, most) = (i, a[i * n + j].abs());
                    }
                }
            } else {
                for (i, blocks) in self.blocks.iter().enumerate().skip(j) {
                    if blocks >> block & 1 == 1 {
                        let entry = a[i * n + j];
                        // Without a branch, as below.
                        self.below[count] = i;
                        count += usize::from(entry != 0.0);
                        if entry.abs() > most {
                            (best, most) = (i, entry.abs());
                        }
                    }
                }
            }
            self.exchanges.push(best);
            let (above, below) = a.split_at_mut((j + 1) * n);
            let pivot_row = &mut above[j * n..];
            if best != j {
                pivot_row.swap_with_slice(&mut below[(best - j - 1) * n..(best - j) * n]);
                self.blocks.swap(j, best);
            }
            let inverse = 1.0 / pivot_row[j];
            self.inverse_pivots.push(inverse);
            if is_one_block {
                for row in below.chunks_exact_mut(n).filter(|row| row[j] != 0.0) {
                    let factor = row[j] * inverse;
                    row[j] = factor;
                    let pairs = row[j + 1..].iter_mut().zip(&pivot_row[j + 1..]);
                    pairs.for_each(|(entry, pivot)| *entry -= factor * pivot);
                }
                continue;
            }
            let of_pivot = self.blocks[j];
            put_runs(&mut self.runs, of_pivot, width, j + 1..n);
            for &i in self.below[..count].iter().filter(|i| **i != best) {
                // The row that was at j has gone to where the pivot was.
                let i = if i == j { best } else { i };
                let row = &mut below[(i - j - 1) * n..(i - j) * n];
                let factor = row[j] * inverse;
                row[j] = factor;
                self.blocks[i] |= of_pivot;
                for columns in &self.runs {
                    let pairs = row[columns.clone()].iter_mut().zip(&pivot_row[columns.clone()]);
                    pairs.for_each(|(entry, pivot)| *entry -= factor * pivot);
                }
            }
        }
        let filled: usize = self.blocks.iter().map(|blocks| blocks.count_ones() as usize * width).sum();
        self.lower.clear(filled);
        self.upper.clear(filled);
        for (i, row) in a.chunks_exact(n.max(1)).enumerate() {
            self.lower.begin();
            self.upper.begin();
            let mut left = self.blocks[i];
            while left != 0 {
                let first = left.trailing_zeros() as usize * width;
                left &= left - 1;
                let end = (first + width).min(n);
                self.lower.push(first, &row[first.min(i)..end.min(i)]);
                let first = first.max(i + 1);
                self.upper.push(first, &row[first.min(end)..end]);
            }
        }
    }

    /// Solves A x = b in place of b.
    pub(crate) fn solve(&self, right: &mut [f64]) {
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
    pub(crate) fn solve_transposed(&self, right: &mut [f64]) {
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
    pub(crate) fn determinant_sign(&self) -> f64 {
        let exchanges = self.exchanges.iter().enumerate().filter(|(j, other)| j != *other).count();
        let start = if exchanges % 2 == 0 { 1.0 } else { -1.0 };
        let is_pivot = |inverse: &f64| inverse.is_finite() && *inverse != 0.0;
        if !self.inverse_pivots.iter().all(is_pivot) {
            return 0.0;
        }
        self.inverse_pivots.iter().fold(start, |sign, inverse| sign * inverse.signum())
    }

    /// Size of the smallest pivot over that of the largest; 0 where the matrix is singular, or not of numbers.
    pub(crate) fn pivot_ratio(&self) -> f64 {
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
        lu.clear(order + 1);
        (0..=order).for_each(|row| lu.add(row, 0, &vec![7.0; order + 1]));
        lu.factor();
        lu.clear(order);
        matrix.chunks(order.max(1)).enumerate().for_each(|(row, entries)| lu.add(row, 0, entries));
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

    #[test]
    fn identity_blocks_without_entries_are_those_of_a_matrix_with_zeros() {
        // One block, up to 64 blocks of six columns, and more columns than those.
        for order in [5_usize, 24, 25, 63, 131, 400] {
            let number = |k: usize| libm::sin(1.7 + 3.1 * k as f64 + 0.37 * (k * k % 1013) as f64);
            let mut own = SparseLu::default();
            own.clear(order);
            let mut matrix = vec![0.0; order * order];
            for row in 0..order {
                // Some entries beside the diagonal, some far from it, and one twice.
                for (k, first) in [row.saturating_sub(2), (row * row + 7) % order, row].into_iter().enumerate() {
                    let count = (2 + k).min(order - first);
                    let values: Vec<f64> = (0..count).map(|at| number(7 * row + 3 * at + k)).collect();
                    own.add(row, first, &values);
                    let entries = &mut matrix[row * order + first..];
                    entries.iter_mut().zip(&values).for_each(|(entry, value)| *entry += value);
                }
            }
            own.factor();
            let full = lu(order, &matrix);
            let right: Vec<f64> = (0..order).map(number).collect();
            for solve in [SparseLu::solve, SparseLu::solve_transposed] {
                let [mut one, mut other] = [right.clone(), right.clone()];
                solve(&own, &mut one);
                solve(&full, &mut other);
                assert_eq!(one, other);
            }
            let mut solution = right.clone();
            full.solve(&mut solution);
            for (row, value) in matrix.chunks(order).zip(&right) {
                let sum: f64 = row.iter().zip(&solution).map(|(a, b)| a * b).sum();
                assert!((sum - value).abs() < 1e-9, "{order}: {sum} {value}");
            }
        }
    }
}
