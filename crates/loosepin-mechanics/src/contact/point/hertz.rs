//! Hertz 1881.

use super::law::PointLaw;

/// Hertz 1881: elastic, χ = 0.
pub(super) const HERTZ: PointLaw =
    PointLaw { name: "hertz", source: "Hertz 1881: χ = 0, no loss", damping_factor: |_| 0.0 };

#[cfg(test)]
mod tests {
    use super::HERTZ;
    use crate::contact::point::delivered::assert_delivers;

    #[test]
    fn analytic_delivered_restitution() {
        assert_delivers(&HERTZ, [1.0, 1.0, 1.0]);
    }
}
