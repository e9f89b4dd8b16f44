//! Johnson 1985.

use super::law::LineLaw;
use super::logarithmic::logarithmic_law;

/// Johnson 1985: δ = f h (ln(4c/(f h)) - 1), f = F/L; no inverse beyond δ = 0.5413 c.
pub(super) const JOHNSON: LineLaw = LineLaw {
    name: "johnson",
    source: "Johnson 1985: δ = f h (ln(4c/(f h)) - 1), f = F/L, h with 1/π; inverted up to δ = 0.5413 c",
    default_damping: "lankarani-nikravesh",
    fitted_clearances_m: None,
    contact: |pair, damping_factor| {
        // ln(4c/s) - 1 = ln(4c/(e s))
        let scale_m = 4.0 * pair.clearance_m / std::f64::consts::E;
        logarithmic_law(pair, scale_m, damping_factor)
    },
};

#[cfg(test)]
mod tests {
    use super::JOHNSON;
    use crate::contact::line::static_table::assert_static_forces;

    #[test]
    fn analytic_static_forces() {
        assert_static_forces(&JOHNSON, [0.8146, 11.700, 87.153], |pair, force_n| {
            let s = force_n / pair.length_m * pair.h_1_pa();
            s * ((4.0 * pair.clearance_m / s).ln() - 1.0)
        });
    }
}
