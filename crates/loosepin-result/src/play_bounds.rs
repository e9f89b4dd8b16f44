//! An input before and after an identification.

use loosepin_text::units::SiUnit;
use serde::{Deserialize, Serialize};

/// A play, before and after.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PlayBounds {
    /// Path in the model, or of the parameter that it follows from.
    pub path: String,
    /// Name in sentences.
    pub name: String,
    /// Its unit.
    pub unit: SiUnit,
    /// Interval of the study, SI.
    pub before_si: [f64; 2],
    /// Interval that is consistent with the readings, SI: within the one before.
    pub after_si: [f64; 2],
    /// Whether the readings fix it by itself, whatever the other plays are.
    pub is_identifiable: bool,
    /// Whether the study states it as a plain interval, which can be narrowed.
    pub is_interval: bool,
}

impl PlayBounds {
    /// Whether the interval after is narrower than the one before, at the lower and at the upper end.
    pub fn is_narrowed(&self) -> [bool; 2] {
        [self.after_si[0] > self.before_si[0], self.after_si[1] < self.before_si[1]]
    }
}
