//! Requirements and their verdicts.

use loosepin_text::units::extended;
use serde::{Deserialize, Serialize};

use super::bound::{DeviationKind, ResponsePoint, Witness};

/// A requirement `P(lower_si <= Y <= upper_si) >= probability_at_least for every value of the epistemic inputs`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RequirementOutcome {
    /// Name of the output.
    pub output: String,
    /// Which deviation.
    pub of: DeviationKind,
    /// Where in the cycle: `whole` means everywhere.
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
    /// The verdict.
    pub verdict: Verdict,
}

/// Whether a requirement is met.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// Met for every value of the epistemic inputs, numerical error included.
    Met,
    /// Not met for at least one value, numerical error included.
    NotMet,
    /// The numerical error reaches over the limit: more runs decide.
    Undecided,
}
