//! The course of the pressure of a film along its bearing.

use loosepin_math::sin_cos;

/// Polynomials of a basis, so of degree 2 [`MODES`] at most.
pub(super) const MODES: usize = 12;
/// Places along half of the bearing.
pub(super) const STATIONS: usize = 16;

/// Modes of -e'' = κ² e along the bearing, ζ = 2z/L from -1 to 1, even and zero at both ends.
///
/// In the basis P_2k - P_2k+2 of Legendre's polynomials ∫ e'² is diagonal and ∫ e² tridiagonal (Shen 1994), so that the modes are
/// those of a small symmetric matrix. Normalised to ∫ e'² = 1.
pub(super) struct AxialModes {
    /// κ² of each mode.
    pub squares: [f64; MODES],
    /// ∫ e dζ κ² of each mode: what a right-hand side that is the same all along the bearing has of it.
    pub shares: [f64; MODES],
    /// e of each mode at each station.
    pub profiles: [[f64; MODES]; STATIONS],
    /// Weights of the stations; their sum is one.
    pub weights: [f64; STATIONS],
}

impl AxialModes {
    pub fn new() -> Self {
        let stiffness = |k: usize| f64::from(2 * (4 * k as u32 + 3));
        let mut matrix = [[0.0; MODES]; MODES];
        for k in 0..MODES {
            let place = 4.0 * k as f64;
            matrix[k][k] = (2.0 / (place + 1.0) + 2.0 / (place + 5.0)) / stiffness(k);
            if k + 1 < MODES {
                let beside = -2.0 / (place + 5.0) / (stiffness(k) * stiffness(k + 1)).sqrt();
                (matrix[k][k + 1], matrix[k + 1][k]) = (beside, beside);
            }
        }
        let vectors = diagonalise(&mut matrix);
        let squares = std::array::from_fn(|mode| 1.0 / matrix[mode][mode]);
        // ∫ (P_2k - P_2k+2) dζ is 2 for k = 0 and nothing for the others.
        let shares = std::array::from_fn(|mode| squares[mode] * 2.0 * vectors[0][mode] / stiffness(0).sqrt());
        let [places, weights] = gauss();
        let profiles = places.map(|place| {
            let values = legendre(place);
            let basis: [f64; MODES] =
                std::array::from_fn(|k| (values[2 * k] - values[2 * k + 2]) / stiffness(k).sqrt());
            std::array::from_fn(|mode| (0..MODES).map(|k| vectors[k][mode] * basis[k]).sum())
        });
        Self { squares, shares, profiles, weights }
    }
}

/// P_0 to P_(2 STATIONS) at `x`.
fn legendre(x: f64) -> [f64; 2 * STATIONS + 1] {
    let mut values = [1.0; 2 * STATIONS + 1];
    values[1] = x;
    for n in 1..2 * STATIONS {
        let order = n as f64;
        values[n + 1] = ((2.0 * order + 1.0) * x * values[n] - order * values[n - 1]) / (order + 1.0);
    }
    values
}

/// Places and weights of Gauss and Legendre's rule with 2 [`STATIONS`] places, its half with ζ > 0.
fn gauss() -> [[f64; STATIONS]; 2] {
    let order = 2.0 * STATIONS as f64;
    let mut rule = [[0.0; STATIONS]; 2];
    for station in 0..STATIONS {
        let mut x = sin_cos(std::f64::consts::PI * (station as f64 + 0.75) / (order + 0.5)).1;
        let mut slope = 0.0;
        for _ in 0..6 {
            let values = legendre(x);
            slope = order * (values[2 * STATIONS - 1] - x * values[2 * STATIONS]) / (1.0 - x * x);
            x -= values[2 * STATIONS] / slope;
        }
        (rule[0][station], rule[1][station]) = (x, 2.0 / ((1.0 - x * x) * slope * slope));
    }
    rule
}

/// Turns the symmetric `matrix` into a diagonal one by Jacobi's rotations; gives its vectors as columns.
fn diagonalise(matrix: &mut [[f64; MODES]; MODES]) -> [[f64; MODES]; MODES] {
    let mut vectors: [[f64; MODES]; MODES] =
        std::array::from_fn(|i| std::array::from_fn(|j| if i == j { 1.0 } else { 0.0 }));
    // It converges with the square of the rest: twelve rounds are more than enough for round-off.
    for _ in 0..12 {
        for p in 0..MODES {
            for q in p + 1..MODES {
                if matrix[p][q] == 0.0 {
                    continue;
                }
                let apart = (matrix[q][q] - matrix[p][p]) / (2.0 * matrix[p][q]);
                let tangent = apart.signum() / (apart.abs() + (apart * apart + 1.0).sqrt());
                let cosine = 1.0 / (tangent * tangent + 1.0).sqrt();
                let sine = tangent * cosine;
                let turn = |row: &mut [f64; MODES]| {
                    (row[p], row[q]) = (cosine * row[p] - sine * row[q], sine * row[p] + cosine * row[q]);
                };
                matrix.iter_mut().for_each(turn);
                for k in 0..MODES {
                    let (first, second) = (matrix[p][k], matrix[q][k]);
                    (matrix[p][k], matrix[q][k]) = (cosine * first - sine * second, sine * first + cosine * second);
                }
                vectors.iter_mut().for_each(turn);
            }
        }
    }
    vectors
}
