//! Gonthier et al. 2004.

use super::law::PointLaw;

/// Gonthier, McPhee, Lange and Piedboeuf 2004: χ = (1 - c_e²)/c_e.
#[derive(Debug)]
pub struct Gonthier;

impl PointLaw for Gonthier {
    fn name(&self) -> &'static str {
        "gonthier"
    }
    fn source(&self) -> &'static str {
        "Gonthier et al. 2004: χ = (1 - c_e²)/c_e"
    }
    fn damping_factor(&self, restitution: f64) -> f64 {
        (1.0 - restitution * restitution) / restitution
    }
    fn diverges_at_zero_restitution(&self) -> bool {
        true
    }
}

#[cfg(test)]
mod tests {
    use super::Gonthier;
    use crate::contact::point::delivered::assert_delivers;

    #[test]
    fn analytic_delivered_restitution() {
        assert_delivers(&Gonthier, [0.4877, 0.6696, 0.8764]);
    }
}
