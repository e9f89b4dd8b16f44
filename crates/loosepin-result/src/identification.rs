//! The record of an identification: what readings of a rig say of the plays of a mechanism.

pub use crate::identification_gain::{Gain, GainedBound};
use crate::motion_identification::{MotionPlan, MotionSpecimen};
pub use crate::play_bounds::PlayBounds;
use crate::repeat::Repeat;
use loosepin_text::units::{DisplayUnits, SiUnit};
use serde::{Deserialize, Serialize};

/// Identification of the plays of a study from its readings.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Identification {
    /// Name of the study.
    pub study: String,
    /// Name of its model.
    pub model: String,
    /// The version that made it.
    pub version: String,
    /// Probability, at least, with which all bounds of a specimen hold together, over the independent errors of its readings and
    /// its random inputs. Everything else is an interval, for which they always hold.
    pub confidence: f64,
    /// Random inputs: each counts with the interval that holds it with its share of the confidence.
    pub random_inputs: Vec<InputRange>,
    /// Units in which it is shown.
    pub display_units: DisplayUnits,
    /// The specimens of backlash tests, in the order of the file.
    pub specimens: Vec<Specimen>,
    /// The specimens whose motion was measured, in the order of the file.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub motion: Vec<MotionSpecimen>,
    /// Expected information in features of the motion, if requested.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub plan: Option<MotionPlan>,
    /// Gain by the narrower intervals, if requested.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gain: Option<Gain>,
    /// How it is made again.
    #[serde(default, skip_serializing_if = "Repeat::is_empty")]
    pub repeat: Repeat,
}

/// The interval of an input that is no play.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct InputRange {
    /// Path in the model.
    pub path: String,
    /// Its unit.
    pub unit: SiUnit,
    /// Its interval, SI.
    pub interval_si: [f64; 2],
}

/// A mechanism that was measured.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Specimen {
    /// Its name; `None` if the file does not say.
    pub name: Option<String>,
    /// Its readings, in the order of the file.
    pub readings: Vec<TestReading>,
    /// Values consistent with them.
    pub outcome: Outcome,
}

/// Values consistent with all readings of a specimen.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Outcome {
    /// Some values of the plays.
    Consistent(ConsistentPlays),
    /// No value of the plays.
    Misfit(Misfit),
}

/// A reading with its part in the model: measured = Σ factor · play + compliance + errors.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct TestReading {
    /// Its name.
    pub name: String,
    /// The output that was read.
    pub output: String,
    /// Unit of the reading.
    pub unit: SiUnit,
    /// Angle at which the drive was locked, rad.
    pub pose_rad: f64,
    /// The push, in words.
    pub push: String,
    /// Dead travel, mean of the repeats, SI.
    pub dead_travel_si: f64,
    /// Number of readings behind it.
    pub repeats: usize,
    /// Largest common error, of either sign, SI.
    pub common_error_si: f64,
    /// Largest independent error of the mean at the confidence, of either sign, SI.
    pub independent_error_si: f64,
    /// Factors of the inputs that are plays, in their order: least with friction and all else against it, nominal, largest.
    pub factors: Vec<[f64; 3]>,
    /// Travel by the contacts that give way under the push, SI: least and largest.
    pub compliance_si: [f64; 2],
    /// Share by which the exact loops differ from the linear model, at most.
    pub linearisation_share: f64,
    /// Range that the study's own intervals allow, SI.
    pub allowed_before_si: [f64; 2],
}

/// Bounds of the plays.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ConsistentPlays {
    /// Each play by itself.
    pub plays: Vec<PlayBounds>,
    /// The combinations of plays that the readings fix.
    pub combinations: Vec<Combination>,
    /// Plays that enter every reading alike, by their places among the plays; each group has two or more.
    pub alike: Vec<Vec<usize>>,
    /// The reading that would narrow most; `None` if none would.
    pub further: Option<FurtherReading>,
    /// The readings that were looked at for it; `None` if it was not looked for.
    #[serde(default)]
    pub searched: Option<ReadingSearch>,
}

/// Readings among which the best further one was looked for.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct ReadingSearch {
    /// Number that was ranked by nominal factors.
    pub candidates: usize,
    /// Number that looked best there and was computed in full.
    pub in_full: usize,
}

/// A sum of plays, each times its weight.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Combination {
    /// Weights, by the place of the play.
    pub weights: Vec<f64>,
    /// Unit of the sum.
    pub unit: SiUnit,
    /// Interval of the study, SI.
    pub before_si: [f64; 2],
    /// Interval that is consistent with the readings, SI.
    pub after_si: [f64; 2],
}

/// A reading that was not made.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FurtherReading {
    /// The measured quantity: an output of the model, or a coordinate of a point that the model has no output for.
    pub reads: String,
    /// Whether the model has an output for it.
    pub has_output: bool,
    /// Angle of the drive, rad.
    pub pose_rad: f64,
    /// The point that is pushed, or the body that a moment turns.
    pub pushed: String,
    /// Direction of the push from the ground's x axis, rad; `None` for a moment.
    pub direction_rad: Option<f64>,
    /// The error that was assumed, of either sign, in the unit of the reading.
    pub error_si: f64,
    /// Unit of the reading.
    pub unit: SiUnit,
    /// Factors of the plays.
    pub factors: Vec<f64>,
    /// Width of the interval of each play that would be left if the reading came out in the middle of what is possible, SI.
    pub widths_si: Vec<f64>,
    /// Number of candidates that were compared.
    pub candidates: usize,
}

/// Readings that no value of the plays explains.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Misfit {
    /// Readings that are at odds with all the others, by their places: without one of them the others are consistent. Empty if the
    /// others contradict one another whichever is left out.
    pub culprits: Vec<InconsistentReading>,
    /// Pairs that contradict each other without any other reading, by their places; looked for where there are no culprits.
    #[serde(default)]
    pub pairs: Vec<[usize; 2]>,
    /// Factor by which the errors of all readings had to be larger for the readings to be consistent; `None` if none is enough.
    pub error_factor: Option<f64>,
    /// Readings that would then lie at the end of their error, by their places.
    pub strained: Vec<usize>,
}

/// A reading that is at odds with the others, or with the intervals of the study alone.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct InconsistentReading {
    /// Its place among the readings.
    pub reading: usize,
    /// Whether the study's own intervals exclude it, without any other reading.
    pub is_alone: bool,
    /// Range of the reading by the others, SI.
    pub expected_si: [f64; 2],
    /// Range of the reading by itself, with its errors, SI.
    pub found_si: [f64; 2],
    /// How far the two are apart, SI, > 0.
    pub apart_si: f64,
}
