//! How long a run of a study takes.

use super::error::StudyError;
use super::file::Study;
use super::problem::problem;
use super::response::StudyResponse;
use loosepin_bounds::{DoubleLoop, SampleTable};
use loosepin_simulate::{Execution, RunFailure};

/// Runs that are timed: enough to fill the lanes of a thread more than once.
const TIMED_RUNS: usize = 48;

/// Processor time of a run of `study` on the lanes of one thread, s: measured on the first runs of its plan, each given up
/// after `largest_evaluations` and counted in proportion to how far it came.
///
/// # Errors
/// The study cannot begin, its sampling is not possible, or all of these runs failed.
pub fn time_a_run_s(study: &Study, largest_evaluations: u64) -> Result<f64, StudyError> {
    let mut response = StudyResponse::new(study)?;
    response.limit_evaluations(largest_evaluations);
    let plan = DoubleLoop::try_new(problem(study, &response))?;
    let round = plan.next_round(&SampleTable::new(response.row_length()))?;
    let variants = response.mechanisms.len();
    let (mut passed, mut reason) = (0.0, None);
    let end_s = response.nominal_end_s();
    let started = std::time::Instant::now();
    for variant in 0..variants {
        let own = round.iter().filter(|inputs| response.variant(&inputs.epistemic) == variant);
        let mut waiting =
            own.take(TIMED_RUNS.div_ceil(variants)).map(|inputs| (0, &inputs.random[..], &inputs.epistemic[..]));
        response.run_all(
            variant,
            Execution::best(),
            || waiting.next(),
            |_, outcome| match outcome {
                Ok(_) => passed += 1.0,
                Err(RunFailure::TooManyEvaluations { time_s, .. }) if time_s > 0.0 => passed += time_s / end_s,
                Err(failure) => reason = Some(failure),
            },
        );
    }
    let elapsed_s = started.elapsed().as_secs_f64();
    match reason {
        Some(reason) if passed == 0.0 => Err(StudyError::AllFailed { runs: TIMED_RUNS.min(round.len()), reason }),
        _ => Ok(elapsed_s / passed),
    }
}
