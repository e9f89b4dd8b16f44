//! Small dense symmetric matrices: Cholesky factor and inverse, in a fixed order of operations.
//!
//! A library would choose its instructions at run time, and with them the last bits of every search and of every fit that
//! follows. Where this processor has wide vectors, loops are compiled for them too, in the same order of the same operations.

use crate::fused::with_vector_instructions;
use crate::solve::four_rows::FourTriangleRows;

/// A symmetric positive definite matrix, factorised as L Lᵀ.
#[derive(Debug, Clone)]
pub struct Cholesky {
    order: usize,
    /// Rows of L, full storage.
    factor: Vec<f64>,
}

impl Cholesky {
    /// Factorises `matrix` (row by row, `order` x `order`); `None` if it is not positive definite to round-off.
    pub fn new(matrix: Vec<f64>, order: usize) -> Option<Self> {
        Self::with_known_rows(matrix, order, 0)
    }

    /// Factorises `matrix`, to whose first rows and columns, those of this one, others have been appended: with the bits of [`Self::new`],
    /// by what the appended rows take.
    pub fn appended(&self, mut matrix: Vec<f64>, order: usize) -> Option<Self> {
        for (row, known) in matrix.chunks_mut(order.max(1)).zip(self.factor.chunks(self.order.max(1))) {
            row[..self.order].copy_from_slice(known);
            row[self.order..].fill(0.0);
        }
        Self::with_known_rows(matrix, order, self.order)
    }

    /// Factorises `matrix`, whose first `known` rows are those of the factor already.
    fn with_known_rows(mut matrix: Vec<f64>, order: usize, known: usize) -> Option<Self> {
        let is_definite = with_vector_instructions(
            #[inline(always)]
            || factorise(&mut matrix, order, known),
        );
        is_definite.then_some(Self { order, factor: matrix })
    }

    /// Number of rows.
    pub fn order(&self) -> usize {
        self.order
    }

    /// ln det of the matrix.
    pub fn ln_determinant(&self) -> f64 {
        2.0 * (0..self.order).map(|i| libm::log(self.factor[i * self.order + i])).sum::<f64>()
    }

    /// Solves A x = b in place.
    pub fn solve(&self, right: &mut [f64]) {
        let order = self.order;
        for i in 0..order {
            let (done, rest) = right.split_at_mut(i);
            rest[0] = (rest[0] - dot(&self.factor[i * order..i * order + i], done)) / self.factor[i * order + i];
        }
        for i in (0..order).rev() {
            right[i] /= self.factor[i * order + i];
            let value = right[i];
            for (j, entry) in right.iter_mut().enumerate().take(i) {
                *entry -= self.factor[i * order + j] * value;
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
            row[i] = 1.0;
            for (j, known) in done.chunks(order).enumerate() {
                let factor = self.factor[i * order + j];
                for (entry, value) in row.iter_mut().zip(&known[..=j]) {
                    *entry -= factor * value;
                }
            }
            for entry in row {
                *entry /= self.factor[i * order + i];
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

/// A lower triangular matrix.
#[derive(Debug, Clone)]
pub struct LowerTriangle(FourTriangleRows);

impl LowerTriangle {
    /// T x
    pub fn multiply(&self, vector: &[f64]) -> Vec<f64> {
        self.0.multiply(vector)
    }

    /// Tᵀ x
    pub fn multiply_transposed(&self, vector: &[f64]) -> Vec<f64> {
        self.0.multiply_transposed(vector)
    }

    /// T x of N vectors side by side.
    pub fn multiply_each<const N: usize>(&self, vectors: &[[f64; N]]) -> Vec<[f64; N]> {
        self.0.multiply_each(vectors)
    }

    /// Tᵀ x of N vectors side by side.
    pub fn multiply_transposed_each<const N: usize>(&self, vectors: &[[f64; N]]) -> Vec<[f64; N]> {
        self.0.multiply_transposed_each(vectors)
    }

    /// TᵀT, row by row, its lower triangle; the rest is zero.
    pub fn gram(&self) -> Vec<f64> {
        let order = self.0.order();
        let mut product = vec![0.0; order * order];
        for last in 0..order {
            let row: Vec<f64> = self.0.row(last).collect();
            for (i, factor) in row.iter().enumerate() {
                if *factor != 0.0 {
                    for (sum, entry) in product[i * order..=i * order + i].iter_mut().zip(&row) {
                        *sum += factor * entry;
                    }
                }
            }
        }
        product
    }

    /// Sum of squares of each column.
    pub fn column_squares(&self) -> Vec<f64> {
        self.0.column_squares()
    }
}

/// Puts the factor L in the place of `matrix`, whose first `known` rows are those of L; whether it is positive definite to round-off.
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
        for i in 0..j {
            matrix[i * order + j] = 0.0;
        }
    }
    true
}

/// Scalar product, in eight partial sums so that it can be vectorised, always in this order.
pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    dot_in_lanes(a, b)
}

#[inline(always)]
fn dot_in_lanes(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; 8];
    let (a_blocks, b_blocks) = (a.chunks_exact(8), b.chunks_exact(8));
    let rest: f64 = a_blocks.remainder().iter().zip(b_blocks.remainder()).map(|(x, y)| x * y).sum();
    for (x, y) in a_blocks.zip(b_blocks) {
        for lane in 0..8 {
            sums[lane] += x[lane] * y[lane];
        }
    }
    // Kept apart from the loop, which would otherwise shuffle its operands into the order of this sum and take half as long again.
    let [a, b, c, d, e, f, g, h] = core::hint::black_box(sums);
    ((a + b) + (c + d)) + ((e + f) + (g + h)) + rest
}

/// The product of a matrix (row by row) and a vector.
pub fn multiply(matrix: &[f64], vector: &[f64]) -> Vec<f64> {
    let mut product = vec![0.0; matrix.len().div_ceil(vector.len().max(1))];
    with_vector_instructions(
        #[inline(always)]
        || {
            for (row, entry) in matrix.chunks(vector.len().max(1)).zip(&mut product) {
                *entry = dot_in_lanes(row, vector);
            }
        },
    );
    product
}

/// AᵀA of a matrix A with rows of `size` entries, its rows added in their order; the lower triangle, as [`Cholesky::new`] wants it, the rest
/// is zero.
pub fn gram(rows: &[f64], size: usize) -> Vec<f64> {
    let mut gram = vec![0.0; size * size];
    with_vector_instructions(
        #[inline(always)]
        || {
            for row in rows.chunks(size.max(1)) {
                for (i, (factor, sums)) in row.iter().zip(gram.chunks_mut(size.max(1))).enumerate() {
                    for (sum, entry) in sums[..=i].iter_mut().zip(row) {
                        *sum += factor * entry;
                    }
                }
            }
        },
    );
    gram
}

#[cfg(test)]
mod tests {
    use super::{Cholesky, dot, multiply};

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

    fn bits(values: &[f64]) -> Vec<u64> {
        values.iter().map(|value| value.to_bits()).collect()
    }

    #[test]
    fn a_matrix_that_is_not_positive_definite_has_no_factor() {
        assert!(Cholesky::new(vec![1.0, 2.0, 2.0, 1.0], 2).is_none());
    }
}
