//! A study in the words of the uncertainty wing.

use crate::file::Study;
use crate::response::columns::BAND;
use crate::response::study_response::StudyResponse;
use loosepin_bounds::{CUT_STANDARD_DEVIATIONS, Problem, Sampling};

/// Runs of the interval-only treatment for each uncertain input, where those are many.
const EXTREME_RUNS_PER_INPUT: usize = 8;

/// The problem that the double loop of `study` solves.
pub(crate) fn problem(study: &Study, response: &StudyResponse) -> Problem {
    let plan = response.plan();
    let usual = Sampling::default();
    let replicates = study.sampling.replicates;
    let choices = study.epistemic.iter().map(|input| input.variable.choices());
    let combinations = choices.fold(1_usize, usize::saturating_mul);
    let extreme = usual.extreme.max(EXTREME_RUNS_PER_INPUT * (study.random.len() + study.epistemic.len()));
    Problem {
        random: study.random.iter().map(|input| input.variable.clone()).collect(),
        copula: study.correlation.as_ref().map(|correlation| correlation.copula.clone()),
        epistemic: study.epistemic.iter().map(|input| input.variable.clone()).collect(),
        parameters: study.epistemic_parameters(),
        reading: study.readings[0],
        readings_beside: study.readings[1..].to_vec(),
        columns: response.row_length(),
        requests: plan.requests(),
        compared_columns: plan.compared_columns(),
        band_probability: BAND[1] - BAND[0],
        cut_standard_deviations: CUT_STANDARD_DEVIATIONS,
        percentiles: study.percentiles.clone(),
        sampling: Sampling {
            outer: study.sampling.outer,
            inner: study.sampling.inner,
            replicates,
            mixture: usual.mixture.div_ceil(replicates) * replicates,
            extreme: extreme.saturating_mul(combinations),
            seed: study.seed,
            confidence: usual.confidence,
        },
    }
}
