//! The interface of a film's pressure, and the bearing that it is in.

use super::motion::{FilmForce, FilmMotion};
use loosepin_math::Real;

/// The numbers of a film's pressure and its equation: what the equations of motion evaluate.
pub trait FilmPressure<T: Real> {
    /// F_r and F_t on the journal, N; zero where nothing moves (ε̇ = wε = 0).
    fn force(&self, motion: &FilmMotion<T>) -> FilmForce<T>;
}

/// A bearing full of oil.
#[derive(Debug, Clone, Copy)]
pub struct FilmBearing {
    /// Viscosity μ of the oil, Pa s.
    pub viscosity_pa_s: f64,
    /// Radius R of the bearing, m.
    pub radius_m: f64,
    /// Length L of the bearing, m.
    pub length_m: f64,
    /// Radial clearance c, m.
    pub clearance_m: f64,
    /// The thinnest film h_min, m: the height of the roughness. Below c.
    pub roughness_m: f64,
}

impl FilmBearing {
    /// Λ = L/D.
    pub fn length_ratio(&self) -> f64 {
        0.5 * self.length_m / self.radius_m
    }

    /// M = μ R L³/c², N s: the factor of infinitely short films.
    pub fn short_factor_n_s(&self) -> f64 {
        self.viscosity_pa_s * self.radius_m * self.length_m.powi(3) / (self.clearance_m * self.clearance_m)
    }

    /// M = μ L R³/c², N s: the factor of infinitely long films.
    pub fn long_factor_n_s(&self) -> f64 {
        self.viscosity_pa_s * self.length_m * self.radius_m.powi(3) / (self.clearance_m * self.clearance_m)
    }
}
