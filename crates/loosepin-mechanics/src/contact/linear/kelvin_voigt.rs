//! Kelvin and Voigt.

use super::law::LinearLaw;

/// Kelvin and Voigt's model: K and D given. What restitution it delivers depends on the masses that meet.
pub(super) const KELVIN_VOIGT: LinearLaw = LinearLaw {
    name: "kelvin-voigt",
    source: "Kelvin and Voigt: F = K δ + D δ̇ with K and D given, cut at zero",
    damping_ratio: None,
};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_damping_is_given() {
        assert!(KELVIN_VOIGT.has_given_damping());
    }
}
