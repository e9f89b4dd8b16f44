//! Legendre's polynomials.

/// P_0 to P_n at z, n >= 1.
pub(crate) fn legendre(z: f64, n: usize) -> Vec<f64> {
    let mut values = vec![1.0, z];
    for degree in 2..=n {
        let k = degree as f64;
        values.push(((2.0 * k - 1.0) * z * values[degree - 1] - (k - 1.0) * values[degree - 2]) / k);
    }
    values
}
