//! loosepin.

use super::law::LinearLaw;
use crate::contact::normal::damping_ratio_that_delivers;

/// D = 2ξ √(K m_eff) with the ξ that delivers exactly the nominal c_e in a free impact although the force is cut at zero. Ours.
pub(super) const EXACT_LINEAR_RESTITUTION: LinearLaw = LinearLaw {
    name: "exact-linear-restitution",
    source: "loosepin: F = K δ + 2ξ √(K m_eff) δ̇, cut at zero, with the ξ that delivers exactly the nominal c_e, from \
        -ln c_e = 2ξ acos(ξ)/√(1 - ξ²)",
    damping_ratio: Some(damping_ratio_that_delivers),
};

#[cfg(test)]
mod tests {
    use super::EXACT_LINEAR_RESTITUTION;
    use crate::contact::linear::delivered::assert_delivers;

    #[test]
    fn analytic_delivered_restitution() {
        assert_delivers(&EXACT_LINEAR_RESTITUTION, [0.5, 0.7, 0.9]);
    }
}
