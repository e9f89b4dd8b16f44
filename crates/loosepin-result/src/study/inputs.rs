//! The uncertain inputs, the runs, and the failures.

use super::path_error::PathError;
use serde::{Deserialize, Serialize};

use loosepin_terms::Purpose;
use loosepin_text::units::{SiUnit, extended};

/// One uncertain input.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct InputDescription {
    /// Path in the model, for example `joint.gudgeon.radial_clearance`.
    pub path: String,
    /// Random or epistemic, with its range.
    pub kind: InputKind,
    /// Unit of its values.
    pub unit: SiUnit,
    /// In words and people's units, for example `normal, mean 50 mm, standard deviation 0.02 mm`.
    pub words: String,
}

/// Kinds of uncertain input.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum InputKind {
    /// Scatters from part to part with a known distribution.
    Random,
    /// Fixed but unknown, in an interval.
    Interval {
        /// Lower end.
        lower_si: f64,
        /// Upper end.
        upper_si: f64,
    },
    /// Somewhere in one of several intervals with masses.
    Evidence {
        /// The intervals.
        elements: Vec<ElementDescription>,
        /// Whether it scatters within them from part to part (a probability box) rather than being fixed.
        is_scattering: bool,
    },
    /// Fixed but unknown, possible to different degrees.
    Fuzzy {
        /// The values possible to at least each degree, degrees increasing.
        cuts: Vec<CutDescription>,
    },
    /// Fixed but unknown, anywhere on a circle: one period of an angle or a phase.
    Periodic {
        /// Start of the period.
        lower_si: f64,
        /// End of the period, which is its start again.
        upper_si: f64,
    },
    /// Fixed but unknown, a parameter with a distribution over its values; the words describe it.
    SecondOrder {
        /// Lower end of what is looked at.
        lower_si: f64,
        /// Upper end of what is looked at.
        upper_si: f64,
    },
    /// The places of the journals of a mechanism in space: anywhere in their play, at each position.
    Play,
    /// The places of the journals of a mechanism in space, drawn for each sample and held over the turn.
    DrawnPlay,
    /// Fixed but unknown, one of a list.
    Choice {
        /// The list.
        of: Vec<String>,
    },
}

impl InputKind {
    /// Whether it scatters from part to part with a known distribution.
    pub fn is_random(&self) -> bool {
        matches!(self, Self::Random | Self::DrawnPlay)
    }
}

/// A focal element.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct ElementDescription {
    /// Lower end.
    pub lower_si: f64,
    /// Upper end.
    pub upper_si: f64,
    /// Its mass, in (0, 1].
    pub mass: f64,
}

/// A cut of a fuzzy number.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct CutDescription {
    /// The degree, in [0, 1].
    pub alpha: f64,
    /// Lower end.
    pub lower_si: f64,
    /// Upper end.
    pub upper_si: f64,
}

/// A correlation of two random inputs.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CorrelationDescription {
    /// Paths of the inputs.
    pub of: Vec<String>,
    /// Spearman's rank correlation, -1 to 1, of the normal variables behind the inputs, which is that of the inputs where no
    /// value comes up twice.
    #[serde(with = "extended")]
    pub rank: f64,
    /// Pearson's linear correlation of the values, where it was stated in place of the other one.
    #[serde(with = "extended", default)]
    pub linear: Option<f64>,
}

/// The recorded part of the cycle of each sample; part of the meaning of every response.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CycleDescription {
    /// Name of the drive whose angle is the input.
    pub drive: String,
    /// Speed of the drive where it is constant.
    #[serde(with = "extended")]
    pub drive_speed_rad_s: Option<f64>,
    /// Turns that were run and thrown away.
    #[serde(with = "extended")]
    pub transient_turns: f64,
    /// Turns that were recorded.
    #[serde(with = "extended")]
    pub recorded_turns: f64,
    /// Position tolerance of the integration.
    #[serde(with = "extended")]
    pub tolerance_m: f64,
    /// Name of the integration method.
    pub method: String,
}

/// One output.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct OutputDescription {
    /// Name of the output.
    pub name: String,
    /// Description, for example `x of slider.pin`.
    pub words: String,
    /// Unit of its values.
    pub unit: SiUnit,
    /// Which part of the error of which point it is; `None` if it is a number that can be read off the mechanism.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub path: Option<PathOutput>,
    /// The joint with play whose force it is; absent, and not written, for any other output.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub contact_force_in: Option<String>,
}

/// A part of the error of a point from its ideal path.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct PathOutput {
    /// The output and its point in words, `tool (coupler.tool)`.
    pub point: String,
    /// Which part.
    pub part: PathError,
}

/// How many runs of which kind.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct RunCounts {
    /// All runs.
    pub runs: u64,
    /// Failed runs.
    pub failed: u64,
    /// The runs by what they were for, purposes without runs left out.
    pub by_purpose: Vec<PurposeRuns>,
    /// Values of the epistemic inputs.
    pub outer: u64,
    /// Random samples at each of them.
    pub inner: u64,
    /// Independently randomised repetitions among the random samples, from which the sampling error comes.
    pub replicates: u64,
    /// Rounds of an adaptive study; 1 otherwise.
    pub rounds: u64,
}

/// How finely the box of the epistemic inputs was seen: a peak within a gap may have been missed, whatever its height.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct GapRecord {
    /// The largest cube of the box without a point at which statistics were estimated, as a share of its volume.
    #[serde(with = "extended")]
    pub between_points: f64,
    /// The largest one without a run: a peak that stands out of the scatter of a single run is seen by that.
    #[serde(with = "extended")]
    pub between_runs: f64,
    /// Unknown inputs that the box has an axis for, which is each but lists; 0 in records of older versions.
    #[serde(default)]
    pub axes: u64,
}

impl GapRecord {
    /// Side of a cube of this share of the volume of the box, as a share of each range; `None` where nothing says how many axes there are.
    pub fn side(&self, share: f64) -> Option<f64> {
        (self.axes > 0).then(|| share.powf(1.0 / self.axes as f64))
    }
}

/// Runs for one purpose.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct PurposeRuns {
    /// The purpose.
    pub purpose: Purpose,
    /// How many.
    pub runs: u64,
}

/// Runs that failed for the same reason.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FailureGroup {
    /// Short name that does not change, for example `cannot_close`.
    pub code: String,
    /// The reason in words.
    pub words: String,
    /// How many runs.
    pub count: u64,
    /// One of them.
    pub example: ExampleRun,
}

/// One run, ready to be made again.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ExampleRun {
    /// Its index in `runs.parquet`.
    pub index: u64,
    /// The command that makes it again.
    pub command: String,
}
