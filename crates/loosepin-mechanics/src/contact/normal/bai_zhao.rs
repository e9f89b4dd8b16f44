//! The normal force of Bai and Zhao's law.

use super::contact::NormalContact;
use super::liu::liu_energy;
use loosepin_math::{Real, numbers};

/// `F_N = ½ K δ^1.5 (3c + 2δ)/(c + δ)^1.5 (1 + χ δ̇/v0)`, cut at zero.
#[derive(Debug, Clone, Copy)]
pub struct BaiZhaoContact<T> {
    /// K = π E* L/(2√2), N/m.
    pub stiffness_n_m: T,
    /// Radial clearance c, m.
    pub clearance_m: T,
    /// Factor χ of the energy loss.
    pub damping_factor: T,
}

numbers!(struct BaiZhaoContact { stiffness_n_m, clearance_m, damping_factor });

impl<T: Real> NormalContact<T> for BaiZhaoContact<T> {
    #[inline(always)]
    fn elastic_n(&self, penetration_m: T) -> T {
        self.elastic_at_root_n(penetration_m.max(T::zero()).sqrt())
    }

    /// F_el with δ = u², N.
    #[inline(always)]
    fn elastic_at_root_n(&self, root: T) -> T {
        let distance_m = root.mul_add(root, self.clearance_m);
        let slope = (self.clearance_m + distance_m + distance_m) / (distance_m * distance_m.sqrt());
        T::from_f64(0.5) * self.stiffness_n_m * (root * root * root) * slope
    }

    #[inline(always)]
    fn damping_factor(&self) -> T {
        self.damping_factor
    }

    /// With F = δ F'_Liu: δ F_Liu minus the energy of Liu's law.
    #[inline(always)]
    fn stored_energy_j(&self, penetration_m: T) -> T {
        let depth = penetration_m.max(T::zero()) / self.clearance_m;
        let liu = depth * depth * (depth / (T::one() + depth)).sqrt();
        self.stiffness_n_m * self.clearance_m * self.clearance_m * (liu - liu_energy(depth))
    }

    /// Smooth in u = √δ where contact begins.
    #[inline(always)]
    fn is_smooth_in_root(&self) -> bool {
        true
    }
}
