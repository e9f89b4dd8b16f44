//! The half-Sommerfeld film of a bearing of any length.

use super::half_sommerfeld::HalfSommerfeld;
use super::motion::{FilmForce, FilmMotion};
use super::ocvirk::OcvirkFilm;
use super::pressure::{FilmBearing, FilmPressure};
use super::quotient::{CROSSOVER, FilmQuotient, MAX_RATIO, THINNEST_SHARE};
use loosepin_math::{Real, numbers, sin_cos};
use std::cell::RefCell;

/// Eccentricity ratios and directions of the velocity that the equation is solved for.
const RATIOS: usize = 20;
const DIRECTIONS: usize = 33;

/// Bearing of any length, half-Sommerfeld: the solution of the Reynolds equation of a film that may pull, without its negative pressure
/// (`HalfSommerfeld`), as a `FilmQuotient` that is made for Λ = L/D when the numbers of a run are laid out, with l between 0.05 and 5.
///
/// Error of the sums against the solution up to ε = 0.9, for Λ from 0.02 to 200: 0.08 % of the force on approach and under a steady
/// load, 0.22 % where the journal moves away. From there up to ε = 0.998: 2 % on approach (Λ = 0.1; 0.7 % for Λ >= 0.2), 0.1 % of the
/// largest force at the same ε in all directions. The solution itself is within 0.01 % up to Λ = 5, and within 0.3 % at Λ = 200.
#[derive(Debug, Clone, Copy)]
pub struct FiniteLengthFilm<T> {
    /// The force.
    pub quotient: FilmQuotient<T>,
}

numbers!(struct FiniteLengthFilm { quotient });

impl FiniteLengthFilm<f64> {
    /// The name used in model files, in kebab case.
    pub const NAME: &'static str = "finite-length";
    /// Author, year, and what it assumes.
    pub const SOURCE: &'static str =
        "own solution of the Reynolds equation for any length: half-Sommerfeld, after Gümbel 1914";
    /// The thinnest film that it holds for, as a share of the clearance.
    pub const THINNEST_SHARE: f64 = THINNEST_SHARE;
    /// The largest L/D that it holds for.
    pub const LONGEST: f64 = f64::INFINITY;

    /// The film of a bearing.
    pub fn new(bearing: &FilmBearing) -> Self {
        let quotient = FilmQuotient { short: OcvirkFilm::new(bearing), ..solved(bearing.length_ratio()) };
        Self { quotient }
    }
}

impl<T: Real> FilmPressure<T> for FiniteLengthFilm<T> {
    #[inline(always)]
    fn force(&self, motion: &FilmMotion<T>) -> FilmForce<T> {
        self.quotient.force(motion)
    }
}

/// For Λ, with forces in units of μ L R³/c².
fn with_length(length_ratio: f64) -> FilmQuotient<f64> {
    let reach = (CROSSOVER * length_ratio * length_ratio).sqrt().clamp(0.05, 5.0);
    let mut film = FilmQuotient::without_sums(length_ratio, reach);
    let equation = HalfSommerfeld::new(length_ratio);
    film.fit((0..RATIOS).map(|k| {
        let share = 0.5 - 0.5 * sin_cos(std::f64::consts::PI * (k as f64 + 0.5) / RATIOS as f64).1;
        // Evenly over √(1 - ε), denser at the ends.
        let thinnest = (1.0 - MAX_RATIO).sqrt();
        let ratio = 1.0 - (thinnest + (1.0 - thinnest) * share).powi(2);
        let pressures = equation.pressures(ratio);
        (0..DIRECTIONS)
            .map(|direction| {
                let turn = std::f64::consts::PI * direction as f64 / (DIRECTIONS - 1) as f64;
                let (sine, cosine) = sin_cos(turn);
                let motion = FilmMotion { ratio, squeeze_1_s: cosine, wedge_1_s: -2.0 * sine };
                (motion, pressures.force(motion.squeeze_1_s, motion.wedge_1_s))
            })
            .collect()
    }));
    film
}

thread_local! {
    /// The last films of this thread, latest first: runs that differ in play, viscosity or load share Λ, and to solve for it
    /// takes longer than a run.
    static SOLVED: RefCell<Vec<(f64, FilmQuotient<f64>)>> = const { RefCell::new(Vec::new()) };
}

/// The film for Λ, solved once for a thread while no [`KEPT`] others come between.
fn solved(length_ratio: f64) -> FilmQuotient<f64> {
    /// More bearings than a mechanism has, each of 1.5 kB.
    const KEPT: usize = 8;
    SOLVED.with_borrow_mut(|films| {
        let at = films.iter().position(|(solved_for, _)| solved_for.to_bits() == length_ratio.to_bits());
        let film = match at {
            Some(at) => films.remove(at).1,
            None => with_length(length_ratio),
        };
        films.truncate(KEPT - 1);
        films.insert(0, (length_ratio, film));
        film
    })
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
        let film = with_length(length_ratio);
        let equation = HalfSommerfeld::new(length_ratio);
        let mut worst = [0.0_f64; 3];
        for &ratio in ratios {
            let pressures = equation.pressures(ratio);
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
        let (film, equation) = (with_length(0.02), HalfSommerfeld::new(0.02));
        for k in 1..=9 {
            let pressures = equation.pressures(0.1 * f64::from(k));
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
        let (film, equation) = (with_length(200.0), HalfSommerfeld::new(200.0));
        for k in 1..=9 {
            let ratio = 0.1 * f64::from(k);
            let pressures = equation.pressures(ratio);
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
