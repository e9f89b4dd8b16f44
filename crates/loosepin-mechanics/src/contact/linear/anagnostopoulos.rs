//! Anagnostopoulos 1988.

use super::law::LinearLaw;

/// Anagnostopoulos 1988: D = 2ξ √(K m_eff) with ξ = -ln c_e/√(π² + ln² c_e), which would deliver c_e if the contact could pull. It
/// cannot, so that it delivers more.
#[derive(Debug)]
pub struct Anagnostopoulos;

impl LinearLaw for Anagnostopoulos {
    fn name(&self) -> &'static str {
        "anagnostopoulos"
    }
    fn source(&self) -> &'static str {
        "Anagnostopoulos 1988: F = K δ + 2ξ √(K m_eff) δ̇ with ξ = -ln c_e/√(π² + ln² c_e), cut at zero"
    }
    fn damping_ratio(&self, restitution: f64) -> Option<f64> {
        let loss = -libm::log(restitution);
        Some(loss / (std::f64::consts::PI.powi(2) + loss * loss).sqrt())
    }
}

#[cfg(test)]
mod tests {
    use super::Anagnostopoulos;
    use crate::contact::linear::delivered::assert_delivers;

    #[test]
    fn analytic_delivered_restitution() {
        assert_delivers(&Anagnostopoulos, [0.5503, 0.7182, 0.9020]);
    }
}
