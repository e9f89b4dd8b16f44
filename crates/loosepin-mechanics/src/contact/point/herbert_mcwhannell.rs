//! Herbert and McWhannell 1977.

use super::law::PointLaw;

/// Herbert and McWhannell 1977: χ = 6(1 - c_e)/((2c_e - 1)² + 3).
#[derive(Debug)]
pub struct HerbertMcWhannell;

impl PointLaw for HerbertMcWhannell {
    fn name(&self) -> &'static str {
        "herbert-mcwhannell"
    }
    fn source(&self) -> &'static str {
        "Herbert and McWhannell 1977: χ = 6(1 - c_e)/((2c_e - 1)² + 3)"
    }
    fn damping_factor(&self, restitution: f64) -> f64 {
        {
            let shifted = 2.0 * restitution - 1.0;
            6.0 * (1.0 - restitution) / (shifted * shifted + 3.0)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::HerbertMcWhannell;
    use crate::contact::point::delivered::assert_delivers;

    #[test]
    fn analytic_delivered_restitution() {
        assert_delivers(&HerbertMcWhannell, [0.5936, 0.7227, 0.9009]);
    }
}
