//! Bai and Zhao 2013.

use super::law::LineLaw;
use super::liu::liu_stiffness_n_m;
use crate::contact::normal::BaiZhaoContact;
use crate::contact::point::ZHIYING_QISHAO;

/// Bai and Zhao's hybrid law 2013: F = K_n δ, K_n = (π E* L/8) √(2δ(3c + 2δ)²/(c + δ)³), for every δ; energy loss by Zhiying and
/// Qishao where the model file names no other.
///
/// K_n is the slope dF/dδ of Liu's law, so that F is δ times it.
pub(super) const BAI_ZHAO: LineLaw = LineLaw {
    name: "bai-zhao",
    source: "Bai and Zhao 2013: F = K_n δ, K_n = (π E* L/8) √(2δ(3c + 2δ)²/(c + δ)³), E* = 1/(π h)",
    default_damping: &ZHIYING_QISHAO,
    fitted_clearances_m: None,
    contact: |pair, damping_factor| {
        let stiffness_n_m = liu_stiffness_n_m(pair);
        BaiZhaoContact { stiffness_n_m, clearance_m: pair.clearance_m, damping_factor }.into()
    },
};

#[cfg(test)]
mod tests {
    use super::BAI_ZHAO;
    use crate::contact::line::static_table::{assert_static_forces, bisected};

    #[test]
    fn analytic_static_forces() {
        assert_static_forces(&BAI_ZHAO, [0.1692, 5.2722, 55.403], |pair, force_n| {
            bisected(force_n, 1.0, |depth_m| {
                let c = pair.clearance_m;
                let square = 2.0 * depth_m * (3.0 * c + 2.0 * depth_m).powi(2) / (c + depth_m).powi(3);
                std::f64::consts::PI * pair.equivalent_modulus_pa() * pair.length_m / 8.0 * square.sqrt() * depth_m
            })
        });
    }
}
