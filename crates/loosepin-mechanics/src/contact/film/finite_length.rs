//! The film of a bearing of any length.

use super::motion::{FilmForce, FilmMotion};
use super::ocvirk::OcvirkFilm;
use super::pressure::{FilmBearing, FilmPressure};
use super::reynolds::Reynolds;
use loosepin_math::{Real, factor_ldl, numbers, sin_cos, solve_ldl};
use std::cell::RefCell;

/// κ, from which on a bearing counts as long: κ Λ² against 1 + X.
const CROSSOVER: f64 = 0.5;
/// The largest i + j of the sums.
const DEGREE: usize = 8;
/// Pairs (i, j).
const TERMS: usize = (DEGREE + 1) * (DEGREE + 2) / 2;
/// The sums are made for films down to this share of the clearance, so for eccentricity ratios up to [`LARGEST_RATIO`].
const THINNEST_SHARE: f64 = 0.002;
const LARGEST_RATIO: f64 = 1.0 - THINNEST_SHARE;
/// Eccentricity ratios and directions of the velocity that the equation is solved for.
const RATIOS: usize = 20;
const DIRECTIONS: usize = 33;
/// The relative error of a force counts with the root of its share of the largest at the same ε, and never less than this.
const SMALLEST_WEIGHT: f64 = 0.1;

/// Bearing of any length: the solution of the Reynolds equation (`Reynolds`, half-Sommerfeld), in numbers that are made for Λ = L/D
/// when the numbers of a run are laid out.
///
/// As a complex number F = F_r + i F_t is Ocvirk's F₀ ([`OcvirkFilm`]) over what the length takes away. With X + i Y = ε F₀/|F₀|, κ = ½,
///
/// F = F₀ (1 + X)/(1 + X + κΛ²)/Σ (a_ij + i Y b_ij) T_i(2 (u - u_1)/(u_2 - u_1) - 1) T_j(η - 1), i + j <= 8,
///
/// Chebyshev's polynomials T, η = (1 - ε²)/(1 + X), u = l/(l + √(1 + X)), l = Λ√κ between 0.05 and 5, and u_1, u_2 its range.
///
/// X + i Y is where the pressure is, √(1 + X) how far it spreads around the bearing, and u how long the bearing is against that: so
/// the sums are smooth where a small change of direction moves the pressure from the thin to the thick film, and at ε = 0.
///
/// Error of the sums against the solution up to ε = 0.9, for Λ from 0.02 to 200: 0.08 % of the force on approach and under a steady
/// load, 0.22 % where the journal moves away. From there up to ε = 0.998: 2 % on approach (Λ = 0.1; 0.7 % for Λ >= 0.2), 0.1 % of the
/// largest force at the same ε in all directions. The solution itself is within 0.01 % up to Λ = 5, and within 0.3 % at Λ = 200.
#[derive(Debug, Clone, Copy)]
pub struct FiniteLengthFilm<T> {
    /// Ocvirk's film of the same bearing.
    pub short: OcvirkFilm<T>,
    /// κ Λ².
    pub crossover: T,
    /// l.
    pub reach: T,
    /// a_ij and b_ij, i outermost.
    pub sums: [[T; 2]; TERMS],
}

numbers!(struct FiniteLengthFilm { short, crossover, reach, sums });

impl FiniteLengthFilm<f64> {
    /// The name used in model files, in kebab case.
    pub const NAME: &'static str = "finite-length";
    /// Author, year, and what it assumes.
    pub const SOURCE: &'static str =
        "own solution of the Reynolds equation for any length: half-Sommerfeld, after Gümbel 1914";
    /// The thinnest film that it holds for, as a share of the clearance.
    pub const THINNEST_SHARE: f64 = THINNEST_SHARE;

    /// The film of a bearing.
    pub fn new(bearing: &FilmBearing) -> Self {
        let length_ratio = 0.5 * bearing.length_m / bearing.radius_m;
        Self { short: OcvirkFilm::new(bearing), ..solved(length_ratio) }
    }

    /// For Λ, with forces in units of μ L R³/c².
    fn with_length(length_ratio: f64) -> Self {
        let crossover = CROSSOVER * length_ratio * length_ratio;
        let mut film = Self {
            short: OcvirkFilm { factor_n_s: 4.0 * length_ratio * length_ratio },
            crossover,
            reach: crossover.sqrt().clamp(0.05, 5.0),
            sums: [[0.0; 2]; TERMS],
        };
        film.fit(&Reynolds::new(length_ratio));
        film
    }

    /// Least squares of the relative error.
    fn fit(&mut self, reynolds: &Reynolds) {
        let mut matrices = [vec![0.0; TERMS * TERMS], vec![0.0; TERMS * TERMS]];
        let mut rights = [vec![0.0; TERMS], vec![0.0; TERMS]];
        for k in 0..RATIOS {
            let share = 0.5 - 0.5 * sin_cos(std::f64::consts::PI * (k as f64 + 0.5) / RATIOS as f64).1;
            // Evenly over √(1 - ε), denser at the ends.
            let thinnest = (1.0 - LARGEST_RATIO).sqrt();
            let ratio = 1.0 - (thinnest + (1.0 - thinnest) * share).powi(2);
            let pressures = reynolds.pressures(ratio);
            let forces: Vec<_> = (0..DIRECTIONS)
                .map(|direction| {
                    let turn = std::f64::consts::PI * direction as f64 / (DIRECTIONS - 1) as f64;
                    let (sine, cosine) = sin_cos(turn);
                    let motion = FilmMotion { ratio, squeeze_1_s: cosine, wedge_1_s: -2.0 * sine };
                    (motion, pressures.force(motion.squeeze_1_s, motion.wedge_1_s))
                })
                .collect();
            let largest = forces.iter().map(|(_, force)| force.size_n()).fold(0.0, f64::max);
            for (motion, force) in &forces {
                let place = self.place(motion);
                let [radial, tangential] = [place.short.radial_n, place.short.tangential_n].map(|f| f * place.share);
                let square = force.size_n() * force.size_n();
                // F₀ (1 + X)/(1 + X + κΛ²)/F.
                let target = [
                    (radial * force.radial_n + tangential * force.tangential_n) / square,
                    (tangential * force.radial_n - radial * force.tangential_n) / square,
                ];
                let weight = (force.size_n() / largest).sqrt().max(SMALLEST_WEIGHT)
                    / (target[0] * target[0] + target[1] * target[1]).sqrt();
                for part in 0..2 {
                    let factor = if part == 0 { weight } else { weight * place.across };
                    let row = place.terms().map(|term| term * factor);
                    for i in 0..TERMS {
                        rights[part][i] += row[i] * target[part] * weight;
                        for j in 0..=i {
                            matrices[part][i * TERMS + j] += row[i] * row[j];
                        }
                    }
                }
            }
        }
        for part in 0..2 {
            let matrix = &mut matrices[part];
            for i in 0..TERMS {
                for j in 0..i {
                    matrix[j * TERMS + i] = matrix[i * TERMS + j];
                }
            }
            factor_ldl(matrix, TERMS);
            solve_ldl(matrix, TERMS, &mut rights[part]);
            for (pair, value) in self.sums.iter_mut().zip(&rights[part]) {
                pair[part] = *value;
            }
        }
    }
}

thread_local! {
    /// The last films of this thread, latest first: runs that differ in play, viscosity or load share Λ, and to solve for it
    /// takes longer than a run.
    static SOLVED: RefCell<Vec<(f64, FiniteLengthFilm<f64>)>> = const { RefCell::new(Vec::new()) };
}

/// The film for Λ, solved once for a thread while no [`KEPT`] others come between.
fn solved(length_ratio: f64) -> FiniteLengthFilm<f64> {
    /// More bearings than a mechanism has, each of 1.5 kB.
    const KEPT: usize = 8;
    SOLVED.with_borrow_mut(|films| {
        let at = films.iter().position(|(solved_for, _)| solved_for.to_bits() == length_ratio.to_bits());
        let film = match at {
            Some(at) => films.remove(at).1,
            None => FiniteLengthFilm::with_length(length_ratio),
        };
        films.truncate(KEPT - 1);
        films.insert(0, (length_ratio, film));
        film
    })
}

/// Where in the sums a motion is.
struct Place<T> {
    short: FilmForce<T>,
    /// (1 + X)/(1 + X + κΛ²).
    share: T,
    /// Y.
    across: T,
    along_u: [T; DEGREE + 1],
    along_eta: [T; DEGREE + 1],
}

impl<T: Real> Place<T> {
    /// T_i T_j, i outermost.
    #[inline(always)]
    fn terms(&self) -> [T; TERMS] {
        let mut terms = [T::zero(); TERMS];
        let mut at = 0;
        for i in 0..=DEGREE {
            for j in 0..=DEGREE - i {
                terms[at] = self.along_u[i] * self.along_eta[j];
                at += 1;
            }
        }
        terms
    }
}

impl<T: Real> FiniteLengthFilm<T> {
    #[inline(always)]
    fn place(&self, motion: &FilmMotion<T>) -> Place<T> {
        let (one, two) = (T::one(), T::from_f64(2.0));
        let short = self.short.force(motion);
        let to_direction = motion.ratio / short.size_n().max(T::from_f64(f64::MIN_POSITIVE));
        let (x, across) = (short.radial_n * to_direction, short.tangential_n * to_direction);
        let room = one + x;
        let eta = (one - motion.ratio * motion.ratio) / room;
        let share = |spread: f64| self.reach / (self.reach + T::from_f64(spread));
        let (last, first) = (share((1.0 - LARGEST_RATIO).sqrt()), share((1.0 + LARGEST_RATIO).sqrt()));
        let u = self.reach / (self.reach + room.sqrt());
        Place {
            short,
            share: room / (room + self.crossover),
            across,
            along_u: chebyshev((two * u - first - last) / (last - first)),
            along_eta: chebyshev(eta - one),
        }
    }
}

impl<T: Real> FilmPressure<T> for FiniteLengthFilm<T> {
    #[inline(always)]
    fn force(&self, motion: &FilmMotion<T>) -> FilmForce<T> {
        let place = self.place(motion);
        let mut sums = [T::zero(); 2];
        let mut at = 0;
        for i in 0..=DEGREE {
            let mut inner = [T::zero(); 2];
            for j in 0..=DEGREE - i {
                for part in 0..2 {
                    inner[part] = self.sums[at][part].mul_add(place.along_eta[j], inner[part]);
                }
                at += 1;
            }
            for part in 0..2 {
                sums[part] = inner[part].mul_add(place.along_u[i], sums[part]);
            }
        }
        let (real, imaginary) = (sums[0], place.across * sums[1]);
        // F₀ over the complex number.
        let share = place.share / (real * real + imaginary * imaginary);
        let short = place.short;
        FilmForce {
            radial_n: share * (short.radial_n * real + short.tangential_n * imaginary),
            tangential_n: share * (short.tangential_n * real - short.radial_n * imaginary),
        }
    }
}

/// T_0(x), T_1(x), and so on.
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
    use crate::contact::film::{OcvirkPrintedFilm, PinkusSternlichtFilm};
    use std::f64::consts::TAU;

    /// For Λ, in units of μ L R³/c².
    fn motions(ratio: f64, directions: u32) -> impl Iterator<Item = FilmMotion<f64>> {
        (0..directions).map(move |k| {
            let (sine, cosine) = (TAU * (f64::from(k) + 0.3) / f64::from(directions)).sin_cos();
            FilmMotion { ratio, squeeze_1_s: cosine, wedge_1_s: -2.0 * sine }
        })
    }

    fn apart(first: &FilmForce<f64>, second: &FilmForce<f64>) -> f64 {
        (first.radial_n - second.radial_n).hypot(first.tangential_n - second.tangential_n)
    }

    /// The largest errors of the sums between the places that they are made from: of the force on approach, of the force, and of
    /// the largest force at the same ε.
    fn errors(length_ratio: f64, ratios: &[f64]) -> [f64; 3] {
        let film = FiniteLengthFilm::with_length(length_ratio);
        let reynolds = Reynolds::new(length_ratio);
        let mut worst = [0.0_f64; 3];
        for &ratio in ratios {
            let pressures = reynolds.pressures(ratio);
            let largest = pressures.force(1.0, 0.0).size_n();
            for motion in motions(ratio, 24) {
                let expected = pressures.force(motion.squeeze_1_s, motion.wedge_1_s);
                let error = apart(&film.force(&motion), &expected);
                let relative = error / expected.size_n();
                let on_approach = if motion.squeeze_1_s < 0.0 { 0.0 } else { relative };
                for (worst, error) in worst.iter_mut().zip([on_approach, relative, error / largest]) {
                    *worst = worst.max(error);
                }
            }
        }
        worst
    }

    #[test]
    fn identity_the_sums_solve_the_reynolds_equation_between_their_places() {
        /// Up to ε = 0.9: of the force on approach, of the force where the journal moves away, of the largest force at the same ε.
        const THICKER: [f64; 3] = [8e-4, 2.2e-3, 1.8e-4];
        /// Up to ε = 0.9975, where a journal that moves away has a thousandth of the largest force.
        const THINNER: [f64; 3] = [0.02, 0.1, 1e-3];
        for length_ratio in [0.02, 0.1, 0.26, 0.5, 1.0, 1.4, 3.0, 9.0, 200.0] {
            for (ratios, limits) in
                [(&[0.01, 0.13, 0.33, 0.55, 0.72, 0.9][..], THICKER), (&[0.93, 0.98, 0.9975], THINNER)]
            {
                let found = errors(length_ratio, ratios);
                let words = format!("L/D = {length_ratio}: {found:?}");
                assert!(found.iter().zip(limits).all(|(error, limit)| *error < limit), "{words}");
            }
        }
    }

    #[test]
    fn analytic_a_very_short_bearing_is_that_of_ocvirk() {
        /// Largest relative error that a film may have.
        const RELATIVE: f64 = 0.01;
        let (film, reynolds) = (FiniteLengthFilm::with_length(0.02), Reynolds::new(0.02));
        for k in 1..=9 {
            let pressures = reynolds.pressures(0.1 * f64::from(k));
            for motion in motions(0.1 * f64::from(k), 24) {
                let short = film.short.force(&motion);
                let solved = pressures.force(motion.squeeze_1_s, motion.wedge_1_s);
                for found in [film.force(&motion), solved] {
                    assert!(apart(&found, &short) < RELATIVE * short.size_n(), "{motion:?}: {found:?} {short:?}");
                }
            }
            let steady = FilmMotion { ratio: 0.1 * f64::from(k), squeeze_1_s: 0.0, wedge_1_s: 1.3 };
            let printed = OcvirkPrintedFilm { factor_n_s: film.short.factor_n_s }.force(&steady);
            assert!(apart(&film.force(&steady), &printed) < RELATIVE * printed.size_n(), "{steady:?}");
        }
    }

    #[test]
    fn analytic_a_very_long_bearing_is_the_infinitely_long_one() {
        /// Largest relative error that a film may have.
        const RELATIVE: f64 = 0.01;
        let (film, reynolds) = (FiniteLengthFilm::with_length(200.0), Reynolds::new(200.0));
        for k in 1..=9 {
            let ratio = 0.1 * f64::from(k);
            let pressures = reynolds.pressures(ratio);
            for wedge_1_s in [-1.3, 1.3] {
                let steady = FilmMotion { ratio, squeeze_1_s: 0.0, wedge_1_s };
                let long = PinkusSternlichtFilm { factor_n_s: 1.0 }.force(&steady);
                for found in [film.force(&steady), pressures.force(0.0, wedge_1_s)] {
                    assert!(apart(&found, &long) < RELATIVE * long.size_n(), "{steady:?}: {found:?} {long:?}");
                }
            }
            for motion in motions(ratio, 24) {
                let rates = [motion.squeeze_1_s, motion.wedge_1_s / ratio];
                let [radial_n, tangential_n] = crate::contact::film::tests::long_integral(ratio, rates);
                let long = FilmForce { radial_n, tangential_n };
                let found = film.force(&motion);
                assert!(apart(&found, &long) < RELATIVE * long.size_n(), "{motion:?}: {found:?} {long:?}");
            }
        }
    }
}
