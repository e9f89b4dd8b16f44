//! The gap function of a contact.

use crate::mechanism::sample::PlayGeometry;

/// Quantity that the gap function of a contact measures; it is positive in contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum GapMeasure {
    /// |e|² - c², m²: smooth also where e = 0. In a slot e goes from the nearest point of its line between both ends.
    Squares {
        /// Radial clearance c, m.
        clearance_m: f64,
    },
    /// δ, m.
    Penetration,
}

impl GapMeasure {
    /// The gap measure of the contacts of a joint with play.
    pub fn of(play: &PlayGeometry<f64>) -> Self {
        if play.foundation.is_some() {
            return Self::Penetration;
        }
        if play.shape.is_round() { Self::Squares { clearance_m: play.clearance_m } } else { Self::Penetration }
    }

    /// δ, m, where the gap function is `gap`.
    pub fn penetration_m(self, gap: f64) -> f64 {
        match self {
            Self::Squares { clearance_m } => gap / ((gap + clearance_m * clearance_m).sqrt() + clearance_m),
            Self::Penetration => gap,
        }
    }

    /// The gap function where the penetration is `penetration_m`.
    pub fn gap(self, penetration_m: f64) -> f64 {
        match self {
            Self::Squares { clearance_m } => penetration_m * (penetration_m + 2.0 * clearance_m),
            Self::Penetration => penetration_m,
        }
    }

    /// Rate of the gap function over δ̇ where the gap function is `gap`.
    pub fn rate_share(self, gap: f64) -> f64 {
        match self {
            Self::Squares { clearance_m } => 2.0 * (gap + clearance_m * clearance_m).max(0.0).sqrt(),
            Self::Penetration => 1.0,
        }
    }

    /// Change of the gap function for a change of δ, near zero, by `tolerance_m`.
    pub fn tolerance(self, tolerance_m: f64) -> f64 {
        match self {
            Self::Squares { clearance_m } => 2.0 * clearance_m * tolerance_m,
            Self::Penetration => tolerance_m,
        }
    }
}
