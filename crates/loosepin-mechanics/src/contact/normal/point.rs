//! The normal force that every point-contact law shares.

use super::contact::NormalContact;
use loosepin_math::{Real, numbers};

/// `F_N = K δⁿ (1 + χ δ̇/v0)`, cut at zero: \[SC16\] eq. (8).
///
/// The laws differ in χ alone; K is eq. (9) or given.
#[derive(Debug, Clone, Copy)]
pub struct PointContact<T> {
    /// Stiffness K, N/mⁿ.
    pub stiffness_n_m_n: T,
    /// Exponent n: 3/2 for metals.
    pub exponent: f64,
    /// Factor χ of the energy loss.
    pub damping_factor: T,
}

numbers!(struct PointContact { stiffness_n_m_n, damping_factor; exponent });

impl<T: Real> NormalContact<T> for PointContact<T> {
    /// F_el = K δⁿ, N.
    #[inline(always)]
    fn elastic_n(&self, penetration_m: T) -> T {
        self.stiffness_n_m_n * penetration_m.max(T::zero()).powf(self.exponent) // eq. (8), K δⁿ
    }

    #[inline(always)]
    fn damping_factor(&self) -> T {
        self.damping_factor
    }

    /// K δ^(n+1)/(n+1).
    #[inline(always)]
    fn stored_energy_j(&self, penetration_m: T) -> T {
        let depth_m = penetration_m.max(T::zero());
        self.stiffness_n_m_n * depth_m.powf(self.exponent) * depth_m / T::from_f64(self.exponent + 1.0)
    }

    #[inline(always)]
    fn stiffness(&self) -> Option<(T, f64)> {
        Some((self.stiffness_n_m_n, self.exponent))
    }

    /// K u³ is smooth where contact begins, K δ^1.5 is not.
    #[inline(always)]
    fn is_smooth_in_root(&self) -> bool {
        self.exponent == 1.5
    }

    #[inline(always)]
    fn elastic_at_root_n(&self, root: T) -> T {
        self.stiffness_n_m_n * (root * root * root)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::PlayState;

    /// In contact since an impact at 1/2 m/s.
    const TOUCH: PlayState<f64> =
        PlayState { contact: 1.0, inverse_impact_speed_s_m: 2.0, effective_mass_kg: f64::NAN };

    #[test]
    fn analytic_force_below_at_and_above_contact() {
        let contact = PointContact { stiffness_n_m_n: 6.6e10, exponent: 1.5, damping_factor: 0.3 };
        assert_eq!(contact.force(-1e-9, 0.7, &TOUCH).total_n, 0.0);
        assert_eq!(contact.force(0.0, 0.7, &TOUCH).total_n, 0.0);
        let force = contact.force(1e-9, 0.7, &TOUCH);
        let elastic_n = 6.6e10 * 1e-9 * 1e-9_f64.sqrt();
        // Two roundings.
        assert!((force.elastic_n / elastic_n - 1.0).abs() < 1e-15);
        assert!((force.total_n / (elastic_n * (1.0 + 0.3 * 0.7 * 2.0)) - 1.0).abs() < 1e-15);
    }

    #[test]
    fn identity_a_law_that_would_pull_is_cut_at_zero() {
        let contact = PointContact { stiffness_n_m_n: 6.6e10, exponent: 1.5, damping_factor: 1.9 };
        let force = contact.force(3e-6, -0.9, &TOUCH);
        assert_eq!(force.total_n, 0.0);
        assert!(force.elastic_n > 0.0);
    }

    #[test]
    fn identity_the_elastic_force_is_the_slope_of_the_stored_energy() {
        for exponent in [1.0, 1.2, 1.5, 2.0] {
            let contact = PointContact { stiffness_n_m_n: 4.1e9, exponent, damping_factor: 0.3 };
            let (depth_m, step_m) = (2.3e-5, 1e-9);
            let slope_n = (contact.stored_energy_j(depth_m + step_m) - contact.stored_energy_j(depth_m - step_m))
                / (2.0 * step_m);
            let force_n = contact.force(depth_m, 0.0, &TOUCH).total_n;
            // Central difference: (step/depth)² and round-off of the energies over the step.
            assert!((slope_n / force_n - 1.0).abs() < 1e-7);
        }
    }
}
