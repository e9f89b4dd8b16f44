//! How a journal moves in its bearing, as a film sees it.

use loosepin_math::Real;

/// How a journal moves in its bearing, as a film sees it: seen from a frame that turns with the mean of the two spins the
/// surfaces only approach one another, with the velocity q = ė - ½(ω_i + ω_j) k × e.
///
/// Along n it is q_n = c ε̇, along t it is q_t = -½ w ε c with w = ω_i + ω_j - 2γ̇. So nothing is divided by ε, and a centred
/// journal, whose n may be any direction, is no exception.
#[derive(Debug, Clone, Copy)]
pub struct FilmMotion<T> {
    /// Eccentricity ratio ε = |e|/c, below one.
    pub ratio: T,
    /// ε̇, 1/s.
    pub squeeze_1_s: T,
    /// w ε, 1/s.
    pub wedge_1_s: T,
}

impl<T: Real> FilmMotion<T> {
    /// V = √((w ε)² + 4 ε̇²) = 2|q|/c, 1/s.
    #[inline(always)]
    pub fn speed_1_s(&self) -> T {
        (self.wedge_1_s * self.wedge_1_s + T::from_f64(4.0) * (self.squeeze_1_s * self.squeeze_1_s)).sqrt()
    }
}

/// The force of a film on the journal, N.
#[derive(Debug, Clone, Copy)]
pub struct FilmForce<T> {
    /// F_r along n, from the bearing's centre to the journal's.
    pub radial_n: T,
    /// F_t along t, n turned by +90°.
    pub tangential_n: T,
}

impl<T: Real> FilmForce<T> {
    /// Its magnitude, N.
    #[inline(always)]
    pub fn size_n(&self) -> T {
        (self.radial_n * self.radial_n + self.tangential_n * self.tangential_n).sqrt()
    }

    /// The force times a number.
    #[inline(always)]
    pub fn times(self, factor: T) -> Self {
        Self { radial_n: self.radial_n * factor, tangential_n: self.tangential_n * factor }
    }
}
