//! Hu and Guo 2015.

use super::law::PointLaw;

/// Hu and Guo 2015: χ = 3(1 - c_e)/(2c_e).
#[derive(Debug)]
pub struct HuGuo;

impl PointLaw for HuGuo {
    fn name(&self) -> &'static str {
        "hu-guo"
    }
    fn source(&self) -> &'static str {
        "Hu and Guo 2015: χ = 3(1 - c_e)/(2c_e)"
    }
    fn damping_factor(&self, restitution: f64) -> f64 {
        3.0 * (1.0 - restitution) / (2.0 * restitution)
    }
    fn diverges_at_zero_restitution(&self) -> bool {
        true
    }
}

#[cfg(test)]
mod tests {
    use super::HuGuo;
    use crate::contact::point::delivered::assert_delivers;

    #[test]
    fn analytic_delivered_restitution() {
        assert_delivers(&HuGuo, [0.4877, 0.6973, 0.8999]);
    }
}
