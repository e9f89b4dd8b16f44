//! Eigenvalues of symmetric matrices.

/// Sweeps after which rotations have become round-off: convergence is quadratic, ten are many.
const SWEEPS: usize = 30;

/// Eigenvalues, largest first, and eigenvectors (one row each) of a symmetric `matrix` of `order`, row by row, by the
/// cyclic rotations of Jacobi. Source: G. H. Golub and C. F. Van Loan, "Matrix Computations", 4th edition 2013, section 8.5.
pub(super) fn symmetric_eigen(mut matrix: Vec<f64>, order: usize) -> (Vec<f64>, Vec<Vec<f64>>) {
    let mut vectors: Vec<Vec<f64>> =
        (0..order).map(|i| (0..order).map(|j| f64::from(u8::from(i == j))).collect()).collect();
    let total: f64 = matrix.iter().map(|x| x * x).sum();
    for _ in 0..SWEEPS {
        let mut rest = 0.0;
        for p in 0..order {
            for q in p + 1..order {
                let entry = matrix[p * order + q];
                rest += entry * entry;
                if entry * entry <= 1e-34 * total {
                    continue;
                }
                let theta = (matrix[q * order + q] - matrix[p * order + p]) / (2.0 * entry);
                let tangent = theta.signum() / (theta.abs() + (theta * theta + 1.0).sqrt());
                let cosine = 1.0 / (tangent * tangent + 1.0).sqrt();
                let sine = tangent * cosine;
                // Columns p and q, then rows p and q.
                for row in matrix.chunks_mut(order) {
                    let (a, b) = (row[p], row[q]);
                    (row[p], row[q]) = (cosine * a - sine * b, sine * a + cosine * b);
                }
                let (head, tail) = matrix.split_at_mut(q * order);
                rotate(&mut head[p * order..(p + 1) * order], &mut tail[..order], cosine, sine);
                let (head, tail) = vectors.split_at_mut(q);
                rotate(&mut head[p], &mut tail[0], cosine, sine);
            }
        }
        if rest <= 1e-30 * total {
            break;
        }
    }
    let mut places: Vec<usize> = (0..order).collect();
    places.sort_by(|&a, &b| matrix[b * order + b].total_cmp(&matrix[a * order + a]).then(a.cmp(&b)));
    let values = places.iter().map(|&k| matrix[k * order + k]).collect();
    (values, places.iter().map(|&k| core::mem::take(&mut vectors[k])).collect())
}

fn rotate(p: &mut [f64], q: &mut [f64], cosine: f64, sine: f64) {
    for (a, b) in p.iter_mut().zip(q) {
        (*a, *b) = (cosine * *a - sine * *b, sine * *a + cosine * *b);
    }
}

#[cfg(test)]
mod tests {
    use super::symmetric_eigen;

    #[test]
    fn analytic_a_chain_of_springs_has_its_known_frequencies() {
        // 2 on the diagonal, -1 beside it: 2 - 2 cos(kπ/(n + 1)).
        const TOLERANCE: f64 = 1e-13; // round-off
        let order = 9;
        let entry = |i: usize, j: usize| match i.abs_diff(j) {
            0 => 2.0,
            1 => -1.0,
            _ => 0.0,
        };
        let matrix = (0..order * order).map(|k| entry(k / order, k % order)).collect();
        let (values, vectors) = symmetric_eigen(matrix, order);
        for (k, value) in values.iter().enumerate() {
            let angle = (order - k) as f64 * core::f64::consts::PI / 10.0;
            assert!((value - (2.0 - 2.0 * libm::cos(angle))).abs() < TOLERANCE, "{k}: {value}");
        }
        for (value, vector) in values.iter().zip(&vectors) {
            for i in 0..order {
                let product: f64 = (0..order).map(|j| entry(i, j) * vector[j]).sum();
                assert!((product - value * vector[i]).abs() < TOLERANCE);
            }
        }
    }
}
