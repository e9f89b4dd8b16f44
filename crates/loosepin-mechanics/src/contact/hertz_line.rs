//! Hertz's pressure of a pin in a hole along a line, for the distribution of wear.

use std::f64::consts::PI;

/// Half-width b of the patch over which a pin is pressed into its hole, m: b = √(4 F R*/(π E* L)), R* = R_i R_j/c, 1/E* = h_i + h_j.
///
/// Without clearance, and where b would be beyond it, π R_i/2: half the circumference.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinePatch {
    /// b²/F, m²/N; infinite without clearance.
    per_force_m2_n: f64,
    /// The largest b, m.
    largest_m: f64,
}

impl LinePatch {
    /// For radii R_i (bearing) and R_j (journal), m, the length L of the bearing, m, and h_i and h_j, 1/Pa
    /// ([`compliance_1_pa`](super::compliance_1_pa)).
    pub fn new(radii_m: [f64; 2], length_m: f64, compliances_1_pa: [f64; 2]) -> Self {
        let curvature_m = radii_m[0] * radii_m[1] / (radii_m[0] - radii_m[1]);
        let per_force_m2_n = 4.0 * curvature_m * (compliances_1_pa[0] + compliances_1_pa[1]) / (PI * length_m);
        Self { per_force_m2_n, largest_m: 0.5 * PI * radii_m[0] }
    }

    /// b under a force, m, and whether it is the largest.
    pub fn half_width_m(&self, force_n: f64) -> (f64, bool) {
        let half_width_m = (self.per_force_m2_n * force_n).sqrt();
        if half_width_m < self.largest_m { (half_width_m, false) } else { (self.largest_m, true) }
    }
}

/// Share of a semi-ellipse over [-1, 1] that lies below ξ: G(ξ) = 1/2 + (ξ √(1 - ξ²) + asin ξ)/π.
pub fn share_below(xi: f64) -> f64 {
    let xi = xi.clamp(-1.0, 1.0);
    0.5 + (xi * (1.0 - xi * xi).max(0.0).sqrt() + xi.asin()) / PI
}

#[cfg(test)]
mod tests {
    use super::{LinePatch, share_below};
    use crate::contact::compliance_1_pa;

    #[test]
    fn analytic_the_share_is_the_integral_of_the_semi_ellipse() {
        assert_eq!([share_below(-3.0), share_below(-1.0), share_below(1.0), share_below(2.0)], [0.0, 0.0, 1.0, 1.0]);
        assert!((share_below(0.0) - 0.5).abs() < 1e-15);
        // Midpoints of (2/π) √(1 - ξ²) from -1 to 0.3.
        const POINTS: usize = 200_000;
        let width = 1.3 / POINTS as f64;
        let ellipse = |k: usize| (1.0 - (-1.0 + (k as f64 + 0.5) * width).powi(2)).sqrt();
        let sum: f64 = (0..POINTS).map(ellipse).sum::<f64>() * width * std::f64::consts::FRAC_2_PI;
        assert!((share_below(0.3) - sum).abs() < 1e-8, "{sum}");
    }

    #[test]
    fn analytic_the_patch_of_a_steel_pin_under_a_kilonewton() {
        let h = compliance_1_pa(207e9, 0.3);
        let patch = LinePatch::new([0.01, 0.0095], 0.02, [h, h]);
        // R* = 0.19 m, E* = 113.7363 GPa: b = √(4 · 1000 · 0.19/(π · 113.7363e9 · 0.02)) = 0.3261125 mm, 1.8685° of the hole.
        let (half_width_m, is_largest) = patch.half_width_m(1000.0);
        assert!((half_width_m - 0.326_112_45e-3).abs() < 1e-11 && !is_largest, "{half_width_m}");
        let tight = LinePatch::new([0.01, 0.01], 0.02, [h, h]);
        assert_eq!(tight.half_width_m(1.0), (0.5 * std::f64::consts::PI * 0.01, true));
    }
}
