//! Zhiying and Qishao 2006.

use super::law::PointLaw;

pub(in crate::contact) const ZHIYING_QISHAO: PointLaw = PointLaw {
    name: "zhiying-qishao",
    source: "Zhiying and Qishao 2006: χ = 3(1 - c_e²) exp(2(1 - c_e))/4",
    damping_factor: |restitution| 0.75 * (1.0 - restitution * restitution) * libm::exp(2.0 * (1.0 - restitution)),
};

#[cfg(test)]
mod tests {
    use super::ZHIYING_QISHAO;
    use crate::contact::point::delivered::assert_delivers;

    #[test]
    fn analytic_delivered_restitution() {
        assert_delivers(&ZHIYING_QISHAO, [0.4826, 0.6796, 0.8959]);
    }
}
