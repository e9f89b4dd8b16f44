//! Eigenvalues and eigenvectors of symmetric matrices, by themselves and with a mass matrix.

use super::cholesky::Cholesky;

/// Sweeps after which rotations are round-off: convergence is quadratic, ten are many.
const SWEEPS: usize = 30;
/// Squares of entries beside the diagonal that count as zero, over the sum of the squares of all entries: [`Precision::OfLargest`].
const ROUND_OFF_OF_ALL: f64 = 1e-34;
/// The same over the product of the entries on the diagonal in their row and column: [`Precision::OfEach`].
const ROUND_OFF_OF_EACH: f64 = 1e-40;

/// When eigenvalues are found well enough.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Precision {
    /// To the round-off of the largest one.
    OfLargest,
    /// Each to its own round-off, as far as the matrix determines it: of a positive definite matrix, the small ones too (J. Demmel and K. Veselić,
    /// SIAM Journal on Matrix Analysis and Applications 13 (1992) 1204-1245). It takes a sweep or two more.
    OfEach,
}

/// A = Σ λ_k v_k v_kᵀ, or the like with a mass matrix: [`Self::new`], [`Self::with_mass`]. In the order in which the rotations leave them until
/// they are sorted.
#[derive(Debug, Clone, PartialEq)]
pub struct SymmetricEigen {
    /// λ_k
    pub values: Vec<f64>,
    /// v_k
    pub vectors: Vec<Vec<f64>>,
}

impl SymmetricEigen {
    /// λ and v of A v = λ v with |v| = 1 for a symmetric `matrix` (row by row, `order` × `order`), by the cyclic rotations of Jacobi. Entries
    /// are between 1e-150 and 1e150, or 0; what is not a number gives values that are not.
    ///
    /// Source: G. H. Golub and C. F. Van Loan, "Matrix Computations", 4th edition 2013, section 8.5.
    pub fn new(mut matrix: Vec<f64>, order: usize, precision: Precision) -> Self {
        let mut vectors: Vec<Vec<f64>> =
            (0..order).map(|i| (0..order).map(|j| f64::from(u8::from(i == j))).collect()).collect();
        let total: f64 = matrix.iter().map(|x| x * x).sum();
        let counts_as_zero = |a: &[f64], p: usize, q: usize| {
            let square = a[p * order + q] * a[p * order + q];
            match precision {
                Precision::OfLargest => square <= ROUND_OFF_OF_ALL * total,
                Precision::OfEach => square <= ROUND_OFF_OF_EACH * (a[p * order + p] * a[q * order + q]).abs(),
            }
        };
        for _ in 0..SWEEPS {
            if (0..order).all(|p| (p + 1..order).all(|q| counts_as_zero(&matrix, p, q))) {
                break;
            }
            for p in 0..order {
                for q in p + 1..order {
                    let is_left = precision == Precision::OfLargest && counts_as_zero(&matrix, p, q);
                    if !is_left && matrix[p * order + q] != 0.0 {
                        rotate(&mut matrix, &mut vectors, p, q);
                    }
                }
            }
        }
        Self { values: (0..order).map(|k| matrix[k * order + k]).collect(), vectors }
    }

    /// λ and v of K v = λ M v with vᵀ M v = 1 for symmetric matrices (row by row, `order` × `order`), by the reduction to L⁻¹ K L⁻ᵀ with L Lᵀ = M;
    /// `None` if M is not positive definite to round-off.
    ///
    /// Source: G. H. Golub and C. F. Van Loan, "Matrix Computations", 4th edition 2013, section 8.7.2.
    pub fn with_mass(stiffness: &[f64], mass: &[f64], order: usize, precision: Precision) -> Option<Self> {
        let inverse = Cholesky::new(mass.to_vec(), order)?.inverse_factor();
        let mut reduced = stiffness.to_vec();
        // Columns of a symmetric matrix are its rows: L⁻¹ from one side, then from the other.
        for _ in 0..2 {
            let rows: Vec<Vec<f64>> = reduced.chunks_exact(order.max(1)).map(|row| inverse.multiply(row)).collect();
            for (row, values) in rows.iter().enumerate() {
                values.iter().enumerate().for_each(|(column, value)| reduced[column * order + row] = *value);
            }
        }
        let mut found = Self::new(reduced, order, precision);
        // v = L⁻ᵀ w with the eigenvectors w of the reduced matrix.
        found.vectors.iter_mut().for_each(|vector| *vector = inverse.multiply_transposed(vector));
        Some(found)
    }

    /// The smallest eigenvalue first; equal ones stay in their order.
    pub fn ascending(self) -> Self {
        self.sorted(|a, b| a.total_cmp(&b))
    }

    /// The largest eigenvalue first; equal ones stay in their order.
    pub fn descending(self) -> Self {
        self.sorted(|a, b| b.total_cmp(&a))
    }

    fn sorted(mut self, order: impl Fn(f64, f64) -> std::cmp::Ordering) -> Self {
        let mut places: Vec<usize> = (0..self.values.len()).collect();
        places.sort_by(|&a, &b| order(self.values[a], self.values[b]));
        Self {
            values: places.iter().map(|&k| self.values[k]).collect(),
            vectors: places.iter().map(|&k| std::mem::take(&mut self.vectors[k])).collect(),
        }
    }
}

/// Turns rows and columns p and q of a symmetric matrix, with `vectors` alike, so that their common entry becomes zero.
fn rotate(matrix: &mut [f64], vectors: &mut [Vec<f64>], p: usize, q: usize) {
    let order = vectors.len();
    let half = (matrix[q * order + q] - matrix[p * order + p]) / (2.0 * matrix[p * order + q]);
    let tangent = half.signum() / (half.abs() + (half * half + 1.0).sqrt());
    let cosine = 1.0 / (tangent * tangent + 1.0).sqrt();
    let sine = tangent * cosine;
    let turned = |a: f64, b: f64| (cosine * a - sine * b, sine * a + cosine * b);
    for row in matrix.chunks_exact_mut(order) {
        (row[p], row[q]) = turned(row[p], row[q]);
    }
    let (head, tail) = matrix.split_at_mut(q * order);
    for (a, b) in head[p * order..(p + 1) * order].iter_mut().zip(&mut tail[..order]) {
        (*a, *b) = turned(*a, *b);
    }
    let (head, tail) = vectors.split_at_mut(q);
    for (a, b) in head[p].iter_mut().zip(&mut tail[0]) {
        (*a, *b) = turned(*a, *b);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TOLERANCE: f64 = 1e-13; // round-off

    #[test]
    fn analytic_a_chain_of_springs_has_its_known_frequencies() {
        // 2 on the diagonal, -1 beside it: 2 - 2 cos(kπ/(n + 1)).
        let order = 9;
        let entry = |i: usize, j: usize| match i.abs_diff(j) {
            0 => 2.0,
            1 => -1.0,
            _ => 0.0,
        };
        let matrix: Vec<f64> = (0..order * order).map(|k| entry(k / order, k % order)).collect();
        for precision in [Precision::OfLargest, Precision::OfEach] {
            let found = SymmetricEigen::new(matrix.clone(), order, precision).descending();
            for (k, value) in found.values.iter().enumerate() {
                let angle = (order - k) as f64 * core::f64::consts::PI / 10.0;
                assert!((value - (2.0 - 2.0 * libm::cos(angle))).abs() < TOLERANCE, "{k}: {value}");
            }
            for (value, vector) in found.values.iter().zip(&found.vectors) {
                for i in 0..order {
                    let product: f64 = (0..order).map(|j| entry(i, j) * vector[j]).sum();
                    assert!((product - value * vector[i]).abs() < TOLERANCE);
                }
            }
        }
    }

    #[test]
    fn analytic_a_small_eigenvalue_keeps_its_digits() {
        // Scaled by D = diag(1e8, 1, 1e-8) from [[1, ε, 0], [ε, 1, ε], [0, ε, 1]]: det = D² (1 - 2 ε²), and λ_3 = det/(λ_1 λ_2).
        let epsilon = 0.1;
        let scales = [1e8, 1.0, 1e-8];
        let core = [1.0, epsilon, 0.0, epsilon, 1.0, epsilon, 0.0, epsilon, 1.0];
        let matrix: Vec<f64> = (0..9).map(|at| core[at] * scales[at / 3] * scales[at % 3]).collect();
        let found = SymmetricEigen::new(matrix, 3, Precision::OfEach).ascending();
        let product = found.values.iter().product::<f64>();
        assert!((product / (1.0 - 2.0 * epsilon * epsilon) - 1.0).abs() < TOLERANCE, "{product}");
        let least = 1e-16 * (1.0 - 2.0 * epsilon * epsilon) / (1.0 - epsilon * epsilon);
        assert!((found.values[0] / least - 1.0).abs() < TOLERANCE, "{} for {least}", found.values[0]);
    }

    #[test]
    fn analytic_two_masses_between_three_springs() {
        // Masses 2 and 3, springs 5, 7 and 11: 6 λ² - 72 λ + 167 = 0.
        let (mass, stiffness) = ([2.0, 0.0, 0.0, 3.0], [12.0, -7.0, -7.0, 18.0]);
        let found = SymmetricEigen::with_mass(&stiffness, &mass, 2, Precision::OfEach).unwrap().ascending();
        let root = (72.0_f64 * 72.0 - 4.0 * 6.0 * 167.0).sqrt();
        for (k, exact) in [(72.0 - root) / 12.0, (72.0 + root) / 12.0].into_iter().enumerate() {
            let (value, v) = (found.values[k], &found.vectors[k]);
            assert!((value - exact).abs() < 1e-14 * exact, "{value} for {exact}");
            assert!((2.0 * v[0] * v[0] + 3.0 * v[1] * v[1] - 1.0).abs() < TOLERANCE);
            assert!((12.0 * v[0] - 7.0 * v[1] - value * 2.0 * v[0]).abs() < TOLERANCE);
        }
        assert_eq!(SymmetricEigen::with_mass(&stiffness, &[1.0, 2.0, 2.0, 1.0], 2, Precision::OfEach), None);
        assert_eq!(SymmetricEigen::with_mass(&[], &[], 0, Precision::OfEach).unwrap().values, [0.0; 0]);
    }
}
