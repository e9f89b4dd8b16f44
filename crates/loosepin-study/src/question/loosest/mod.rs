//! The inverse question: how loose inputs may be, one at a time, together, or at the least cost.
//! Requirements as such are judged with the bounds.

mod loosened;
mod one;
mod together;

pub use loosened::with_loosened;

use super::found::{Found, StudyRun};
use super::kind::{Planned, Question, QuestionContext};
use crate::assemble::Material;
use crate::error::StudyError;
use crate::planning::cost_estimate::CostEstimate;
use crate::runs::all_runs::Runs;
use loosepin_result::study::{AllocationRecord, AllowanceRecord, TogetherRecord};
use one::{allocation, allowances, most_studies, runs_of_a_study};
use together::{most_tried_together, together};

/// How loose inputs may be.
struct LoosestQuestion {
    most_runs: usize,
    one_at_a_time: Vec<AllowanceRecord>,
    together: Option<TogetherRecord>,
    cheapest: Option<AllocationRecord>,
}

/// Planned where an input may be loosened.
pub fn planned(basis: &QuestionContext<'_>) -> Planned {
    let study = basis.study;
    if study.allowances.is_empty() {
        return Ok(None);
    }
    let studies = study.together.map_or_else(|| most_studies(study), |how| 2 * most_tried_together(how));
    let most_runs = studies.saturating_mul(runs_of_a_study(study));
    let (one_at_a_time, together, cheapest) = (Vec::new(), None, None);
    Ok(Some(Box::new(LoosestQuestion { most_runs, one_at_a_time, together, cheapest })))
}

impl Question for LoosestQuestion {
    fn most_runs(&self) -> usize {
        self.most_runs
    }

    fn add_cost(&self, cost: &mut CostEstimate) {
        cost.search_runs = self.most_runs;
    }

    /// Its studies have lists of their own; what is in `runs` is kept whatever happens to them.
    fn run(&mut self, runs: &mut Runs<'_>, _found: &mut Found) -> Result<(), StudyError> {
        runs.close();
        self.search(runs).map_err(|error| match error {
            StudyError::Interrupted { most_runs, .. } => {
                StudyError::Interrupted { finished: Box::new(runs.runs_table()), most_runs }
            }
            error => error,
        })
    }

    fn record(&self, _material: &Material<'_>, _found: &Found, run: &mut StudyRun) -> Result<(), StudyError> {
        let result = &mut run.result;
        result.allowances.clone_from(&self.one_at_a_time);
        result.together.clone_from(&self.together);
        result.allocation.clone_from(&self.cheapest);
        Ok(())
    }
}

impl LoosestQuestion {
    fn search(&mut self, runs: &Runs<'_>) -> Result<(), StudyError> {
        self.together = together(runs)?;
        if self.together.is_none() {
            self.one_at_a_time = allowances(runs)?;
        }
        self.cheapest = allocation(runs)?;
        Ok(())
    }
}
