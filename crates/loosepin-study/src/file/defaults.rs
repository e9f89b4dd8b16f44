//! What holds where a study file does not say.

use super::description::{Sampling, StudySurrogate};
use loosepin_surrogate::Choice;

/// Randomisations of the inner samples: fewer and longer ones than the double loop has by itself.
const REPLICATES: usize = 4;
/// Training runs for each uncertain input, and at least.
const TRAINING_PER_INPUT: usize = 25;
const LEAST_TRAINING: usize = 100;
/// Direct runs at a witness in each replicate.
const CONFIRMING_PER_REPLICATE: usize = 16;

impl Default for Sampling {
    fn default() -> Self {
        let loosepin_bounds::Sampling { outer, inner, .. } = loosepin_bounds::Sampling::default();
        Self { outer, inner, replicates: REPLICATES, tolerance_m: 1e-8, most_failed: 0.1 }
    }
}

impl StudySurrogate {
    /// The surrogate of a study with so many uncertain inputs, and so many inner samples in `replicates`.
    pub fn usual(inputs: usize, replicates: usize, inner: usize) -> Self {
        Self {
            choice: Choice::Auto,
            training_runs: (TRAINING_PER_INPUT * inputs).max(LEAST_TRAINING),
            confirming_runs: (CONFIRMING_PER_REPLICATE * replicates).min(inner),
            is_alone: false,
        }
    }
}
