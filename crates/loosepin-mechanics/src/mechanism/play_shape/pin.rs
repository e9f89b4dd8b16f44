//! A round pin in a round hole.

use super::form::{PlayForm, PlayFreedom};
use loosepin_math::{Real, numbers};

/// A round hole.
#[derive(Debug, Clone, Copy)]
pub struct PinShape<T> {
    /// Radius R_i of the bearing, m.
    pub bearing_radius_m: T,
}

numbers!(struct PinShape { bearing_radius_m });

impl<T: Real> PlayForm<T> for PinShape<T> {
    fn freedom(&self) -> PlayFreedom<T> {
        PlayFreedom::InCircle
    }

    fn thickness_m(&self, clearance_m: T) -> T {
        (self.bearing_radius_m - clearance_m).max(T::zero())
    }

    fn hole_radius_m(&self) -> Option<T> {
        Some(self.bearing_radius_m)
    }

    #[inline(always)]
    fn is_round(&self) -> bool {
        true
    }
}
