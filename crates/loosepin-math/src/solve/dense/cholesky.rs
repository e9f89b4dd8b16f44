//! Symmetric positive definite matrices: Cholesky factor and inverse, in a fixed order of operations.
//!
//! A library would choose its instructions at run time, and with them the last bits of every search and of every fit that
//! follows. Where this processor has wide vectors, loops are compiled for them too, in the same order of the same operations.

use super::products::dot_in_lanes;
use super::triangle::LowerTriangle;
use crate::fused::with_vector_instructions;
use crate::solve::four_rows::FourTriangleRows;

/// A symmetric positive definite matrix A, factorised as A = L Lᵀ:
///
/// ```text
/// L_ij = (A_ij - Σ_(k<j) L_ik L_jk)/L_jj for j < i,   L_ii = √(A_ii - Σ_(k<i) L_ik²)
/// ```
///
/// Source: G. H. Golub and C. F. Van Loan, "Matrix Computations", 4th edition 2013, section 4.2. The default is that of a matrix without rows.
#[derive(Debug, Clone, Default)]
pub struct Cholesky {
    order: usize,
    /// Rows of L, up to its diagonal.
    factor: Vec<f64>,
}

impl Cholesky {
    /// Factorises `matrix` (row by row, `order` × `order`, of which the lower triangle is read); `None` if it is not positive definite to round-off.
    pub fn new(matrix: Vec<f64>, order: usize) -> Option<Self> {
        Self::with_known_rows(matrix, order, 0)
    }

    /// Factorises `matrix`, to whose first rows and columns, those of this one, others have been appended: with the bits of [`Self::new`],
    /// by what the appended rows take.
    pub fn appended(&self, mut matrix: Vec<f64>, order: usize) -> Option<Self> {
        for (row, own) in matrix.chunks_mut(order.max(1)).enumerate().take(self.order) {
            own[..=row].copy_from_slice(self.row(row));
        }
        Self::with_known_rows(matrix, order, self.order)
    }

    /// Factorises a matrix that need not be positive definite to round-off, of which `matrix` has the lower triangle, row by row: each L_ii² is at
    /// least the number in `least`, positive, for its row. Where none is below, the bits are those of [`Self::new`].
    pub fn with_raised_pivots(matrix: &[f64], least: &[f64]) -> Self {
        let order = least.len();
        debug_assert_eq!(matrix.len(), order * order);
        let mut raised = Self::default();
        for (row, (entries, least)) in matrix.chunks(order.max(1)).zip(least).enumerate() {
            raised.append(&entries[..row], entries[row], |rest| Some(rest.max(*least)));
        }
        raised
    }

    /// Appends a row to the matrix: `products` are its entries before the diagonal, `square` the one there. False, and nothing is changed, where
    /// what is left of `square` for L_ii² is not more than `least_share` of it: where the matrix would be singular.
    pub fn push(&mut self, products: &[f64], square: f64, least_share: f64) -> bool {
        self.append(products, square, |rest| (rest > least_share * square).then_some(rest))
    }

    /// Appends a row whose L_ii² is what `square_of` makes of what is left; nothing where it makes nothing of it.
    fn append(&mut self, products: &[f64], square: f64, square_of: impl Fn(f64) -> Option<f64>) -> bool {
        let start = self.factor.len();
        for (j, product) in products[..self.order].iter().enumerate() {
            let known = self.row(j);
            let entry = (product - dot_in_lanes(&known[..j], &self.factor[start..])) / known[j];
            self.factor.push(entry);
        }
        let own = &self.factor[start..];
        let Some(square) = square_of(square - dot_in_lanes(own, own)) else {
            self.factor.truncate(start);
            return false;
        };
        self.factor.push(square.sqrt());
        self.order += 1;
        true
    }

    /// Factorises `matrix`, whose first `known` rows are those of the factor already.
    fn with_known_rows(mut matrix: Vec<f64>, order: usize, known: usize) -> Option<Self> {
        let is_definite = with_vector_instructions(
            #[inline(always)]
            || factorise(&mut matrix, order, known),
        );
        if !is_definite {
            return None;
        }
        for row in 1..order {
            matrix.copy_within(row * order..=row * order + row, row * (row + 1) / 2);
        }
        matrix.truncate(order * (order + 1) / 2);
        Some(Self { order, factor: matrix })
    }

    /// Number of rows.
    pub fn order(&self) -> usize {
        self.order
    }

    /// A row of L, up to its diagonal.
    #[inline(always)]
    pub fn row(&self, row: usize) -> &[f64] {
        let start = row * (row + 1) / 2;
        &self.factor[start..=start + row]
    }

    /// Multiplies L by a number, and the matrix by its square.
    pub fn scale(&mut self, factor: f64) {
        self.factor.iter_mut().for_each(|entry| *entry *= factor);
    }

    /// ln det of the matrix.
    pub fn ln_determinant(&self) -> f64 {
        2.0 * (0..self.order).map(|i| libm::log(self.row(i)[i])).sum::<f64>()
    }

    /// Solves L x = b in place.
    pub fn solve_lower(&self, right: &mut [f64]) {
        for i in 0..self.order {
            let (done, rest) = right.split_at_mut(i);
            let row = self.row(i);
            rest[0] = (rest[0] - dot_in_lanes(&row[..i], done)) / row[i];
        }
    }

    /// Solves A x = b in place.
    pub fn solve(&self, right: &mut [f64]) {
        self.solve_lower(right);
        for i in (0..self.order).rev() {
            let row = self.row(i);
            right[i] /= row[i];
            let value = right[i];
            for (entry, factor) in right.iter_mut().zip(&row[..i]) {
                *entry -= factor * value;
            }
        }
    }

    /// L⁻¹.
    pub fn inverse_factor(&self) -> LowerTriangle {
        self.inverse_factor_after(None)
    }

    /// L⁻¹, whose first rows are those `known` where this factor was appended to another.
    pub fn inverse_factor_after(&self, known: Option<&LowerTriangle>) -> LowerTriangle {
        let order = self.order;
        let mut entries = vec![0.0; order * order];
        let first = known.map_or(0, |known| known.0.order());
        for (row, own) in entries.chunks_mut(order.max(1)).enumerate().take(first) {
            own.iter_mut()
                .zip(known.into_iter().flat_map(|known| known.0.row(row)))
                .for_each(|(own, entry)| *own = entry);
        }
        with_vector_instructions(
            #[inline(always)]
            || self.invert_into(&mut entries, first),
        );
        LowerTriangle(FourTriangleRows::new(&entries, order))
    }

    /// Row i of L⁻¹ is (e_i - Σ_(j<i) L_ij row_j)/L_ii, from row `first` on; these are zero before.
    #[inline(always)]
    fn invert_into(&self, rows: &mut [f64], first: usize) {
        let order = self.order;
        for i in first..order {
            let (done, rest) = rows.split_at_mut(i * order);
            let row = &mut rest[..=i];
            let factors = self.row(i);
            row[i] = 1.0;
            for (j, (known, factor)) in done.chunks(order).zip(factors).enumerate() {
                for (entry, value) in row.iter_mut().zip(&known[..=j]) {
                    *entry -= factor * value;
                }
            }
            for entry in row {
                *entry /= factors[i];
            }
        }
    }

    /// The inverse, row by row.
    pub fn inverse(&self) -> Vec<f64> {
        let order = self.order;
        let mut inverse = vec![0.0; order * order];
        for (column, row) in inverse.chunks_mut(order.max(1)).enumerate() {
            row[column] = 1.0;
            self.solve(row);
        }
        inverse
    }
}

/// Puts the factor L in the place of the lower triangle of `matrix`, whose first `known` rows are those of L; whether it is positive definite to
/// round-off.
#[inline(always)]
fn factorise(matrix: &mut [f64], order: usize, known: usize) -> bool {
    for j in 0..order {
        for i in j.max(known)..order {
            let (row_i, row_j) = (&matrix[i * order..i * order + j], &matrix[j * order..j * order + j]);
            let sum = matrix[i * order + j] - dot_in_lanes(row_i, row_j);
            if i == j {
                if sum <= 0.0 || !sum.is_finite() {
                    return false;
                }
                matrix[i * order + j] = sum.sqrt();
            } else {
                matrix[i * order + j] = sum / matrix[j * order + j];
            }
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use super::Cholesky;
    use crate::solve::dense::{dot, multiply};

    #[test]
    fn identity_the_inverse_times_the_matrix_is_the_identity() {
        const TOLERANCE: f64 = 1e-12; // round-off times the condition number, about 100
        let order = 7;
        let matrix: Vec<f64> = (0..order * order)
            .map(|k| (k / order, k % order))
            .map(|(i, j)| libm::exp(-0.3 * (i as f64 - j as f64).abs()) + if i == j { 0.5 } else { 0.0 })
            .collect();
        let cholesky = Cholesky::new(matrix.clone(), order).unwrap();
        let inverse = cholesky.inverse();
        for i in 0..order {
            let row = multiply(&matrix, &inverse[i * order..(i + 1) * order]);
            for (j, value) in row.into_iter().enumerate() {
                assert!((value - f64::from(u8::from(i == j))).abs() < TOLERANCE);
            }
        }
        let vector: Vec<f64> = (0..order).map(|i| 0.3 + i as f64).collect();
        let white = cholesky.inverse_factor().multiply(&vector);
        let expected = dot(&vector, &multiply(&inverse, &vector));
        assert!((dot(&white, &white) - expected).abs() < TOLERANCE * expected);
        let back = cholesky.inverse_factor().multiply_transposed(&white);
        assert!(back.iter().zip(multiply(&inverse, &vector)).all(|(a, b)| (a - b).abs() < TOLERANCE));
        let double = Cholesky::new(matrix.iter().map(|x| 2.0 * x).collect(), order).unwrap();
        let expected = cholesky.ln_determinant() + 7.0 * 2.0_f64.ln();
        assert!((double.ln_determinant() - expected).abs() < TOLERANCE);
    }

    #[test]
    fn identity_appended_rows_give_the_bits_of_the_whole_matrix() {
        let entry = |i: usize, j: usize| {
            let [x, y] = [i, j].map(|k| (1.7 * k as f64 + 0.3).sin());
            libm::exp(-2.0 * (x - y) * (x - y)) + if i == j { 1e-6 } else { 0.0 }
        };
        let matrix = |order: usize| -> Vec<f64> {
            (0..order * order)
                .map(|k| (k / order, k % order))
                .map(|(i, j)| if j <= i { entry(i, j) } else { 0.0 })
                .collect()
        };
        for known in [0, 1, 2, 7, 8, 9, 20] {
            let first = Cholesky::new(matrix(known), known).unwrap();
            for order in [known, known + 1, known + 3, known + 11] {
                let whole = Cholesky::new(matrix(order), order).unwrap();
                let appended = first.appended(matrix(order), order).unwrap();
                assert_eq!(bits(&appended.factor), bits(&whole.factor), "{known} of {order}");
                let inverse = appended.inverse_factor_after(Some(&first.inverse_factor()));
                let (vector, whole) = ((0..order).map(|i| 0.3 + i as f64).collect::<Vec<_>>(), whole.inverse_factor());
                assert_eq!(bits(&inverse.multiply(&vector)), bits(&whole.multiply(&vector)), "{known} of {order}");
                assert_eq!(bits(&inverse.gram()), bits(&whole.gram()), "{known} of {order}");
            }
        }
        // The leading part is the one of the factor, whatever else stands there; what is appended makes it singular.
        let first = Cholesky::new(vec![4.0], 1).unwrap();
        assert!(first.appended(vec![4.0, 0.0, 4.0, 4.0], 2).is_none());
    }

    #[test]
    fn identity_rows_pushed_one_after_the_other_give_the_bits_of_the_whole_matrix() {
        let order = 21;
        let entry = |i: usize, j: usize| libm::exp(-0.2 * (i as f64 - j as f64).abs()) + f64::from(u8::from(i == j));
        let matrix: Vec<f64> = (0..order * order).map(|k| entry(k / order, k % order)).collect();
        let whole = Cholesky::new(matrix.clone(), order).unwrap();
        let mut pushed = Cholesky::default();
        for row in 0..order {
            let products: Vec<f64> = (0..row).map(|column| entry(row, column)).collect();
            assert!(pushed.push(&products, 2.0, 1e-12));
            // A row that repeats another is refused, and leaves nothing behind.
            let again: Vec<f64> = (0..=row).map(|column| entry(row, column)).collect();
            assert!(!pushed.push(&again, 2.0, 1e-12));
        }
        let raised = Cholesky::with_raised_pivots(&matrix, &vec![1e-12; order]);
        for factor in [pushed, raised] {
            assert_eq!((factor.order(), bits(&factor.factor)), (order, bits(&whole.factor)));
        }
    }

    #[test]
    fn analytic_raised_pivots() {
        // The second row would leave 1 - 4 = -3.
        let raised = Cholesky::with_raised_pivots(&[1.0, 0.0, 2.0, 1.0], &[0.25, 0.25]);
        assert_eq!((raised.row(0), raised.row(1)), (&[1.0][..], &[2.0, 0.5][..]));
        let mut right = [1.0, 3.0];
        raised.solve_lower(&mut right);
        assert_eq!(right, [1.0, 2.0]);
        let mut doubled = raised;
        doubled.scale(2.0);
        assert_eq!((doubled.row(1), doubled.ln_determinant()), (&[4.0, 1.0][..], 2.0 * 2.0_f64.ln()));
    }

    fn bits(values: &[f64]) -> Vec<u64> {
        values.iter().map(|value| value.to_bits()).collect()
    }

    #[test]
    fn a_matrix_that_is_not_positive_definite_has_no_factor() {
        assert!(Cholesky::new(vec![1.0, 2.0, 2.0, 1.0], 2).is_none());
    }
}
