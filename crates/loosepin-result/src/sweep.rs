//! Result of a sweep, as pages and files read it. SI.

use crate::repeat::Repeat;
use crate::simulation::Override;
use loosepin_text::units::{DisplayUnits, SiUnit};
use serde::{Deserialize, Serialize};

/// A finished sweep.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SweepRecord {
    /// Name of the model.
    pub model: String,
    /// Version of the program.
    pub version: String,
    /// Values set on the command line.
    pub overrides: Vec<Override>,
    /// How it is made again; empty in records of older versions.
    #[serde(default, skip_serializing_if = "Repeat::is_empty")]
    pub repeat: Repeat,
    /// Path of the quantity that was varied.
    pub path: String,
    /// Its unit.
    pub unit: SiUnit,
    /// Name of the drive whose turns are counted, or `cycle`.
    pub drive: String,
    /// Angle of the drive at which the motion is looked at once a turn, rad.
    pub section_angle_rad: f64,
    /// Turns before those that are looked at.
    pub transient_turns: u32,
    /// Turns that are looked at.
    pub recorded_turns: u32,
    /// Tolerance of a step, m: it may err by 0.5 % of it.
    pub tolerance_m: f64,
    /// Positions and angles that were looked at.
    pub outputs: Vec<SweptOutput>,
    /// Joints with play.
    pub joints: Vec<String>,
    /// One for each value, in the order of the values.
    pub points: Vec<SweepPoint>,
    /// Units in which people read it.
    pub display_units: DisplayUnits,
}

/// A position or angle that was looked at.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SweptOutput {
    /// Its name.
    pub name: String,
    /// Description, for example `x of slider.pin`.
    pub words: String,
    /// Its unit.
    pub unit: SiUnit,
}

/// The run for one value.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SweepPoint {
    /// The value of the quantity.
    pub value_si: f64,
    /// Why the run failed; then the lists below are empty.
    pub failure: Option<String>,
    /// Turns after which the motion repeats itself; `None` if it did not within half of the turns looked at.
    pub period_turns: Option<u32>,
    /// By output: its deviation from the ideal motion of the same dimensions, once a turn.
    pub sections_si: Vec<Vec<f64>>,
    /// By joint with play.
    pub joints: Vec<SweptJoint>,
}

/// A joint with play during the turns looked at; all numbers are zero where its clearance is.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct SweptJoint {
    /// Located onsets faster than the floor of the law, a turn.
    pub impacts_per_turn: f64,
    /// Share of the time without contact.
    pub flight_share: f64,
    /// Contacts that ended, a turn.
    pub losses_per_turn: f64,
    /// Largest normal force, N.
    pub peak_force_n: f64,
    /// Largest penetration, m.
    pub largest_penetration_m: f64,
}

impl SweptJoint {
    /// In a run in which it has no play: its parts do not part.
    pub fn without_play() -> Self {
        let zero = 0.0;
        Self {
            impacts_per_turn: zero,
            flight_share: zero,
            losses_per_turn: zero,
            peak_force_n: zero,
            largest_penetration_m: zero,
        }
    }
}
