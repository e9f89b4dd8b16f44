//! Hertz 1881.

use super::law::PointLaw;

/// Hertz 1881: elastic, χ = 0.
#[derive(Debug)]
pub struct Hertz;

impl PointLaw for Hertz {
    fn name(&self) -> &'static str {
        "hertz"
    }
    fn source(&self) -> &'static str {
        "Hertz 1881: χ = 0, no loss"
    }
    fn damping_factor(&self, _restitution: f64) -> f64 {
        0.0
    }
}

#[cfg(test)]
mod tests {
    use super::Hertz;
    use crate::contact::point::delivered::assert_delivers;

    #[test]
    fn analytic_delivered_restitution() {
        assert_delivers(&Hertz, [1.0, 1.0, 1.0]);
    }
}
