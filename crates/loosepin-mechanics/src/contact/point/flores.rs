//! Flores et al. 2011.

use super::law::PointLaw;

/// Flores, Machado, Silva and Martins 2011: χ = 8(1 - c_e)/(5c_e).
pub(super) const FLORES: PointLaw = PointLaw {
    name: "flores",
    source: "Flores et al. 2011: χ = 8(1 - c_e)/(5c_e)",
    damping_factor: |restitution| 8.0 * (1.0 - restitution) / (5.0 * restitution),
};

#[cfg(test)]
mod tests {
    use super::FLORES;
    use crate::contact::point::delivered::assert_delivers;

    #[test]
    fn analytic_delivered_restitution() {
        assert_delivers(&FLORES, [0.4704, 0.6832, 0.8939]);
    }
}
