//! Hunt and Crossley 1975.

use super::law::PointLaw;

/// Hunt and Crossley 1975: χ = 3(1 - c_e)/2.
#[derive(Debug)]
pub struct HuntCrossley;

impl PointLaw for HuntCrossley {
    fn name(&self) -> &'static str {
        "hunt-crossley"
    }
    fn source(&self) -> &'static str {
        "Hunt and Crossley 1975: χ = 3(1 - c_e)/2"
    }
    fn damping_factor(&self, restitution: f64) -> f64 {
        3.0 * (1.0 - restitution) / 2.0
    }
}

#[cfg(test)]
mod tests {
    use super::HuntCrossley;
    use crate::contact::point::delivered::assert_delivers;

    #[test]
    fn analytic_delivered_restitution() {
        assert_delivers(&HuntCrossley, [0.663, 0.768, 0.909]);
    }
}
