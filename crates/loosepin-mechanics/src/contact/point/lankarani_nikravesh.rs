//! Lankarani and Nikravesh 1990, [SC16] eq. (8).

use super::law::PointLaw;

/// Lankarani and Nikravesh 1990, the law of the source paper, \[SC16\] eq. (8), and the default: χ = 3(1 - c_e²)/4.
#[derive(Debug)]
pub struct LankaraniNikravesh;

impl PointLaw for LankaraniNikravesh {
    fn name(&self) -> &'static str {
        "lankarani-nikravesh"
    }
    fn source(&self) -> &'static str {
        "Lankarani and Nikravesh 1990, [SC16] eq. (8): χ = 3(1 - c_e²)/4"
    }
    fn damping_factor(&self, restitution: f64) -> f64 {
        3.0 * (1.0 - restitution * restitution) / 4.0 // eq. (8)
    }
}

#[cfg(test)]
mod tests {
    use super::LankaraniNikravesh;
    use crate::contact::point::delivered::assert_delivers;

    #[test]
    fn analytic_delivered_restitution() {
        assert_delivers(&LankaraniNikravesh, [0.7252, 0.796, 0.9132]);
    }
}
