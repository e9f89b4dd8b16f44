//! The distribution function and its bounds over u.

use super::experiment::Experiment;
use super::interval::Modelled;
use super::random_set::RandomSet;
use crate::data::bound::Bound;
use crate::data::direction::{Direction, range_of};
use crate::data::problem::Reading;
use crate::data::table::Purpose;
use crate::estimators::estimate::Estimate;
use crate::estimators::pool::Pool;
use crate::estimators::probability::{ShareLimits, probability};
use crate::measures::measure::Measure;
use crate::measures::probability::Probability;
use crate::parallel;
use crate::search::models::of_points::TARGETS_AT_ONCE;
use loosepin_terms::Event;

/// Values at which the distribution functions are evaluated, equally spaced over everything that was seen.
const GRID_VALUES: usize = 101;

/// Bounds of P(Y <= y) over the epistemic box, for a grid of y.
///
/// Every distribution function of Y given u lies between the two curves (at each y with the stated error); the same holds
/// for every mixture of them.
#[derive(Debug, Clone, PartialEq)]
pub struct ProbabilityBox {
    /// Column of the response.
    pub column: usize,
    /// The values y, increasing; empty where no run finished.
    pub values: Vec<f64>,
    /// P(Y <= y) when every interval is taken as uniform and every member of a list as equally probable, for each y, failed runs taken as not below: the
    /// probability-only treatment, by the estimate that the bounds are made of. `None` if the problem compares no columns, so that it was
    /// not sampled.
    pub probability_only: Option<Vec<f64>>,
    /// Largest sampling error of these, which are a sample of their own; 0 where there is none.
    pub probability_only_error: f64,
    /// min over u of P(Y <= y), for each y; `widened` is made increasing.
    pub lower: Vec<Bound>,
    /// max over u of P(Y <= y), for each y; `widened` is made increasing.
    pub upper: Vec<Bound>,
}

impl ProbabilityBox {
    pub(crate) fn new(experiment: &Experiment<'_>, column: usize) -> Self {
        let setup = experiment.setup;
        let samples = experiment.pool.samples(column);
        let ends = samples.iter().filter_map(|sample| sample.ends());
        let (low, high) = range_of(ends.flat_map(|(first, last)| [first, last]));
        let values: Vec<f64> = if low > high {
            Vec::new()
        } else {
            let step = (high - low) / (GRID_VALUES - 1) as f64;
            (0..GRID_VALUES).map(|i| if i + 1 == GRID_VALUES { high } else { low + i as f64 * step }).collect()
        };
        let limits = ShareLimits::default();
        let measures: Vec<Measure> = parallel::map(&values, |&value| {
            Probability(Event::UpTo(value)).measure_with(&samples, &setup.confidence, &limits)
        });
        let search = experiment.search(measures.iter());
        let elements = experiment.focal_elements(setup.structure.widest());
        let set = (setup.problem.reading == Reading::RandomSet).then(|| RandomSet::new(experiment, &elements, column));
        let ends: Vec<[Bound; 2]> = match &set {
            Some(set) => {
                let of = |&value: &f64, direction| set.probability(experiment, Event::UpTo(value), direction);
                parallel::map(&values, |value| Direction::BOTH.map(|direction| of(value, direction)))
            }
            None => {
                let of = |modelled: Modelled<'_>| {
                    Direction::BOTH.map(|direction| experiment.added(&modelled, &elements, direction))
                };
                let chunks: Vec<&[Measure]> = measures.chunks(TARGETS_AT_ONCE).collect();
                parallel::flat_map(&chunks, |own| {
                    Modelled::of_column(&search, own, &samples).into_iter().map(of).collect::<Vec<_>>()
                })
            }
        };
        let (mut lower, mut upper): (Vec<Bound>, Vec<Bound>) = ends.into_iter().map(<(Bound, Bound)>::from).unzip();
        // A distribution function increases, so a bound at one y holds on one side of it; of two, the wider one is kept.
        for i in 1..upper.len() {
            upper[i].widened = upper[i].widened.max(upper[i - 1].widened);
        }
        for i in (1..lower.len()).rev() {
            lower[i - 1].widened = lower[i - 1].widened.min(lower[i].widened);
        }
        // Without epistemic inputs the double loop is the mixture.
        let own = if setup.epistemic_box.is_a_point() { Purpose::DoubleLoop } else { Purpose::Mixture };
        let mixture = Pool::gather(experiment.table, own, [column]).with_polynomials(setup.mixture_basis());
        let estimates: Option<Vec<Estimate>> = mixture.samples(column).first().map(|sample| {
            let share = |&value: &f64| probability(sample, Event::UpTo(value), &setup.confidence, &limits).low;
            values.iter().map(share).collect()
        });
        let probability_only_error = estimates.iter().flatten().map(|at| at.below.max(at.above)).fold(0.0, f64::max);
        let probability_only = estimates.map(|found| found.iter().map(|at| at.value).collect());
        Self { column, values, probability_only, probability_only_error, lower, upper }
    }
}
