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
use loosepin_bounds::{Problem, Request, RunInputs, SampleTable};
use loosepin_text::units::SiUnit;

/// What the runs of a study record, for statistics of further columns Z = h(Y): Y is what a run records, h a function of the caller, over
/// the same inputs with the same random numbers.
///
/// The caller plans [`FurtherOutputs::problem`], makes each round by [`FurtherOutputs::run`], and adds the further columns of its runs to
/// the table of its plan. Surrogates, contributors and small probabilities of the study play no part.
pub struct FurtherOutputs<'s> {
    study: &'s Study,
    response: StudyResponse,
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
