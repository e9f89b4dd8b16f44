//! Bounds put together from surrogates and direct runs.

use super::confirm::{Confirmation, Confirmed, confirmed};
use super::learned::{Learned, LearnedGroup};
use super::plan::{SurrogatePlan, SurrogatePlanError};
use super::reach::{MARGIN, SharesOfReach};
use super::response::Aspect;
use super::search::{FIRST_REACH, SurrogateSearchBounds, search_group};
use super::treatments::{LearnedTreatments, extreme_runs, largest_ratio, treatments};
use crate::data::bound::{Bound, BoundError, BoundPair, CutBounds, Guarantee};
use crate::data::direction::Direction;
use crate::data::problem::Request;
use crate::data::table::{Purpose, RunInputs, SampleTable};
use crate::readings::bounds::Bounds;
use crate::readings::probability_box::ProbabilityBox;
use loosepin_terms::{Estimation, Statistic};

/// Bounds of one requested statistic by a surrogate.
#[derive(Debug, Clone)]
pub struct SurrogatePair {
    /// The bounds; the witnesses are those on the surrogate.
    pub pair: BoundPair,
    /// Whether the value of the lower and of the upper bound is corrected by direct runs at its witness.
    pub is_confirmed: [bool; 2],
}

/// Everything about one group of columns.
#[derive(Clone)]
pub struct GroupBounds {
    /// The surrogates, or the reason why there are none.
    pub learned: LearnedGroup,
    /// k: by how many of its standard deviations the surrogate is taken to err, at most.
    pub reach: f64,
    /// The largest error at the witnesses, in σ.
    pub largest_ratio: f64,
    /// Runs that gave nothing, to learn from and at the witnesses.
    pub failed: usize,
    /// The largest share of the inner runs at a witness that lies outside of the range of the runs, where the surrogate gives no answer.
    pub share_outside: f64,
    /// Bounds of what is possible at all, in the order of the requests; empty where nothing was learned.
    pub pairs: Vec<SurrogatePair>,
    /// Bounds over every α-cut, where an input is a fuzzy number.
    pub levels: Vec<(f64, Vec<SurrogatePair>)>,
    /// Distribution functions of the surrogate itself.
    pub boxes: Vec<ProbabilityBox>,
    /// The three treatments of its numbers, once they are compared.
    pub treatments: Option<LearnedTreatments>,
}

/// Bounds by surrogates.
#[derive(Clone)]
pub struct SurrogateBounds {
    /// One entry a group, in their order.
    pub groups: Vec<GroupBounds>,
    /// Runs to learn from.
    pub training_runs: usize,
    /// Direct runs that it was held against: at witnesses of bounds, and at extremes of treatments.
    pub confirming_runs: usize,
    /// Runs at witnesses of bounds.
    pub runs_at_bounds: usize,
    /// Failed ones of both.
    pub failed_runs: usize,
}

impl SurrogatePlan {
    /// Bounds from the surrogates without the treatments, with the runs of `confirmation` in `table`.
    ///
    /// # Errors
    ///
    /// [`SurrogatePlanError::Evaluate`].
    pub fn results(
        &self,
        learned: Learned,
        confirmation: &Confirmation,
        table: &SampleTable,
    ) -> Result<SurrogateBounds, SurrogatePlanError> {
        let count = |purpose: Purpose| table.inputs().iter().filter(|inputs| inputs.purpose == purpose).count();
        let is_own = |run: &usize| matches!(table.inputs()[*run].purpose, Purpose::Training | Purpose::Confirming);
        let groups = learned.groups.into_iter().zip(&confirmation.searched);
        Ok(SurrogateBounds {
            groups: groups
                .map(|(group, searched)| {
                    let confirmed = confirmed(self, &group, confirmation, table);
                    let failed =
                        (0..table.len()).filter(is_own).filter(|&run| group.group.row(table, run).is_none()).count();
                    group_bounds(self, group, searched, &confirmed, failed)
                })
                .collect::<Result<_, _>>()?,
            training_runs: count(Purpose::Training),
            confirming_runs: count(Purpose::Confirming),
            runs_at_bounds: count(Purpose::Confirming),
            failed_runs: (0..table.len()).filter(is_own).filter(|&run| table.failure(run).is_some()).count(),
        })
    }
}

impl SurrogateBounds {
    /// These bounds with the three treatments of the numbers that `plan` compares.
    ///
    /// # Errors
    ///
    /// [`SurrogatePlanError::Evaluate`].
    pub fn with_treatments(mut self, plan: &SurrogatePlan) -> Result<Self, SurrogatePlanError> {
        // Of bands of mechanisms, some of which fail, the surrogate knows nothing.
        for group in self.groups.iter_mut().filter(|group| group.failed == 0) {
            group.treatments = treatments(plan, &group.learned, group.reach)?;
        }
        Ok(self)
    }

    /// Direct runs at the extremes of the treatments, as round `round`.
    pub fn extreme_round(&self, round: u32) -> Vec<RunInputs> {
        extreme_runs(self.groups.iter().filter_map(|group| group.treatments.as_ref()), round)
    }

    /// Checks these bounds against the runs of [`Self::extreme_round`], which are those of `table` from `first` on.
    ///
    /// # Errors
    ///
    /// [`SurrogatePlanError::Evaluate`].
    pub fn checked_against_extremes(
        mut self,
        plan: &SurrogatePlan,
        table: &SampleTable,
        first: usize,
    ) -> Result<Self, SurrogatePlanError> {
        self.confirming_runs += table.len() - first;
        self.failed_runs += (first..table.len()).filter(|&run| table.failure(run).is_some()).count();
        for group in &mut self.groups {
            // Where an extreme has none the ends of bands are not known.
            if (first..table.len()).any(|run| group.learned.group.row(table, run).is_none()) {
                group.treatments = None;
            }
            let reach = MARGIN * largest_ratio(plan, &group.learned, table, first);
            let Some(known) = group.treatments.as_mut().filter(|_| reach > group.reach) else { continue };
            let Some(wide) = treatments(plan, &group.learned, reach)? else { continue };
            known.outer_points[1] = wide.outer_points[1].clone();
            for (known, wide) in known.comparisons.iter_mut().zip(wide.comparisons) {
                known.comparison.interval_only = wide.comparison.interval_only;
                known.coverage_surrogate[1] = wide.coverage_surrogate[1];
            }
        }
        Ok(self)
    }

    /// All bounds in the shape of direct ones, in the order of the requests, for a table of `runs` runs in `rounds` rounds. Without
    /// distribution functions and treatments; of what nothing was learned nothing is known.
    pub fn to_bounds(&self, plan: &SurrogatePlan, rounds: u32) -> Bounds {
        let ordered = |pairs: Vec<&SurrogatePair>| -> Vec<BoundPair> {
            let requests = plan.problem().requests.iter();
            let found = |request: &Request| {
                let own = |pair: &&&SurrogatePair| {
                    (pair.pair.column, pair.pair.statistic) == (request.column, request.statistic)
                };
                pairs
                    .iter()
                    .find(own)
                    .map_or_else(|| nothing_known(request, self.failed_runs), |found| found.pair.clone())
            };
            requests.filter(|request| request.statistic.is_single()).map(found).collect()
        };
        let mut alphas: Vec<f64> = Vec::new();
        for (alpha, _) in self.groups.iter().flat_map(|group| &group.levels) {
            if !alphas.contains(alpha) {
                alphas.push(*alpha);
            }
        }
        let level = |&alpha: &f64| {
            let own = self.groups.iter().flat_map(|group| &group.levels).filter(|(of, _)| *of == alpha);
            CutBounds { alpha: Some(alpha), pairs: ordered(own.flat_map(|(_, pairs)| pairs).collect()) }
        };
        Bounds {
            reading: plan.problem().reading,
            pairs: ordered(self.groups.iter().flat_map(|group| &group.pairs).collect()),
            levels: alphas.iter().map(level).collect(),
            percentiles: Vec::new(),
            boxes: Vec::new(),
            comparisons: Vec::new(),
            outer_points: Vec::new(),
            centre_point: 0,
            gaps: None,
            runs: self.training_runs + self.confirming_runs,
            failed_runs: self.failed_runs,
            rounds,
        }
    }

    /// The bounds of `statistic` of `column`.
    pub fn pair(&self, column: usize, statistic: Statistic) -> Option<&SurrogatePair> {
        let mut pairs = self.groups.iter().flat_map(|group| &group.pairs);
        pairs.find(|pair| pair.pair.column == column && pair.pair.statistic == statistic)
    }
}

fn group_bounds(
    plan: &SurrogatePlan,
    learned: LearnedGroup,
    searched: &[SurrogateSearchBounds],
    confirmed: &[Confirmed],
    failed: usize,
) -> Result<GroupBounds, SurrogatePlanError> {
    let largest_ratio = confirmed.iter().map(Confirmed::ratio).fold(0.0, f64::max);
    let reach = FIRST_REACH.max(MARGIN * largest_ratio);
    let shares = SharesOfReach::new(plan, confirmed, learned.group.columns.len(), reach);
    // The values stay those whose witnesses were looked at; only what is conceded grows.
    let again = if reach > FIRST_REACH { Some(search_group(plan, &learned, reach)?) } else { None };
    let wide = again.as_deref().unwrap_or(searched);
    let has_rest = learned.keeps_residual() && !plan.problem().random.is_empty();
    let missing = learned.failed + confirmed.iter().map(Confirmed::without_difference).sum::<usize>();
    let mut levels: Vec<(Option<f64>, Vec<SurrogatePair>)> = Vec::new();
    for (near, far) in searched.iter().zip(wide) {
        for (level, ((alpha, pairs), (_, far_pairs))) in near.levels().into_iter().zip(far.levels()).enumerate() {
            if levels.len() <= level {
                levels.push((alpha, Vec::new()));
            }
            for (request, pair) in near.values(pairs) {
                let place = learned.group.columns.iter().position(|&column| column == request.column).unwrap_or(0);
                let end = |bound: &Bound, direction| {
                    let on_band = far.furthest(far_pairs, request, direction);
                    let furthest = bound.widened + shares.of(request.statistic) * (on_band - bound.widened);
                    put_together(plan, bound, furthest, (confirmed, has_rest), (place, request), direction)
                };
                let (mut lower, is_lower) = end(&pair.lower, Direction::Minimum);
                let (mut upper, is_upper) = end(&pair.upper, Direction::Maximum);
                if !(is_lower && is_upper) {
                    (lower.guarantee, upper.guarantee) = (Guarantee::unconfirmed(), Guarantee::unconfirmed());
                }
                if failed > 0 {
                    (lower, upper) =
                        (not_known(lower, request, Direction::Minimum), not_known(upper, request, Direction::Maximum));
                }
                let mut pair = BoundPair { lower, upper, central: None, failed_runs: missing, ..pair.clone() };
                (pair.column, pair.statistic) = (request.column, request.statistic);
                pair.unbounded_by_failures =
                    !request.statistic.is_by_shares() && (missing > 0 || pair.unbounded_by_failures);
                levels[level].1.push(SurrogatePair { pair, is_confirmed: [is_lower, is_upper] });
            }
        }
    }
    let mut levels = levels.into_iter();
    let pairs = levels.next().map(|(_, pairs)| pairs).unwrap_or_default();
    let column_of = |searched: &SurrogateSearchBounds, column: usize| {
        learned.group.columns[searched.places[column / Aspect::ALL.len()]]
    };
    let boxes = searched.iter().flat_map(|searched| {
        let own = searched.bounds.boxes.iter().cloned();
        own.map(|found| ProbabilityBox { column: column_of(searched, found.column), ..found })
    });
    Ok(GroupBounds {
        reach,
        largest_ratio,
        failed,
        share_outside: confirmed.iter().map(Confirmed::share_outside).fold(0.0, f64::max),
        pairs,
        levels: levels.filter_map(|(alpha, pairs)| Some((alpha?, pairs))).collect(),
        boxes: boxes.collect(),
        treatments: None,
        learned,
    })
}

/// `bound` where direct runs failed. What share of the mechanisms fails at which u was not learned: a probability may be anything, and so
/// may a quantile.
fn not_known(bound: Bound, request: Request, direction: Direction) -> Bound {
    if !request.statistic.is_by_shares() {
        return bound;
    }
    let widened = furthest_possible(request.statistic, direction);
    let error = BoundError { surrogate: nothing_known_error(request.statistic), ..bound.error };
    Bound { widened, error, guarantee: Guarantee::unconfirmed(), ..bound }
}

/// The bounds that say nothing.
fn nothing_known(request: &Request, failed_runs: usize) -> BoundPair {
    let error = BoundError { surrogate: nothing_known_error(request.statistic), ..BoundError::default() };
    let ends = Direction::BOTH.map(|direction| {
        let value = furthest_possible(request.statistic, direction);
        Bound { value, widened: value, witness: None, error, guarantee: Guarantee::unconfirmed() }
    });
    BoundPair::new(request.column, request.statistic, ends, failed_runs)
}

/// Error of a statistic about which nothing is known, to either side.
fn nothing_known_error(statistic: Statistic) -> f64 {
    if statistic.is_probability() { 1.0 } else { f64::INFINITY }
}

/// The end of all values that a statistic can have.
fn furthest_possible(statistic: Statistic, direction: Direction) -> f64 {
    let [least, greatest] = statistic.range();
    direction.of(least, greatest)
}

/// A bound on the surrogate's value with what direct runs and the band say: whether it was corrected, too.
fn put_together(
    plan: &SurrogatePlan,
    bound: &Bound,
    furthest: f64,
    (confirmed, has_rest): (&[Confirmed], bool),
    (place, request): (usize, Request),
    direction: Direction,
) -> (Bound, bool) {
    let sign = direction.sign();
    let at_witness = bound.witness.as_ref().and_then(|witness| {
        let confirmed = confirmed.iter().find(|confirmed| confirmed.is_at(&witness.epistemic))?;
        // With a rest that is drawn from, the bound is not that of ŝ alone.
        let known = (!has_rest).then_some((bound.value, bound.error.sampling));
        confirmed.corrected(place, request.statistic, known, &plan.direct.setup.confidence)
    });
    let is_confirmed = at_witness.is_some();
    let (value, sampling) = at_witness.map_or((bound.value, bound.error.sampling), |corrected| {
        let own = if direction == Direction::Minimum { corrected.below } else { corrected.above };
        // Where the direct runs show no difference they may have missed one: the surrogate's own error stays.
        let is_mean = request.statistic.estimation() == Some(Estimation::Mean);
        (corrected.value, if is_mean { own } else { own.max(bound.error.sampling) })
    });
    let known = sampling + bound.error.optimisation;
    let surrogate = sign * (furthest - value) - known;
    let surrogate = if surrogate.is_nan() { f64::INFINITY } else { surrogate.max(0.0) };
    let error = BoundError { sampling, optimisation: bound.error.optimisation, surrogate };
    let [least, greatest] = request.statistic.range();
    let widened = error.widen(value, direction).clamp(least, greatest);
    let guarantee = bound.guarantee.with_confidence(|| plan.stated_confidence);
    (Bound { value, widened, witness: bound.witness.clone(), error, guarantee }, is_confirmed)
}
