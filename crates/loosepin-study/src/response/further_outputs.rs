//! Further outputs of a study: whatever a function makes of what every run records.

use crate::error::StudyError;
use crate::file::{Study, Where};
use crate::planning::problem::problem;
use crate::response::columns::Location;
use crate::response::study_response::StudyResponse;
use crate::run_options::RunOptions;
use crate::runs::all_runs::Runs;
use crate::runs::run_subset::RunSubset;
use crate::runs::table::{curve_name, scalar_name};
use crate::study_run::all_failed;
use loosepin_bounds::{DoubleLoop, Problem, Request, RunInputs, SampleTable};
use loosepin_text::units::SiUnit;

/// The double loop of a study over other columns than its own: Z = h(Y), Y the record of a run, h a function of the caller, over the same
/// inputs with the same random numbers.
///
/// Rounds come from [`FurtherOutputs::plan`]. [`FurtherOutputs::run`] makes their runs; the caller turns each row into the further
/// columns and adds it to the table that the plan is asked with. Sizes of the samples are those stated: accuracy, budget,
/// surrogates, contributors and small probabilities of the study play no part.
pub struct FurtherOutputs<'s> {
    study: &'s Study,
    response: StudyResponse,
    plan: DoubleLoop,
}

/// A number or a curve that every run records.
#[derive(Debug, Clone, PartialEq)]
pub struct RecordedOutput {
    /// `slider total maximum_absolute`, `slider total at 1.1 rad`, or `slider total` for a curve.
    pub name: String,
    /// Unit of its values.
    pub unit: SiUnit,
    /// Angles of the drive at the points of a curve, rad; `None` for a number.
    pub pose_rad: Option<Vec<f64>>,
    /// Columns of its values in a row.
    pub columns: Vec<usize>,
}

impl<'s> FurtherOutputs<'s> {
    /// Plans the statistics `requests` of `columns` further columns.
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

    /// Recorded outputs of every run, in the order in which the study asks for them.
    pub fn recorded(&self) -> Vec<RecordedOutput> {
        let plan = &self.response.shared.plan;
        let mut recorded: Vec<RecordedOutput> = Vec::new();
        let mut push = |name: String, columns: Vec<usize>, pose_rad: Option<Vec<f64>>| {
            let output = columns.first().map(|&first| plan.columns[first].output);
            if let Some(output) = output.filter(|_| recorded.iter().all(|known| known.name != name)) {
                recorded.push(RecordedOutput { name, unit: plan.outputs[output].unit.clone(), pose_rad, columns });
            }
        };
        let asked = plan.asks.iter().map(|ask| (ask.location == Where::Cycle, &ask.columns));
        let required = plan.requirements.iter().map(|requirement| (false, &requirement.columns));
        for (is_curve, columns) in asked.chain(required) {
            if is_curve {
                let angle = |&column: &usize| match plan.columns[column].spot {
                    Location::Pose { angle_rad, .. } => angle_rad,
                    Location::Reduced(_) => f64::NAN,
                };
                let pose_rad = columns.iter().map(angle).collect();
                push(
                    columns.first().map_or_else(String::new, |&first| curve_name(plan, first)),
                    columns.clone(),
                    Some(pose_rad),
                );
            } else {
                columns.iter().for_each(|&column| push(scalar_name(plan, column), vec![column], None));
            }
        }
        recorded
    }

    /// Makes the runs of a round, `before` of which were made in the rounds before it: what they record, in their order. The store
    /// and the subset of runs of `options` are not used.
    ///
    /// # Errors
    /// It was interrupted, all runs of the first round failed, or their provider stopped.
    pub fn run(&self, round: &[RunInputs], before: usize, options: &RunOptions<'_>) -> Result<SampleTable, StudyError> {
        let options = RunOptions { store: None, run_subset: RunSubset::Whole, ..*options };
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
