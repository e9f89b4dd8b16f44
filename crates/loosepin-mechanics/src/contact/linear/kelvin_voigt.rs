//! Kelvin and Voigt.

use super::law::LinearLaw;

/// Kelvin and Voigt's model: K and D given. What restitution it delivers depends on the masses that meet.
#[derive(Debug)]
pub struct KelvinVoigt;

impl LinearLaw for KelvinVoigt {
    fn name(&self) -> &'static str {
        "kelvin-voigt"
    }
    fn source(&self) -> &'static str {
        "Kelvin and Voigt: F = K δ + D δ̇ with K and D given, cut at zero"
    }
    fn damping_ratio(&self, _restitution: f64) -> Option<f64> {
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_damping_is_given() {
        assert!(KelvinVoigt.has_given_damping());
    }
}
