//! Lankarani and Nikravesh 1990, [SC16] eq. (8).

use super::law::PointLaw;

/// Lankarani and Nikravesh 1990, the law of the source paper, \[SC16\] eq. (8), and the default: χ = 3(1 - c_e²)/4.
pub(super) const LANKARANI_NIKRAVESH: PointLaw = PointLaw {
    name: "lankarani-nikravesh",
    source: "Lankarani and Nikravesh 1990, [SC16] eq. (8): χ = 3(1 - c_e²)/4",
    damping_factor: |restitution| {
        3.0 * (1.0 - restitution * restitution) / 4.0 // eq. (8)
    },
};

#[cfg(test)]
mod tests {
    use super::LANKARANI_NIKRAVESH;
    use crate::contact::point::delivered::assert_delivers;

    #[test]
    fn analytic_delivered_restitution() {
        assert_delivers(&LANKARANI_NIKRAVESH, [0.7252, 0.796, 0.9132]);
    }
}
