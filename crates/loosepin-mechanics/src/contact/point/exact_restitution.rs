//! loosepin.

use super::law::PointLaw;
use crate::contact::restitution::damping_factor_that_delivers;

/// The χ that delivers exactly the nominal c_e in a free impact: χ(1 + c_e) = ln((1 + χ)/(1 - χc_e)). Ours, not
/// the paper's.
pub(super) const EXACT_RESTITUTION: PointLaw = PointLaw {
    name: "exact-restitution",
    source: "loosepin: the χ that delivers exactly the nominal c_e, from χ(1 + c_e) = ln((1 + χ)/(1 - χc_e))",
    damping_factor: damping_factor_that_delivers,
};

#[cfg(test)]
mod tests {
    use super::EXACT_RESTITUTION;
    use crate::contact::point::delivered::assert_delivers;

    #[test]
    fn analytic_delivered_restitution() {
        assert_delivers(&EXACT_RESTITUTION, [0.5, 0.7, 0.9]);
    }
}
