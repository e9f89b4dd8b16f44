//! Questions of a study, and the one loop that makes their runs.

use super::budget::Limits;
use super::error::StudyError;
use super::sheet::{Sheet, Stage};
use loosepin_bounds::{DoubleLoop, RunInputs, SampleTable};

/// Question of a study. It says which runs it wants next, given all runs so far, and in the end what its answer is.
///
/// Each kind of question is a file: the direct double loop, contributors, small probabilities, surrogates. What it wants depends on
/// nothing but the runs so far, so that a study that goes on, or that shards share, asks for the same runs again.
pub(super) trait Question: Send {
    /// What is known once all runs are made.
    type Answer: Send;

    /// The next runs, given those in `runs`, or the answer.
    ///
    /// # Errors
    /// The question cannot be answered.
    fn next(&mut self, runs: &SampleTable) -> Result<Next<Self::Answer>, StudyError>;

    /// The plan of bounds that the runs so far allow; nothing where the question has none.
    fn plan_so_far(&self, runs: &SampleTable) -> Option<DoubleLoop> {
        let _ = runs;
        None
    }

    /// Hears that the budget does not allow the step of `runs` runs that was asked for last: the answer is due.
    fn refuse(&mut self, runs: usize) {
        let _ = runs;
    }
}

/// What a question says.
pub(super) enum Next<A> {
    /// Runs, in their order, that begin a step, and how many the step takes at most: the budget may refuse it.
    Step(Vec<RunInputs>, usize),
    /// Further runs of the step that has begun.
    Further(Vec<RunInputs>),
    /// Runs that no bound of the study stands on: they may fail.
    Beside(Vec<RunInputs>),
    /// The answer.
    Answer(A),
}

/// Makes the runs that `question` wants on `sheet` until it has its answer. With `limits` the budget may end it, and too many failed
/// runs give the study up: of its answer the study states its bounds.
///
/// # Errors
/// Those of the question and of the runs; the budget does not suffice for the first step.
pub(super) fn ask<Q: Question>(
    mut question: Q,
    sheet: &mut Sheet<'_>,
    limits: Option<&Limits>,
) -> Result<Q::Answer, StudyError> {
    let watch = limits.map(Limits::watch);
    let mut steps = 0;
    loop {
        let pool = sheet.runner.pool;
        sheet.runner.progress.stage(Stage::Planning);
        let (runs, may_fail) = match pool.install(|| question.next(&sheet.table))? {
            Next::Answer(answer) => return Ok(answer),
            Next::Beside(runs) => (runs, true),
            Next::Further(runs) => (runs, false),
            Next::Step(runs, most) => {
                if let (Some(limits), Some(watch)) = (limits, &watch) {
                    let made = sheet.table.len();
                    if !watch.allows(most, made, steps) {
                        if made == 0 {
                            return Err(limits.too_small(most));
                        }
                        question.refuse(most);
                        continue;
                    }
                    sheet.most_runs = limits.most_runs_with(made + most);
                }
                steps += 1;
                (runs, false)
            }
        };
        sheet.make(&runs)?;
        if limits.is_some() && !may_fail {
            sheet.refuse_failures()?;
        }
        if sheet.drafts.is_some()
            && let Some(plan) = question.plan_so_far(&sheet.table)
        {
            sheet.tell_draft(&plan);
        }
    }
}
