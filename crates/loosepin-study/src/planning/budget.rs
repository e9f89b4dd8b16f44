//! Budget of a study: where its samples end although they are not yet large enough.

use crate::error::StudyError;
use crate::file::{Budget, Study};
use loosepin_bounds::USUAL_GROWTH;
use std::time::Instant;

/// Where no budget is stated, a study ends at [`USUAL_GROWTH`], or where its runs, which it holds in memory, are so many numbers (a gibibyte).
const USUAL_NUMBERS: usize = 1 << 27;

/// The budget of a study whose samples may grow, or that has one; `stated_runs` of `row_length` numbers each are those without
/// growth.
pub(crate) fn budget(study: &Study, stated_runs: usize, row_length: usize) -> Option<Budget> {
    let held = (USUAL_NUMBERS / row_length).max(stated_runs);
    let usual = || Budget::Runs { runs: stated_runs.saturating_mul(USUAL_GROWTH).min(held) as u64 };
    study.budget.or_else(|| (!study.accuracy.is_empty()).then(usual))
}

/// Limits of the question whose answer gives the bounds of a study.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Limits {
    /// Budget at which it ends although its goals are not reached.
    pub budget: Option<Budget>,
    /// Runs of all questions, samples not grown.
    pub stated_runs: usize,
    /// Reserved runs of the questions that follow.
    pub reserved: usize,
}

impl Limits {
    /// Watches the budget from now on.
    pub fn watch(&self) -> BudgetWatch {
        BudgetWatch { limits: *self, began: Instant::now() }
    }

    /// Runs at most; with a budget of time or rounds, those before the samples grow.
    pub fn most_runs(&self) -> usize {
        self.most_of(self.stated_runs)
    }

    /// Largest number of runs, if this question makes `own_runs` runs.
    pub fn most_runs_with(&self, own_runs: usize) -> usize {
        self.most_of(self.stated_runs.max(own_runs + self.reserved))
    }

    /// That the budget does not suffice for a first step of `step_runs` runs.
    pub fn too_small(&self, step_runs: usize) -> StudyError {
        let budget = if let Some(Budget::Runs { runs }) = self.budget { runs } else { 0 };
        StudyError::BudgetTooSmall { budget, least: step_runs + self.reserved }
    }

    fn most_of(&self, planned: usize) -> usize {
        match self.budget {
            Some(Budget::Runs { runs }) => usize::try_from(runs).unwrap_or(usize::MAX),
            _ => planned,
        }
    }
}

/// Decides before each step whether it is made.
pub(crate) struct BudgetWatch {
    limits: Limits,
    began: Instant,
}

impl BudgetWatch {
    /// Whether a step of `next` runs stays within the budget, `made` runs and `steps` steps being made. A time is foreseen from that
    /// of the runs so far, so that the first step is always made.
    pub fn allows(&self, next: usize, made: usize, steps: u32) -> bool {
        let Limits { budget, reserved, .. } = self.limits;
        match budget {
            None => true,
            Some(Budget::Runs { runs }) => (made + next + reserved) as u64 <= runs,
            Some(Budget::Rounds { rounds }) => steps < rounds,
            Some(Budget::Time { seconds }) => {
                let elapsed_s = self.began.elapsed().as_secs_f64();
                made == 0 || elapsed_s * (made + next + reserved) as f64 / made as f64 <= seconds
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Budget, BudgetWatch, Limits};

    fn watch(budget: Option<Budget>) -> BudgetWatch {
        Limits { budget, stated_runs: 650, reserved: 150 }.watch()
    }

    #[test]
    fn a_budget_of_runs_counts_what_follows_the_rounds() {
        let runs = watch(Some(Budget::Runs { runs: 1000 }));
        assert!(runs.allows(350, 500, 4) && !runs.allows(351, 500, 4));
        let rounds = watch(Some(Budget::Rounds { rounds: 5 }));
        assert!(rounds.allows(9999, 500, 4) && !rounds.allows(1, 500, 5));
        let time = watch(Some(Budget::Time { seconds: 1e-9 }));
        assert!(time.allows(350, 0, 0), "the first round is always made");
        assert!(!time.allows(350, 1, 1));
        assert!(watch(None).allows(usize::MAX, 500, 4));
    }
}
