//! The direct double loop: rounds until its goals are reached.

use super::steps::{Next, Steps};
use crate::error::StudyError;
use crate::file::Budget;
use crate::planning::goals::RoundsEnd;
use loosepin_bounds::{Bounds, DoubleLoop, Refinement, SampleTable};

/// The direct double loop.
pub struct DirectSteps {
    refinement: Refinement,
    budget: Option<Budget>,
    rounds: u32,
    /// Runs of the round that the budget did not allow.
    left: Option<usize>,
}

/// Answer of the direct double loop.
pub struct Direct {
    /// The plan of its last round.
    pub plan: DoubleLoop,
    /// The bounds.
    pub bounds: Bounds,
    /// How its rounds ended.
    pub ended: RoundsEnd,
}

impl DirectSteps {
    /// The rounds of `refinement`, none made yet.
    pub fn new(refinement: Refinement, budget: Option<Budget>) -> Self {
        Self { refinement, budget, rounds: 0, left: None }
    }
}

impl Steps for DirectSteps {
    type Answer = Direct;

    fn next(&mut self, runs: &SampleTable) -> Result<Next<Direct>, StudyError> {
        if self.left.is_none() {
            let round = self.refinement.next_round(runs)?;
            if !round.is_empty() {
                self.rounds += 1;
                let most = round.len();
                return Ok(Next::Step(round, most));
            }
        }
        let plan = self.refinement.plan(runs).clone();
        let bounds = plan.results(runs)?;
        let ended = RoundsEnd::new(&self.refinement, self.left, (self.rounds, runs.len()), self.budget);
        Ok(Next::Answer(Direct { plan, bounds, ended }))
    }

    fn plan_so_far(&self, runs: &SampleTable) -> Option<DoubleLoop> {
        Some(self.refinement.plan(runs).clone())
    }

    fn refuse(&mut self, runs: usize) {
        self.rounds -= 1;
        self.left = Some(runs);
    }
}
