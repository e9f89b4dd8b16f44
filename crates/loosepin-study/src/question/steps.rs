//! The runs of a question step by step, and the one loop that makes them.

use crate::drafts::progress::Stage;
use crate::error::StudyError;
use crate::planning::budget::Limits;
use crate::runs::all_runs::Runs;
use loosepin_bounds::{DoubleLoop, RunInputs, SampleTable};

/// Says which runs are wanted next, given all runs so far, and in the end what the answer is.
///
/// What is wanted depends on nothing but the runs so far, so that a study that goes on, or that shards share, asks for the same runs again.
pub(crate) trait Steps: Send {
    /// What is known once all runs are made.
    type Answer: Send;

    /// The next runs, given those in `runs`, or the answer.
    ///
    /// # Errors
    /// There is no answer.
    fn next(&mut self, runs: &SampleTable) -> Result<Next<Self::Answer>, StudyError>;

    /// The plan of bounds that the runs so far allow; `None` if there is none.
    fn plan_so_far(&self, runs: &SampleTable) -> Option<DoubleLoop> {
        let _ = runs;
        None
    }

    /// The budget does not allow the step of `runs` runs that was asked for last: the answer is due.
    fn refuse(&mut self, runs: usize) {
        let _ = runs;
    }
}

/// The next step of a question.
pub(crate) enum Next<A> {
    /// Runs, in their order, that begin a step, and how many the step takes at most: the budget may refuse it.
    Step(Vec<RunInputs>, usize),
    /// Further runs of the step that has begun.
    Further(Vec<RunInputs>),
    /// Runs that no bound of the study stands on: they may fail.
    Beside(Vec<RunInputs>),
    /// The answer.
    Answer(A),
}

/// Makes the runs that `steps` want until they have their answer. With `limits` the budget may end them, and too many failed
/// runs give the study up: of that answer the study states its bounds.
///
/// # Errors
/// Those of the steps and of the runs; the budget does not suffice for the first step.
pub(crate) fn take_steps<S: Steps>(
    mut steps: S,
    runs: &mut Runs<'_>,
    limits: Option<&Limits>,
) -> Result<S::Answer, StudyError> {
    let watch = limits.map(Limits::watch);
    let mut begun = 0;
    loop {
        runs.options.progress.stage(Stage::Planning);
        let (wanted, may_fail) = match runs.pool.install(|| steps.next(&runs.table))? {
            Next::Answer(answer) => return Ok(answer),
            Next::Beside(wanted) => (wanted, true),
            Next::Further(wanted) => (wanted, false),
            Next::Step(wanted, most) => {
                if let (Some(limits), Some(watch)) = (limits, &watch) {
                    let made = runs.table.len();
                    if !watch.allows(most, made, begun) {
                        if made == 0 {
                            return Err(limits.too_small(most));
                        }
                        steps.refuse(most);
                        continue;
                    }
                    runs.most_runs = limits.most_runs_with(made + most);
                }
                begun += 1;
                (wanted, false)
            }
        };
        runs.make(&wanted)?;
        if limits.is_some() && !may_fail {
            runs.refuse_failures()?;
        }
        if runs.drafts.is_some()
            && let Some(plan) = steps.plan_so_far(&runs.table)
        {
            runs.tell_draft(&plan);
        }
    }
}
