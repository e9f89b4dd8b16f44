//! The normal force that the logarithmic line-contact laws share.

use super::contact::NormalContact;
use loosepin_math::{Real, logarithm_above_one, natural_logarithm, numbers};

/// The force F that δ = s ln(a/s), s = F h/L, gives for a penetration δ, times (1 + χ δ̇/v0), cut at zero.
///
/// Johnson, ESDU-78035, Dubowsky and Freudenstein and Radzimovsky differ in the length a alone. With w = ln(a/s) the law reads
/// `w - ln w = -ln(δ/a)`, w >= 1, and s = δ/w. δ is largest, a/e, where w = 1: a law cannot be inverted beyond.
#[derive(Debug, Clone, Copy)]
pub struct LogarithmicContact<T> {
    /// L/h, N/m.
    pub stiffness_n_m: T,
    /// The length a, m.
    pub scale_m: T,
    /// Factor χ of the energy loss.
    pub damping_factor: T,
}

numbers!(struct LogarithmicContact { stiffness_n_m, scale_m, damping_factor });

impl<T: Real> LogarithmicContact<T> {
    /// 1/w = s/δ at a penetration δ, m. Beyond the limit of inversion as at it.
    #[inline(always)]
    fn share(&self, depth_m: T) -> T {
        T::one() / inverse_logarithmic(depth_m / self.scale_m)
    }
}

impl<T: Real> NormalContact<T> for LogarithmicContact<T> {
    #[inline(always)]
    fn elastic_n(&self, penetration_m: T) -> T {
        let depth_m = penetration_m.max(T::zero());
        self.stiffness_n_m * depth_m * self.share(depth_m)
    }

    #[inline(always)]
    fn damping_factor(&self) -> T {
        self.damping_factor
    }

    /// ∫ F dδ = F δ - ∫ δ dF = (L/h)(s δ - s²/2 ln(a/s) - s²/4) = F (δ/2 - s/4).
    #[inline(always)]
    fn stored_energy_j(&self, penetration_m: T) -> T {
        let depth_m = penetration_m.max(T::zero());
        let share = self.share(depth_m);
        let force_n = self.stiffness_n_m * depth_m * share;
        force_n * depth_m * (T::from_f64(0.5) - T::from_f64(0.25) * share)
    }

    #[inline(always)]
    fn limit_m(&self) -> Option<T> {
        Some(self.scale_m * T::from_f64(1.0 / std::f64::consts::E))
    }

    #[inline(always)]
    fn has_abrupt_onset(&self) -> bool {
        true
    }
}

/// w >= 1 with w - ln w = -ln z, for z = δ/a from 1e-300 to 1/e: minus the lower branch of Lambert's function of -z. A smaller z
/// counts as 1e-300, a larger one as 1/e.
///
/// Straight-line arithmetic: a guess within half a per cent, then two steps of Fritsch's iteration (Fritsch, Shafer and Crowley
/// 1973), each of which raises the error to its fourth power.
///
/// Long, and so out of line.
#[inline(never)]
pub fn inverse_logarithmic<T: Real>(z: T) -> T {
    let constant = T::from_f64;
    // d = -ln z - 1, and η with d = η²/2.
    let d = (-natural_logarithm(z) - T::one()).max(T::zero());
    let eta = (d + d).sqrt();
    // w = 1 + η + η²/3 + η³/36 + ..., bent so that it ends as η²/2.
    let bend = T::one() + eta / eta.mul_add(constant(2.0), constant(12.0));
    let mut w = T::one() + eta + eta * eta * bend * constant(1.0 / 3.0);
    for _ in 0..2 {
        let excess = w - T::one();
        let residual = excess - logarithm_above_one(w) - d;
        // At the limit itself w - 1 is zero, and so is the residual.
        let slope = -excess.max(constant(1e-9));
        let q = (slope + slope) * residual.mul_add(constant(2.0 / 3.0), slope);
        let change = residual / slope * ((q - residual) / (q - residual - residual));
        w = w.mul_add(change, w);
    }
    w
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::line::static_table::bisected;

    #[test]
    fn identity_inverse_against_bisection_over_its_whole_range() {
        let mut z: f64 = 1e-290;
        let limit = 1.0 / std::f64::consts::E;
        while z < limit {
            let w = inverse_logarithmic(z);
            // x = 1/w · z solves -x ln x = z; the bisection is on x, below its largest value 1/e.
            let x = bisected(z, limit, |x| -x * libm::log(x));
            // Near the limit x answers a change of z by 1/(w - 1) times as much; ten roundings.
            let tolerance = 2e-15 * (1.0 + 1.0 / (w - 1.0)) + 3e-16 * (1.0 / z).ln() / w;
            assert!((z / w / x - 1.0).abs() < tolerance.min(1e-7), "{z}: {} {x}", z / w);
            if z < 0.99 * limit {
                assert!((z / w / x - 1.0).abs() < 1e-13, "{z}: {} {x}", z / w);
            }
            z *= if z > 1e-4 { 1.01 } else { 1.9 };
        }
    }

    #[test]
    fn analytic_ends_of_the_range() {
        let limit = 1.0 / std::f64::consts::E;
        // The root of a rounding of z.
        assert!((inverse_logarithmic(limit) - 1.0).abs() < 3e-8);
        assert_eq!(inverse_logarithmic(0.7), 1.0);
        assert_eq!(inverse_logarithmic(0.0), inverse_logarithmic(1e-300));
        for distance in [1e-15, 1e-12, 1e-9, 1e-6] {
            // w = 1 + √(2d) + 2d/3 with d = -ln(z e) - 1: a rounding of z moves w by its 1/√(2d)-fold.
            let d: f64 = -(limit * (1.0 - distance)).ln() - 1.0;
            let expected = 1.0 + (2.0 * d).sqrt() + 2.0 / 3.0 * d;
            let off = (inverse_logarithmic(limit * (1.0 - distance)) - expected).abs();
            assert!(off < 3e-16 / d.sqrt() + d * d.sqrt(), "{distance}: {off}");
        }
    }
}
