//! A checked problem, and the plan of its surrogates.

use std::ops::Range;

use thiserror::Error;

use super::settings::{MAX_WITNESSES, SurrogateSettings};
use super::space::{SurrogateInput, TrainingSpace};
use crate::data::problem::{Problem, Reading, Request};
use crate::data::table::{Purpose, RunInputs};
use crate::plan::double_loop::DoubleLoop;
use crate::plan::error::PlanError;
use crate::plan::evaluate::EvaluateError;
use crate::plan::refinement::Goal;
use loosepin_surrogate::FEWEST_RUNS;
use loosepin_terms::Statistic;
use loosepin_uncertainty::EpistemicVariable;

/// Why there are no bounds by surrogates.
#[derive(Debug, Clone, PartialEq, Error)]
#[allow(missing_docs, reason = "the text of an error says what it is, and names its fields")]
pub enum SurrogatePlanError {
    /// The problem, or its runs.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// The double loop on a surrogate.
    #[error(transparent)]
    Evaluate(#[from] EvaluateError),
    #[error("{training} training runs; must be at least {FEWEST_RUNS}\nhint: 30 for each uncertain input are a start")]
    TooFewTraining { training: usize },
    #[error(
        "{confirming} confirming runs; must be a multiple of the {replicates} replicates, at least 2 in each, and at most the \
         {inner} inner runs"
    )]
    Confirming { confirming: usize, replicates: usize, inner: usize },
    #[error("column {column} is asked for and in none of the groups that are learned")]
    NotLearned { column: usize },
}

/// A checked problem, and the plan of its surrogates.
#[derive(Debug, Clone)]
pub struct SurrogatePlan {
    pub(crate) direct: DoubleLoop,
    pub(crate) settings: SurrogateSettings,
    pub(crate) space: TrainingSpace,
    /// Goals of the bounds on the surrogates alone, where the double loop on them is to grow.
    pub(crate) goals: Vec<Goal>,
    /// Confidence of the stated bounds; errors may be computed for a higher one, as where one looks repeatedly.
    pub(crate) stated_confidence: f64,
}

impl SurrogatePlan {
    /// Checks `problem` and `settings`.
    ///
    /// # Errors
    ///
    /// [`SurrogatePlanError`] where either breaks a rule.
    pub fn try_new(problem: Problem, settings: SurrogateSettings) -> Result<Self, SurrogatePlanError> {
        let direct = DoubleLoop::try_new(problem)?;
        let problem = direct.problem();
        let SurrogateSettings { training, confirming, .. } = settings;
        if training < FEWEST_RUNS {
            return Err(SurrogatePlanError::TooFewTraining { training });
        }
        let (replicates, inner) = (problem.sampling.replicates, problem.sampling.inner);
        let is_spread = confirming.is_multiple_of(replicates) && confirming >= 2 * replicates && confirming <= inner;
        if !problem.random.is_empty() && !is_spread {
            return Err(SurrogatePlanError::Confirming { confirming, replicates, inner });
        }
        let is_learned = |column: &usize| settings.groups.iter().any(|group| group.columns.contains(column));
        if let Some(column) = direct.setup.needed_columns().into_iter().find(|column| !is_learned(column)) {
            return Err(SurrogatePlanError::NotLearned { column });
        }
        let (space, stated_confidence) = (TrainingSpace::new(problem), problem.sampling.confidence);
        Ok(Self { direct, settings, space, goals: Vec::new(), stated_confidence })
    }

    /// The problem.
    pub fn problem(&self) -> &Problem {
        self.direct.problem()
    }

    /// Whether every statistic belongs to a single u, with errors of the surrogate that differ over X alone.
    pub(crate) fn is_at_single_values(&self) -> bool {
        let problem = self.problem();
        problem.reading == Reading::FixedButUnknown && !problem.epistemic.iter().any(EpistemicVariable::is_structured)
    }

    /// The inputs of the surrogates, in their order.
    pub fn inputs(&self) -> &[SurrogateInput] {
        self.space.coordinates()
    }

    /// The values of the epistemic inputs that are lists, by their position, in one combination of their members.
    pub fn members(&self, combination: usize) -> Vec<(usize, f64)> {
        self.space.members(combination)
    }

    /// Settings of the surrogates.
    pub fn settings(&self) -> &SurrogateSettings {
        &self.settings
    }

    /// The runs to learn from, as round `round` of a table.
    ///
    /// # Errors
    ///
    /// More inputs than Sobol' points have dimensions.
    pub fn training_round(&self, round: u32) -> Result<Vec<RunInputs>, SurrogatePlanError> {
        self.training_runs(round, 0..self.settings.training, &[])
    }

    /// Further runs to learn from: number `numbers` for each combination of the members of lists, half of them at the values `near` of the
    /// epistemic inputs.
    pub(crate) fn training_runs(
        &self,
        round: u32,
        numbers: Range<usize>,
        near: &[Vec<f64>],
    ) -> Result<Vec<RunInputs>, SurrogatePlanError> {
        let before = numbers.start * self.space.combinations();
        let places = self.space.places(self.problem(), numbers, near).map_err(PlanError::from)?;
        let run = |(point, (random, epistemic)): (usize, (Vec<f64>, Vec<f64>))| RunInputs {
            round,
            purpose: Purpose::Training,
            point: (before + point) as u32,
            replicate: 0,
            index: 0,
            random,
            epistemic,
        };
        Ok(places.into_iter().enumerate().map(run).collect())
    }

    /// Direct runs at witnesses, at most, with those at the extremes of the treatments.
    pub fn most_confirming(&self) -> usize {
        let problem = self.problem();
        let mut ends = 0;
        for group in &self.settings.groups {
            let own = problem.requests.iter().filter(|request| group.columns.contains(&request.column));
            let mut statistics: Vec<Statistic> = Vec::new();
            for Request { statistic, .. } in own {
                if statistic.is_single() && !statistics.contains(statistic) {
                    statistics.push(*statistic);
                }
            }
            ends += 2 * statistics.len();
        }
        let inner = if problem.random.is_empty() { 1 } else { self.settings.confirming };
        ends.min(MAX_WITNESSES) * inner + 2 * problem.compared_columns.len()
    }

    /// Runs of all steps, at most.
    pub fn most_runs(&self) -> usize {
        self.settings.training * self.space.combinations() + self.most_confirming()
    }
}
