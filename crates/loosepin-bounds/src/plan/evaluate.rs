//! Running a plan on the threads of this process.

use thiserror::Error;

use super::double_loop::DoubleLoop;
use super::error::PlanError;
use crate::data::problem::Problem;
use crate::data::table::{Failure, RunInputs, SampleTable, TableError};
use crate::parallel;
use crate::readings::bounds::Bounds;

/// A function from a row of numbers to a row of numbers.
pub trait Response: Sync {
    /// Writes the columns of the response at these inputs. A column that does not exist for them is not a number.
    ///
    /// # Errors
    ///
    /// [`Failure`] with the reason where the run gives nothing at all.
    fn evaluate(&self, random: &[f64], epistemic: &[f64], columns: &mut [f64]) -> Result<(), Failure>;
}

/// A function of the random and the epistemic inputs as a response with one column.
pub struct Function<F>(pub F);

impl<F: Fn(&[f64], &[f64]) -> f64 + Sync> Response for Function<F> {
    fn evaluate(&self, random: &[f64], epistemic: &[f64], columns: &mut [f64]) -> Result<(), Failure> {
        columns[0] = (self.0)(random, epistemic);
        Ok(())
    }
}

/// Why a response has no bounds.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum EvaluateError {
    /// The plan.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// The table of runs.
    #[error(transparent)]
    Table(#[from] TableError),
}

/// Plans, runs and evaluates `problem`; the result is the same for any number of threads.
///
/// # Errors
///
/// [`EvaluateError`] where the problem breaks a rule; failed runs are no error.
pub fn evaluate(problem: Problem, response: &impl Response) -> Result<Bounds, EvaluateError> {
    let plan = DoubleLoop::try_new(problem)?;
    Ok(plan.results(&execute_all(&plan, response)?)?)
}

/// The runs of all rounds of `plan`.
///
/// # Errors
///
/// [`EvaluateError`] where a round has no plan, or its rows do not fit; failed runs are no error.
pub(crate) fn execute_all(plan: &DoubleLoop, response: &impl Response) -> Result<SampleTable, EvaluateError> {
    let mut table = SampleTable::new(plan.problem().columns);
    loop {
        let round = plan.next_round(&table)?;
        if round.is_empty() {
            return Ok(table);
        }
        execute(round, response, &mut table)?;
    }
}

/// Runs `round` on all threads and adds its rows to `table` in the order of the plan.
///
/// # Errors
///
/// [`TableError`] where the rows do not fit the table.
pub fn execute(round: Vec<RunInputs>, response: &impl Response, table: &mut SampleTable) -> Result<(), TableError> {
    let columns = table.columns();
    let outcomes: Vec<Result<Vec<f64>, Failure>> = parallel::map(&round, |inputs| {
        let mut values = vec![f64::NAN; columns];
        response.evaluate(&inputs.random, &inputs.epistemic, &mut values).map(|()| values)
    });
    for (inputs, outcome) in round.into_iter().zip(outcomes) {
        table.push(inputs, outcome.as_deref().map_err(|&failure| failure))?;
    }
    Ok(())
}
