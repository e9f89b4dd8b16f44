//! Runs at few values of the parameters of distributions, weighted for all others.

use serde::{Deserialize, Serialize};

use loosepin_text::units::extended;

/// How runs were weighted for values of the epistemic inputs at which none were made.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ReweightingRecord {
    /// Whether the weights were worth enough; otherwise the bounds come from the search with runs of its own at every value.
    pub is_used: bool,
    /// Values of the epistemic inputs at which runs were made.
    pub points: u64,
    /// Values that these were weighted for.
    pub compared: u64,
    /// To how many independent runs the weights come at the value for which they are worth least (Kish); not a number where they were not
    /// used.
    #[serde(with = "extended")]
    pub least_effective_runs: f64,
    /// Numbers of each run that bounds are taken of.
    pub columns: u64,
    /// Those for which polynomials of the random inputs stand in, which follow every run.
    pub polynomials: u64,
    /// Ends of bounds, distribution functions and bands beyond which the weighted runs show nothing.
    pub confirmed: u64,
    /// Those for which the weights are worth too little: the search alone tells how far they may go.
    pub unconfirmed: u64,
}
