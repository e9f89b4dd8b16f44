//! Surrogates: what they learned, how well, and the bounds that they give.

use serde::{Deserialize, Serialize};

use super::bound::{BoundRecord, ResponsePoint};
use super::figures::TreatmentComparison;
use loosepin_terms::{Deviation, SurrogateVerdict};
use loosepin_text::units::{SiUnit, extended};

/// Bounds by surrogates, beside the direct ones.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SurrogateRecord {
    /// Runs to learn from.
    pub training_runs: u64,
    /// Direct runs that it was held against: at the witnesses of bounds, and at the extremes of treatments.
    pub confirming_runs: u64,
    /// Runs at the witnesses of bounds.
    pub runs_at_bounds: u64,
    /// Failed ones of both.
    pub failed: u64,
    /// Runs of the direct double loop, for comparison.
    pub direct_runs: u64,
    /// Surrogates, one entry for each number and each curve.
    pub outputs: Vec<SurrogateOutput>,
    /// The bounds; of what nothing was learned nothing is known.
    pub bounds: Vec<BoundRecord>,
    /// The three treatments by the surrogates, beside those of the direct runs.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub treatments: Vec<TreatmentComparison>,
}

impl SurrogateRecord {
    /// Whether there is no direct double loop beside: the bounds of the study are its own.
    pub fn is_alone(&self) -> bool {
        self.direct_runs == 0
    }
}

/// Surrogate of a number or a curve; where laws or members of lists have surrogates of their own, that with the largest error.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SurrogateOutput {
    /// Name of the output.
    pub output: String,
    /// Which deviation.
    pub of: Deviation,
    /// Place in the cycle; [`ResponsePoint::Whole`] for a curve.
    pub at: ResponsePoint,
    /// Unit of the output.
    pub unit: SiUnit,
    /// Why nothing was learned; the fields below are then empty.
    pub problem: Option<String>,
    /// Kind of the surrogate of each mode of a curve; one for a number: constant, polynomial chaos, Kriging, neural network.
    pub kinds: Vec<String>,
    /// Runs that it learned from, and training runs that did not deliver it.
    pub runs: u64,
    /// Runs without this output.
    pub missing: u64,
    /// Failed runs, those at the witnesses included: if there are any, probabilities and quantiles are unknown.
    pub failed: u64,
    /// The largest share of the mechanisms at a witness that lies outside of the range of the runs, where the surrogate gives no answer.
    #[serde(with = "extended")]
    pub share_outside: f64,
    /// Root mean square of the held-out errors, over runs and along a curve.
    #[serde(with = "extended")]
    pub held_out_si: f64,
    /// 1 - Σ error²/Σ (y - mean)² of held-out runs; `None` for a constant.
    #[serde(with = "extended")]
    pub q2: Option<f64>,
    /// Verdict of the held-out errors on the response.
    pub verdict: Option<SurrogateVerdict>,
    /// Held-out error from fewer runs.
    pub learning: Vec<SurrogateLearning>,
    /// Number of its standard deviations by which the surrogate is taken to err in the bounds.
    #[serde(with = "extended")]
    pub reach: f64,
    /// The largest error that direct runs at witnesses have shown, root mean square, in its standard deviations.
    #[serde(with = "extended")]
    pub largest_ratio: f64,
    /// Held-out error along a curve.
    pub along: Option<SurrogateAlong>,
    /// Runs against the input that matters most, with the surrogate.
    pub picture: Option<SurrogatePicture>,
}

/// Held-out error from a number of runs.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct SurrogateLearning {
    /// Runs learned from.
    pub runs: u64,
    /// Root mean square of the held-out errors.
    #[serde(with = "extended")]
    pub held_out_si: f64,
}

/// Held-out error along a curve.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SurrogateAlong {
    /// Angles of the drive.
    #[serde(with = "extended")]
    pub pose_rad: Vec<f64>,
    /// Root mean square of the held-out errors there.
    #[serde(with = "extended")]
    pub held_out_si: Vec<f64>,
}

/// Training runs against one input, moved along the surrogate to the middle of all others, and the surrogate there.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SurrogatePicture {
    /// Path of the input.
    pub path: String,
    /// Its unit.
    pub input_unit: SiUnit,
    /// Angle of the drive on a curve, where its error is largest.
    #[serde(with = "extended")]
    pub pose_rad: Option<f64>,
    /// The runs: values of the input.
    #[serde(with = "extended")]
    pub run_input_si: Vec<f64>,
    /// The runs: values of the output.
    #[serde(with = "extended")]
    pub run_output_si: Vec<f64>,
    /// The surrogate: values of the input.
    #[serde(with = "extended")]
    pub input_si: Vec<f64>,
    /// The surrogate: its value.
    #[serde(with = "extended")]
    pub output_si: Vec<f64>,
    /// The surrogate: by how much it is taken to err.
    #[serde(with = "extended")]
    pub half_width_si: Vec<f64>,
}
