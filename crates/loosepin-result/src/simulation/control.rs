//! Controls and how they follow their references.

use loosepin_text::units::{SiUnit, extended};
use serde::{Deserialize, Serialize};

/// How one control followed its reference, at the sample times.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ControlHistory {
    /// Name of the control.
    pub name: String,
    /// Name of the joint of the actuator.
    pub joint: String,
    /// Name of the joint whose coordinate follows the reference.
    pub measured: String,
    /// Unit of reference and error.
    pub unit: SiUnit,
    /// Unit of the effort.
    pub effort_unit: SiUnit,
    /// The reference.
    #[serde(with = "extended")]
    pub reference_si: Vec<f64>,
    /// Reference minus measured coordinate.
    #[serde(with = "extended")]
    pub error_si: Vec<f64>,
    /// Torque or force of the actuator.
    #[serde(with = "extended")]
    pub effort_si: Vec<f64>,
    /// Swings of the error that do not die out although the reference rests; absent where there are none.
    pub swing: Option<ErrorOscillation>,
}

/// Swings of an error about its mean over the second half of the recorded part.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct ErrorOscillation {
    /// Whether the oscillation is steady or grows.
    pub course: OscillationTrend,
    /// Half the range of the error over a swing: the mean of all, or of the last ones where they grow.
    #[serde(with = "extended")]
    pub amplitude_si: f64,
    /// Mean duration of a swing.
    #[serde(with = "extended")]
    pub period_s: f64,
    /// Mean error.
    #[serde(with = "extended")]
    pub mean_si: f64,
    /// How many were looked at.
    pub swings: usize,
}

/// Trend of an oscillation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum OscillationTrend {
    /// As wide at the end as at the beginning: a limit cycle.
    Steady,
    /// Wider and wider.
    Grows,
}
