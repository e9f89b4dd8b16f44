//! Ocvirk's film, its positive half wherever that is.

use super::motion::{FilmForce, FilmMotion};
use super::pressure::{FilmBearing, FilmPressure};
use loosepin_math::{Real, arctangent, numbers};

/// Infinitely short bearing (Ocvirk 1953), the positive half of its pressure: with h = 1 + ε cos θ, θ from the
/// thickest film, p ~ V sin(θ - α)/h³ is positive from α = atan2(2ε̇, wε) to α + π, V = √((wε)² + 4ε̇²).
///
/// F_r = ½ M V (C cos α - A sin α), F_t = ½ M V (B cos α - C sin α), M = μ R L³/c², with the integrals of cos²θ/h³, sin²θ/h³ and
/// sin θ cos θ/h³ over that half in closed form [derived here; tested against a quadrature]. With s = sin α, k = cos α, S = 1 - ε²,
/// P = 1 - ε²k², J = (π + 2 atan(ε s/√S))/√S:
///
/// A = J (1 + 2ε²)/(2S²) + ε s (3/(P S²) + 2k²/(P² S)), B = J/(2S) + ε s (1 - 2k² + ε²k²)/(P² S), C = -2 ε k³/P².
///
/// No angle is computed, and nothing jumps at w = 0. The film whose half is fixed is
/// [`super::OcvirkPrintedFilm`].
#[derive(Debug, Clone, Copy)]
pub struct OcvirkFilm<T> {
    /// M = μ R L³/c², N s.
    pub factor_n_s: T,
}

numbers!(struct OcvirkFilm { factor_n_s });

impl OcvirkFilm<f64> {
    /// The name used in model files, in kebab case.
    pub const NAME: &'static str = "ocvirk";
    /// Author, year, and what it assumes.
    pub const SOURCE: &'static str = "Ocvirk 1953, infinitely short, the positive half of the film from atan2(2ε̇, wε)";
    /// The thinnest film that it holds for, as a share of the clearance.
    pub const THINNEST_SHARE: f64 = 0.0;
    /// The largest L/D that it holds for.
    pub const LONGEST: f64 = f64::INFINITY;

    /// The film of a bearing.
    pub fn new(bearing: &FilmBearing) -> Self {
        Self { factor_n_s: bearing.short_factor_n_s() }
    }
}

impl<T: Real> FilmPressure<T> for OcvirkFilm<T> {
    #[inline(always)]
    fn force(&self, motion: &FilmMotion<T>) -> FilmForce<T> {
        let (one, two) = (T::one(), T::from_f64(2.0));
        let epsilon = motion.ratio;
        let speed_1_s = motion.speed_1_s();
        let inverse_s = one / speed_1_s.max(T::from_f64(f64::MIN_POSITIVE));
        let (sine, cosine) = (two * motion.squeeze_1_s * inverse_s, motion.wedge_1_s * inverse_s);
        let tilt = epsilon * sine;
        let across = epsilon * cosine;
        let inverse_gap = one / (one - epsilon * epsilon); // 1/S
        let root = inverse_gap.sqrt();
        let inverse_product = one / (one - across * across); // 1/P
        let angle = two.mul_add(arctangent(tilt * root), T::from_f64(std::f64::consts::PI)) * root; // J
        let squares = inverse_product * inverse_product;
        let cosine_squared = cosine * cosine;
        let sum_a = T::from_f64(3.0).mul_add(inverse_gap, two * cosine_squared * inverse_product) * inverse_product;
        let bend = two.mul_add(epsilon * epsilon, one);
        let half = T::from_f64(0.5);
        let a = (half * angle * bend * inverse_gap + tilt * sum_a) * inverse_gap;
        let sum_b = across.mul_add(across, one - two * cosine_squared) * squares;
        let b = (half * angle + tilt * sum_b) * inverse_gap;
        let c = -(two * across * cosine_squared * squares);
        let size_n = half * self.factor_n_s * speed_1_s;
        FilmForce { radial_n: size_n * (c * cosine - a * sine), tangential_n: size_n * (b * cosine - c * sine) }
    }
}
