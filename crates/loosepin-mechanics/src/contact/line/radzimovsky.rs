//! Radzimovsky 1953.

use super::law::LineLaw;
use super::logarithmic::logarithmic_law;
use crate::contact::point::DEFAULT_LAW;

/// Coefficient of the half width b of the contact, for radii: 4/√π, rounded as printed.
const WIDTH: f64 = 2.2568;

/// Radzimovsky 1953: δ = f h (2/3 + ln(4R_i/b) + ln(4R_j/b)), f = F/L, b = 2.2568 √(f R*/E*), R* = R_i R_j/c; no inverse beyond
/// δ = 0.72 c.
///
/// Printed with diameters too, where the coefficient of b is 1.60. Since b² is proportional to f, this is a law like
/// Johnson's.
pub(super) const RADZIMOVSKY: LineLaw = LineLaw {
    name: "radzimovsky",
    source: "Radzimovsky 1953: δ = f h (2/3 + ln(4R_i/b) + ln(4R_j/b)), f = F/L, b = 2.2568 √(f R*/E*), R* = R_i R_j/c, with \
        radii and h with 1/π; inverted up to δ = 0.72 c",
    default_damping: DEFAULT_LAW,
    fitted_clearances_m: None,
    contact: |pair, damping_factor| {
        // 16 R_i R_j/b² = 16 c E*/(2.2568² f) = 16 c/(2.2568² π s)
        let width = WIDTH * WIDTH * std::f64::consts::PI;
        let scale_m = 16.0 * pair.clearance_m * libm::exp(2.0 / 3.0) / width;
        logarithmic_law(pair, scale_m, damping_factor)
    },
};

#[cfg(test)]
mod tests {
    use super::RADZIMOVSKY;
    use crate::contact::line::static_table::assert_static_forces;

    #[test]
    fn analytic_static_forces() {
        assert_static_forces(&RADZIMOVSKY, [0.7863, 11.094, 80.013], |pair, force_n| {
            let per_length_n_m = force_n / pair.length_m;
            let [r_i, r_j] = [pair.bearing_radius_m, pair.journal_radius_m()];
            let curvature_m = r_i * r_j / pair.clearance_m;
            let b = 2.2568 * (per_length_n_m * curvature_m / pair.equivalent_modulus_pa()).sqrt();
            per_length_n_m * pair.h_1_pa() * (2.0 / 3.0 + (4.0 * r_i / b).ln() + (4.0 * r_j / b).ln())
        });
    }
}
