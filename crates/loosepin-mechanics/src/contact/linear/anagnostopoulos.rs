//! Anagnostopoulos 1988.

use super::law::LinearLaw;

/// Anagnostopoulos 1988: D = 2ξ √(K m_eff) with ξ = -ln c_e/√(π² + ln² c_e), which would deliver c_e if the contact could pull. It
/// cannot, so that it delivers more.
pub(super) const ANAGNOSTOPOULOS: LinearLaw = LinearLaw {
    name: "anagnostopoulos",
    source: "Anagnostopoulos 1988: F = K δ + 2ξ √(K m_eff) δ̇ with ξ = -ln c_e/√(π² + ln² c_e), cut at zero",
    damping_ratio: Some(|restitution| {
        let loss = -libm::log(restitution);
        loss / (std::f64::consts::PI.powi(2) + loss * loss).sqrt()
    }),
};

#[cfg(test)]
mod tests {
    use super::ANAGNOSTOPOULOS;
    use crate::contact::linear::delivered::assert_delivers;

    #[test]
    fn analytic_delivered_restitution() {
        assert_delivers(&ANAGNOSTOPOULOS, [0.5503, 0.7182, 0.9020]);
    }
}
