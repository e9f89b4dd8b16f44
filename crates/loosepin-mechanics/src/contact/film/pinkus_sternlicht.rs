//! The infinitely long film of Pinkus and Sternlicht.

use super::motion::{FilmForce, FilmMotion};
use super::pressure::{FilmBearing, FilmPressure};
use loosepin_math::{Real, numbers};

/// Infinitely long bearing with squeeze (Pinkus and Sternlicht 1961, with its sign corrected, see `docs/lubrication.md`). With
/// M = μ L R³/c², S = 1 - ε² and k² = S ((w/(2ε̇))² + 1/ε²)
///
/// F_r = -6 M ε̇ (4kε² + (2 + ε²)π)/((2 + ε²) S^1.5) g, F_t = 6π M ε w/((2 + ε²) √S) g, g = (k + 3)/(k + 3/2) for ε̇ > 0; for ε̇ < 0 with
/// |ε̇|, the sign of π turned, and g = k/(k + 3/2).
///
/// k grows without limit where ε or ε̇ is zero, so that κ = k ε |ε̇| = √S V/2 takes its place: k ε² |ε̇| = ε κ,
/// g = (κ + 3ε max(ε̇, 0))/(κ + 3/2 ε|ε̇|).
///
/// Without squeeze this is the half-Sommerfeld film. With squeeze it is the authors' approximation: 3.4 % above -12π M ε̇/S^1.5 in pure
/// squeeze at ε = 0.9; on approach up to 16 % off the film whose negative pressure is dropped, up to ε = 0.9; where the journal moves
/// away, up to thirty times the small force of that film. [`super::FiniteLengthFilm`] has no such error for any L/D.
#[derive(Debug, Clone, Copy)]
pub struct PinkusSternlichtFilm<T> {
    /// M = μ L R³/c², N s.
    pub factor_n_s: T,
}

numbers!(struct PinkusSternlichtFilm { factor_n_s });

impl PinkusSternlichtFilm<f64> {
    /// The name used in model files, in kebab case.
    pub const NAME: &'static str = "pinkus-sternlicht";
    /// Author, year, and what it assumes.
    pub const SOURCE: &'static str = "Pinkus and Sternlicht 1961, infinitely long with squeeze, half-Sommerfeld";
    /// The thinnest film that it holds for, as a share of the clearance.
    pub const THINNEST_SHARE: f64 = 0.0;
    /// The largest L/D that it holds for.
    pub const LONGEST: f64 = f64::INFINITY;

    /// The film of a bearing.
    pub fn new(bearing: &FilmBearing) -> Self {
        Self { factor_n_s: bearing.long_factor_n_s() }
    }
}

impl<T: Real> FilmPressure<T> for PinkusSternlichtFilm<T> {
    #[inline(always)]
    fn force(&self, motion: &FilmMotion<T>) -> FilmForce<T> {
        let constant = T::from_f64;
        let (epsilon, squeeze) = (motion.ratio, motion.squeeze_1_s);
        let gap = T::one() - epsilon * epsilon; // S
        let root = gap.sqrt();
        let bend = epsilon.mul_add(epsilon, constant(2.0));
        let kappa = constant(0.5) * root * motion.speed_1_s();
        let above = (constant(3.0) * epsilon).mul_add(squeeze.max(T::zero()), kappa);
        let below = (constant(1.5) * epsilon).mul_add(squeeze.abs(), kappa);
        let share = above / below.max(constant(f64::MIN_POSITIVE)); // g
        let size_n = constant(6.0) * self.factor_n_s * share / (bend * root);
        let pi = constant(std::f64::consts::PI);
        let radial = (constant(4.0) * epsilon * kappa + bend * pi * squeeze) / gap;
        FilmForce { radial_n: -(size_n * radial), tangential_n: size_n * pi * motion.wedge_1_s }
    }
}
