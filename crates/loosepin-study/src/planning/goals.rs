//! Goals of a study: how near its bounds are to be, and how its steps towards that ended.

use crate::file::{AccuracyTarget, Ask, Budget, Study, dimension_of_statistic, statistic_name};
use crate::response::columns::ColumnPlan;
use loosepin_bounds::{Assessment, Goal, Refinement, RefinementStatus, Request, Statistic, SurrogateRounds};

/// The accuracy that `statistic` of question `place` is to have.
fn target(study: &Study, place: usize, ask: &Ask, statistic: Statistic) -> Option<f64> {
    let name = statistic_name(statistic)?;
    if ask.is_by_method(statistic) {
        return None;
    }
    let dimension = dimension_of_statistic(statistic, study.outputs[ask.output].dimension);
    let concerns = |target: &&AccuracyTarget| {
        target.dimension == dimension
            && target.ask.is_none_or(|own| own == place)
            && target.output.is_none_or(|output| output == ask.output)
            && target.statistic.is_none_or(|of| of == name)
    };
    let named = |target: &AccuracyTarget| {
        let parts = [target.ask.is_some(), target.output.is_some(), target.statistic.is_some()];
        (target.is_argument, parts.into_iter().filter(|is_named| *is_named).count())
    };
    // The last of those that name most.
    study.accuracy.iter().filter(concerns).max_by_key(|target| named(target)).map(|target| target.most_si)
}

/// Every bound with an accuracy: its question, by its place, and what its statistic may be widened by.
pub(crate) fn targets<'p>(study: &'p Study, plan: &'p ColumnPlan) -> impl Iterator<Item = (&'p Ask, Statistic, f64)> {
    plan.asks.iter().enumerate().flat_map(move |(place, ask)| {
        let of_statistic = move |statistic: Statistic| Some((ask, statistic, target(study, place, ask, statistic)?));
        ask.statistics().filter_map(of_statistic)
    })
}

/// The goals of the double loop, column by column.
pub(crate) fn goals(study: &Study, plan: &ColumnPlan) -> Vec<Goal> {
    let mut goals: Vec<Goal> = Vec::new();
    for (ask, statistic, most) in targets(study, plan) {
        for &column in &ask.columns {
            let request = Request { column, statistic };
            match goals.iter_mut().find(|goal| goal.request == request) {
                Some(goal) => goal.most = goal.most.min(most),
                None => goals.push(Goal { request, most }),
            }
        }
    }
    goals
}

/// How the rounds ended.
pub(crate) struct RoundsEnd {
    pub standing: RefinementStatus,
    /// Runs of the round that the budget did not allow.
    pub left: Option<usize>,
    /// Rounds and runs that were made.
    pub rounds: u32,
    pub runs: usize,
    pub history: Vec<Assessment>,
    pub budget: Option<Budget>,
}

impl RoundsEnd {
    /// Ends `rounds` of surrogates, of which `made` were made with `runs` runs.
    pub fn of_surrogates(
        rounds: &SurrogateRounds,
        left: Option<usize>,
        (made, runs): (u32, usize),
        budget: Option<Budget>,
    ) -> Self {
        Self { standing: rounds.status(), left, rounds: made, runs, history: rounds.history().to_vec(), budget }
    }

    /// Ends `refinement` after `runs` runs in `rounds` rounds.
    pub fn new(
        refinement: &Refinement,
        left: Option<usize>,
        (rounds, runs): (u32, usize),
        budget: Option<Budget>,
    ) -> Self {
        let (standing, history) = (refinement.status(), refinement.history().to_vec());
        Self { standing, left, rounds, runs, history, budget }
    }
}
