//! Liu, Zhang and Yang 2006.

use super::law::LineLaw;
use super::pair::LinePair;
use crate::contact::normal::LiuContact;
use crate::contact::point::DEFAULT_LAW;

/// Liu, Zhang, Yang and co-workers 2006: F = ½ π E* L δ √(δ/(2(c + δ))), for every δ.
pub(super) const LIU: LineLaw = LineLaw {
    name: "liu",
    source: "Liu, Zhang and Yang 2006: F = ½ π E* L δ √(δ/(2(c + δ))), E* = 1/(π h)",
    default_damping: DEFAULT_LAW,
    fitted_clearances_m: None,
    contact: |pair, damping_factor| {
        let stiffness_n_m = liu_stiffness_n_m(pair);
        LiuContact { stiffness_n_m, clearance_m: pair.clearance_m, damping_factor }.into()
    },
};

/// K = π E* L/(2√2), N/m, of F = K δ √(δ/(c + δ)).
pub(super) fn liu_stiffness_n_m(pair: &LinePair) -> f64 {
    0.5 * std::f64::consts::PI * pair.equivalent_modulus_pa() * pair.length_m * std::f64::consts::FRAC_1_SQRT_2
}

#[cfg(test)]
mod tests {
    use super::LIU;
    use crate::contact::line::static_table::{assert_static_forces, bisected};

    #[test]
    fn analytic_static_forces() {
        assert_static_forces(&LIU, [0.1129, 3.5379, 38.090], |pair, force_n| {
            // The law gives F(δ); its inverse by bisection.
            bisected(force_n, 1.0, |depth_m| {
                let root = (depth_m / (2.0 * (pair.clearance_m + depth_m))).sqrt();
                0.5 * std::f64::consts::PI * pair.equivalent_modulus_pa() * pair.length_m * depth_m * root
            })
        });
    }
}
