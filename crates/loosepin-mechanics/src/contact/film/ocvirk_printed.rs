//! Ocvirk's film as it is printed.

use super::motion::{FilmForce, FilmMotion};
use super::pressure::{FilmBearing, FilmPressure};
use loosepin_math::{Real, numbers};

/// β: where |wε| is below this times |ε̇|, the jump of F_t is spread out.
const BAND: f64 = 0.05;

/// Infinitely short bearing (Ocvirk 1953) as it is printed: the half of the film that the rotation alone would
/// load, θ from 0 to π for w > 0 and from -π to 0 for w < 0. With M = μ R L³/c² and S = 1 - ε²
///
/// F_r = -M (|w| ε²/S² + π ε̇ (1 + 2ε²)/(2 S^2.5)), F_t = M (w π ε/(4 S^1.5) + sgn(w) 2 ε ε̇/S²).
///
/// Part of the pressure in the half is negative, and F_t jumps where w goes through zero while ε̇ is not: there with ε̇ > 0 it drives w
/// back to zero from both sides, and a run would stand still. So sgn(w) is led linearly from -1 to 1 where |wε| < |ε̇|/20 [our own].
/// [`super::OcvirkFilm`] needs none of that.
#[derive(Debug, Clone, Copy)]
pub struct OcvirkPrintedFilm<T> {
    /// M = μ R L³/c², N s.
    pub factor_n_s: T,
}

numbers!(struct OcvirkPrintedFilm { factor_n_s });

impl OcvirkPrintedFilm<f64> {
    /// The name used in model files, in kebab case.
    pub const NAME: &'static str = "ocvirk-printed";
    /// Author, year, and what it assumes.
    pub const SOURCE: &'static str = "Ocvirk 1953, infinitely short, the half of the film that the rotation loads";
    /// The thinnest film that it holds for, as a share of the clearance.
    pub const THINNEST_SHARE: f64 = 0.0;
    /// The largest L/D that it holds for.
    pub const LONGEST: f64 = f64::INFINITY;

    /// The film of a bearing.
    pub fn new(bearing: &FilmBearing) -> Self {
        Self { factor_n_s: bearing.short_factor_n_s() }
    }
}

impl<T: Real> FilmPressure<T> for OcvirkPrintedFilm<T> {
    #[inline(always)]
    fn force(&self, motion: &FilmMotion<T>) -> FilmForce<T> {
        let constant = T::from_f64;
        let (epsilon, squeeze, wedge) = (motion.ratio, motion.squeeze_1_s, motion.wedge_1_s);
        let square = epsilon * epsilon;
        let inverse = T::one() / (T::one() - square); // 1/S
        let root = inverse.sqrt();
        let bend = constant(2.0).mul_add(square, T::one());
        let radial = wedge.abs() * epsilon + constant(std::f64::consts::FRAC_PI_2) * squeeze * bend * root;
        // sgn(w) |ε̇|, led over |wε| < β|ε̇|.
        let size = squeeze.abs();
        let led = (wedge * constant(1.0 / BAND)).max(-size).min(size);
        let turning = T::select(squeeze.less_than(T::zero()), -led, led);
        let along = constant(std::f64::consts::FRAC_PI_4) * wedge * root * inverse;
        let jump = turning * constant(2.0) * epsilon * inverse * inverse;
        FilmForce {
            radial_n: -(self.factor_n_s * radial * inverse * inverse),
            tangential_n: self.factor_n_s * (along + jump),
        }
    }
}
