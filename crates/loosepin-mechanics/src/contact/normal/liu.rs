//! The normal force of Liu's law.

use super::contact::NormalContact;
use loosepin_math::{Real, logarithm_above_one, numbers};

/// `F_N = K δ √(δ/(c + δ)) (1 + χ δ̇/v0)`, cut at zero.
#[derive(Debug, Clone, Copy)]
pub struct LiuContact<T> {
    /// K = π E* L/(2√2), N/m.
    pub stiffness_n_m: T,
    /// Radial clearance c, m.
    pub clearance_m: T,
    /// Factor χ of the energy loss.
    pub damping_factor: T,
}

numbers!(struct LiuContact { stiffness_n_m, clearance_m, damping_factor });

impl<T: Real> NormalContact<T> for LiuContact<T> {
    #[inline(always)]
    fn elastic_n(&self, penetration_m: T) -> T {
        self.elastic_at_root_n(penetration_m.max(T::zero()).sqrt())
    }

    /// F_el with δ = u²: K u³/√(c + u²), N.
    #[inline(always)]
    fn elastic_at_root_n(&self, root: T) -> T {
        self.stiffness_n_m * (root * root * root) / root.mul_add(root, self.clearance_m).sqrt()
    }

    #[inline(always)]
    fn damping_factor(&self) -> T {
        self.damping_factor
    }

    /// K c² G(δ/c), G as in `liu_energy`.
    #[inline(always)]
    fn stored_energy_j(&self, penetration_m: T) -> T {
        let depth = penetration_m.max(T::zero()) / self.clearance_m;
        self.stiffness_n_m * self.clearance_m * self.clearance_m * liu_energy(depth)
    }

    /// K u³/√(c + u²) is smooth where contact begins.
    #[inline(always)]
    fn is_smooth_in_root(&self) -> bool {
        true
    }
}

/// G(t) = ∫ t^1.5/√(1 + t) dt from zero: (√(t(1 + t))(2t - 3) + 3 ln(√t + √(1 + t)))/4, and by its series where that
/// loses its digits. Long, and so out of line.
#[inline(never)]
pub(super) fn liu_energy<T: Real>(t: T) -> T {
    /// Up to here the series is used.
    const SERIES_END: f64 = 0.25;
    /// The next term is below the last place of the sum at the end.
    const TERMS: usize = 24;
    let constant = T::from_f64;
    let root = t.sqrt();
    // t^2.5 Σ b_k tᵏ/(k + 5/2), b_k the binomial coefficients of -1/2.
    let short = t.min(constant(SERIES_END));
    let mut coefficients = [1.0; TERMS];
    for k in 1..TERMS {
        coefficients[k] = -coefficients[k - 1] * (k as f64 - 0.5) / k as f64;
    }
    let mut sum = T::zero();
    for k in (0..TERMS).rev() {
        sum = sum.mul_add(short, constant(coefficients[k] / (k as f64 + 2.5)));
    }
    let series = sum * t * t * root;
    let rise = (T::one() + t).sqrt();
    let logarithm = constant(3.0) * logarithm_above_one(root + rise);
    let closed = constant(0.25) * (root * rise).mul_add(t + t - constant(3.0), logarithm);
    T::select(constant(SERIES_END).less_than(t), closed, series)
}

#[cfg(test)]
mod tests {
    use super::liu_energy;

    #[test]
    fn identity_series_and_closed_form_meet() {
        // Just below and just above the change; the function itself grows by 1e-9 of 1.5/2.
        let (below, above) = (liu_energy(0.25), liu_energy(0.25 + 1e-12));
        assert!((above / below - 1.0).abs() < 2e-11, "{below} {above}");
    }
}
