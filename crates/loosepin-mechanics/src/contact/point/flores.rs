//! Flores et al. 2011.

use super::law::PointLaw;

/// Flores, Machado, Silva and Martins 2011: χ = 8(1 - c_e)/(5c_e).
#[derive(Debug)]
pub struct Flores;

impl PointLaw for Flores {
    fn name(&self) -> &'static str {
        "flores"
    }
    fn source(&self) -> &'static str {
        "Flores et al. 2011: χ = 8(1 - c_e)/(5c_e)"
    }
    fn damping_factor(&self, restitution: f64) -> f64 {
        8.0 * (1.0 - restitution) / (5.0 * restitution)
    }
    fn diverges_at_zero_restitution(&self) -> bool {
        true
    }
}

#[cfg(test)]
mod tests {
    use super::Flores;
    use crate::contact::point::delivered::assert_delivers;

    #[test]
    fn analytic_delivered_restitution() {
        assert_delivers(&Flores, [0.4704, 0.6832, 0.8939]);
    }
}
