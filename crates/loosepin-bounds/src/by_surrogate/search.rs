//! The double loop on the surrogates of a group.

use super::learned::LearnedGroup;
use super::plan::SurrogatePlan;
use super::response::{Aspect, BandResponse, LearnedFunction};
use crate::data::bound::BoundPair;
use crate::data::direction::Direction;
use crate::data::problem::{Problem, Request};
use crate::data::table::SampleTable;
use crate::plan::evaluate::{EvaluateError, evaluate, execute};
use crate::plan::refinement::{Goal, Refinement};
use crate::readings::bounds::Bounds;
use loosepin_surrogate::Surrogate;
use loosepin_terms::{ErrorEffect, Statistic};

/// Places of a curve that go through the double loop together, so that its table stays small.
const MAX_PLACES: usize = 64;
/// Share of the allowed widening of a bound that its double loop on the surrogate may take: that costs no runs.
const FREE_SHARE: f64 = 0.25;
/// Runs of such a double loop, at most, over those that are stated for it; where it would grow beyond them it ends.
const MAX_GROWTH: usize = 16;

/// k before direct runs have been seen: an error of three standard deviations to the same side everywhere.
pub(crate) const FIRST_REACH: f64 = 3.0;

/// Bounds on the surrogate for some places of a group.
pub(crate) struct SurrogateSearchBounds {
    /// Positions within the group.
    pub places: Vec<usize>,
    /// Meaning of each pair of the bounds: a request of the problem, on an aspect.
    asked: Vec<(Request, Aspect)>,
    /// Columns are those of the aspects.
    pub bounds: Bounds,
}

/// Searches one group, k of it being `reach`, a number of places at a time; empty if it was not learned.
pub(crate) fn search_group(
    plan: &SurrogatePlan,
    group: &LearnedGroup,
    reach: f64,
) -> Result<Vec<SurrogateSearchBounds>, EvaluateError> {
    let Ok(surrogates) = &group.surrogates else { return Ok(Vec::new()) };
    let needed = plan.direct.setup.needed_columns();
    let places: Vec<usize> =
        (0..group.group.columns.len()).filter(|&place| needed.contains(&group.group.columns[place])).collect();
    places.chunks(MAX_PLACES).map(|places| search_places(plan, group, surrogates, places, reach)).collect()
}

fn search_places(
    plan: &SurrogatePlan,
    group: &LearnedGroup,
    surrogates: &[Surrogate],
    places: &[usize],
    reach: f64,
) -> Result<SurrogateSearchBounds, EvaluateError> {
    let direct = plan.problem();
    let column_of = |slot: usize, aspect: Aspect| slot * Aspect::ALL.len() + aspect.position();
    let slot_of = |column: usize| places.iter().position(|&place| group.group.columns[place] == column);
    let mut requests = Vec::new();
    let mut asked = Vec::new();
    for request in &direct.requests {
        let Some(slot) = slot_of(request.column) else { continue };
        for (aspect, statistic) in aspects(request.statistic) {
            requests.push(Request { column: column_of(slot, aspect), statistic });
            if request.statistic.is_single() {
                asked.push((*request, aspect));
            }
        }
    }
    let problem = Problem {
        columns: places.len() * Aspect::ALL.len(),
        requests,
        // The treatments go over wider points, and by themselves.
        compared_columns: Vec::new(),
        ..direct.clone()
    };
    let response = BandResponse::new(LearnedFunction { plan, surrogates, places }, reach);
    let goal = |goal: &Goal| {
        let column = column_of(slot_of(goal.request.column)?, Aspect::Value);
        Some(Goal { request: Request { column, ..goal.request }, most: FREE_SHARE * goal.most })
    };
    let goals: Vec<Goal> = plan.goals.iter().filter_map(goal).collect();
    let bounds = if goals.is_empty() { evaluate(problem, &response)? } else { refined(problem, goals, &response)? };
    Ok(SurrogateSearchBounds { places: places.to_vec(), asked, bounds })
}

/// The bounds of a double loop that grows as far as `goals` ask, within limits.
fn refined(problem: Problem, goals: Vec<Goal>, response: &BandResponse<'_>) -> Result<Bounds, EvaluateError> {
    let most = MAX_GROWTH * problem.sampling.outer * problem.sampling.inner;
    let mut table = SampleTable::new(problem.columns);
    let mut refinement = Refinement::try_new(problem, goals)?;
    loop {
        let round = refinement.next_round(&table)?;
        let is_too_much = table.len() + round.len() > most && !table.is_empty();
        if round.is_empty() || is_too_much {
            return Ok(refinement.results(&table)?);
        }
        execute(round, response, &mut table)?;
    }
}

/// Questions to a surrogate for a statistic: on its value first, then on the ends of its error.
fn aspects(statistic: Statistic) -> Vec<(Aspect, Statistic)> {
    let error = match statistic.effect_of_errors() {
        _ if !statistic.is_single() => Vec::new(),
        ErrorEffect::Shifts => vec![(Aspect::Low, statistic), (Aspect::High, statistic)],
        ErrorEffect::RootMeanSquare => vec![(Aspect::Square, Statistic::of_squared_error())],
        ErrorEffect::Unknown => Vec::new(),
    };
    [(Aspect::Value, statistic)].into_iter().chain(error).collect()
}

impl SurrogateSearchBounds {
    /// The pairs of what is possible at all, and those of every degree.
    pub fn levels(&self) -> Vec<(Option<f64>, &[BoundPair])> {
        let all = (None, &self.bounds.pairs[..]);
        [all].into_iter().chain(self.bounds.levels.iter().map(|level| (level.alpha, &level.pairs[..]))).collect()
    }

    /// The requests of these places, without those for whole distribution functions, each with the bounds on the surrogate's value.
    pub fn values<'p>(&self, pairs: &'p [BoundPair]) -> impl Iterator<Item = (Request, &'p BoundPair)> {
        let own = self.asked.iter().zip(pairs).filter(|((_, aspect), _)| *aspect == Aspect::Value);
        own.map(|((request, _), pair)| (*request, pair)).collect::<Vec<_>>().into_iter()
    }

    /// The furthest that the bound of `request` can lie, of `pairs`, when the surrogate errs by kσ; of a deviation it may be below 0. Without
    /// end for a statistic of which it is not known what errors do to it.
    pub fn furthest(&self, pairs: &[BoundPair], request: Request, direction: Direction) -> f64 {
        if request.statistic.effect_of_errors() == ErrorEffect::Unknown {
            return direction.sign() * f64::INFINITY;
        }
        let own = self.asked.iter().zip(pairs).filter(|((of, _), _)| *of == request);
        let mut furthest = f64::NAN;
        let mut square = 0.0;
        for ((_, aspect), pair) in own {
            if *aspect == Aspect::Square {
                square = pair.upper.widened.max(0.0);
                continue;
            }
            let widened = direction.of(&pair.lower, &pair.upper).widened;
            if furthest.is_nan() || direction.is_beyond(widened, furthest) {
                furthest = widened;
            }
        }
        furthest + direction.sign() * square.sqrt()
    }
}
