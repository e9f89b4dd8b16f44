//! ESDU 78035.

use super::law::LineLaw;
use super::logarithmic::logarithmic_law;
use crate::contact::point::DEFAULT_LAW;

/// Engineering Sciences Data Unit, item 78035: δ = f h (ln(4c/(f h)) + 1), f = F/L; no inverse beyond δ = 4 c.
///
/// Also printed with a further π beside h, which makes it softer by more than a factor of 3: a slip, since h has its 1/π.
pub(super) const ESDU_78035: LineLaw = LineLaw {
    name: "esdu-78035",
    source: "ESDU item 78035: δ = f h (ln(4c/(f h)) + 1), f = F/L, h with 1/π and no further π; inverted up to δ = 4c",
    default_damping: DEFAULT_LAW,
    fitted_clearances_m: None,
    contact: |pair, damping_factor| {
        // ln(4c/s) + 1 = ln(4ce/s)
        let scale_m = 4.0 * pair.clearance_m * std::f64::consts::E;
        logarithmic_law(pair, scale_m, damping_factor)
    },
};

#[cfg(test)]
mod tests {
    use super::ESDU_78035;
    use crate::contact::line::static_table::assert_static_forces;

    #[test]
    fn analytic_static_forces() {
        assert_static_forces(&ESDU_78035, [0.6497, 8.4770, 54.372], |pair, force_n| {
            let s = force_n / pair.length_m * pair.h_1_pa();
            s * ((4.0 * pair.clearance_m / s).ln() + 1.0)
        });
    }
}
