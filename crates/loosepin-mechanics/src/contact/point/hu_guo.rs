//! Hu and Guo 2015.

use super::law::PointLaw;

pub(super) const HU_GUO: PointLaw = PointLaw {
    name: "hu-guo",
    source: "Hu and Guo 2015: χ = 3(1 - c_e)/(2c_e)",
    damping_factor: |restitution| 3.0 * (1.0 - restitution) / (2.0 * restitution),
};

#[cfg(test)]
mod tests {
    use super::HU_GUO;
    use crate::contact::point::delivered::assert_delivers;

    #[test]
    fn analytic_delivered_restitution() {
        assert_delivers(&HU_GUO, [0.4877, 0.6973, 0.8999]);
    }
}
