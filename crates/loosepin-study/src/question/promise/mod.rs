//! Promises for a share of the box: all runs at once, fixed beforehand.
//! The limits of a share are those of `loosepin-bounds`.

mod plan;
mod promised;
mod record;

use super::found::{Found, StudyRun};
use super::kind::{Planned, Question, QuestionContext};
use super::steps::{Next, Steps, take_steps};
use crate::assemble::Material;
use crate::error::StudyError;
use crate::planning::cost_estimate::{CostEstimate, PromiseCost};
use crate::runs::all_runs::Runs;
use loosepin_bounds::{PromisePlan, PromisedBound, RunInputs, SampleTable};
use plan::promise_plan;
use promised::Promised;

/// What is promised for a share of the box.
struct PromiseQuestion {
    plan: PromisePlan,
    /// Ends of single numbers, once its runs are made.
    ends: Vec<PromisedBound>,
}

/// Planned where something is promised.
pub fn planned(basis: &QuestionContext<'_>) -> Planned {
    let plan = promise_plan(basis.study, basis.response)?;
    Ok(plan.map(|plan| -> Box<dyn Question> { Box::new(PromiseQuestion { plan, ends: Vec::new() }) }))
}

impl Question for PromiseQuestion {
    fn most_runs(&self) -> usize {
        self.plan.runs()
    }

    fn add_cost(&self, cost: &mut CostEstimate) {
        cost.promise = Some(PromiseCost::new(&self.plan));
    }

    fn run(&mut self, runs: &mut Runs<'_>, _found: &mut Found) -> Result<(), StudyError> {
        let steps = PromiseSteps { plan: &self.plan, runs: Some(self.plan.round(runs.table.rounds())) };
        self.ends = take_steps(steps, runs, None)?;
        Ok(())
    }

    fn record(&self, material: &Material<'_>, found: &Found, run: &mut StudyRun) -> Result<(), StudyError> {
        let promised = Promised::new(&self.plan, &self.ends, &found.curve_bands, material.table)?;
        record::decide(material, promised.ends, &mut run.result.requirements);
        run.result.promise = Some(record::promise_record(material, &promised));
        Ok(())
    }
}

/// The runs of a promise.
struct PromiseSteps<'p> {
    plan: &'p PromisePlan,
    runs: Option<Vec<RunInputs>>,
}

impl Steps for PromiseSteps<'_> {
    type Answer = Vec<PromisedBound>;

    fn next(&mut self, runs: &SampleTable) -> Result<Next<Self::Answer>, StudyError> {
        // A failed run leaves nothing promised, and no other answer stands on it.
        match self.runs.take() {
            Some(wanted) => Ok(Next::Beside(wanted)),
            None => Ok(Next::Answer(self.plan.results(runs)?)),
        }
    }
}
