//! Carvalho and Martins 2019.

use super::law::PointLaw;

pub(super) const CARVALHO_MARTINS: PointLaw = PointLaw {
    name: "carvalho-martins",
    source: "Carvalho and Martins 2019: χ = (3/2)(1 - c_e)(11 - c_e)/(1 + 9c_e)",
    damping_factor: |restitution| 1.5 * (1.0 - restitution) * (11.0 - restitution) / (1.0 + 9.0 * restitution),
};

#[cfg(test)]
mod tests {
    use super::CARVALHO_MARTINS;
    use crate::contact::point::delivered::assert_delivers;

    #[test]
    fn analytic_delivered_restitution() {
        assert_delivers(&CARVALHO_MARTINS, [0.5002, 0.7, 0.9]);
    }
}
