//! Percentiles of statistics where parameters of distributions have distributions themselves.
//!
//! With θ the parameters that have distributions and v the other epistemic inputs, a statistic S(θ, v) is itself random, by θ alone:
//!
//! ```text
//! S_p(v) = the value that S(θ, v) does not exceed with probability p over θ;    from min over v to max over v of S_p(v)
//! ```
//!
//! S is known at the outer points; between them its model (`smoother.rs`) is asked at scrambled Sobol' points of θ for each of a few
//! values of v, and S_p of these has a model over v of its own. Where θ lies outside of the range in which it is looked at, S counts as
//! unknown: below everything for lower ends, above everything for upper ones.
//!
//! Conceded are four deviations of the model of S at every θ, in the direction of the end, and how far the model of S_p over v may
//! go (optimisation error); the sampling error of S where it is near S_p, and the spread of S_p between scramblings of θ (sampling
//! error).

use super::experiment::Experiment;
use crate::data::bound::{Bound, BoundError, Guarantee, Witness};
use crate::data::direction::{Direction, extreme, extreme_point};
use crate::data::problem::Request;
use crate::data::table::Purpose;
use crate::estimators::estimate::{Confidence, replicate_error};
use crate::measures::measure::Measure;
use crate::measures::of_statistic::estimator;
use crate::parallel;
use crate::search::design::{first_points, structural_point_count};
use crate::search::models::noise::Noise;
use crate::search::models::of_points::{Branch, Search};
use crate::search::models::prediction::Allowance;
use crate::search::models::target_model::Forecast;
use crate::search::search_box::{Axes, BoxPoint, Region};
use crate::search::target::{Target, TargetKind};
use loosepin_math::{sort_ascending, sort_by_number};
use loosepin_terms::Statistic;
use loosepin_uncertainty::{EpistemicVariable, ScrambledSobol, SecondOrder, hash};

/// Independent scramblings of the parameters, and points of each: alone, and for each of several values of the other inputs.
const SCRAMBLINGS: u32 = 8;
const POINTS_ALONE: u32 = 256;
const POINTS: u32 = 64;

/// Values of the other epistemic inputs at which the percentiles are taken, at least: corners, centre and interior points.
const MIN_VALUES: usize = 40;

/// Number of outer points with the nearest statistics; the largest of their sampling errors is that of a percentile.
const NEAREST: usize = 5;

/// Separates the stream of random numbers.
const PARAMETERS: u64 = 0x7365_636f_6e64;

/// A percentile of a statistic, from the least to the greatest over all other epistemic inputs.
#[derive(Debug, Clone, PartialEq)]
pub struct Percentile {
    /// With this probability the parameters are such that the statistic does not exceed it, in (0, 1).
    pub probability: f64,
    /// The least. Of the witness the parameters are not numbers.
    pub lower: Bound,
    /// The greatest; the same value as the least where nothing else is epistemic.
    pub upper: Bound,
}

/// A statistic that is itself random.
#[derive(Debug, Clone, PartialEq)]
pub struct StatisticPercentiles {
    /// Column of the response.
    pub column: usize,
    /// The statistic.
    pub statistic: Statistic,
    /// One for each probability that the problem names, in its order.
    pub percentiles: Vec<Percentile>,
}

/// Grid on which the models of the statistics are evaluated.
struct Grid {
    /// Places of the whole box, parameters changing fastest; empty if the parameters lie outside of their range.
    places: Vec<Option<Vec<f64>>>,
    /// Coordinates of the other inputs in their own unit box, one for each value of them.
    others: Vec<Vec<f64>>,
    other_axes: Axes,
    /// Axes of the other inputs in the whole box.
    other_inputs: Vec<usize>,
    /// Points of each scrambling of the parameters.
    points: u32,
}

impl Experiment<'_> {
    /// Percentiles of all statistics but whole distribution functions; empty if no parameter has a distribution.
    pub fn percentiles(&self) -> Vec<StatisticPercentiles> {
        let Some(grid) = self.grid() else { return Vec::new() };
        let confidence = &self.setup.confidence;
        let asked: Vec<(Request, Measure)> = self
            .setup
            .single_statistics()
            .into_iter()
            .filter_map(|request| {
                let samples = self.pool.samples(request.column);
                Some((request, estimator(request.statistic)?.measure(&samples, confidence)))
            })
            .collect();
        let inside: Vec<Vec<f64>> = grid.places.iter().flatten().cloned().collect();
        let search = Search::new(
            self.setup.epistemic_box.axes(),
            &self.places,
            &inside,
            asked.iter().map(|(_, measure)| &measure.target),
        );
        parallel::map(&asked, |(request, measure)| {
            let branches = search.branches(&measure.target);
            let seen: Vec<Option<Vec<Forecast>>> =
                branches.iter().map(|branch| grid.at_places(branch, inside.len())).collect();
            let percentile = |&probability: &f64| {
                let [lower, upper] = Direction::BOTH
                    .map(|direction| self.percentile(&grid, measure, &seen, probability, direction, confidence));
                Percentile { probability, lower, upper }
            };
            StatisticPercentiles {
                column: request.column,
                statistic: request.statistic,
                percentiles: self.setup.problem.percentiles.iter().map(percentile).collect(),
            }
        })
    }

    fn grid(&self) -> Option<Grid> {
        let search_box = &self.setup.epistemic_box;
        let parameters: Vec<(usize, &SecondOrder)> = search_box
            .inputs()
            .iter()
            .enumerate()
            .filter_map(|(input, known)| match known {
                EpistemicVariable::SecondOrder(parameter) => Some((search_box.axis_of(input)?, parameter)),
                _ => None,
            })
            .collect();
        if parameters.is_empty() {
            return None;
        }
        let is_parameter = |axis: &usize| parameters.iter().any(|(own, _)| own == axis);
        let other_inputs: Vec<usize> = (0..search_box.dimensions()).filter(|axis| !is_parameter(axis)).collect();
        let other_axes = search_box.axes().of(&other_inputs);
        let seed = self.setup.problem.sampling.seed;
        let others = if other_inputs.is_empty() {
            vec![Vec::new()]
        } else {
            let structural = structural_point_count(other_inputs.len());
            let points = first_points(seed, other_inputs.len(), MIN_VALUES.max(2 * structural)).ok()?;
            points.into_iter().map(|at| other_axes.vertex(at)).collect()
        };
        let points = if others.len() > 1 { POINTS } else { POINTS_ALONE };
        let sobol = ScrambledSobol::try_new(hash(seed, PARAMETERS), parameters.len()).ok()?;
        let mut drawn: Vec<Option<Vec<f64>>> = Vec::new();
        let mut point = vec![0.0; parameters.len()];
        for scrambling in 0..SCRAMBLINGS {
            for index in 0..points {
                sobol.write_point(scrambling, index, &mut point);
                let fraction = |(&probability, (_, parameter)): (&f64, &(usize, &SecondOrder))| {
                    parameter.quantile_in_range(probability).map(|value| parameter.range().fraction_of(value))
                };
                drawn.push(point.iter().zip(&parameters).map(fraction).collect());
            }
        }
        let place = |other: &Vec<f64>, fractions: &Option<Vec<f64>>| -> Option<Vec<f64>> {
            let mut at = vec![0.0; search_box.dimensions()];
            for ((axis, _), fraction) in parameters.iter().zip(fractions.as_ref()?) {
                at[*axis] = *fraction;
            }
            for (axis, value) in other_inputs.iter().zip(other) {
                at[*axis] = *value;
            }
            Some(at)
        };
        let place = &place;
        let places = others.iter().flat_map(|other| drawn.iter().map(move |fractions| place(other, fractions)));
        Some(Grid { places: places.collect(), others, other_axes, other_inputs, points })
    }

    /// One end of a percentile over the other epistemic inputs.
    fn percentile(
        &self,
        grid: &Grid,
        measure: &Measure,
        seen: &[Option<Vec<Forecast>>],
        probability: f64,
        direction: Direction,
        confidence: &Confidence,
    ) -> Bound {
        let sign = direction.sign();
        let drawn = (SCRAMBLINGS * grid.points) as usize;
        // For every combination and every value of the other inputs: the percentile, with the model's error, with its spread.
        let mut points: Vec<BoxPoint> = Vec::new();
        let mut found: Vec<Found> = Vec::new();
        for (combination, seen) in seen.iter().enumerate() {
            let Some(seen) = seen else { return self.unknown(direction) };
            let mut rest = seen.iter();
            for (other, places) in grid.others.iter().zip(grid.places.chunks(drawn)) {
                let values: Vec<Option<Forecast>> =
                    places.iter().map(|place| place.as_ref().and_then(|_| rest.next().copied())).collect();
                points.push(BoxPoint { combination, at: other.clone() });
                found.push(Found::new(&values, grid.points as usize, probability, direction, confidence));
            }
        }
        let values: Vec<f64> = found.iter().map(|found| found.value).collect();
        let Some(best) = extreme_point(&values, direction) else { return self.unknown(direction) };
        let conceded: Vec<f64> = found.iter().map(|found| found.conceded).collect();
        let further = self.further_over_others(grid, &points, conceded, direction);
        let of = |target: f64| measure.of.statistic_of(target);
        let value = of(values[best]);
        let optimisation = (sign * (of(further) - value)).max(0.0);
        let spread = (of(values[best] + sign * found[best].spread) - value).abs();
        let sampling = spread + sampling_error(measure, values[best], direction, of);
        let error = BoundError::of_runs(sampling, optimisation);
        let widened = measure.of.limited(error.widen(value, direction));
        let mut at = vec![f64::NAN; self.setup.epistemic_box.dimensions()];
        for (axis, fraction) in grid.other_inputs.iter().zip(&points[best].at) {
            at[*axis] = *fraction;
        }
        let epistemic =
            self.setup.epistemic_box.values_at(&BoxPoint { combination: points[best].combination, at: at.clone() });
        let epistemic = epistemic.iter().enumerate().map(|(input, &value)| {
            let is_unknown = self.setup.epistemic_box.axis_of(input).is_some_and(|axis| at[axis].is_nan());
            if is_unknown { f64::NAN } else { value }
        });
        let witness =
            Witness { purpose: Purpose::DoubleLoop, point: 0, epistemic: epistemic.collect(), random: Vec::new() };
        let guarantee = Guarantee::of_sample(self.setup.problem.sampling.confidence);
        Bound { value, widened, witness: Some(witness), error, guarantee }
    }

    /// How far the percentile, with what its model concedes, may go between the values of the other inputs.
    fn further_over_others(&self, grid: &Grid, points: &[BoxPoint], values: Vec<f64>, direction: Direction) -> f64 {
        let attained = extreme(&values, direction);
        if grid.other_inputs.is_empty() || values.iter().any(|value| !value.is_finite()) {
            return attained;
        }
        let target =
            Target { values, kind: TargetKind::Plain, noise: Noise::NONE, resolutions: [f64::MIN_POSITIVE; 2] };
        let search = Search::new(&grid.other_axes, points, &grid.others, [&target]);
        let branches = search.branches(&target);
        let region = Region::whole(grid.other_inputs.len());
        let reach = search.furthest_reach(&target, &branches, direction, &region);
        direction.further(attained, reach)
    }
}

impl Grid {
    /// Mean and deviation of a statistic at all places inside the range.
    fn at_places(&self, branch: &Branch<'_>, count: usize) -> Option<Vec<Forecast>> {
        Some(branch.at_candidates(Allowance::CONCESSION)?.take(count).collect())
    }
}

/// A percentile at one value of the other inputs, of the target of its measure.
struct Found {
    value: f64,
    /// With four deviations of the model, and what is unknown, conceded.
    conceded: f64,
    /// Half-width of the confidence interval from the scramblings.
    spread: f64,
}

impl Found {
    /// From the values at all draws of the parameters, `points` of each scrambling.
    fn new(
        values: &[Option<Forecast>],
        points: usize,
        probability: f64,
        direction: Direction,
        confidence: &Confidence,
    ) -> Self {
        let sign = direction.sign();
        let means =
            |values: &[Option<Forecast>]| -> Vec<f64> { values.iter().flatten().map(|value| value.mean()).collect() };
        let conceded = values
            .iter()
            .map(|value| value.map_or(sign * f64::INFINITY, |value| value.moved(Allowance::CONCESSION, sign)));
        let own: Vec<f64> = values.chunks(points).map(|values| order_statistic(means(values), probability)).collect();
        let (below, above) = replicate_error(&own, confidence);
        Self {
            value: order_statistic(means(values), probability),
            conceded: order_statistic(conceded.collect(), probability),
            spread: below.max(above),
        }
    }
}

/// The percentile of numbers that each have the same probability: between order statistics, y_(k) at (k - 1/2)/N.
fn order_statistic(mut values: Vec<f64>, probability: f64) -> f64 {
    sort_ascending(&mut values);
    let Some(last) = values.len().checked_sub(1) else { return f64::NAN };
    let place = (probability * values.len() as f64 - 0.5).clamp(0.0, last as f64);
    let below = place.floor() as usize;
    let share = place - below as f64;
    // Half of infinity and half of a number is infinity; what is below everything stays there.
    if share == 0.0 || values[below].is_infinite() {
        values[below]
    } else {
        values[below] + share * (values[below + 1] - values[below])
    }
}

/// The largest sampling error in `direction` among the outer points at which the target is nearest to `value`, failed runs counted
/// either way; with it what lies between the statistic and `of` its target.
fn sampling_error(measure: &Measure, value: f64, direction: Direction, of: impl Fn(f64) -> f64) -> f64 {
    let estimates = measure.estimates(direction);
    let mut near: Vec<(f64, f64)> = measure
        .target
        .values
        .iter()
        .zip(measure.low.iter().zip(estimates))
        .filter(|(target, _)| target.is_finite())
        .map(|(target, (low, estimate))| {
            let error = match direction {
                Direction::Minimum => estimate.below,
                Direction::Maximum => estimate.above + (estimate.value - low.value).max(0.0),
            };
            ((target - value).abs(), error + (of(*target) - low.value).abs())
        })
        .collect();
    sort_by_number(&mut near, |a| a.0);
    near.iter().take(NEAREST).map(|(_, error)| *error).reduce(f64::max).unwrap_or(f64::INFINITY)
}
