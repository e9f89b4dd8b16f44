//! The normal force of Pereira's law: a power whose exponent is a number of the run.

use super::contact::NormalContact;
use loosepin_math::{Real, exponential, natural_logarithm, numbers};

/// `F_N = F₁ (δ/1 mm)ⁿ (1 + χ δ̇/v0)`, cut at zero, with an exponent that follows the clearance.
#[derive(Debug, Clone, Copy)]
pub struct PereiraContact<T> {
    /// F₁, N: F_el at δ = 1 mm.
    pub force_at_1_mm_n: T,
    /// Exponent n.
    pub exponent: T,
    /// Factor χ of the energy loss.
    pub damping_factor: T,
}

numbers!(struct PereiraContact { force_at_1_mm_n, exponent, damping_factor });

impl<T: Real> NormalContact<T> for PereiraContact<T> {
    /// F_el, N; zero without penetration.
    #[inline(always)]
    fn elastic_n(&self, penetration_m: T) -> T {
        let depth_mm = penetration_m * T::from_f64(1e3);
        let power = exponential(self.exponent * natural_logarithm(depth_mm));
        T::select(T::zero().less_than(depth_mm), self.force_at_1_mm_n * power, T::zero())
    }

    #[inline(always)]
    fn damping_factor(&self) -> T {
        self.damping_factor
    }

    /// F_el δ/(n + 1).
    #[inline(always)]
    fn stored_energy_j(&self, penetration_m: T) -> T {
        self.elastic_n(penetration_m) * penetration_m / (self.exponent + T::one())
    }

    #[inline(always)]
    fn has_abrupt_onset(&self) -> bool {
        true
    }
}
