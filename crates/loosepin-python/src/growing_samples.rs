//! Samples of a function of Python that grow until its bounds are as accurate as stated.

use loosepin::bounds::{
    self, Assessment, Bounds, Goal, PlanError, Problem, Refinement, RefinementStatus, Request, RunInputs, SampleTable,
};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::waiting::without_gil;

/// By how much bounds may be widened, and how many runs may be made for it, as Python states them.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Accuracy {
    /// One number for each request; `None` for those that do not matter.
    most: Vec<Option<f64>>,
    /// [`bounds::USUAL_GROWTH`] times the runs without an accuracy if omitted.
    budget: Option<usize>,
}

/// A plan whose samples grow, and its budget.
pub struct GrowingSamples {
    plan: Refinement,
    is_asked: bool,
    budget: usize,
    is_budget_spent: bool,
}

impl GrowingSamples {
    /// Plans `problem` to `accuracy`.
    ///
    /// # Errors
    /// The problem cannot be planned.
    pub fn try_new(problem: Problem, accuracy: &Accuracy) -> Result<Self, PlanError> {
        let goal = |(request, most): (&Request, &Option<f64>)| Some(Goal { request: *request, most: (*most)? });
        let goals: Vec<Goal> = problem.requests.iter().zip(&accuracy.most).filter_map(goal).collect();
        let is_asked = !goals.is_empty();
        let columns = problem.columns;
        let plan = Refinement::try_new(problem, goals)?;
        let planned = plan.plan(&SampleTable::new(columns)).most_runs();
        let budget = accuracy.budget.unwrap_or(planned.saturating_mul(bounds::USUAL_GROWTH));
        Ok(Self { plan, is_asked, budget, is_budget_spent: false })
    }

    /// Runs at most, as far as is known.
    pub fn most_runs(&self, table: &SampleTable) -> usize {
        self.plan.plan(table).most_runs()
    }

    /// The runs of the next round; none where the plan has ended or the budget does not allow them. `fail` makes an exception of an error.
    ///
    /// # Errors
    /// A signal, an error of the plan, or a budget below the first round.
    pub fn next_round(
        &mut self,
        py: Python<'_>,
        table: &SampleTable,
        fail: impl Fn(PlanError) -> PyErr,
    ) -> PyResult<Vec<RunInputs>> {
        let round = without_gil(py, || self.plan.next_round(table))?.map_err(fail)?;
        self.is_budget_spent = self.is_asked && table.len() + round.len() > self.budget;
        match (self.is_budget_spent, table.is_empty()) {
            (true, true) => Err(PyValueError::new_err(format!(
                "budget {}; the first round takes {} runs, smaller outer and inner need fewer",
                self.budget,
                round.len()
            ))),
            (true, false) => Ok(Vec::new()),
            (false, _) => Ok(round),
        }
    }

    /// The bounds of the runs in `table`.
    ///
    /// # Errors
    /// [`PlanError`] where the table lacks runs.
    pub fn results(&self, table: &SampleTable) -> Result<Bounds, PlanError> {
        self.plan.results(table)
    }

    /// Adds how the accuracy was approached to the answers of Python, `None` if none was asked for.
    pub fn tell(&self, answers: &Bound<'_, PyDict>) -> PyResult<()> {
        let stop = match self.plan.status() {
            _ if self.is_budget_spent => "budget",
            RefinementStatus::Reached => "reached",
            RefinementStatus::Growing | RefinementStatus::Exhausted => "exhausted",
        };
        let step = |step: &Assessment| (step.runs, step.outer, step.inner, step.share);
        let steps: Vec<_> = self.plan.history().iter().map(step).collect();
        answers.set_item("accuracy", self.is_asked.then_some((stop, steps)))
    }
}
