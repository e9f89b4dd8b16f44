//! Eigenvalues of a small stiffness matrix with its mass matrix, and the damping that goes with them.

use loosepin_math::dense::{Precision, SymmetricEigen, multiply};

/// λ and v of K v = λ M v with vᵀ M v = 1, ascending; none if M is not positive definite.
pub(crate) fn modes(mass: &[f64], stiffness: &[f64], n: usize) -> SymmetricEigen {
    let found = SymmetricEigen::with_mass(stiffness, mass, n, Precision::OfEach);
    found.unwrap_or(SymmetricEigen { values: Vec::new(), vectors: Vec::new() }).ascending()
}

/// λ of K v = λ M v, ascending; not numbers where M is not positive definite.
pub(crate) fn eigenvalues(mass: &[f64], stiffness: &[f64], n: usize) -> Vec<f64> {
    let mut values = modes(mass, stiffness, n).values;
    values.resize(n, f64::NAN);
    values
}

/// Eigenvectors of K v = λ M v, by λ.
pub(crate) fn eigenvectors(mass: &[f64], stiffness: &[f64], n: usize) -> Vec<Vec<f64>> {
    modes(mass, stiffness, n).vectors
}

/// The first `count` eigenvectors of K v = λ M v, by λ, where K is positive definite and its largest numbers would hide small λ: from M v = K v/λ.
pub(crate) fn lowest(mass: &[f64], stiffness: &[f64], n: usize, count: usize) -> Vec<Vec<f64>> {
    modes(stiffness, mass, n).vectors.into_iter().rev().take(count).collect()
}

/// M V diag(√λ) Vᵀ M with K V = M V diag(λ) and Vᵀ M V = 1: times 2ζ the damping of all shapes with the ratio ζ.
pub(crate) fn root_damping(mass: &[f64], stiffness: &[f64], n: usize) -> Vec<f64> {
    let Some(found) = SymmetricEigen::with_mass(stiffness, mass, n, Precision::OfEach) else {
        return vec![f64::NAN; n * n];
    };
    let columns: Vec<Vec<f64>> = found.vectors.iter().map(|vector| multiply(mass, vector)).collect();
    let entry = |row: usize, column: usize| {
        let term = |(value, of_mode): (&f64, &Vec<f64>)| value.max(0.0).sqrt() * of_mode[row] * of_mode[column];
        found.values.iter().zip(&columns).map(term).sum()
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
