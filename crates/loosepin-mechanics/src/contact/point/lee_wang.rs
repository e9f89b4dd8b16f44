//! Lee and Wang 1983.

use super::law::PointLaw;

/// Lee and Wang 1983: χ = 3(1 - c_e)/4.
#[derive(Debug)]
pub struct LeeWang;

impl PointLaw for LeeWang {
    fn name(&self) -> &'static str {
        "lee-wang"
    }
    fn source(&self) -> &'static str {
        "Lee and Wang 1983: χ = 3(1 - c_e)/4"
    }
    fn damping_factor(&self, restitution: f64) -> f64 {
        3.0 * (1.0 - restitution) / 4.0
    }
}

#[cfg(test)]
mod tests {
    use super::LeeWang;
    use crate::contact::point::delivered::assert_delivers;

    #[test]
    fn analytic_delivered_restitution() {
        assert_delivers(&LeeWang, [0.7992, 0.8693, 0.9524]);
    }
}
