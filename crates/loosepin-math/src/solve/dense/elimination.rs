//! Gaussian elimination of square matrices: solutions, inverses and determinants. Rows without a part in a pivot are left alone: the loops of
//! many links share few coordinates.

use crate::Real;

/// Reduces the n × n matrix `a` to L and U with P A = L U, and `right`, n rows of `columns` numbers, to L⁻¹ P `right`: U on and above the diagonal
/// of `a`, L without its ones below; all row by row. False where `choose` finds no row for a pivot.
///
/// `choose` gives the row of the pivot in a column, `over` the division by a pivot, and `is_nothing` whether a share of the pivot's row need not be
/// taken off.
#[inline(always)]
pub(super) fn reduce<T: Real, Over: Fn(T) -> T>(
    a: &mut [T],
    n: usize,
    right: &mut [T],
    columns: usize,
    mut choose: impl FnMut(&[T], usize) -> Option<usize>,
    over: impl Fn(T) -> Over,
    is_nothing: impl Fn(T) -> bool,
) -> bool {
    for j in 0..n {
        let Some(best) = choose(a, j) else { return false };
        if best != j {
            (0..n).for_each(|k| a.swap(j * n + k, best * n + k));
            (0..columns).for_each(|k| right.swap(j * columns + k, best * columns + k));
        }
        let over = over(a[j * n + j]);
        for i in j + 1..n {
            let share = over(a[i * n + j]);
            a[i * n + j] = share;
            if is_nothing(share) {
                continue;
            }
            take_off(a, [i * n + j + 1, j * n + j + 1], n - j - 1, share);
            take_off(right, [i * columns, j * columns], columns, share);
        }
    }
    true
}

/// Subtracts `share` × `numbers[of..of + count]` from `numbers[from..from + count]`; `from` lies behind `of + count`.
#[inline(always)]
fn take_off<T: Real>(numbers: &mut [T], [from, of]: [usize; 2], count: usize, share: T) {
    let (above, below) = numbers.split_at_mut(from);
    for (entry, pivot) in below[..count].iter_mut().zip(&above[of..of + count]) {
        *entry -= share * *pivot;
    }
}

/// U⁻¹ of n rows of `columns` numbers, in place.
#[inline(always)]
fn substitute_back<T: Real>(a: &[T], n: usize, right: &mut [T], columns: usize) {
    for i in (0..n).rev() {
        for k in i + 1..n {
            let (above, below) = right.split_at_mut(k * columns);
            for (entry, known) in above[i * columns..(i + 1) * columns].iter_mut().zip(&below[..columns]) {
                *entry -= a[i * n + k] * *known;
            }
        }
        for entry in &mut right[i * columns..(i + 1) * columns] {
            *entry = *entry / a[i * n + i];
        }
    }
}

/// Solves A X = B in place by elimination with row exchanges: `a` is n × n and destroyed, `b`, n rows of `columns` numbers, becomes X; both row by
/// row. Gives the ratio of the smallest to the largest pivot: zero where A is singular, or its pivots are no numbers, and then `b` is worthless.
#[inline(always)]
fn solve_columns(a: &mut [f64], n: usize, b: &mut [f64], columns: usize) -> f64 {
    let (mut smallest, mut largest) = (f64::INFINITY, 0.0_f64);
    let choose = |a: &[f64], j: usize| {
        let mut best = j;
        for i in j + 1..n {
            if a[i * n + j].abs() > a[best * n + j].abs() {
                best = i;
            }
        }
        let size = a[best * n + j].abs();
        smallest = smallest.min(size);
        largest = largest.max(size);
        (size > 0.0).then_some(best)
    };
    if !reduce(a, n, b, columns, choose, |pivot| move |entry| entry / pivot, |share| share == 0.0) {
        return 0.0;
    }
    substitute_back(a, n, b, columns);
    if largest > 0.0 { smallest / largest } else { 1.0 }
}

/// Solves the n × n system A x = b (row by row) in place by elimination with row exchanges: `a` is destroyed, `b` becomes x. Gives the ratio of the
/// smallest to the largest pivot: zero where A is singular, or its pivots are no numbers, and then `b` is worthless.
pub fn solve_square(a: &mut [f64], n: usize, b: &mut [f64]) -> f64 {
    solve_columns(a, n, b, 1)
}

/// A⁻¹ of an n × n matrix, both row by row; `None` if it is singular. Its columns have the bits that [`solve_square`] gives for unit vectors.
pub fn inverse(mut a: Vec<f64>, n: usize) -> Option<Vec<f64>> {
    let mut inverse: Vec<f64> = (0..n * n).map(|at| f64::from(u8::from(at / n == at % n))).collect();
    (solve_columns(&mut a, n, &mut inverse, n) > 0.0).then_some(inverse)
}

/// Solves A X = B in place by elimination in the order of the rows: `a` is n × n and destroyed, `b`, n rows of `columns` numbers, becomes X; both row
/// by row. The pivots are on the diagonal of `a` afterwards. For a matrix near the identity; false as soon as `is_pivot` refuses a pivot.
///
/// No choice depends on a value but that: it runs on lanes, on intervals and as it is written down for machine code.
#[inline(always)]
pub fn solve_in_order<T: Real>(
    a: &mut [T],
    n: usize,
    b: &mut [T],
    columns: usize,
    is_pivot: impl Fn(T) -> bool,
) -> bool {
    let choose = |a: &[T], j: usize| is_pivot(a[j * n + j]).then_some(j);
    let over = |pivot: T| {
        let inverse = T::one() / pivot;
        move |entry: T| entry * inverse
    };
    let is_reduced = reduce(a, n, b, columns, choose, over, |_| false);
    if is_reduced {
        substitute_back(a, n, b, columns);
    }
    is_reduced
}

/// Determinant of the n × n matrix `a` (row by row), which is destroyed.
pub fn determinant(a: &mut [f64], n: usize) -> f64 {
    product_of_pivots(a, n, |pivot| pivot)
}

/// Sign of the determinant of the n × n matrix `a` (row by row), which is destroyed: 1, -1, or 0 where it is singular. The determinant itself may
/// be too large or too small for a number.
pub fn determinant_sign(a: &mut [f64], n: usize) -> f64 {
    product_of_pivots(a, n, f64::signum)
}

/// Product of `part` of each pivot, with the sign of the row exchanges; zero where a pivot is.
fn product_of_pivots(a: &mut [f64], n: usize, part: impl Fn(f64) -> f64) -> f64 {
    let mut product = 1.0;
    let choose = |a: &[f64], j: usize| {
        let best = largest_in_column(a, n, j);
        product *= part(a[best * n + j]);
        if best != j {
            product = -product;
        }
        (a[best * n + j] != 0.0).then_some(best)
    };
    let is_regular = reduce(a, n, &mut [], 0, choose, |pivot| move |entry| entry / pivot, |share| share == 0.0);
    if is_regular { product } else { 0.0 }
}

/// The row of the largest entry of column j, from row j on: the last of equal ones. What is not a number counts as largest.
#[inline(always)]
pub(super) fn largest_in_column(a: &[f64], n: usize, j: usize) -> usize {
    (j..n).max_by(|&i, &k| a[i * n + j].abs().total_cmp(&a[k * n + j].abs())).unwrap_or(j)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Interval;

    /// Round-off of systems of order one with four unknowns.
    const ROUND_OFF: f64 = 1e-13;
    const MATRIX: [f64; 9] = [0.0, 2.3, -0.4, 1.7, 0.6, 3.1, -0.9, 0.2, 0.5];

    #[test]
    fn identity_square_solution_and_singular_matrix() {
        let x = [0.7, -1.3, 2.9];
        let mut b: Vec<f64> = (0..3).map(|i| (0..3).map(|j| MATRIX[i * 3 + j] * x[j]).sum()).collect();
        assert!(solve_square(&mut MATRIX.clone(), 3, &mut b) > 0.1);
        for (solved, exact) in b.iter().zip(x) {
            assert!((solved - exact).abs() < ROUND_OFF);
        }
        let mut singular = [1.3, 2.6, 0.4, 0.8];
        assert!(solve_square(&mut singular, 2, &mut [0.3, 0.9]) < 1e-15);
        assert_eq!(solve_square(&mut [f64::NAN; 4], 2, &mut [0.3, 0.9]), 0.0);
        assert_eq!(solve_square(&mut [], 0, &mut []), 1.0);
    }

    #[test]
    fn identity_columns_of_the_inverse_have_the_bits_of_single_solutions() {
        let found = inverse(MATRIX.to_vec(), 3).unwrap();
        for column in 0..3 {
            let mut unit = [0.0; 3];
            unit[column] = 1.0;
            solve_square(&mut MATRIX.clone(), 3, &mut unit);
            assert_eq!(unit, [0, 1, 2].map(|row| found[3 * row + column]));
        }
        assert_eq!(inverse(vec![1.0, 2.0, 2.0, 4.0], 2), None);
        assert_eq!(inverse(Vec::new(), 0), Some(Vec::new()));
    }

    #[test]
    fn identity_elimination_in_order_holds_the_solution_on_intervals() {
        let matrix = [1.1, 0.2, -0.1, -0.05, 0.9, 0.1, 0.15, -0.2, 1.05];
        let right = [0.3, 1.0, -0.7, 0.0, 0.4, 2.0];
        let (mut a, mut b) = (matrix.map(Interval::from_f64), right.map(Interval::from_f64));
        assert!(solve_in_order(&mut a, 3, &mut b, 2, |pivot| pivot.low() > 0.0));
        for column in 0..2 {
            let mut plain = [0, 1, 2].map(|row| right[2 * row + column]);
            solve_square(&mut matrix.clone(), 3, &mut plain);
            for (row, value) in plain.into_iter().enumerate() {
                let [low, high] = [b[2 * row + column].low(), b[2 * row + column].high()];
                assert!(low < value + ROUND_OFF && value - ROUND_OFF < high && high - low < ROUND_OFF);
            }
        }
        assert!(!solve_in_order(&mut [Interval::around_zero(0.1)], 1, &mut [Interval::ZERO], 1, |p| p.low() > 0.0));
    }

    #[test]
    fn analytic_determinant_with_row_exchanges() {
        // Sarrus: 2.3·3.1·(-0.9) + (-0.4)·1.7·0.2 - (-0.4)·0.6·(-0.9) - 0.5·1.7·2.3.
        let exact = 2.3 * 3.1 * -0.9 - 0.4 * 1.7 * 0.2 - 0.4 * 0.6 * 0.9 - 0.5 * 1.7 * 2.3;
        assert!((determinant(&mut MATRIX.clone(), 3) - exact).abs() < ROUND_OFF);
        assert_eq!(determinant_sign(&mut MATRIX.clone(), 3), exact.signum());
        assert_eq!(determinant_sign(&mut [1e-200, 0.0, 0.0, -1e-200], 2), -1.0);
        assert_eq!(determinant_sign(&mut [1.3, 2.6, 0.4, 0.8], 2), 0.0);
        assert_eq!(determinant(&mut [1.3, 2.6, 0.4, 0.8], 2), 0.0);
        assert_eq!(determinant(&mut [], 0), 1.0);
    }
}
