//! What a study will come to: how many runs, and how long one of them takes.

use super::error::StudyError;
use super::file::Study;
use super::plans::planned;
use super::problem::problem;
use super::response::StudyResponse;
use loosepin_bounds::{DoubleLoop, PromisePlan};
use loosepin_simulate::{Execution, RunFailure};
use std::cell::Cell;
use std::time::Instant;

/// Runs that are timed: they fill the lanes of a thread.
const TIMED_RUNS: usize = 32;
/// As many where each has an ideal motion that is a run of its own.
const TIMED_FREE_RUNS: usize = 1;
/// Evaluations of each of them, at most.
const MOST_EVALUATIONS: f64 = 6000.0;
/// Multiplications of all timed runs, about a twentieth of a second; and evaluations without which a run shows nothing.
const TIMED_MULTIPLICATIONS: f64 = 5e7;
const LEAST_EVALUATIONS: f64 = 100.0;

/// What a study will come to.
#[derive(Debug, Clone, Copy)]
pub struct Foreseen {
    /// As [`super::plan_runs`].
    pub most_runs: usize,
    /// Processor time of a run on the lanes of one thread, s; none where a run takes too long to be tried.
    pub run_s: Option<f64>,
    /// Those of the runs that stand behind a promise, where something is promised.
    pub promise: Option<ForeseenPromise>,
}

/// What a promise costs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ForeseenPromise {
    /// Ends that are promised together.
    pub ends: usize,
    /// Boxes: combinations of the members of lists and focal elements.
    pub boxes: usize,
    /// Values in each box.
    pub values: usize,
    /// Runs at each value.
    pub inner: usize,
    /// All of them.
    pub runs: usize,
}

impl ForeseenPromise {
    fn new(plan: &PromisePlan) -> Self {
        Self { ends: plan.ends(), boxes: plan.boxes(), values: plan.values(), inner: plan.inner(), runs: plan.runs() }
    }
}

/// How many runs `study` comes to, and how long they take: measured on the first runs of its plan, each given up after some thousand
/// evaluations and counted in proportion to how far it came. No samples but these are drawn.
///
/// # Errors
/// As for [`super::plan_runs`], or all timed runs failed.
pub fn foresee(study: &Study) -> Result<Foreseen, StudyError> {
    let mut response = StudyResponse::new(study)?;
    let plans = planned(study, &response)?;
    let (most_runs, promise) = (plans.limits.most_runs(), plans.promise.as_ref().map(ForeseenPromise::new));
    let multiplications = response.mechanism().multiplications();
    // Where drives do not move everything, a run is prepared by a run of its ideal motion, which no lanes share.
    let most = if response.mechanism().is_driven() { TIMED_RUNS } else { TIMED_FREE_RUNS };
    let runs = ((TIMED_MULTIPLICATIONS / (LEAST_EVALUATIONS * multiplications)) as usize).min(most);
    if runs == 0 {
        return Ok(Foreseen { most_runs, run_s: None, promise });
    }
    let evaluations = (TIMED_MULTIPLICATIONS / (runs as f64 * multiplications)).min(MOST_EVALUATIONS);
    response.limit_evaluations(evaluations as u64);
    Ok(Foreseen { most_runs, run_s: time_runs_s(study, &response, runs)?, promise })
}

/// Processor time of a whole run, s, from the first `runs` of the plan; none where no run came to its first step.
///
/// A run is prepared (its ideal motion) and then stepped through. What is given up was prepared as a whole.
fn time_runs_s(study: &Study, response: &StudyResponse, runs: usize) -> Result<Option<f64>, StudyError> {
    let plan = DoubleLoop::try_new(problem(study, response))?;
    let variants = response.mechanisms.len();
    let each = runs.div_ceil(variants);
    let passed = Cell::new(0.0);
    let (mut prepared, mut preparing_s, mut stepping_s, mut reason) = (0_u32, 0.0, 0.0, None);
    let end_s = response.nominal_end_s();
    for variant in 0..variants {
        let first = plan.first_runs(each, |epistemic| response.variant(epistemic) == variant);
        let mut waiting = first.iter().map(|inputs| (0, &inputs.random[..], &inputs.epistemic[..]));
        let (passed_before, mut asked) = (passed.get(), Vec::new());
        response.run_all(
            variant,
            Execution::best(),
            || {
                asked.push((Instant::now(), passed.get() == passed_before));
                waiting.next()
            },
            |_, outcome| match outcome {
                Ok(_) => passed.set(passed.get() + 1.0),
                Err(RunFailure::TooManyEvaluations { time_s, .. }) => passed.set(passed.get() + time_s / end_s),
                Err(failure) => reason = Some(failure),
            },
        );
        // The equations are written down between the first question for a run and the second; all lanes are filled before the first step.
        match (asked.get(1), asked.get(first.len())) {
            (Some(&(begun, true)), Some(&(filled, true))) => {
                prepared += first.len() as u32 - 1;
                preparing_s += (filled - begun).as_secs_f64();
                stepping_s += filled.elapsed().as_secs_f64();
            }
            (Some(&(begun, true)), _) => stepping_s += begun.elapsed().as_secs_f64(),
            // One run after the other.
            _ => stepping_s += asked.first().map_or(0.0, |(begun, _)| begun.elapsed().as_secs_f64()),
        }
    }
    let passed = passed.get();
    match reason {
        Some(reason) if passed == 0.0 => Err(StudyError::AllFailed { runs, reason }),
        _ if passed == 0.0 => Ok(None),
        _ => Ok(Some(preparing_s / f64::from(prepared.max(1)) + stepping_s / passed)),
    }
}

#[cfg(test)]
mod tests {
    use crate::file::Study;
    use crate::response::StudyResponse;
    use loosepin_simulate::{Execution, RunFailure};
    use std::path::Path;

    #[test]
    fn a_run_that_is_timed_is_given_up_after_the_evaluations_it_has() {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/slider_crank_worn_pin/study.toml");
        let study = Study::from_path(&path).unwrap_or_else(|complaints| panic!("{complaints}"));
        let mut response = StudyResponse::new(&study).unwrap();
        response.limit_evaluations(50);
        let mut waiting = [(0, &[0.05, 0.12][..], &[0.0005, 0.8][..])].into_iter();
        let mut outcomes = Vec::new();
        response.run_all(0, Execution::best(), || waiting.next(), |_, outcome| outcomes.push(outcome.map(|_| ())));
        assert!(matches!(outcomes[..], [Err(RunFailure::TooManyEvaluations { .. })]), "{outcomes:?}");
    }
}
