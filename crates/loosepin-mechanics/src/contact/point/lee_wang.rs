//! Lee and Wang 1983.

use super::law::PointLaw;

pub(super) const LEE_WANG: PointLaw = PointLaw {
    name: "lee-wang",
    source: "Lee and Wang 1983: χ = 3(1 - c_e)/4",
    damping_factor: |restitution| 3.0 * (1.0 - restitution) / 4.0,
};

#[cfg(test)]
mod tests {
    use super::LEE_WANG;
    use crate::contact::point::delivered::assert_delivers;

    #[test]
    fn analytic_delivered_restitution() {
        assert_delivers(&LEE_WANG, [0.7992, 0.8693, 0.9524]);
    }
}
