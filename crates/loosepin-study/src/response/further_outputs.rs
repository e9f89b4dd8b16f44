//! Further outputs of a study: whatever a function makes of what every run records.

use crate::error::StudyError;
use crate::file::Study;
use crate::planning::problem::problem;
use crate::response::recorded_output::RecordedOutput;
use crate::response::study_response::StudyResponse;
use crate::run_options::RunOptions;
use crate::runs::all_runs::Runs;
use crate::runs::run_subset::RunSubset;
use crate::study_run::all_failed;
use loosepin_bounds::{Problem, Request, RunInputs, SampleTable};

/// What the runs of a study record, for statistics of further columns Z = h(Y): Y is what a run records, h a function of the caller, over
/// the same inputs with the same random numbers.
///
/// The caller plans [`FurtherOutputs::problem`], makes each round by [`FurtherOutputs::run`], and adds the further columns of its runs to
/// the table of its plan. Surrogates, contributors and small probabilities of the study play no part.
pub struct FurtherOutputs<'s> {
    study: &'s Study,
    response: StudyResponse,
}

impl<'s> FurtherOutputs<'s> {
    /// Prepares the mechanism of `study`.
    ///
    /// # Errors
    /// The study cannot begin.
    pub fn new(study: &'s Study) -> Result<Self, StudyError> {
        Ok(Self { study, response: StudyResponse::new(study)? })
    }

    /// The statistics `requests` of so many further `columns`, over the inputs of the study and with its samples.
    pub fn problem(&self, columns: usize, requests: Vec<Request>) -> Problem {
        let compared_columns = (0..columns).collect();
        let asked = problem(self.study, &self.response);
        Problem { columns, requests, compared_columns, readings_beside: Vec::new(), ..asked }
    }

    /// Recorded outputs of every run, in the order in which the study asks for them.
    pub fn recorded(&self) -> Vec<RecordedOutput> {
        RecordedOutput::of_plan(self.response.plan())
    }

    /// Makes the runs of a round: what they record, in their order. `before` runs were made in earlier rounds, and at most `most_runs` are
    /// planned, as progress tells. The store and the part of `options` are not used.
    ///
    /// # Errors
    /// It was interrupted, all runs of the first round failed, or their provider stopped.
    pub fn run(
        &self,
        round: &[RunInputs],
        [before, most_runs]: [usize; 2],
        options: &RunOptions<'_>,
    ) -> Result<SampleTable, StudyError> {
        let options = RunOptions { store: None, run_subset: RunSubset::Whole, ..*options };
        let most_runs = most_runs.max(before + round.len());
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
