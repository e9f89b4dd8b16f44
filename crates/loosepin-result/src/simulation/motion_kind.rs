//! Kind of motion of a run: whether it repeats itself, once a turn, and the behaviour of neighbouring motions.

use super::drawing::JournalOrbit;
use loosepin_text::units::{SiUnit, extended};
use serde::{Deserialize, Serialize};

/// Share within which two sections count as the same: of its clearance for every journal, of its size for everything else.
pub const REPEAT_SHARE: f64 = 1e-2;

/// Whether the recorded turns repeat each other, and the motion once a turn (Poincaré section).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MotionKind {
    /// Whole turns that were looked at, at the end of each.
    pub turns: u32,
    /// The least number of turns, at most half of those looked at, after which the motion is back; absent where there is none:
    /// it has not settled, has a longer period, or never repeats itself.
    pub period_turns: Option<u32>,
    /// Tolerance for a return: this share of the clearance for every journal, and for a mechanism that its drives do not move alone this
    /// share of a tenth of its size, of a tenth of a radian, and of these over the time of a radian of the input for rates.
    #[serde(with = "extended")]
    pub repeat_share: f64,
    /// Angle of the drive, or phase of the cycle, within a turn at which the motion was looked at.
    #[serde(with = "extended")]
    pub section_angle_rad: f64,
    /// Paths of every journal, in the frame of its bearing.
    pub journals: Vec<JournalOrbit>,
    /// The outputs that are positions or angles.
    pub outputs: Vec<SectionedOutput>,
}

/// An output once a turn.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SectionedOutput {
    /// Its name.
    pub name: String,
    /// Unit of its values.
    pub unit: SiUnit,
    /// Actual minus ideal.
    #[serde(with = "extended")]
    pub deviation_si: Vec<f64>,
}

/// The largest Lyapunov exponent: how fast two motions part that differ by next to nothing.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct LyapunovRecord {
    /// λ: the separation changes as exp(λ t). Mean over the turns.
    #[serde(with = "extended")]
    pub exponent_1_s: f64,
    /// Standard error of λ, from the means of 20 batches of turns in a row.
    #[serde(with = "extended")]
    pub standard_error_1_s: f64,
    /// Lower end of the interval that holds λ with 95 % confidence.
    #[serde(with = "extended")]
    pub lower_1_s: f64,
    /// Upper end of that interval.
    #[serde(with = "extended")]
    pub upper_1_s: f64,
    /// The resulting kind.
    pub kind: NeighbourKind,
    /// Duration of a turn.
    #[serde(with = "extended")]
    pub turn_s: f64,
    /// Turns run before.
    #[serde(with = "extended")]
    pub transient_turns: f64,
    /// Turns after them in which the direction of the separation settled; not counted.
    pub aligning_turns: u32,
    /// The separation that was set up again and again, as a share of the natural scales.
    #[serde(with = "extended")]
    pub separation: f64,
    /// ln of the growth of the separation over each turn that counts.
    #[serde(with = "extended")]
    pub growth: Vec<f64>,
}

impl LyapunovRecord {
    /// Mean of ln of the growth over a turn.
    pub fn growth_per_turn(&self) -> f64 {
        self.exponent_1_s * self.turn_s
    }
}

/// Behaviour of neighbouring motions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum NeighbourKind {
    /// Neighbouring motions part: the whole interval lies above zero, and over all turns they parted more than a thousandfold.
    Part,
    /// Neighbouring motions meet: the whole interval lies below zero, and over all turns they came closer more than a thousandfold.
    Meet,
    /// Neither is shown: the exponent is compatible with zero.
    Undecided,
}
