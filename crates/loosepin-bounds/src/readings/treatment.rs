//! Bands of a column with everything random, with everything an interval, and with both kinds kept apart.

use super::added_quantile::QuantileJob;
use super::coverage::Coverage;
use super::experiment::Experiment;
use super::interval::Modelled;
use super::random_set::RandomSet;
use crate::data::bound::{Bound, BoundError, Guarantee, Treatment, Witness};
use crate::data::direction::{Direction, extreme};
use crate::data::problem::Reading;
use crate::data::table::{Purpose, SampleTable};
use crate::estimators::pool::Pool;
use crate::estimators::quantile::quantile;
use crate::measures::measure::{Estimator, Measure};
use crate::measures::quantile::Quantile;
use crate::parallel;
use crate::search::models::of_points::Search;
use crate::search::models::shared_grids::SharedGrids;
use crate::search::search_box::Region;
use crate::search::target::SEARCH_RESOLUTION;

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
    pub(crate) fn all(experiment: &Experiment<'_>) -> Vec<Self> {
        let setup = experiment.setup;
        let columns = &setup.problem.compared_columns;
        if columns.is_empty() {
            return Vec::new();
        }
        let runs_of = |has_own: bool, own: Purpose| gather(experiment.table, has_own, own, columns);
        let mixture = runs_of(setup.has_mixture(), Purpose::Mixture).with_polynomials(setup.mixture_basis());
        let extremes = runs_of(setup.has_extremes(), Purpose::Extreme);
        let mixed = mixed_ends(experiment, columns);
        let probability_only = probability_only_ends(experiment, &mixture, columns);
        let interval_only = interval_only_ends(experiment, &extremes, columns);
        let shares = setup.shares_of_mechanisms(experiment.pool);
        let band = |treatment, pool: &Pool, column, ends: &[Bound; 2]| {
            let [lower, upper] = ends.clone();
            let coverage =
                Coverage::of_band(experiment.pool, column, [lower.value, upper.value], &shares, &setup.confidence);
            let failed_runs = pool.samples(column).iter().map(|sample| sample.failed()).sum();
            Band { treatment, half_width: 0.5 * (upper.value - lower.value), lower, upper, failed_runs, coverage }
        };
        parallel::map_indices(columns.len(), |index| Self {
            column: columns[index],
            probability: setup.problem.band_probability,
            probability_only: band(Treatment::ProbabilityOnly, &mixture, columns[index], &probability_only[index]),
            interval_only: band(Treatment::IntervalOnly, &extremes, columns[index], &interval_only[index]),
            mixed: band(Treatment::Mixed, experiment.pool, columns[index], &mixed[index]),
        })
    }
}

/// The runs of a treatment. Without epistemic inputs the runs of the double loop are the mixture, without random inputs
/// they are points of the joint box: then the treatment has none of its own.
fn gather(table: &SampleTable, has_own: bool, own: Purpose, columns: &[usize]) -> Pool {
    Pool::gather(table, if has_own { own } else { Purpose::DoubleLoop }, columns.iter().copied())
}

/// Both ends of every column where u is unknown within the box.
fn mixed_ends(experiment: &Experiment<'_>, columns: &[usize]) -> Vec<[Bound; 2]> {
    let setup = experiment.setup;
    let quantiles = setup.band_quantiles();
    let elements = experiment.focal_elements(setup.structure.widest());
    if setup.problem.reading == Reading::RandomSet {
        return parallel::map(columns, |&column| {
            let set = RandomSet::new(experiment, &elements, column);
            quantiles.map(|(probability, direction)| set.quantile(experiment, probability, direction))
        });
    }
    let [whole] = &elements[..] else {
        let job = |column, (probability, direction)| QuantileJob { column, probability, direction };
        let jobs: Vec<QuantileJob> =
            columns.iter().flat_map(|&column| quantiles.map(|wanted| job(column, wanted))).collect();
        let bounds = experiment.quantiles(&jobs, &elements);
        return bounds.chunks(2).map(|pair| [pair[0].clone(), pair[1].clone()]).collect();
    };
    let measures: Vec<[Measure; 2]> = parallel::map(columns, |&column| {
        let samples = experiment.pool.samples(column);
        quantiles.map(|(probability, _)| Quantile(probability).measure(&samples, &setup.confidence))
    });
    let search = experiment.search(measures.iter().flatten());
    parallel::map_indices(columns.len(), |index| {
        let samples = experiment.pool.samples(columns[index]);
        let measures = &measures[index];
        [0, 1].map(|end| experiment.bound(&Modelled::new(&search, &measures[end], &samples), quantiles[end].1, whole))
    })
}

/// Both quantiles of the mixture of every column.
fn probability_only_ends(experiment: &Experiment<'_>, pool: &Pool, columns: &[usize]) -> Vec<[Bound; 2]> {
    let setup = experiment.setup;
    let tail = 0.5 * (1.0 - setup.problem.band_probability);
    let guarantee = Guarantee::of_sample(setup.problem.sampling.confidence);
    let end = |value: f64, sign: f64, sampling: f64| {
        Bound::without_witness(value, value + sign * sampling, BoundError::of_runs(sampling, 0.0), guarantee)
    };
    parallel::map(columns, |&column| match pool.samples(column).first() {
        Some(sample) if !sample.values().is_empty() => {
            let lower = quantile(sample, &setup.confidence, tail).low;
            let upper = quantile(sample, &setup.confidence, 1.0 - tail).high;
            [end(lower.value, -1.0, lower.below), end(upper.value, 1.0, upper.above)]
        }
        _ => Direction::BOTH.map(|direction| Bound::unknown(direction, guarantee)),
    })
}

/// Extremes of every column over the joint box.
fn interval_only_ends(experiment: &Experiment<'_>, pool: &Pool, columns: &[usize]) -> Vec<[Bound; 2]> {
    let setup = experiment.setup;
    let places = setup.extreme_places(pool);
    let targets: Vec<_> = parallel::map(columns, |&column| setup.extreme_target(pool, column));
    let grids = SharedGrids::after(experiment.table, Purpose::Extreme);
    let search = Search::sharing(&grids, setup.joint_box.axes(), &places, &setup.joint_candidates, &targets);
    let whole = Region::whole(setup.joint_box.dimensions());
    parallel::map_indices(columns.len(), |index| {
        let (column, target) = (columns[index], &targets[index]);
        let branches = search.branches(target);
        Direction::BOTH.map(|direction| {
            let sign = direction.sign();
            let (value, witness) = furthest_run(experiment, column, direction);
            let searched = extreme(&target.values, direction);
            let further = search.furthest_reach(target, &branches, direction, &whole);
            let conceded = SEARCH_RESOLUTION * target.range();
            let optimisation = (sign * (further - value)).max(sign * (searched - value)).max(conceded);
            let has_box = setup.joint_box.dimensions() > 0;
            let error = BoundError { optimisation: if has_box { optimisation } else { 0.0 }, ..BoundError::default() };
            Bound { value, widened: error.widen(value, direction), witness, error, guarantee: Guarantee::of_search() }
        })
    })
}

/// The run that goes furthest of all runs inside the joint box, whatever they were made for.
fn furthest_run(experiment: &Experiment<'_>, column: usize, direction: Direction) -> (f64, Option<Witness>) {
    let (joint_box, table) = (&experiment.setup.joint_box, experiment.table);
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
