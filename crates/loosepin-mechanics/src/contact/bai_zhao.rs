//! Bai and Zhao 2013.

use super::line::{LineLaw, LinePair};
use super::liu::{liu_energy, liu_stiffness_n_m};
use super::normal::{NormalContact, NormalLaw};
use loosepin_math::Real;

/// Bai and Zhao's hybrid law 2013: F = K_n δ, K_n = (π E* L/8) √(2δ(3c + 2δ)²/(c + δ)³), for every δ; energy loss by Zhiying and
/// Qishao where the model file names no other.
///
/// K_n is the slope dF/dδ of Liu's law, so that F is δ times it.
#[derive(Debug)]
pub struct BaiZhao;

impl LineLaw for BaiZhao {
    fn name(&self) -> &'static str {
        "bai-zhao"
    }
    fn source(&self) -> &'static str {
        "Bai and Zhao 2013: F = K_n δ, K_n = (π E* L/8) √(2δ(3c + 2δ)²/(c + δ)³), E* = 1/(π h)"
    }
    fn default_damping(&self) -> &'static str {
        "zhiying-qishao"
    }
    fn contact(&self, pair: &LinePair, damping_factor: f64) -> NormalLaw<f64> {
        NormalLaw::BaiZhao(BaiZhaoContact {
            stiffness_n_m: liu_stiffness_n_m(pair),
            clearance_m: pair.clearance_m,
            damping_factor,
        })
    }
}

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

impl<T: Real> BaiZhaoContact<T> {
    /// The same numbers in every lane.
    pub fn broadcast(from: &BaiZhaoContact<f64>) -> Self {
        Self {
            stiffness_n_m: T::from_f64(from.stiffness_n_m),
            clearance_m: T::from_f64(from.clearance_m),
            damping_factor: T::from_f64(from.damping_factor),
        }
    }
}

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

    fn visit(&mut self, visit: &mut impl FnMut(&mut T)) {
        visit(&mut self.stiffness_n_m);
        visit(&mut self.clearance_m);
        visit(&mut self.damping_factor);
    }
}

#[cfg(test)]
mod tests {
    use super::BaiZhao;
    use crate::contact::static_table::{assert_static_forces, bisected};

    #[test]
    fn analytic_static_forces() {
        assert_static_forces(&BaiZhao, [0.1692, 5.2722, 55.403], |pair, force_n| {
            bisected(force_n, 1.0, |depth_m| {
                let c = pair.clearance_m;
                let square = 2.0 * depth_m * (3.0 * c + 2.0 * depth_m).powi(2) / (c + depth_m).powi(3);
                std::f64::consts::PI * pair.equivalent_modulus_pa() * pair.length_m / 8.0 * square.sqrt() * depth_m
            })
        });
    }
}
