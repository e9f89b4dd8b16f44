//! Gonthier et al. 2004.

use super::law::PointLaw;

/// Gonthier, McPhee, Lange and Piedboeuf 2004: χ = (1 - c_e²)/c_e.
pub(super) const GONTHIER: PointLaw = PointLaw {
    name: "gonthier",
    source: "Gonthier et al. 2004: χ = (1 - c_e²)/c_e",
    damping_factor: |restitution| (1.0 - restitution * restitution) / restitution,
};

#[cfg(test)]
mod tests {
    use super::GONTHIER;
    use crate::contact::point::delivered::assert_delivers;

    #[test]
    fn analytic_delivered_restitution() {
        assert_delivers(&GONTHIER, [0.4877, 0.6696, 0.8764]);
    }
}
