//! Where the two bodies of a joint with play may touch.

use super::sample::PlayGeometry;

/// A place where the two bodies of a joint with play may touch: a contact, with a state, forces and events of its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ContactPlace {
    /// Index of the joint in [`super::Mechanism::plays`].
    pub play: usize,
    /// Which of the joint's places, from 0.
    pub place: usize,
}

/// What plays in what.
#[derive(Debug, Clone, Copy)]
pub enum PlayShape<T> {
    /// A round pin in a round hole: one contact.
    Pin {
        /// Radius R_i of the bearing, m.
        bearing_radius_m: T,
    },
}

impl<T> PlayShape<T> {
    /// Number of places where the two bodies may touch.
    pub fn contacts(&self) -> usize {
        match self {
            Self::Pin { .. } => 1,
        }
    }
}

/// What the gap function of a contact measures; it is positive in contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum GapMeasure {
    /// |e|² - c², m²: smooth also where e = 0.
    Squares {
        /// Radial clearance c, m.
        clearance_m: f64,
    },
}

impl GapMeasure {
    /// What the gaps of the contacts of a joint with play measure.
    pub fn of(play: &PlayGeometry<f64>) -> Self {
        match play.shape {
            PlayShape::Pin { .. } => Self::Squares { clearance_m: play.clearance_m },
        }
    }

    /// δ, m, where the gap function is `gap`.
    pub fn penetration_m(self, gap: f64) -> f64 {
        match self {
            Self::Squares { clearance_m } => gap / ((gap + clearance_m * clearance_m).sqrt() + clearance_m),
        }
    }

    /// The gap function where the penetration is `penetration_m`.
    pub fn gap(self, penetration_m: f64) -> f64 {
        match self {
            Self::Squares { clearance_m } => penetration_m * (penetration_m + 2.0 * clearance_m),
        }
    }

    /// Rate of the gap function over δ̇ where the gap function is `gap`.
    pub fn rate_share(self, gap: f64) -> f64 {
        match self {
            Self::Squares { clearance_m } => 2.0 * (gap + clearance_m * clearance_m).max(0.0).sqrt(),
        }
    }

    /// By how much the gap function changes when δ, near zero, changes by `tolerance_m`.
    pub fn tolerance(self, tolerance_m: f64) -> f64 {
        match self {
            Self::Squares { clearance_m } => 2.0 * clearance_m * tolerance_m,
        }
    }
}
