//! The normal force that every point-contact law shares.

use crate::math::Real;

/// `F_N = K δⁿ (1 + χ δ̇/v0)`, cut at zero (method, section 2.1).
///
/// The laws differ in χ alone; K is eq. (9) of the source or given.
#[derive(Debug, Clone, Copy)]
pub struct NormalContact<T> {
    /// Stiffness K, N/mⁿ.
    pub stiffness_n_m_n: T,
    /// Exponent n: 3/2 for metals.
    pub exponent: f64,
    /// Factor χ of the energy loss.
    pub damping_factor: T,
}

/// A normal force and its elastic part.
#[derive(Debug, Clone, Copy)]
pub struct NormalForce<T> {
    /// F_N, N, never negative.
    pub total_n: T,
    /// F_el = K δⁿ, N: the part that is stored and given back.
    pub elastic_n: T,
}

impl<T: Real> NormalContact<T> {
    /// The force at penetration δ, m, and penetration rate δ̇, m/s, in a contact that began at speed v0
    /// (`inverse_impact_speed_s_m` = 1/v0). A negative δ counts as zero: there the force is zero.
    ///
    /// The contact loses the power (F_N - F_el) δ̇, also while the cut acts.
    #[inline(always)]
    pub fn force(&self, penetration_m: T, rate_m_s: T, inverse_impact_speed_s_m: T) -> NormalForce<T> {
        let elastic_n = self.stiffness_n_m_n * penetration_m.max(T::zero()).powf(self.exponent);
        self.with_loss(elastic_n, rate_m_s, inverse_impact_speed_s_m)
    }

    /// The force for n = 3/2 at the root u = √δ of the penetration, √m: K u³ is smooth where contact begins, K δ^1.5 is
    /// not. A negative root, just beyond the end of contact, continues the force smoothly.
    #[inline(always)]
    pub fn force_at_root(&self, root: T, rate_m_s: T, inverse_impact_speed_s_m: T) -> NormalForce<T> {
        self.with_loss(self.stiffness_n_m_n * (root * root * root), rate_m_s, inverse_impact_speed_s_m)
    }

    /// `F_N = F_el (1 + χ δ̇/v0)`, the factor cut at zero.
    #[inline(always)]
    fn with_loss(&self, elastic_n: T, rate_m_s: T, inverse_impact_speed_s_m: T) -> NormalForce<T> {
        let factor = (self.damping_factor * rate_m_s).mul_add(inverse_impact_speed_s_m, T::one());
        NormalForce { total_n: elastic_n * factor.max(T::zero()), elastic_n }
    }

    /// The energy stored at penetration δ: K δ^(n+1)/(n+1), J.
    #[inline(always)]
    pub fn stored_energy_j(&self, penetration_m: T) -> T {
        let depth_m = penetration_m.max(T::zero());
        self.stiffness_n_m_n * depth_m.powf(self.exponent) * depth_m / T::from_f64(self.exponent + 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_force_below_at_and_above_contact() {
        let contact = NormalContact { stiffness_n_m_n: 6.6e10, exponent: 1.5, damping_factor: 0.3 };
        assert_eq!(contact.force(-1e-9, 0.7, 2.0).total_n, 0.0);
        assert_eq!(contact.force(0.0, 0.7, 2.0).total_n, 0.0);
        let force = contact.force(1e-9, 0.7, 2.0);
        let elastic_n = 6.6e10 * 1e-9 * 1e-9_f64.sqrt();
        // Two roundings.
        assert!((force.elastic_n / elastic_n - 1.0).abs() < 1e-15);
        assert!((force.total_n / (elastic_n * (1.0 + 0.3 * 0.7 * 2.0)) - 1.0).abs() < 1e-15);
    }

    #[test]
    fn identity_a_law_that_would_pull_is_cut_at_zero() {
        let contact = NormalContact { stiffness_n_m_n: 6.6e10, exponent: 1.5, damping_factor: 1.9 };
        let force = contact.force(3e-6, -0.9, 1.0);
        assert_eq!(force.total_n, 0.0);
        assert!(force.elastic_n > 0.0);
    }

    #[test]
    fn identity_the_elastic_force_is_the_slope_of_the_stored_energy() {
        for exponent in [1.0, 1.2, 1.5, 2.0] {
            let contact = NormalContact { stiffness_n_m_n: 4.1e9, exponent, damping_factor: 0.3 };
            let (depth_m, step_m) = (2.3e-5, 1e-9);
            let slope_n = (contact.stored_energy_j(depth_m + step_m) - contact.stored_energy_j(depth_m - step_m))
                / (2.0 * step_m);
            let force_n = contact.force(depth_m, 0.0, 1.0).total_n;
            // Central difference: (step/depth)² and round-off of the energies over the step.
            assert!((slope_n / force_n - 1.0).abs() < 1e-7);
        }
    }
}
