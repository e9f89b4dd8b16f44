//! Dubowsky and Freudenstein 1971.

use super::law::LineLaw;
use super::logarithmic::logarithmic_law;
use crate::contact::point::DEFAULT_LAW;

/// Dubowsky and Freudenstein 1971: δ = f h (ln(L³c/(F R_i R_j h)) + 1), f = F/L; no inverse beyond δ = L²c/(R_i R_j).
///
/// Goldsmith's law is the same with an exponent m of L. With m = 3 the argument of the logarithm is a number; the m = 1 that is
/// printed as well leaves it with a dimension.
pub(super) const DUBOWSKY_FREUDENSTEIN: LineLaw = LineLaw {
    name: "dubowsky-freudenstein",
    source: "Dubowsky and Freudenstein 1971: δ = f h (ln(L³c/(F R_i R_j h)) + 1), f = F/L, h with 1/π (Goldsmith's with \
        the exponent 3, which alone is right in its dimensions); inverted up to δ = L²c/(R_i R_j)",
    default_damping: DEFAULT_LAW,
    fitted_clearances_m: None,
    contact: |pair, damping_factor| {
        // L³c/(F R_i R_j h) = L²c/(R_i R_j s)
        let radii_m2 = pair.bearing_radius_m * pair.journal_radius_m();
        let scale_m = std::f64::consts::E * pair.length_m * pair.length_m * pair.clearance_m / radii_m2;
        logarithmic_law(pair, scale_m, damping_factor)
    },
};

#[cfg(test)]
mod tests {
    use super::DUBOWSKY_FREUDENSTEIN;
    use crate::contact::line::static_table::assert_static_forces;

    #[test]
    fn analytic_static_forces() {
        assert_static_forces(&DUBOWSKY_FREUDENSTEIN, [0.6464, 8.4190, 53.876], |pair, force_n| {
            let radii_m2 = pair.bearing_radius_m * pair.journal_radius_m();
            let argument = pair.length_m.powi(3) * pair.clearance_m / (force_n * radii_m2 * pair.h_1_pa());
            force_n / pair.length_m * pair.h_1_pa() * (argument.ln() + 1.0)
        });
    }
}
