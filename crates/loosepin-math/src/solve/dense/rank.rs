//! Rectangular systems: which rows and columns carry them, and what they say of the unknowns.

/// Gaussian elimination with full pivoting of a rectangular matrix: its rank, which rows and columns carry it, and
/// solutions of consistent systems.
#[derive(Debug, Clone)]
pub struct Elimination {
    rows: usize,
    columns: usize,
    /// The reduced matrix, row-major, rows and columns still in their original places.
    reduced: Vec<f64>,
    /// Pivot rows and columns in order; their number is the rank.
    pivots: Vec<(usize, usize)>,
    /// Multipliers applied to later rows for each pivot, in the order of elimination.
    multipliers: Vec<Vec<(usize, f64)>>,
}

impl Elimination {
    /// Factors the `rows` × `columns` row-major `matrix`. A pivot smaller than `tolerance` times the largest counts as
    /// zero.
    pub fn new(matrix: &[f64], rows: usize, columns: usize, tolerance: f64) -> Self {
        let mut reduced = matrix.to_vec();
        let mut row_free = vec![true; rows];
        let mut column_free = vec![true; columns];
        let mut pivots = Vec::new();
        let mut multipliers = Vec::new();
        let mut first = 0.0_f64;
        // A pivot changes few rows of a mechanism with many parts: the others keep their largest entry.
        let mut largest: Vec<(f64, usize)> =
            (0..rows).map(|i| largest_entry(&reduced[i * columns..(i + 1) * columns], &column_free)).collect();
        let mut filled = Vec::with_capacity(columns);
        loop {
            let mut best = (0.0_f64, 0, 0);
            for i in (0..rows).filter(|&i| row_free[i]) {
                let (size, j) = largest[i];
                if size > best.0 {
                    best = (size, i, j);
                }
            }
            let (size, i, j) = best;
            if pivots.is_empty() {
                first = size;
            }
            // The negated comparison also ends the elimination when an entry is not a number.
            if !(size > tolerance * first) || size == 0.0 {
                break;
            }
            row_free[i] = false;
            column_free[j] = false;
            filled.clear();
            filled.extend((0..columns).filter(|k| reduced[i * columns + k] != 0.0));
            let mut applied = Vec::new();
            for other in (0..rows).filter(|&k| row_free[k]) {
                if reduced[other * columns + j] == 0.0 {
                    continue;
                }
                let factor = reduced[other * columns + j] / reduced[i * columns + j];
                if factor != 0.0 {
                    for &k in &filled {
                        reduced[other * columns + k] -= factor * reduced[i * columns + k];
                    }
                    reduced[other * columns + j] = 0.0;
                    applied.push((other, factor));
                }
                largest[other] = largest_entry(&reduced[other * columns..(other + 1) * columns], &column_free);
            }
            pivots.push((i, j));
            multipliers.push(applied);
        }
        Self { rows, columns, reduced, pivots, multipliers }
    }

    /// Number of independent rows.
    pub fn rank(&self) -> usize {
        self.pivots.len()
    }
    /// Rows that depend on the others, ascending.
    pub fn dependent_rows(&self) -> Vec<usize> {
        others(self.rows, self.pivots.iter().map(|&(row, _)| row))
    }
    /// Columns that the others do not determine, ascending.
    pub fn free_columns(&self) -> Vec<usize> {
        others(self.columns, self.pivots.iter().map(|&(_, column)| column))
    }
    /// A solution x of A x = b over the independent rows, with the free columns at zero.
    pub fn solve(&self, right_hand_side: &[f64]) -> Vec<f64> {
        let mut b = right_hand_side.to_vec();
        for (&(row, _), applied) in self.pivots.iter().zip(&self.multipliers) {
            for &(other, factor) in applied {
                b[other] -= factor * b[row];
            }
        }
        let mut x = vec![0.0; self.columns];
        for &(row, column) in self.pivots.iter().rev() {
            let mut sum = b[row];
            for (k, value) in x.iter().enumerate() {
                if k != column {
                    sum -= self.reduced[row * self.columns + k] * value;
                }
            }
            x[column] = sum / self.reduced[row * self.columns + column];
        }
        x
    }
    /// The direction in which free column `free` can move with A x = 0, with `x[free]` = 1.
    pub fn null_direction(&self, free: usize) -> Vec<f64> {
        let mut x = vec![0.0; self.columns];
        x[free] = 1.0;
        for &(row, column) in self.pivots.iter().rev() {
            let sum: f64 =
                (0..self.columns).filter(|&k| k != column).map(|k| self.reduced[row * self.columns + k] * x[k]).sum();
            x[column] = -sum / self.reduced[row * self.columns + column];
        }
        x
    }
}

/// The largest entry of a row in the free columns, and its column; zero where it has none.
fn largest_entry(row: &[f64], column_free: &[bool]) -> (f64, usize) {
    let mut best = (0.0_f64, 0);
    for (j, entry) in row.iter().enumerate() {
        if entry.abs() > best.0 && column_free[j] {
            best = (entry.abs(), j);
        }
    }
    best
}

/// The numbers below `count` that are not among `taken`, ascending.
fn others(count: usize, taken: impl Iterator<Item = usize>) -> Vec<usize> {
    let mut is_left = vec![true; count];
    taken.for_each(|index| is_left[index] = false);
    (0..count).filter(|&index| is_left[index]).collect()
}

/// Puts a matrix (row by row, with rows of `columns` entries) into reduced echelon form and gives the columns of its pivots: the first rows, one for
/// each of them, have a one there and no other row has anything.
///
/// In each column in turn the largest entry of the rows that have no pivot yet becomes the pivot where it is larger than `least`; else they count as
/// zero there and keep what they have. The rows behind those with pivots are left over.
pub fn reduced_echelon(matrix: &mut [f64], columns: usize, least: f64) -> Vec<usize> {
    let rows = matrix.len() / columns.max(1);
    let mut pivots = Vec::new();
    for column in 0..columns {
        let rank = pivots.len();
        let size = |row: usize| matrix[row * columns + column].abs();
        let best = (rank..rows).max_by(|a, b| size(*a).total_cmp(&size(*b)));
        let Some(best) = best.filter(|row| size(*row) > least) else { continue };
        (0..columns).for_each(|k| matrix.swap(rank * columns + k, best * columns + k));
        let own = &mut matrix[rank * columns..(rank + 1) * columns];
        let pivot = own[column];
        own.iter_mut().for_each(|entry| *entry /= pivot);
        let own = own.to_vec();
        for (_, row) in matrix.chunks_exact_mut(columns).enumerate().filter(|(index, _)| *index != rank) {
            let share = row[column];
            row.iter_mut().zip(&own).for_each(|(entry, own)| *entry -= share * own);
        }
        pivots.push(column);
    }
    pivots
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Round-off of systems of order one with four unknowns.
    const ROUND_OFF: f64 = 1e-13;

    #[test]
    fn analytic_reduced_echelon_form() {
        // The third row is the first plus twice the second; columns two and three are alike but for the sign.
        let mut matrix = [1.0, 2.0, -2.0, 0.0, 0.0, 1.0, -1.0, 3.0, 1.0, 4.0, -4.0, 6.0];
        assert_eq!(reduced_echelon(&mut matrix, 4, 1e-9), [0, 1]);
        let expected = [1.0, 0.0, 0.0, -6.0, 0.0, 1.0, -1.0, 3.0, 0.0, 0.0, 0.0, 0.0];
        assert!(matrix.iter().zip(expected).all(|(a, b)| (a - b).abs() < ROUND_OFF), "{matrix:?}");
        assert_eq!(reduced_echelon(&mut [], 3, 1e-9), [0; 0]);
    }

    /// The elimination that examines every entry before every pivot: pivots, and the rest of the matrix.
    fn looking_everywhere(matrix: &[f64], rows: usize, columns: usize) -> (Vec<(usize, usize)>, Vec<f64>) {
        let (mut a, mut pivots) = (matrix.to_vec(), Vec::<(usize, usize)>::new());
        loop {
            let mut best = (0.0, 0, 0);
            for (i, j) in (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j))) {
                let is_free = pivots.iter().all(|&(row, column)| row != i && column != j);
                if is_free && a[i * columns + j].abs() > best.0 {
                    best = (a[i * columns + j].abs(), i, j);
                }
            }
            let (size, i, j) = best;
            let first = pivots.first().map_or(size, |&(i, j): &(usize, usize)| a[i * columns + j].abs());
            if !(size > 1e-9 * first) {
                return (pivots, a);
            }
            pivots.push((i, j));
            for other in (0..rows).filter(|k| pivots.iter().all(|(row, _)| row != k)) {
                let factor = a[other * columns + j] / a[i * columns + j];
                (0..columns).for_each(|k| a[other * columns + k] -= factor * a[i * columns + k]);
                a[other * columns + j] = 0.0;
            }
        }
    }

    #[test]
    fn identity_elimination_takes_the_pivots_and_bits_of_one_that_looks_everywhere() {
        let (rows, columns) = (17, 14);
        for seed in 1..30_u32 {
            // A quarter of the entries, some of them equal, with a row that repeats two others.
            let entry = |k: u32| {
                let chance = k.wrapping_mul(2_654_435_761).wrapping_add(seed.wrapping_mul(40_503)) >> 8;
                if chance.is_multiple_of(4) { f64::from(chance % 19) / 7.0 - 1.3 } else { 0.0 }
            };
            let mut matrix: Vec<f64> = (0..(rows * columns) as u32).map(entry).collect();
            for k in 0..columns {
                matrix[16 * columns + k] = matrix[3 * columns + k] - 2.0 * matrix[9 * columns + k];
            }
            let found = Elimination::new(&matrix, rows, columns, 1e-9);
            assert_eq!((found.pivots, found.reduced), looking_everywhere(&matrix, rows, columns), "seed {seed}");
        }
    }

    #[test]
    fn identity_elimination_finds_rank_solution_and_null_direction() {
        // The third row is the first plus twice the second.
        let matrix = [1.3, 2.1, -0.4, 0.8, -0.9, 0.7, 1.6, 2.2, -0.5, 3.5, 2.8, 5.2];
        let elimination = Elimination::new(&matrix, 3, 4, 1e-12);
        assert_eq!(elimination.rank(), 2);
        assert_eq!(elimination.dependent_rows().len(), 1);
        let b: Vec<f64> = (0..3).map(|i| (0..4).map(|j| matrix[i * 4 + j] * [0.4, -1.1, 0.2, 0.7][j]).sum()).collect();
        let x = elimination.solve(&b);
        for i in 0..3 {
            let row: f64 = (0..4).map(|j| matrix[i * 4 + j] * x[j]).sum();
            assert!((row - b[i]).abs() < ROUND_OFF);
        }
        for free in elimination.free_columns() {
            let direction = elimination.null_direction(free);
            for i in 0..3 {
                let row: f64 = (0..4).map(|j| matrix[i * 4 + j] * direction[j]).sum();
                assert!(row.abs() < ROUND_OFF);
            }
        }
    }
}
