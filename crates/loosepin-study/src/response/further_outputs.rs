//! Further outputs of a study: whatever a function makes of what every run records.

use crate::error::StudyError;
use crate::file::Study;
use crate::planning::problem::problem;
use crate::response::recorded_output::RecordedOutput;
use crate::response::study_response::StudyResponse;
use crate::run_options::RunOptions;
use crate::runs::all_runs::Runs;
use crate::runs::part::Part;
use crate::study_run::all_failed;
use loosepin_bounds::{DoubleLoop, Problem, Request, RunInputs, SampleTable};

/// The double loop of a study over other columns than those that it asks for: Z = h(Y), Y what a run records, h a function of
/// whoever calls, over the same inputs with the same random numbers.
///
/// Rounds come from [`FurtherOutputs::plan`]. [`FurtherOutputs::run`] makes their runs; the caller turns each row into the further
/// columns and adds it to the table that the plan is asked with. Sizes of the samples are those stated: accuracy, budget,
/// surrogates, contributors and small probabilities of the study play no part.
pub struct FurtherOutputs<'s> {
    study: &'s Study,
    response: StudyResponse,
    plan: DoubleLoop,
}

impl<'s> FurtherOutputs<'s> {
    /// Plans the statistics `requests` of so many further `columns`.
    ///
    /// # Errors
    /// The study cannot begin, or its sampling or a request is not possible.
    pub fn new(study: &'s Study, columns: usize, requests: Vec<Request>) -> Result<Self, StudyError> {
        let response = StudyResponse::new(study)?;
        let compared_columns = (0..columns).collect();
        let asked = problem(study, &response);
        let asked = Problem { columns, requests, compared_columns, readings_beside: Vec::new(), ..asked };
        Ok(Self { study, response, plan: DoubleLoop::try_new(asked)? })
    }

    /// Which runs are made, and what they say in the end.
    pub fn plan(&self) -> &DoubleLoop {
        &self.plan
    }

    /// What every run records, in the order in which the study asks for it.
    pub fn recorded(&self) -> Vec<RecordedOutput> {
        RecordedOutput::of_plan(&self.response.shared.plan)
    }

    /// Makes the runs of a round, `before` of which were made in the rounds before it: what they record, in their order. The store
    /// and the part of `options` are not used.
    ///
    /// # Errors
    /// It was interrupted, all runs of the first round failed, or their maker stopped.
    pub fn run(&self, round: &[RunInputs], before: usize, options: &RunOptions<'_>) -> Result<SampleTable, StudyError> {
        let options = RunOptions { store: None, part: Part::Whole, ..*options };
        let most_runs = self.plan.most_runs().max(before + round.len());
        let table = SampleTable::new(self.response.row_length());
        let mut runs = Runs::new(&options, (self.study, &self.response), table, (before, most_runs))?;
        runs.make(round)?;
        let table = runs.table;
        if before == 0 && table.failed() == table.len() && !table.is_empty() {
            return Err(all_failed(&self.response, &table));
        }
        Ok(table)
    }
}
