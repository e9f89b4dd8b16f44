//! Measured curves beside computed ones.

use loosepin_text::units::{SiUnit, extended};
use serde::{Deserialize, Serialize};

/// The quantity in the first column of a measured table.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Abscissa {
    /// Time since the start of the run.
    Time,
    /// Angle of the drive.
    DriveAngle,
}

/// A measured curve over the computed one. All lists have one entry a measured value.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MeasuredCurve {
    /// The file that it was read from, as it was given.
    pub file: String,
    /// Name of the output.
    pub output: String,
    /// Unit of the values.
    pub unit: SiUnit,
    /// The quantity of `at_si`.
    pub abscissa: Abscissa,
    /// Times or angles of the measurements, s or rad, increasing; angles are moved by whole turns into the recorded ones.
    #[serde(with = "extended")]
    pub at_si: Vec<f64>,
    /// The measured values.
    #[serde(with = "extended")]
    pub measured_si: Vec<f64>,
    /// The computed values at the same places, between the rows of the history.
    #[serde(with = "extended")]
    pub computed_si: Vec<f64>,
    /// Root of the mean square of measured minus computed.
    #[serde(with = "extended")]
    pub rms_si: f64,
    /// The residual of the largest magnitude, measured minus computed.
    #[serde(with = "extended")]
    pub largest_si: f64,
    /// Place of the largest residual.
    #[serde(with = "extended")]
    pub largest_at_si: f64,
}
