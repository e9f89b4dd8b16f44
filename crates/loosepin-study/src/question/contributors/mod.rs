//! Contributors to an answer: the runs that determine shares of the variance. The indices are computed in `loosepin-uncertainty`.
//! Without an ask for them, each output has those that need no runs of their own.

mod plan;
mod record;
mod subjects;
mod without_dynamics;

use super::found::{Found, StudyRun};
use super::kind::{Planned, Question, QuestionContext};
use super::steps::{Next, Steps, take_steps};
use crate::assemble::Material;
use crate::error::StudyError;
use crate::file::Ask;
use crate::runs::all_runs::Runs;
use loosepin_bounds::{RunInputs, SampleTable};
use plan::ContributorPlan;
use subjects::subjects;

/// What contributes to the answers.
struct ContributorQuestion {
    /// `None` if nothing is random or no ask wants contributors: then nothing needs further runs.
    plan: Option<ContributorPlan>,
}

/// Planned where direct runs answer; with runs of its own where an ask wants contributors.
pub fn planned(basis: &QuestionContext<'_>) -> Planned {
    if basis.is_surrogate_alone {
        return Ok(None);
    }
    let is_asked = basis.study.asks.iter().any(Ask::is_for_contributors);
    let plan = if is_asked { ContributorPlan::new(basis.study, basis.double_loop)? } else { None };
    Ok(Some(Box::new(ContributorQuestion { plan })))
}

impl Question for ContributorQuestion {
    fn most_runs(&self) -> usize {
        self.plan.as_ref().map_or(0, ContributorPlan::runs)
    }

    fn run(&mut self, runs: &mut Runs<'_>, found: &mut Found) -> Result<(), StudyError> {
        let (Some(plan), Some(double_loop)) = (&self.plan, &found.double_loop) else { return Ok(()) };
        take_steps(AllAtOnce { runs: Some(plan.round(double_loop, found.bounds.rounds)) }, runs, None)
    }

    fn record(&self, material: &Material<'_>, found: &Found, run: &mut StudyRun) -> Result<(), StudyError> {
        if let Some(double_loop) = &found.double_loop {
            let subjects = subjects(material.plan(), &run.result.requirements);
            run.result.contributors = record::contributors(material, double_loop, self.plan.as_ref(), &subjects);
        }
        Ok(())
    }
}

/// The runs of the indices, all at once.
struct AllAtOnce {
    runs: Option<Vec<RunInputs>>,
}

impl Steps for AllAtOnce {
    /// The rows of the table.
    type Answer = ();

    fn next(&mut self, _runs: &SampleTable) -> Result<Next<()>, StudyError> {
        Ok(self.runs.take().map_or(Next::Answer(()), Next::Beside))
    }
}
