//! The same question with everything random, with everything an interval, and with both kinds kept apart.

use rayon::prelude::*;

use super::assemble::{Evidence, Modelled};
use super::bound::{Bound, BoundError, Guarantee, Reading, Treatment, Witness};
use super::combine::QuantileJob;
use super::coverage::Coverage;
use super::measure::Measure;
use super::pool::Pool;
use super::quantile::quantile;
use super::random_set::RandomSet;
use super::search::{Direction, SEARCH_RESOLUTION, Search, extreme};
use super::search_box::Region;
use super::statistic::Statistic;
use super::table::{Purpose, SampleTable};

/// A band for a column, by one treatment.
#[derive(Debug, Clone, PartialEq)]
pub struct Band {
    /// How the band was found.
    pub treatment: Treatment,
    /// Lower end.
    pub lower: Bound,
    /// Upper end.
    pub upper: Bound,
    /// Half the distance of the attained ends.
    pub half_width: f64,
    /// Failed runs of the column among those that the band was made from. The quantiles of the other treatments take them
    /// as unknown; an interval-only band says nothing of them.
    pub failed_runs: usize,
    /// P(Y in band | u), for the attained ends.
    pub coverage: Coverage,
}

/// The central bands of one column by all three treatments.
#[derive(Debug, Clone, PartialEq)]
pub struct TreatmentComparison {
    /// Column of the response.
    pub column: usize,
    /// Probability of the central band, in (0, 1); an interval-only band has none of its own.
    pub probability: f64,
    /// Every interval taken as uniform, every member of a list as equally probable: both quantiles of the mixture.
    pub probability_only: Band,
    /// Every random input cut to an interval: the extremes of the response.
    pub interval_only: Band,
    /// The lower quantile's minimum and the upper quantile's maximum over u.
    pub mixed: Band,
}

impl TreatmentComparison {
    /// Compares all columns that the problem asks for.
    pub(super) fn all(evidence: &Evidence<'_>, table: &SampleTable) -> Vec<Self> {
        let problem = evidence.plan.problem();
        let columns = &problem.compared_columns;
        if columns.is_empty() {
            return Vec::new();
        }
        let plan = evidence.plan;
        let mixture =
            gather(table, plan.has_mixture(), Purpose::Mixture, columns).with_polynomials(plan.mixture_basis());
        let extremes = gather(table, plan.has_extremes(), Purpose::Extreme, columns);
        let mixed = mixed_ends(evidence, columns);
        let probability_only = probability_only_ends(evidence, &mixture, columns);
        let interval_only = interval_only_ends(evidence, table, &extremes, columns);
        let shares = plan.shares_of_mechanisms(evidence.pool);
        let band = |treatment, pool: &Pool, column, [lower, upper]: [Bound; 2]| {
            let coverage =
                Coverage::of_band(evidence.pool, column, [lower.value, upper.value], &shares, plan.confidence());
            let failed_runs = pool.samples(column).iter().map(|sample| sample.failed()).sum();
            Band { treatment, half_width: 0.5 * (upper.value - lower.value), lower, upper, failed_runs, coverage }
        };
        let ends: Vec<_> = columns.iter().zip(mixed).zip(probability_only).zip(interval_only).collect();
        ends.into_par_iter()
            .map(|(((&column, mixed), probability_only), interval_only)| Self {
                column,
                probability: problem.band_probability,
                probability_only: band(Treatment::ProbabilityOnly, &mixture, column, probability_only),
                interval_only: band(Treatment::IntervalOnly, &extremes, column, interval_only),
                mixed: band(Treatment::Mixed, evidence.pool, column, mixed),
            })
            .collect()
    }
}

/// The runs of a treatment. Without epistemic inputs the runs of the double loop are the mixture, without random inputs
/// they are points of the joint box: then the treatment has none of its own.
fn gather(table: &SampleTable, has_own: bool, own: Purpose, columns: &[usize]) -> Pool {
    Pool::gather(table, if has_own { own } else { Purpose::DoubleLoop }, columns.iter().copied())
}

fn mixed_ends(evidence: &Evidence<'_>, columns: &[usize]) -> Vec<[Bound; 2]> {
    let statistics = evidence.plan.band_statistics();
    let parts = evidence.parts(evidence.plan.structure().widest());
    if evidence.plan.problem().reading == Reading::RandomSet {
        return columns
            .par_iter()
            .map(|&column| {
                let set = RandomSet::new(evidence, &parts, column);
                [0, 1].map(|end| set.bounds(evidence, statistics[end].0)[end].clone())
            })
            .collect();
    }
    if parts.parts.len() > 1 {
        let job = |column, (statistic, direction)| match statistic {
            Statistic::Quantile(probability) => Some(QuantileJob { column, probability, direction }),
            _ => None,
        };
        let jobs: Vec<QuantileJob> =
            columns.iter().flat_map(|&column| statistics.map(|wanted| job(column, wanted))).flatten().collect();
        let bounds = evidence.quantiles(&jobs, &parts);
        return bounds.chunks(2).map(|pair| [pair[0].clone(), pair[1].clone()]).collect();
    }
    let measures: Vec<[Measure; 2]> = columns
        .par_iter()
        .filter_map(|&column| {
            let samples = evidence.pool.samples(column);
            let measure = |end: usize| Measure::new(&samples, statistics[end].0, evidence.plan.confidence());
            Some([measure(0)?, measure(1)?])
        })
        .collect();
    let search = evidence.search(measures.iter().flatten());
    columns
        .par_iter()
        .zip(&measures)
        .map(|(&column, measures)| {
            let samples = evidence.pool.samples(column);
            [0, 1].map(|end| {
                let modelled = Modelled::new(&search, &measures[end]);
                evidence.added(&search, &samples, &modelled, &parts, statistics[end].1)
            })
        })
        .collect()
}

fn probability_only_ends(evidence: &Evidence<'_>, pool: &Pool, columns: &[usize]) -> Vec<[Bound; 2]> {
    let plan = evidence.plan;
    let tail = 0.5 * (1.0 - plan.problem().band_probability);
    let guarantee = Guarantee::Sampled { confidence: plan.problem().sampling.confidence };
    let unknown = |sign: f64| Bound {
        value: f64::NAN,
        widened: sign * f64::INFINITY,
        witness: None,
        error: BoundError { sampling: f64::INFINITY, ..BoundError::default() },
        guarantee,
    };
    let end = |value: f64, sign: f64, sampling: f64| Bound {
        value,
        widened: value + sign * sampling,
        witness: None,
        error: BoundError { sampling, ..BoundError::default() },
        guarantee,
    };
    columns
        .par_iter()
        .map(|&column| match pool.samples(column).first() {
            Some(sample) if !sample.values().is_empty() => {
                let lower = quantile(sample, plan.confidence(), tail).low;
                let upper = quantile(sample, plan.confidence(), 1.0 - tail).high;
                [end(lower.value, -1.0, lower.below), end(upper.value, 1.0, upper.above)]
            }
            _ => [unknown(-1.0), unknown(1.0)],
        })
        .collect()
}

fn interval_only_ends(evidence: &Evidence<'_>, table: &SampleTable, pool: &Pool, columns: &[usize]) -> Vec<[Bound; 2]> {
    let plan = evidence.plan;
    let places = plan.extreme_places(pool);
    let targets: Vec<_> = columns.par_iter().map(|&column| plan.extreme_target(pool, column)).collect();
    let search = Search::new(plan.joint_box().axes(), &places, plan.joint_candidates(), &targets);
    let whole = Region::whole(plan.joint_box().dimensions());
    columns
        .par_iter()
        .zip(&targets)
        .map(|(&column, target)| {
            let branches = search.branches(target);
            Direction::BOTH.map(|direction| {
                let sign = direction.sign();
                let (value, witness) = furthest_run(evidence, table, column, direction);
                let searched = extreme(&target.values, direction);
                let further = search.furthest_reach(target, &branches, direction, &whole);
                let conceded = SEARCH_RESOLUTION * target.range();
                let optimisation = (sign * (further - value)).max(sign * (searched - value)).max(conceded);
                let has_box = plan.joint_box().dimensions() > 0;
                let error =
                    BoundError { optimisation: if has_box { optimisation } else { 0.0 }, ..BoundError::default() };
                let widened = if value.is_nan() { sign * f64::INFINITY } else { value + sign * error.total() };
                Bound { value, widened, witness, error, guarantee: Guarantee::Optimised }
            })
        })
        .collect()
}

/// The run that goes furthest of all runs inside the joint box, whatever they were made for.
fn furthest_run(
    evidence: &Evidence<'_>,
    table: &SampleTable,
    column: usize,
    direction: Direction,
) -> (f64, Option<Witness>) {
    let joint_box = evidence.plan.joint_box();
    let mut best: Option<usize> = None;
    for (run, inputs) in table.inputs().iter().enumerate() {
        let value = table.values(run)[column];
        if !value.is_finite() || best.is_some_and(|best| !direction.is_beyond(value, table.values(best)[column])) {
            continue;
        }
        if joint_box.holds(&inputs.random) {
            best = Some(run);
        }
    }
    let Some(best) = best else { return (f64::NAN, None) };
    let inputs = &table.inputs()[best];
    let witness = Witness {
        purpose: inputs.purpose,
        point: inputs.point,
        epistemic: inputs.epistemic.clone(),
        random: inputs.random.clone(),
    };
    (table.values(best)[column], Some(witness))
}
