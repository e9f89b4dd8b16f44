//! Requirements and what became of them.

use loosepin_text::units::extended;
use serde::{Deserialize, Serialize};

use super::accuracy::is_zero_count;
use super::bound::{ResponsePoint, Witness};
use super::verdict::Verdict;
use loosepin_terms::Deviation;

/// A requirement `P(lower_si <= Y <= upper_si) >= probability_at_least for every value of the epistemic inputs`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RequirementOutcome {
    /// Name of the output.
    pub output: String,
    /// Which deviation.
    pub of: Deviation,
    /// Place in the cycle: `whole` means everywhere.
    pub at: ResponsePoint,
    /// Least allowed value; minus infinity where there is none.
    #[serde(with = "extended")]
    pub lower_si: f64,
    /// Largest allowed value; infinity where there is none.
    #[serde(with = "extended")]
    pub upper_si: f64,
    /// The least share of mechanisms that must keep the limits.
    #[serde(with = "extended")]
    pub probability_at_least: f64,
    /// Bounds of that share over the epistemic inputs, widened by their numerical error.
    #[serde(with = "extended")]
    pub probability: [f64; 2],
    /// The epistemic inputs at which the share is smallest.
    pub witness: Witness,
    /// Least share that a promise for a share of the box states, where the requirement is decided by one.
    #[serde(default, with = "extended", skip_serializing_if = "Option::is_none")]
    pub promised: Option<f64>,
    /// Values of the epistemic inputs at which a run failed, so that this promise states nothing.
    #[serde(default, skip_serializing_if = "is_zero_count")]
    pub failed_values: u64,
    /// Mechanisms that were counted at the witness; `None` if the share is no count at one value of the epistemic inputs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub counted: Option<CountedMechanisms>,
    /// The verdict.
    pub verdict: Verdict,
}

/// Mechanisms counted at one value of the epistemic inputs.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct CountedMechanisms {
    /// All of them.
    pub mechanisms: u64,
    /// Mechanisms that break the limit, failed runs among them.
    pub outside: u64,
    /// Error of the share outside, from the finite number of mechanisms.
    #[serde(with = "extended")]
    pub sampling_error: f64,
}
