//! The film of a bearing of any length.

use super::finite_length_table::{COEFFICIENTS, DEGREE};
use super::motion::{FilmForce, FilmMotion};
use super::ocvirk::OcvirkFilm;
use super::{FilmBearing, FilmDescription, FilmLaw, FilmPressure};
use crate::math::Real;

/// κ, from which on a bearing counts as long: κ (L/D)² against 1 + X.
const CROSSOVER: f64 = 0.5;

/// Bearing of any length (own solution): (h³ p')' + (D/L)² h³ p_ζζ = 6 μ (R/c)² (2ε̇ cos θ - wε sin θ), ζ = 2z/L, p = 0 at both ends, negative
/// pressure dropped (half-Sommerfeld).
///
/// As a complex number F = F_r + i F_t is Ocvirk's F₀ (see [`OcvirkFilm`]) over 1 + what the length takes away. With X + i Y = ε F₀/|F₀|,
/// Λ = L/D, η = (1 - ε²)/(1 + X), τ = Λ/(Λ + √((1 + X)/κ)), κ = ½ and Chebyshev's polynomials T
///
/// F = F₀ (1 + X)/(1 + X + κΛ²)/(1 + τ Σ (a_ijk + i Y b_ijk) T_i(X) T_j(η - 1) T_k(2τ - 1)), i + j + k <= 6.
///
/// X + i Y is where the pressure is, so that the sums stay smooth where a small change of direction moves it from the thin to the thick
/// film; they are also smooth at ε = 0, and F = F₀ for Λ = 0. `tools/film/fit.py` solves the equation by collocation and makes a and b
/// from 0.02 <= ε <= 0.985 and 0.02 <= Λ <= 200.
///
/// Error against that solution: 0.3 % of the largest force at the same ε and Λ; of the force itself up to ε = 0.9 1.3 % where
/// ε̇ >= 0, and 4 % where the journal moves away and the force is up to a hundred times smaller.
#[derive(Debug, Clone, Copy)]
pub struct FiniteLengthFilm<T> {
    /// Ocvirk's film of the same bearing.
    pub short: OcvirkFilm<T>,
    /// Λ = L/D.
    pub length_ratio: T,
}

impl FiniteLengthFilm<f64> {
    /// How model files know it.
    pub const DESCRIPTION: FilmDescription = FilmDescription {
        name: "finite-length",
        source: "own solution of the Reynolds equation for any length, half-Sommerfeld",
        law: |bearing| FilmLaw::FiniteLength(Self::new(bearing)),
    };

    /// The film of a bearing.
    pub fn new(bearing: &FilmBearing) -> Self {
        Self { short: OcvirkFilm::new(bearing), length_ratio: 0.5 * bearing.length_m / bearing.radius_m }
    }
}

impl<T: Real> FiniteLengthFilm<T> {
    /// The same numbers in every lane.
    pub fn broadcast(from: &FiniteLengthFilm<f64>) -> Self {
        Self { short: OcvirkFilm::broadcast(&from.short), length_ratio: T::from_f64(from.length_ratio) }
    }
}

impl<T: Real> FilmPressure<T> for FiniteLengthFilm<T> {
    #[inline(always)]
    fn force(&self, motion: &FilmMotion<T>) -> FilmForce<T> {
        let (one, two) = (T::one(), T::from_f64(2.0));
        let short = self.short.force(motion);
        let size_n = (short.radial_n * short.radial_n + short.tangential_n * short.tangential_n).sqrt();
        let to_direction = motion.ratio / size_n.max(T::from_f64(f64::MIN_POSITIVE));
        let (x, y) = (short.radial_n * to_direction, short.tangential_n * to_direction);
        let room = one + x;
        let eta = (one - motion.ratio * motion.ratio) / room;
        let length = self.length_ratio;
        let tau = length / (length + (room / T::from_f64(CROSSOVER)).sqrt());
        let [along_x, along_eta, along_tau] = [x, eta - one, two.mul_add(tau, -one)].map(chebyshev);
        let mut sums = [T::zero(); 2];
        let mut coefficients = COEFFICIENTS.iter();
        for i in 0..=DEGREE {
            for j in 0..=DEGREE - i {
                let product = along_x[i] * along_eta[j];
                let mut inner = [T::zero(); 2];
                for (of_tau, pair) in along_tau[..=DEGREE - i - j].iter().zip(&mut coefficients) {
                    for part in 0..2 {
                        inner[part] = T::from_f64(pair[part]).mul_add(*of_tau, inner[part]);
                    }
                }
                for part in 0..2 {
                    sums[part] = product.mul_add(inner[part], sums[part]);
                }
            }
        }
        let (real, imaginary) = (tau.mul_add(sums[0], one), tau * y * sums[1]);
        // F₀ over the complex number.
        let long = T::from_f64(CROSSOVER) * length * length;
        let share = room / ((room + long) * (real * real + imaginary * imaginary));
        FilmForce {
            radial_n: share * (short.radial_n * real + short.tangential_n * imaginary),
            tangential_n: share * (short.tangential_n * real - short.radial_n * imaginary),
        }
    }

    fn visit(&mut self, visit: &mut impl FnMut(&mut T)) {
        self.short.visit(visit);
        visit(&mut self.length_ratio);
    }
}

/// T_0(x) to T_6(x).
#[inline(always)]
fn chebyshev<T: Real>(x: T) -> [T; DEGREE + 1] {
    let mut values = [T::one(); DEGREE + 1];
    values[1] = x;
    for k in 2..=DEGREE {
        values[k] = (x + x).mul_add(values[k - 1], -values[k - 2]);
    }
    values
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{PI, TAU};

    /// Points over the angle, over half of the length, and modes along the bearing of the solution below.
    const POINTS: usize = 720;
    const STATIONS: usize = 24;
    const MODES: usize = 60;

    /// Finite differences over the angle, cosines along the bearing: pressures for ε̇ = 1 and for wε = 1, in units of μ (R/c)².
    struct Reynolds {
        pressure: Vec<[f64; 2]>,
    }

    impl Reynolds {
        fn new(ratio: f64, length_ratio: f64) -> Self {
            let step = TAU / POINTS as f64;
            let film = |place: f64| (1.0 + ratio * (place * step).cos()).powi(3);
            let mut pressure = vec![[0.0; 2]; POINTS * STATIONS];
            for mode in 0..MODES {
                let wave = (mode as f64 + 0.5) * PI;
                let amplitude = if mode % 2 == 0 { 2.0 / wave } else { -2.0 / wave };
                let sink = (wave / length_ratio).powi(2);
                let sides: Vec<f64> = (0..POINTS).map(|k| film(k as f64 + 0.5) / (step * step)).collect();
                let middle: Vec<f64> = (0..POINTS)
                    .map(|k| -sides[k] - sides[(k + POINTS - 1) % POINTS] - sink * film(k as f64))
                    .collect();
                for part in 0..2 {
                    let right = |k: usize| {
                        let (sine, cosine) = (k as f64 * step).sin_cos();
                        6.0 * amplitude * if part == 0 { 2.0 * cosine } else { -sine }
                    };
                    let right: Vec<f64> = (0..POINTS).map(right).collect();
                    for (k, value) in periodic(&sides, &middle, &right).into_iter().enumerate() {
                        for station in 0..STATIONS {
                            let along = (wave * (station as f64 + 0.5) / STATIONS as f64).cos();
                            pressure[k * STATIONS + station][part] += value * along;
                        }
                    }
                }
            }
            Self { pressure }
        }

        /// F_r and F_t in units of μ L R³/c².
        fn force(&self, squeeze_1_s: f64, wedge_1_s: f64) -> [f64; 2] {
            let mut sum = [0.0; 2];
            for k in 0..POINTS {
                let (sine, cosine) = (TAU * k as f64 / POINTS as f64).sin_cos();
                for [of_squeeze, of_wedge] in &self.pressure[k * STATIONS..(k + 1) * STATIONS] {
                    let pressure = (of_squeeze * squeeze_1_s + of_wedge * wedge_1_s).max(0.0);
                    sum[0] += pressure * cosine;
                    sum[1] += pressure * sine;
                }
            }
            sum.map(|sum| sum * TAU / (POINTS * STATIONS) as f64)
        }
    }

    /// The solution of s_k x_{k+1} + m_k x_k + s_{k-1} x_{k-1} = r_k around a circle (Thomas, with Sherman and Morrison's formula for
    /// the corner).
    fn periodic(sides: &[f64], middle: &[f64], right: &[f64]) -> Vec<f64> {
        let n = middle.len();
        let corner = sides[n - 1];
        let mut changed = middle.to_vec();
        let gamma = -middle[0];
        changed[0] -= gamma;
        changed[n - 1] -= corner * corner / gamma;
        let mut border = vec![0.0; n];
        (border[0], border[n - 1]) = (gamma, corner);
        let [x, z] = [right, &border].map(|right| {
            let (mut above, mut value) = (vec![0.0; n], right.to_vec());
            let mut pivot = changed[0];
            value[0] /= pivot;
            for k in 1..n {
                above[k] = sides[k - 1] / pivot;
                pivot = changed[k] - sides[k - 1] * above[k];
                value[k] = (value[k] - sides[k - 1] * value[k - 1]) / pivot;
            }
            for k in (0..n - 1).rev() {
                value[k] -= above[k + 1] * value[k + 1];
            }
            value
        });
        let weight = (x[0] + corner * x[n - 1] / gamma) / (1.0 + z[0] + corner * z[n - 1] / gamma);
        x.iter().zip(&z).map(|(x, z)| x - weight * z).collect()
    }

    /// In units of μ L R³/c²: F₀ has the factor μ R L³/c².
    fn film(length_ratio: f64) -> FiniteLengthFilm<f64> {
        let short = OcvirkFilm { factor_n_s: 4.0 * length_ratio * length_ratio };
        FiniteLengthFilm { short, length_ratio }
    }

    #[test]
    fn identity_the_table_solves_the_reynolds_equation_between_its_places() {
        /// Of the largest force at the same ε and L/D; the solution here is good to 0.05 %.
        const OF_LARGEST: f64 = 4e-3;
        /// Of the force, on approach and with a steady load.
        const OF_FORCE: f64 = 0.015;
        for ratio in [0.04, 0.25, 0.45, 0.65, 0.82, 0.92] {
            for length_ratio in [0.15, 0.35, 0.9, 1.7, 4.0] {
                let reynolds = Reynolds::new(ratio, length_ratio);
                let film = film(length_ratio);
                let largest = reynolds.force(1.0, 0.0);
                let largest = largest[0].hypot(largest[1]);
                for k in 0..24 {
                    let (sine, cosine) = (TAU * (f64::from(k) + 0.3) / 24.0).sin_cos();
                    let (squeeze_1_s, wedge_1_s) = (cosine, -2.0 * sine);
                    let expected = reynolds.force(squeeze_1_s, wedge_1_s);
                    let found = film.force(&FilmMotion { ratio, squeeze_1_s, wedge_1_s });
                    let error = (found.radial_n - expected[0]).hypot(found.tangential_n - expected[1]);
                    let size = expected[0].hypot(expected[1]);
                    let words = format!("ε = {ratio}, L/D = {length_ratio}, direction {k}: {found:?} {expected:?}");
                    assert!(error <= OF_LARGEST * largest, "{words}: {} of the largest", error / largest);
                    assert!(cosine < 0.0 || error <= OF_FORCE * size, "{words}: {} of the force", error / size);
                }
            }
        }
    }

    #[test]
    fn analytic_a_very_short_bearing_is_that_of_ocvirk() {
        for k in 1..=9 {
            let ratio = 0.1 * f64::from(k);
            for direction in 0..24 {
                let (sine, cosine) = (TAU * f64::from(direction) / 24.0).sin_cos();
                let motion = FilmMotion { ratio, squeeze_1_s: cosine, wedge_1_s: -2.0 * sine };
                let (found, short) = (film(0.02).force(&motion), film(0.02).short.force(&motion));
                let error = (found.radial_n - short.radial_n).hypot(found.tangential_n - short.tangential_n);
                assert!(error < 0.01 * short.radial_n.hypot(short.tangential_n), "ε = {ratio}: {found:?} {short:?}");
            }
        }
    }

    #[test]
    fn analytic_a_very_long_bearing_under_a_steady_load_is_the_infinitely_long_one() {
        for k in 1..=9 {
            let ratio = 0.1 * f64::from(k);
            for w in [-1.3, 1.3] {
                let found = film(200.0).force(&FilmMotion { ratio, squeeze_1_s: 0.0, wedge_1_s: w * ratio });
                let gap = 1.0 - ratio * ratio;
                let radial = -12.0 * ratio * ratio * f64::abs(w) / ((2.0 + ratio * ratio) * gap);
                let tangential = 6.0 * PI * ratio * w / ((2.0 + ratio * ratio) * gap.sqrt());
                let error = (found.radial_n - radial).hypot(found.tangential_n - tangential);
                assert!(error < 0.01 * radial.hypot(tangential), "ε = {ratio}: {found:?} {radial} {tangential}");
            }
        }
    }
}
