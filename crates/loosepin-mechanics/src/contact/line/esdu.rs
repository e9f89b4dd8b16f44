//! ESDU 78035.

use super::law::LineLaw;
use super::logarithmic::logarithmic_law;
use super::pair::LinePair;
use crate::contact::normal::NormalLaw;

/// Engineering Sciences Data Unit, item 78035: δ = f h (ln(4c/(f h)) + 1), f = F/L; no inverse beyond δ = 4 c.
///
/// Also printed with a further π beside h, which makes it softer by more than a factor of 3: a slip, since h has its 1/π.
#[derive(Debug)]
pub struct Esdu78035;

impl LineLaw for Esdu78035 {
    fn name(&self) -> &'static str {
        "esdu-78035"
    }
    fn source(&self) -> &'static str {
        "ESDU item 78035: δ = f h (ln(4c/(f h)) + 1), f = F/L, h with 1/π and no further π; inverted up to δ = 4c"
    }
    fn contact(&self, pair: &LinePair, damping_factor: f64) -> NormalLaw<f64> {
        // ln(4c/s) + 1 = ln(4ce/s)
        let scale_m = 4.0 * pair.clearance_m * std::f64::consts::E;
        logarithmic_law(pair, scale_m, damping_factor)
    }
}

#[cfg(test)]
mod tests {
    use super::Esdu78035;
    use crate::contact::line::static_table::assert_static_forces;

    #[test]
    fn analytic_static_forces() {
        assert_static_forces(&Esdu78035, [0.6497, 8.4770, 54.372], |pair, force_n| {
            let s = force_n / pair.length_m * pair.h_1_pa();
            s * ((4.0 * pair.clearance_m / s).ln() + 1.0)
        });
    }
}
