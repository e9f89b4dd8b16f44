//! Estimated cost of a study: the number of its runs, and the duration of one.

use crate::error::StudyError;
use crate::file::{EpistemicSubject, Study};
use crate::planning::cost_estimate::CostEstimate;
use crate::planning::plans::{Plans, default_threads, planned};
use crate::planning::problem::problem;
use crate::response::kind::Stepping;
use crate::response::study_response::StudyResponse;
use loosepin_bounds::{DoubleLoop, RunInputs, SampleTable};
use loosepin_simulate::{Execution, RunFailure};
use std::cell::Cell;
use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};

/// Runs that are timed: they fill the lanes of a thread.
const TIMED_RUNS: usize = 32;
/// Runs in space that are timed.
const TIMED_POSITIONS: usize = 4;
/// Largest number of timed combinations of laws, each of which is a batch of its own.
const MAX_VARIANTS: usize = 4;
/// The mechanisms among the runs, each at several values of the epistemic inputs; and where forces decide the ideal motion, which then takes
/// as long as a run.
const MECHANISMS: usize = 4;
const FREE_MECHANISMS: usize = 1;
/// No further run is begun when all but the first preparation have taken so long.
const MAX_PREPARING: Duration = Duration::from_millis(10);
/// Multiplications of all timed runs, about a hundredth of a second; and evaluations without which a run shows nothing.
const TIMED_MULTIPLICATIONS: f64 = 1.2e7;
const MIN_EVALUATIONS: f64 = 100.0;
/// Least progress of the timed runs, as a share of their time, on average, where forces decide the motion: the initial settling says
/// nothing about the rest.
const MIN_FREE_SHARE: f64 = 0.1;

/// Estimated number and duration of the runs of `study`: measured on the first runs of its plan, each given up after some hundred or
/// thousand evaluations and extrapolated from its progress. No samples but these are drawn.
///
/// # Errors
/// As for [`crate::plan_runs`], or all timed runs failed.
pub fn estimate_cost(study: &Study) -> Result<CostEstimate, StudyError> {
    let mut response = StudyResponse::new(study)?;
    let plans = planned(study, &response, default_threads())?;
    let mut estimate = CostEstimate { most_runs: plans.limits.most_runs(), search_runs: 0, run_s: None, promise: None };
    plans.questions.iter().for_each(|question| question.add_cost(&mut estimate));
    let Some(Stepping { multiplications, .. }) = response.stepping() else {
        let share = closed_share(study, &response, &plans);
        estimate.run_s = time_positions_s(study, &response)?.map(|closing_s| share * closing_s);
        return Ok(estimate);
    };
    let variants = response.variants().min(MAX_VARIANTS);
    let all = TIMED_MULTIPLICATIONS / (variants as f64 * multiplications);
    // What has no room for the lanes of a thread runs on its own.
    let runs = ((all / MIN_EVALUATIONS) as usize).min(TIMED_RUNS);
    if runs == 0 {
        return Ok(estimate);
    }
    let most_evaluations = (all / runs as f64) as u64;
    response.limit_evaluations(most_evaluations);
    if let Some(stepping) = response.stepping() {
        estimate.run_s = time_runs_s(study, &response, &TimedRuns { stepping, runs, most_evaluations })?;
    }
    Ok(estimate)
}

/// Share of the runs in space for which the loops are closed: the first round repeats its samples at each place of the journals, apart from those
/// of the probability-only treatment, and a sample is closed once.
fn closed_share(study: &Study, response: &StudyResponse, plans: &Plans) -> f64 {
    let play = study.epistemic.iter().find(|input| matches!(input.subject, EpistemicSubject::Play));
    let Some(places) = play.map(|input| input.variable.choices()).filter(|_| !plans.is_surrogate_alone) else {
        return 1.0;
    };
    let direct = plans.refinement.plan(&SampleTable::new(response.row_length()));
    let mixture = if direct.problem().compared_columns.is_empty() { 0 } else { direct.problem().sampling.mixture };
    let repeated = direct.first_round_runs().saturating_sub(mixture) as f64 * (1.0 - 1.0 / places as f64);
    1.0 - (repeated / plans.limits.most_runs() as f64).min(1.0)
}

/// Processor time of a run in space whose loops are closed, s: the mean of the first runs of the plan.
///
/// # Errors
/// All of them failed.
fn time_positions_s(study: &Study, response: &StudyResponse) -> Result<Option<f64>, StudyError> {
    let plan = DoubleLoop::try_new(problem(study, response))?;
    // Each sample once: at other places of its journals it is not closed again.
    let play = study.epistemic.iter().position(|input| matches!(input.subject, EpistemicSubject::Play));
    let is_in_the_middle = |epistemic: &[f64]| play.is_none_or(|place| epistemic[place] == 0.0);
    let points = plan.first_runs(TIMED_POSITIONS, 1, is_in_the_middle).len().max(1);
    let inputs = plan.first_runs(points, TIMED_POSITIONS / points, is_in_the_middle);
    let mut row = vec![f64::NAN; response.row_length()];
    let mut finished: Vec<f64> = Vec::new();
    let mut reason = None;
    for inputs in &inputs {
        let begun = Instant::now();
        match response.run(&inputs.random, &inputs.epistemic, &mut row) {
            Ok(()) => finished.push(begun.elapsed().as_secs_f64()),
            Err(failure) => reason = Some(failure),
        }
    }
    match reason {
        Some(reason) if finished.is_empty() => Err(StudyError::AllFailed { runs: inputs.len(), reason }),
        _ if finished.is_empty() => Ok(None),
        _ => Ok(Some(finished.iter().sum::<f64>() / finished.len() as f64)),
    }
}

/// Durations of the timed runs.
#[derive(Default)]
struct Timing {
    /// Evaluations of each run, and the share of its time that it came to with them.
    runs: Vec<(f64, f64)>,
    /// Time in which `prepared` runs were prepared.
    preparing: Duration,
    prepared: u32,
    /// Time in which all runs were stepped through.
    stepping: Duration,
    /// All runs, failed ones too, and why one failed.
    tried: usize,
    reason: Option<RunFailure>,
}

impl Timing {
    /// Processor time of a whole run, s:
    ///
    /// ```text
    /// preparing/prepared + stepping/Σ evaluations · mean(evaluations/share)
    /// ```
    ///
    /// `None` if the runs came to less than `least_share` of their time, on average.
    fn run_s(&self, least_share: f64) -> Option<f64> {
        let count = self.runs.len() as f64;
        let all: f64 = self.runs.iter().map(|(evaluations, _)| evaluations).sum();
        let whole = self.runs.iter().map(|(evaluations, share)| evaluations / share).sum::<f64>() / count;
        let preparing_s = self.preparing.as_secs_f64() / f64::from(self.prepared);
        let run_s = preparing_s + self.stepping.as_secs_f64() / all * whole;
        let share = self.runs.iter().map(|(_, share)| share).sum::<f64>() / count;
        (run_s.is_finite() && share >= least_share).then_some(run_s)
    }
}

/// The runs that are timed.
struct TimedRuns<'r> {
    stepping: Stepping<'r>,
    /// How many of each combination of laws.
    runs: usize,
    /// Evaluations after which each is given up.
    most_evaluations: u64,
}

/// Processor time of a whole run, s, from the first runs of the plan; `None` if they do not show it.
///
/// A run is prepared (its ideal motion) and then stepped through. What is given up was prepared as a whole.
fn time_runs_s(study: &Study, response: &StudyResponse, timed: &TimedRuns<'_>) -> Result<Option<f64>, StudyError> {
    let plan = DoubleLoop::try_new(problem(study, response))?;
    let runs = timed.runs;
    let (mechanisms, least_share) =
        if timed.stepping.is_driven { (MECHANISMS, 0.0) } else { (FREE_MECHANISMS, MIN_FREE_SHARE) };
    let mut timing = Timing::default();
    for variant in 0..response.variants().min(MAX_VARIANTS) {
        let is_meant = |epistemic: &[f64]| response.variant(epistemic) == variant;
        // The mechanisms are the same at each value of the epistemic inputs, as in the study: where these do not change an ideal motion,
        // it is known at all but the first. Where there is but one value, each has a mechanism of its own.
        let points = plan.first_runs(runs, 1, is_meant).len();
        let each = if points > 1 { mechanisms.min(runs) } else { runs };
        time_variant(response, variant, (timed, &plan.first_runs(runs / each, each, is_meant)), &mut timing);
    }
    match timing.reason.take() {
        Some(reason) if timing.runs.is_empty() => Err(StudyError::AllFailed { runs: timing.tried, reason }),
        _ => Ok(timing.run_s(least_share)),
    }
}

/// Adds runs of the kind `variant`: those of `inputs`, over and over, so that all lanes are filled.
fn time_variant(
    response: &StudyResponse,
    variant: usize,
    (timed, inputs): (&TimedRuns<'_>, &[RunInputs]),
    timing: &mut Timing,
) {
    let (Stepping { settings, nominal_end_s, .. }, given) = (&timed.stepping, timed.most_evaluations);
    let mut waiting =
        inputs.iter().cycle().take(timed.runs).map(|inputs| (0, &inputs.random[..], &inputs.epistemic[..]));
    let ended = Cell::new(0_u32);
    let mut asked: Vec<(Instant, u32)> = Vec::new();
    let preparations = response.run_all_until(
        variant,
        Execution::best(),
        &AtomicBool::new(false),
        || {
            asked.push((Instant::now(), ended.get()));
            let is_in_time = asked.get(1).is_none_or(|(second, _)| second.elapsed() < MAX_PREPARING);
            waiting.next().filter(|_| is_in_time)
        },
        |_, outcome| {
            ended.set(ended.get() + 1);
            match outcome {
                Ok(row) => {
                    let extras = response.extras(&row);
                    // Where nothing is integrated each step counts as one of the method.
                    let of_steps = extras.steps * settings.method.stages.len() as f64;
                    let evaluations = if extras.evaluations > 0.0 { extras.evaluations } else { of_steps };
                    timing.runs.push((evaluations, 1.0));
                }
                Err(RunFailure::TooManyEvaluations { time_s, limit }) if limit == given => {
                    timing.runs.push((limit as f64, time_s / nominal_end_s));
                }
                Err(failure) => timing.reason = Some(failure),
            }
        },
    );
    let Some(&(begun, _)) = asked.first() else { return };
    let mut spent = begun.elapsed();
    // The equations are written down once, behind the first preparation and before the second question for a run.
    if let (Some(&(second, 0)), Some(&preparation)) = (asked.get(1), preparations.first()) {
        spent = spent.saturating_sub((second - begun).saturating_sub(preparation));
    }
    timing.stepping += spent.saturating_sub(preparations.iter().sum());
    timing.tried += preparations.len();
    // What comes again is known, and the first ones are those of a value of the epistemic inputs at which nothing was known.
    let fresh = preparations.len().min(inputs.len());
    let later = &preparations[fresh / 2..fresh];
    timing.preparing += later.iter().sum::<Duration>();
    timing.prepared += later.len() as u32;
}

#[cfg(test)]
mod tests {
    use super::{Timing, estimate_cost};
    use crate::response::planar_response::PlanarResponse;
    use crate::written::texts::study_with;
    use loosepin_simulate::{Execution, RunFailure};
    use std::time::Duration;

    #[test]
    fn analytic_a_run_that_is_slow_counts_as_much_as_one_that_is_fast() {
        // 100 evaluations a millisecond. The first run needs 100 of them, the second 1000: 550 on average, though they came to 1.1 runs.
        let timing = Timing {
            runs: vec![(100.0, 1.0), (100.0, 0.1)],
            preparing: Duration::from_millis(6),
            prepared: 3,
            stepping: Duration::from_millis(2),
            ..Timing::default()
        };
        assert!((timing.run_s(0.5).unwrap() - 7.5e-3).abs() < 1e-12);
        assert_eq!(timing.run_s(0.6), None);
        assert_eq!(Timing::default().run_s(0.0), None);
    }

    const WORN_PIN: &str = "cases/slider_crank_worn_pin/study.toml";

    #[test]
    fn a_run_without_play_and_one_of_many_laws_have_a_time() {
        let play = "\"joint.gudgeon.radial_clearance\" = { interval = [\"0.1 mm\", \"0.5 mm\"] }\n";
        let run_s = |replaced: &[(&str, &str)]| estimate_cost(&study_with(WORN_PIN, replaced)).unwrap().run_s;
        let without = run_s(&[(play, ""), ("radial_clearance = \"0.3 mm\"", "radial_clearance = \"0 mm\"")]);
        assert!(without.is_some());
        let laws = "\"contact.steel_pin.law\" = { any_of = [\"lankarani-nikravesh\", \"flores\", \"hunt-crossley\", \"herbert-mcwhannell\", \"lee-wang\"] }\n";
        assert!(run_s(&[(play, laws)]).is_some());
    }

    #[test]
    fn a_run_that_is_timed_is_given_up_after_the_evaluations_it_has() {
        let mut response = PlanarResponse::new(&study_with(WORN_PIN, &[])).unwrap();
        response.limit_evaluations(50);
        let mut waiting = [(0, &[0.05, 0.12][..], &[0.0005, 0.8][..])].into_iter();
        let mut outcomes = Vec::new();
        response.run_all(0, Execution::best(), || waiting.next(), |_, outcome| outcomes.push(outcome.map(|_| ())));
        assert!(matches!(outcomes[..], [Err(RunFailure::TooManyEvaluations { .. })]), "{outcomes:?}");
    }
}
