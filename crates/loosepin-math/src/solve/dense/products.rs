//! Products of vectors and matrices whose order of operations never changes.

use crate::fused::with_vector_instructions;

/// Scalar product, in eight partial sums so that it can be vectorised, always in this order.
pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    dot_in_lanes(a, b)
}

#[inline(always)]
pub(super) fn dot_in_lanes(a: &[f64], b: &[f64]) -> f64 {
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

/// AᵀA of a matrix A with rows of `size` entries, its rows added in their order; the lower triangle, as [`super::Cholesky::new`] wants it, the
/// rest is zero.
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
