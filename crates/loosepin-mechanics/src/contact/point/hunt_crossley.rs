//! Hunt and Crossley 1975.

use super::law::PointLaw;

pub(super) const HUNT_CROSSLEY: PointLaw = PointLaw {
    name: "hunt-crossley",
    source: "Hunt and Crossley 1975: χ = 3(1 - c_e)/2",
    damping_factor: |restitution| 3.0 * (1.0 - restitution) / 2.0,
};

#[cfg(test)]
mod tests {
    use super::HUNT_CROSSLEY;
    use crate::contact::point::delivered::assert_delivers;

    #[test]
    fn analytic_delivered_restitution() {
        assert_delivers(&HUNT_CROSSLEY, [0.663, 0.768, 0.909]);
    }
}
