//! Johnson 1985.

use super::law::LineLaw;
use super::logarithmic::logarithmic_law;
use super::pair::LinePair;
use crate::contact::normal::NormalLaw;

/// Johnson 1985: δ = f h (ln(4c/(f h)) - 1), f = F/L; no inverse beyond δ = 0.5413 c.
#[derive(Debug)]
pub struct Johnson;

impl LineLaw for Johnson {
    fn name(&self) -> &'static str {
        "johnson"
    }
    fn source(&self) -> &'static str {
        "Johnson 1985: δ = f h (ln(4c/(f h)) - 1), f = F/L, h with 1/π; inverted up to δ = 0.5413 c"
    }
    fn contact(&self, pair: &LinePair, damping_factor: f64) -> NormalLaw<f64> {
        // ln(4c/s) - 1 = ln(4c/(e s))
        let scale_m = 4.0 * pair.clearance_m / std::f64::consts::E;
        logarithmic_law(pair, scale_m, damping_factor)
    }
}

#[cfg(test)]
mod tests {
    use super::Johnson;
    use crate::contact::line::static_table::assert_static_forces;

    #[test]
    fn analytic_static_forces() {
        assert_static_forces(&Johnson, [0.8146, 11.700, 87.153], |pair, force_n| {
            let s = force_n / pair.length_m * pair.h_1_pa();
            s * ((4.0 * pair.clearance_m / s).ln() - 1.0)
        });
    }
}
