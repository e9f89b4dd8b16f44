//! Eigenvalues of a small stiffness matrix with its mass matrix, and the damping that goes with them.

use loosepin_math::dense::{Cholesky, LowerTriangle, multiply};

/// Sweeps of Jacobi's rotations; four are enough for twenty rows.
const SWEEPS: usize = 30;
/// An entry beside the diagonal this small against the diagonal changes nothing any more.
const ROUND_OFF: f64 = 1e-40;

/// L⁻¹ K L⁻ᵀ with L Lᵀ = M, and L⁻¹; `None` if M is not positive definite.
fn reduced(mass: &[f64], stiffness: &[f64], n: usize) -> Option<(Vec<f64>, LowerTriangle)> {
    let inverse = Cholesky::new(mass.to_vec(), n)?.inverse_factor();
    let mut matrix = stiffness.to_vec();
    // Columns of a symmetric matrix are its rows: L⁻¹ from one side, then from the other.
    for _ in 0..2 {
        let rows: Vec<Vec<f64>> = matrix.chunks_exact(n).map(|row| inverse.multiply(row)).collect();
        for (row, values) in rows.iter().enumerate() {
            values.iter().enumerate().for_each(|(column, value)| matrix[column * n + row] = *value);
        }
    }
    Some((matrix, inverse))
}

/// Eigenvalues, and eigenvectors in columns, of a symmetric matrix: Jacobi's rotations.
fn jacobi(mut a: Vec<f64>, n: usize) -> (Vec<f64>, Vec<f64>) {
    let mut vectors = vec![0.0; n * n];
    (0..n).for_each(|k| vectors[k * n + k] = 1.0);
    for _ in 0..SWEEPS {
        let is_done =
            |p: usize, q: usize, a: &[f64]| a[p * n + q].powi(2) <= ROUND_OFF * (a[p * n + p] * a[q * n + q]).abs();
        if (0..n).all(|p| (p + 1..n).all(|q| is_done(p, q, &a))) {
            break;
        }
        for p in 0..n {
            for q in p + 1..n {
                if a[p * n + q] == 0.0 {
                    continue;
                }
                let half = (a[q * n + q] - a[p * n + p]) / (2.0 * a[p * n + q]);
                let tangent = half.signum() / (half.abs() + (half * half + 1.0).sqrt());
                let cosine = 1.0 / (tangent * tangent + 1.0).sqrt();
                let sine = tangent * cosine;
                for k in 0..n {
                    let (kp, kq) = (a[k * n + p], a[k * n + q]);
                    (a[k * n + p], a[k * n + q]) = (cosine * kp - sine * kq, sine * kp + cosine * kq);
                }
                for k in 0..n {
                    let (pk, qk) = (a[p * n + k], a[q * n + k]);
                    (a[p * n + k], a[q * n + k]) = (cosine * pk - sine * qk, sine * pk + cosine * qk);
                    let (kp, kq) = (vectors[k * n + p], vectors[k * n + q]);
                    (vectors[k * n + p], vectors[k * n + q]) = (cosine * kp - sine * kq, sine * kp + cosine * kq);
                }
            }
        }
    }
    ((0..n).map(|k| a[k * n + k]).collect(), vectors)
}

/// λ of K v = λ M v, ascending; not numbers where M is not positive definite.
pub(crate) fn eigenvalues(mass: &[f64], stiffness: &[f64], n: usize) -> Vec<f64> {
    if n == 0 {
        return Vec::new();
    }
    let Some((matrix, _)) = reduced(mass, stiffness, n) else { return vec![f64::NAN; n] };
    let (mut values, _) = jacobi(matrix, n);
    values.sort_by(f64::total_cmp);
    values
}

/// λ and v of K v = λ M v with vᵀ M v = 1, ascending; empty if M is not positive definite.
pub(crate) fn pairs(mass: &[f64], stiffness: &[f64], n: usize) -> Vec<(f64, Vec<f64>)> {
    let Some((matrix, inverse)) = reduced(mass, stiffness, n) else { return Vec::new() };
    let (values, vectors) = jacobi(matrix, n);
    // v = L⁻ᵀ w with the eigenvectors w of the reduced matrix.
    let own = |k: usize| inverse.multiply_transposed(&(0..n).map(|row| vectors[row * n + k]).collect::<Vec<f64>>());
    let mut found: Vec<(f64, Vec<f64>)> = values.iter().enumerate().map(|(k, value)| (*value, own(k))).collect();
    found.sort_by(|one, other| one.0.total_cmp(&other.0));
    found
}

/// Eigenvectors of K v = λ M v, by λ.
pub(crate) fn eigenvectors(mass: &[f64], stiffness: &[f64], n: usize) -> Vec<Vec<f64>> {
    pairs(mass, stiffness, n).into_iter().map(|(_, vector)| vector).collect()
}

/// The first `count` eigenvectors of K v = λ M v, by λ, where K is positive definite and its largest numbers would hide small λ: from M v = K v/λ.
pub(crate) fn lowest(mass: &[f64], stiffness: &[f64], n: usize, count: usize) -> Vec<Vec<f64>> {
    pairs(stiffness, mass, n).into_iter().rev().take(count).map(|(_, vector)| vector).collect()
}

/// M V diag(√λ) Vᵀ M with K V = M V diag(λ) and Vᵀ M V = 1: times 2ζ the damping of all shapes with the ratio ζ.
pub(crate) fn root_damping(mass: &[f64], stiffness: &[f64], n: usize) -> Vec<f64> {
    if n == 0 {
        return Vec::new();
    }
    let Some((matrix, inverse)) = reduced(mass, stiffness, n) else { return vec![f64::NAN; n * n] };
    let (values, vectors) = jacobi(matrix, n);
    // V = L⁻ᵀ W with the eigenvectors W of the reduced matrix.
    let columns: Vec<Vec<f64>> = (0..n)
        .map(|k| {
            let vector: Vec<f64> = (0..n).map(|row| vectors[row * n + k]).collect();
            multiply(mass, &inverse.multiply_transposed(&vector))
        })
        .collect();
    let entry = |row: usize, column: usize| {
        let term = |(value, of_mode): (&f64, &Vec<f64>)| value.max(0.0).sqrt() * of_mode[row] * of_mode[column];
        values.iter().zip(&columns).map(term).sum()
    };
    (0..n * n).map(|place| entry(place / n, place % n)).collect()
}

#[cfg(test)]
mod tests {
    use super::{eigenvalues, root_damping};

    #[test]
    fn analytic_two_masses_between_three_springs() {
        // Masses 2 and 3, springs 5, 7 and 11: 6 λ² - 72 λ + 167 = 0.
        let (mass, stiffness) = ([2.0, 0.0, 0.0, 3.0], [12.0, -7.0, -7.0, 18.0]);
        let root = (72.0_f64 * 72.0 - 4.0 * 6.0 * 167.0).sqrt();
        for (found, exact) in eigenvalues(&mass, &stiffness, 2).iter().zip([(72.0 - root) / 12.0, (72.0 + root) / 12.0])
        {
            assert!((found - exact).abs() < 1e-14 * exact, "{found} for {exact}");
        }
        // D M⁻¹ D = K for the root.
        let damping = root_damping(&mass, &stiffness, 2);
        for row in 0..2 {
            for column in 0..2 {
                let square: f64 = (0..2).map(|k| damping[row * 2 + k] / mass[k * 3] * damping[k * 2 + column]).sum();
                assert!((square - stiffness[row * 2 + column]).abs() < 1e-13);
            }
        }
    }
}
