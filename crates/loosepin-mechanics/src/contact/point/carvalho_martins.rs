//! Carvalho and Martins 2019.

use super::law::PointLaw;

/// Carvalho and Martins 2019: χ = (3/2)(1 - c_e)(11 - c_e)/(1 + 9c_e).
#[derive(Debug)]
pub struct CarvalhoMartins;

impl PointLaw for CarvalhoMartins {
    fn name(&self) -> &'static str {
        "carvalho-martins"
    }
    fn source(&self) -> &'static str {
        "Carvalho and Martins 2019: χ = (3/2)(1 - c_e)(11 - c_e)/(1 + 9c_e)"
    }
    fn damping_factor(&self, restitution: f64) -> f64 {
        1.5 * (1.0 - restitution) * (11.0 - restitution) / (1.0 + 9.0 * restitution)
    }
}

#[cfg(test)]
mod tests {
    use super::CarvalhoMartins;
    use crate::contact::point::delivered::assert_delivers;

    #[test]
    fn analytic_delivered_restitution() {
        assert_delivers(&CarvalhoMartins, [0.5002, 0.7, 0.9]);
    }
}
