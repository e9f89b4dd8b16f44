//! loosepin.

use super::law::LinearLaw;
use crate::contact::normal::damping_ratio_that_delivers;

/// D = 2ξ √(K m_eff) with the ξ that delivers exactly the nominal c_e in a free impact although the force is cut at zero. Ours.
#[derive(Debug)]
pub struct ExactLinearRestitution;

impl LinearLaw for ExactLinearRestitution {
    fn name(&self) -> &'static str {
        "exact-linear-restitution"
    }
    fn source(&self) -> &'static str {
        "loosepin: F = K δ + 2ξ √(K m_eff) δ̇, cut at zero, with the ξ that delivers exactly the nominal c_e, from \
         -ln c_e = 2ξ acos(ξ)/√(1 - ξ²)"
    }
    fn damping_ratio(&self, restitution: f64) -> Option<f64> {
        Some(damping_ratio_that_delivers(restitution))
    }
}

#[cfg(test)]
mod tests {
    use super::ExactLinearRestitution;
    use crate::contact::linear::delivered::assert_delivers;

    #[test]
    fn analytic_delivered_restitution() {
        assert_delivers(&ExactLinearRestitution, [0.5, 0.7, 0.9]);
    }
}
