//! The film of a bearing of any length that ruptures where its pressure and the slope of the pressure vanish.

use super::motion::{FilmForce, FilmMotion};
use super::ocvirk::OcvirkFilm;
use super::pressure::{FilmBearing, FilmPressure};
use super::quotient::{CROSSOVER, FilmQuotient, TERMS, THINNEST_SHARE};
use super::reynolds_table::{LENGTHS, TABLE};
use loosepin_math::{Real, numbers, sin_cos};

/// The largest Λ of the table.
const LONGEST: f64 = 4.0;
/// l of a very short bearing.
const MIN_REACH: f64 = 0.05;

/// Bearing of any length up to Λ = L/D = 4 under the Reynolds condition (Swift 1932, Stieber 1933): the pressure is nowhere negative, and
/// where the film ruptures pressure and slope vanish together. The problem is nonlinear in the velocity; its solution (`RupturedFilm` of
/// the tests) was fitted once by a `FilmQuotient` with l² = κΛ² + 0.05² at 24 eccentricities and 41 directions of the velocity for each
/// of 16 lengths. The sums for any Λ are interpolated in Λ/(1 + Λ) by the polynomial through these and Ocvirk's film (Λ = 0).
///
/// Error of the sums against the solution, between lengths, eccentricities and directions, up to ε = 0.9: 0.05 % of the force on approach and
/// under a steady load (0.15 % from L/D = 3 on), 0.3 % where the journal moves away. From there up to ε = 0.998: 0.25 % on approach, 0.1 % of
/// the largest force at the same ε in all directions. The solution itself is within 0.01 %.
///
/// The force has all derivatives but where nothing moves, and the power lost is positive in every direction.
#[derive(Debug, Clone, Copy)]
pub struct ReynoldsFilm<T> {
    /// The force.
    pub quotient: FilmQuotient<T>,
}

numbers!(struct ReynoldsFilm { quotient });

impl ReynoldsFilm<f64> {
    /// The name used in model files, in kebab case.
    pub const NAME: &'static str = "reynolds";
    /// Author, year, and what it assumes.
    pub const SOURCE: &'static str =
        "own solution of the Reynolds equation for L/D up to 4 that ruptures without a slope: Swift 1932, Stieber 1933";
    /// The thinnest film that it holds for, as a share of the clearance.
    pub const THINNEST_SHARE: f64 = THINNEST_SHARE;
    /// The largest L/D that it holds for.
    pub const LONGEST: f64 = LONGEST;

    /// The film of a bearing.
    pub fn new(bearing: &FilmBearing) -> Self {
        let quotient = FilmQuotient { short: OcvirkFilm::new(bearing), ..with_length(bearing.length_ratio()) };
        Self { quotient }
    }
}

impl<T: Real> FilmPressure<T> for ReynoldsFilm<T> {
    #[inline(always)]
    fn force(&self, motion: &FilmMotion<T>) -> FilmForce<T> {
        self.quotient.force(motion)
    }
}

/// For Λ, without sums.
fn without_sums(length_ratio: f64) -> FilmQuotient<f64> {
    let reach = (CROSSOVER * length_ratio * length_ratio + MIN_REACH * MIN_REACH).sqrt();
    FilmQuotient::without_sums(length_ratio, reach)
}

/// Λ/(1 + Λ) of a length of the table; zero is Ocvirk's film. Chebyshev's places, denser at the ends.
fn place(length: usize) -> f64 {
    let share = 0.5 - 0.5 * sin_cos(std::f64::consts::PI * length as f64 / LENGTHS as f64).1;
    share * LONGEST / (1.0 + LONGEST)
}

/// For Λ, with forces in units of μ L R³/c²: the polynomial through the sums of all lengths, in barycentric form.
fn with_length(length_ratio: f64) -> FilmQuotient<f64> {
    let at = length_ratio / (1.0 + length_ratio);
    let mut film = without_sums(length_ratio);
    let mut total = 0.0;
    for length in 0..=LENGTHS {
        let sums = |term: usize| match length.checked_sub(1) {
            Some(row) => TABLE[row][term],
            None => [if term == 0 { 1.0 } else { 0.0 }, 0.0],
        };
        let apart = at - place(length);
        if apart == 0.0 {
            film.sums = std::array::from_fn(sums);
            return film;
        }
        let is_end = length == 0 || length == LENGTHS;
        let weight = if length % 2 == 0 { 1.0 } else { -1.0 } * if is_end { 0.5 } else { 1.0 } / apart;
        total += weight;
        for term in 0..TERMS {
            for part in 0..2 {
                film.sums[term][part] += weight * sums(term)[part];
            }
        }
    }
    film.sums.iter_mut().flatten().for_each(|sum| *sum /= total);
    film
}

#[cfg(test)]
mod tests {
    use super::super::quotient::MAX_RATIO;
    use super::super::ruptured::RupturedFilm;
    use super::*;
    use std::f64::consts::PI;
    use std::fmt::Write;

    /// Eccentricity ratios and directions of the velocity that the equation is solved for.
    const RATIOS: usize = 24;
    const DIRECTIONS: usize = 41;

    fn motion(ratio: f64, turn: f64) -> FilmMotion<f64> {
        let (sine, cosine) = sin_cos(turn);
        FilmMotion { ratio, squeeze_1_s: cosine, wedge_1_s: 2.0 * sine }
    }

    /// The sums for Λ.
    fn fitted(length_ratio: f64) -> FilmQuotient<f64> {
        let mut film = without_sums(length_ratio);
        film.fit((0..RATIOS).map(|k| {
            let share = 0.5 - 0.5 * sin_cos(PI * k as f64 / (RATIOS - 1) as f64).1;
            // Evenly over √(1 - ε), denser at the ends.
            let thinnest = (1.0 - MAX_RATIO).sqrt();
            let ratio = 1.0 - (thinnest + (1.0 - thinnest) * share).powi(2);
            let mut solution = RupturedFilm::new(length_ratio, ratio);
            (0..DIRECTIONS)
                .map(|direction| {
                    let motion = motion(ratio, PI * direction as f64 / (DIRECTIONS - 1) as f64);
                    (motion, solution.force(motion.squeeze_1_s, motion.wedge_1_s))
                })
                .collect()
        }));
        film
    }

    fn apart(first: &FilmForce<f64>, second: &FilmForce<f64>) -> f64 {
        (first.radial_n - second.radial_n).hypot(first.tangential_n - second.tangential_n)
    }

    /// The largest errors of the sums between the places that they are made from: of the force on approach and under a steady load, of the
    /// force, and of the largest force at the same ε.
    fn errors(length_ratio: f64, ratios: &[f64], directions: u32) -> [f64; 3] {
        let film = with_length(length_ratio);
        let mut worst = [0.0_f64; 3];
        for &ratio in ratios {
            let mut solution = RupturedFilm::new(length_ratio, ratio);
            let largest = film.force(&motion(ratio, 0.0)).size_n();
            for k in 0..directions {
                let motion = motion(ratio, PI * (f64::from(k) + 0.3) / f64::from(directions));
                let expected = solution.force(motion.squeeze_1_s, motion.wedge_1_s);
                let error = apart(&film.force(&motion), &expected);
                let relative = error / expected.size_n();
                let on_approach = if motion.squeeze_1_s < -1e-9 { 0.0 } else { relative };
                for (worst, error) in worst.iter_mut().zip([on_approach, relative, error / largest]) {
                    *worst = worst.max(error);
                }
            }
        }
        worst
    }

    /// Largest errors up to ε = 0.9, then up to 0.9975, of bearings up to L/D = 3, then up to 4.
    const LIMITS: [[[f64; 3]; 2]; 2] =
        [[[5e-4, 2.5e-3, 2.5e-4], [1e-3, 2.5e-2, 1e-3]], [[1.5e-3, 3e-3, 3e-4], [2.5e-3, 6e-3, 3e-4]]];

    fn assert_errors(lengths: &[f64], ratios: [&[f64]; 2], directions: u32) {
        let mut worst = [[[0.0_f64; 3]; 2]; 2];
        for &length_ratio in lengths {
            let is_long = usize::from(length_ratio > 3.0);
            for part in 0..2 {
                let found = errors(length_ratio, ratios[part], directions);
                for k in 0..3 {
                    worst[is_long][part][k] = worst[is_long][part][k].max(found[k]);
                }
            }
            println!("L/D = {length_ratio}: {worst:.5?}");
        }
        let is_within = |(found, limit): (&[f64; 3], &[f64; 3])| found.iter().zip(limit).all(|(f, l)| f < l);
        assert!(worst.iter().flatten().zip(LIMITS.iter().flatten()).all(is_within), "{worst:.5?}");
    }

    #[test]
    fn identity_the_table_solves_the_reynolds_condition_between_its_places() {
        assert_errors(&[0.03, 0.4, 3.6], [&[0.47], &[0.95]], 5);
    }

    #[test]
    #[ignore = "a minute or two in a release build: the figures of docs/lubrication.md"]
    fn identity_the_table_solves_the_reynolds_condition_at_many_places() {
        let lengths =
            [0.005, 0.02, 0.05, 0.08, 0.125, 0.2, 0.27, 0.4, 0.55, 0.8, 1.0, 1.2, 1.6, 2.0, 2.5, 2.9, 3.3, 3.6, 3.9];
        let thicker = [0.01, 0.07, 0.2, 0.35, 0.47, 0.6, 0.72, 0.81, 0.9];
        assert_errors(&lengths, [&thicker, &[0.93, 0.955, 0.975, 0.985, 0.992, 0.9975]], 24);
    }

    #[test]
    fn analytic_a_very_short_bearing_is_that_of_ocvirk() {
        let short = OcvirkFilm { factor_n_s: 4.0 * 1e-8 };
        for ratio in [0.0, 0.3, 0.7, 0.97] {
            for k in 0..12 {
                let motion = motion(ratio, PI * f64::from(k) / 6.0);
                let (found, expected) = (with_length(1e-4).force(&motion), short.force(&motion));
                assert!(apart(&found, &expected) < 2e-3 * expected.size_n(), "{motion:?}: {found:?} {expected:?}");
            }
        }
    }

    /// The power lost is F·q over |F||q|: positive in every direction, and by more than the sums err.
    #[test]
    fn identity_the_film_takes_power_in_every_direction() {
        let mut least = [1.0_f64; 3];
        // Eccentricities, and what they are told apart by: up to 0.9, up to 0.99, up to the thinnest film.
        for length in 0..=160 {
            let film = with_length(LONGEST * (f64::from(length) / 160.0).powi(2));
            for step in 0..=120 {
                let thickness = 1.0 + (THINNEST_SHARE.sqrt() - 1.0) * f64::from(step) / 120.0;
                let ratio = 1.0 - thickness * thickness;
                let part = usize::from(ratio > 0.9) + usize::from(ratio > 0.99);
                for k in 0..90 {
                    let motion = motion(ratio, 2.0 * PI * f64::from(k) / 90.0);
                    let force = film.force(&motion);
                    let power = 0.5 * force.tangential_n * motion.wedge_1_s - force.radial_n * motion.squeeze_1_s;
                    if length > 0 {
                        least[part] = least[part].min(power / force.size_n());
                    }
                }
            }
        }
        println!("{least:.4?}");
        // What a film that is as thin as this has by itself: it pushes away from the wall whatever direction the journal moves in.
        for (found, at_least) in least.into_iter().zip([0.3, 0.1, 0.04]) {
            assert!(found > at_least, "{least:?}");
        }
    }

    #[test]
    #[allow(clippy::disallowed_methods, reason = "a source is written, not a result")]
    #[ignore = "writes reynolds_table.rs in a few minutes: just film-table"]
    fn write_the_table() {
        let rows: Vec<_> = std::thread::scope(|scope| {
            let halves = [0, 1].map(|half| {
                scope.spawn(move || {
                    let lengths = (1..=LENGTHS).filter(|length| length % 2 == half);
                    lengths.map(|length| (length, fitted(place(length) / (1.0 - place(length))))).collect::<Vec<_>>()
                })
            });
            let mut rows: Vec<_> = halves.into_iter().flat_map(|half| half.join().expect("it is solved")).collect();
            rows.sort_by_key(|(length, _)| *length);
            rows
        });
        let mut text = format!(
            "//! The sums of [`super::ReynoldsFilm`], a_ij and b_ij, for each length. Written by `just film-table`.\n\n\
             use super::quotient::TERMS;\n\n\
             /// Lengths of the table.\n\
             pub(super) const LENGTHS: usize = {LENGTHS};\n\n\
             pub(super) static TABLE: [[[f64; 2]; TERMS]; LENGTHS] = [\n"
        );
        for (length, film) in rows {
            let length_ratio = place(length) / (1.0 - place(length));
            writeln!(text, "    // L/D = {length_ratio:.6}\n    [").expect("a string takes all");
            for pairs in film.sums.chunks(5) {
                let pairs: Vec<_> = pairs.iter().map(|[a, b]| format!("[{a:.8}, {b:.8}]")).collect();
                writeln!(text, "        {},", pairs.join(", ")).expect("a string takes all");
            }
            text += "    ],\n";
        }
        let file = concat!(env!("CARGO_MANIFEST_DIR"), "/src/contact/film/reynolds_table.rs");
        std::fs::write(file, text + "];\n").expect("the table is written");
    }
}
