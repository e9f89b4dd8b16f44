//! Herbert and McWhannell 1977.

use super::law::PointLaw;

pub(super) const HERBERT_MCWHANNELL: PointLaw = PointLaw {
    name: "herbert-mcwhannell",
    source: "Herbert and McWhannell 1977: χ = 6(1 - c_e)/((2c_e - 1)² + 3)",
    damping_factor: |restitution| {
        let shifted = 2.0 * restitution - 1.0;
        6.0 * (1.0 - restitution) / (shifted * shifted + 3.0)
    },
};

#[cfg(test)]
mod tests {
    use super::HERBERT_MCWHANNELL;
    use crate::contact::point::delivered::assert_delivers;

    #[test]
    fn analytic_delivered_restitution() {
        assert_delivers(&HERBERT_MCWHANNELL, [0.5936, 0.7227, 0.9009]);
    }
}
