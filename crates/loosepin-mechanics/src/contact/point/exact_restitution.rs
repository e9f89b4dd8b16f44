//! loosepin.

use super::law::PointLaw;
use crate::contact::restitution::damping_factor_that_delivers;

/// The χ that delivers exactly the nominal c_e in a free impact: χ(1 + c_e) = ln((1 + χ)/(1 - χc_e)). Ours, not
/// the paper's.
#[derive(Debug)]
pub struct ExactRestitution;

impl PointLaw for ExactRestitution {
    fn name(&self) -> &'static str {
        "exact-restitution"
    }
    fn source(&self) -> &'static str {
        "loosepin: the χ that delivers exactly the nominal c_e, from χ(1 + c_e) = ln((1 + χ)/(1 - χc_e))"
    }
    fn damping_factor(&self, restitution: f64) -> f64 {
        damping_factor_that_delivers(restitution)
    }
    fn diverges_at_zero_restitution(&self) -> bool {
        true
    }
}

#[cfg(test)]
mod tests {
    use super::ExactRestitution;
    use crate::contact::point::delivered::assert_delivers;

    #[test]
    fn analytic_delivered_restitution() {
        assert_delivers(&ExactRestitution, [0.5, 0.7, 0.9]);
    }
}
