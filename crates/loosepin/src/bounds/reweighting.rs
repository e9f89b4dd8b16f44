//! The runs at a few u, weighted, in place of runs at many: where u is nothing but parameters of distributions.
//!
//! Then the response does not know u, and the runs at all outer points are one pool from the mixture of their distributions. At any
//! other u, with f the density of the random inputs that parameters belong to,
//!
//! ```text
//! q(x) = 1/K Σ_k f(x; u_k),   w_i = f(x_i; u)/q(x_i) over its sum,   E h(Y) ≈ E h(p(X)) + Σ_i w_i (h(y_i) - h(p(x_i)))
//! ```
//!
//! (A. Owen and Y. Zhou, "Safe and effective importance sampling", Journal of the American Statistical Association 95 (2000)
//! 135-143: weights from a mixture are never above K where u is one of its members, and a control variate takes out what it
//! explains; here p, a polynomial of the random inputs that each replicate takes from the others, or a constant where nothing better is
//! known. E h(p(X)) is taken at points at u, which cost no run.)
//!
//! What is wanted of u is by how much it lies beyond the outer point w that attains a bound. Both are estimated from the same pool, so
//! that near w their errors cancel:
//!
//! ```text
//! D(u) = S(u) - S(w), from each replicate its own;   S(u) <= S(w) + mean of D + t · its standard error
//! ```
//!
//! The bound keeps the value of the runs at w itself. At every u the weights must be worth enough independent runs,
//!
//! ```text
//! n = min((Σ w)²/Σ w²,  N/E_u(w)),   the first from the pool (L. Kish 1965), the second from points at u: it also sees what the pool misses
//! ```
//!
//! else nothing is said there: more runs are made at such a u, and where that does not help the search goes by its models alone.

use std::collections::BTreeMap;
use std::sync::Arc;

use rayon::prelude::*;

use super::inner_basis::{CrossFit, Design, InnerBasis};
use super::measure::{Event, Sought};
use super::moments::{mean, standard_deviation, variance};
use super::orthogonal::Axis;
use super::plan::DoubleLoop;
use super::pool::Pool;
use super::probability::wilson;
use super::problem::Problem;
use super::quantile::quantile;
use super::sample::{Confidence, Estimate, Sample, replicate_error};
use super::search::Direction;
use super::search_box::{Axes, Place, Region, SearchBox};
use super::smooth::smooth;
use crate::uncertainty::{Level, RandomVariable};

/// Weights must be worth so many independent runs.
const LEAST_EFFECTIVE: f64 = 64.0;
/// Of these so many must lie beyond a quantile.
const LEAST_BEYOND: f64 = 4.0;
/// Points at each u at which the polynomials are asked, in each replicate; where there are many columns.
const POINTS: usize = 128;
const POINTS_OF_CURVES: usize = 64;
/// More columns than this are those of curves.
const MANY_COLUMNS: usize = 8;
/// Places of each combination of the members of lists that are compared, about; where there are many columns.
const PLACES: usize = 128;
const PLACES_OF_CURVES: usize = 48;
/// Around each outer point these distances along each axis are compared too, in units of the box.
const NEIGHBOUR_DISTANCES: [f64; 3] = [0.1, 0.02, 0.004];
const MOST_NEIGHBOURHOODS: usize = 16;
/// The furthest place is moved on by steps from the first length down to the last.
const FIRST_STEP: f64 = 0.05;
const LAST_STEP: f64 = 1e-4;
/// Polynomials of a higher degree only stand for a response that they follow everywhere.
const MOST_DEGREE_BESIDE: usize = 4;
/// A polynomial of a higher degree must leave less of the squares by this factor: else it follows what it should not.
const CLEARLY_LESS: f64 = 0.7;
/// Polynomials that leave no more than this share of the deviation of the pool at any run stand for the response; between the runs it
/// may be more, by the second factor.
const LARGEST_RESIDUAL: f64 = 1e-4;
const RESIDUAL_MARGIN: f64 = 2.0;
/// The worth of weights is seen from this many points at a place, at most.
const MOST_POINTS_AT_A_PLACE: usize = 256;
/// A share with fewer hits or misses in each replicate of the pool has no error from the spread of the replicates.
const LEAST_PER_REPLICATE: usize = 2;
/// Halvings of the range in which a quantile may lie.
const HALVINGS: usize = 30;

/// One place and the pool as it is seen from there.
#[derive(Debug)]
struct Seen {
    place: Place,
    /// Weights of all runs, replicate by replicate; their sum is 1.
    weights: Vec<f64>,
    /// Independent runs that would know as much.
    effective: f64,
}

/// By how much a statistic may lie beyond at a place; nothing where the pool cannot tell.
type Gain<'s> = Box<dyn Fn(usize) -> Option<f64> + Sync + 's>;

/// All outer points, then the places that they are compared with.
#[derive(Debug)]
struct View {
    outer: usize,
    seen: Vec<Seen>,
    replicates: usize,
    /// Runs of one replicate, and points of one at each place.
    runs: usize,
    points: usize,
}

/// One column of the pool.
#[derive(Debug)]
pub(super) struct Pooled {
    view: Arc<View>,
    /// Values of the runs, replicate by replicate.
    values: Vec<f64>,
    /// Those of the polynomials, each replicate by the other ones.
    explained: Vec<f64>,
    /// The polynomials at points at each place, replicate by replicate.
    expected: Vec<Vec<f64>>,
    /// Where the polynomials stand for the response.
    smooth: Option<StandIn>,
}

/// Polynomials that stand for the response at every u.
#[derive(Debug)]
struct StandIn {
    ground: Arc<Ground>,
    design: Arc<Design>,
    fit: CrossFit,
    /// A sample at each place.
    samples: Vec<Sample>,
    /// How far the response may be from them.
    left: f64,
}

/// How runs were weighted for values of the epistemic inputs at which none were made.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reweighted {
    /// Outer points, whose runs are the pool.
    pub points: usize,
    /// Places that they were compared with.
    pub places: usize,
    /// To how many independent runs the weights come at least, over these.
    pub least_effective: f64,
    /// Columns whose response polynomials stand for.
    pub polynomials: usize,
    /// Columns that were compared.
    pub columns: usize,
    /// Ends of bounds, distribution functions and bands whose search the weighted runs confirm.
    pub told: usize,
    /// Those that the weights are worth too little for: the models of the search alone tell how far these may go.
    pub untold: usize,
}

/// A place beyond an extreme, as far as is known.
#[derive(Debug, Clone)]
pub(super) struct Beyond {
    /// How far the statistic may lie beyond that at the outer point, in units of what is searched; 0 where it does not.
    pub gain: f64,
    /// Where.
    pub place: Place,
}

impl Pool {
    /// How the runs were weighted; nothing where they were not. `told` and `untold` are counted by whoever asks.
    pub fn reweighted(&self, told: usize, untold: usize) -> Option<Reweighted> {
        let first = self.points.first()?;
        let pooled: Vec<&Pooled> =
            self.column_numbers().filter_map(|column| self.samples(column).first()?.pooled()).collect();
        let view = &pooled.first()?.view;
        debug_assert_eq!(view.runs * view.replicates, first.runs * self.points.len());
        Some(Reweighted {
            points: view.outer,
            places: view.seen.len() - view.outer,
            least_effective: view.seen.iter().fold(f64::INFINITY, |least, seen| least.min(seen.effective)),
            polynomials: pooled.iter().filter(|pooled| pooled.is_smooth()).count(),
            columns: self.columns(),
            told,
            untold,
        })
    }

    /// The same with all runs weighted for other u, column by column, where the plan allows that and no run failed.
    pub fn with_weights(mut self, plan: &DoubleLoop) -> Self {
        if self.points.len() > plan.most_reweighted() || self.points.is_empty() {
            return self;
        }
        let many = self.columns() > MANY_COLUMNS;
        let Some(ground) = Ground::new(plan, &self, many).map(Arc::new) else { return self };
        let designs = ground.designs();
        let view = Arc::new(ground.view());
        let columns: Vec<usize> = self.column_numbers().collect();
        let pooled: Vec<Option<Arc<Pooled>>> = columns
            .par_iter()
            .map(|&column| Pooled::new(&ground, &designs, &view, &self.samples(column)).map(Arc::new))
            .collect();
        let pooled: BTreeMap<usize, Arc<Pooled>> =
            columns.into_iter().zip(pooled).filter_map(|(column, pooled)| Some((column, pooled?))).collect();
        for (column, pooled) in pooled {
            for sample in self.samples_mut(column) {
                sample.set_pooled(pooled.clone());
            }
        }
        self
    }
}

/// What is known of the runs and places before any column is looked at.
#[derive(Debug)]
struct Ground {
    problem: Problem,
    epistemic_box: SearchBox,
    basis: Option<Arc<InnerBasis>>,
    replicates: usize,
    /// Runs of one replicate at one outer point.
    each: usize,
    runs: usize,
    points: usize,
    /// Inputs with parameters.
    moving: Vec<usize>,
    /// Their values at all runs, replicate by replicate.
    drawn: Vec<Vec<f64>>,
    /// The least and the greatest of these, input by input.
    ranges: Vec<[f64; 2]>,
    axes: Vec<Axis>,
    /// Coordinates of all runs, replicate by replicate.
    coordinates: Vec<Vec<f64>>,
    /// Points of the unit cube, as many in each replicate as are asked for anything: coordinates, and the levels of the moving inputs.
    asked: Vec<(Vec<f64>, Vec<Level>)>,
    places: Vec<Place>,
    variables: Vec<Vec<RandomVariable>>,
}

impl Ground {
    fn new(plan: &DoubleLoop, pool: &Pool, many: bool) -> Option<Self> {
        let problem = plan.problem();
        let replicates = problem.sampling.replicates;
        let moving = problem.inputs_with_parameters();
        let outer = plan.outer_places(pool);
        let most = if many { PLACES_OF_CURVES } else { PLACES };
        let stride = plan.candidates().len().div_ceil(most);
        let mut places = outer.clone();
        for combination in 0..plan.box_combinations() {
            let at = plan.candidates().iter().step_by(stride).cloned();
            places.extend(at.map(|at| Place { combination, at }));
        }
        let axes_of_box = plan.epistemic_box().axes();
        for place in outer.iter().take(MOST_NEIGHBOURHOODS) {
            for step in NEIGHBOUR_DISTANCES.into_iter().flat_map(|distance| [distance, -distance]) {
                for axis in 0..place.at.len() {
                    let mut at = place.at.clone();
                    at[axis] = axes_of_box.inside(axis, at[axis] + step, [0.0, 1.0]);
                    if at != place.at {
                        places.push(Place { combination: place.combination, at });
                    }
                }
            }
        }
        let variables: Option<Vec<Vec<RandomVariable>>> = places
            .iter()
            .map(|place| {
                let epistemic = plan.epistemic_box().values_at(place);
                moving.iter().map(|&input| problem.variable_at(input, &epistemic)).collect()
            })
            .collect();
        let variables = variables?;
        let each = plan.inner_runs() / replicates;
        let points = if many { POINTS_OF_CURVES } else { POINTS };
        let cube = plan.inner_cube(each.max(points));
        let per = cube.len() / replicates;
        let of_replicate = |replicate: usize, count: usize| &cube[replicate * per..replicate * per + count];
        let values = |own: &[RandomVariable], levels: &[Level]| -> Vec<f64> {
            moving.iter().zip(own).map(|(&input, variable)| variable.at(levels[input])).collect()
        };
        let mut drawn = Vec::new();
        let mut cubes: Vec<&Vec<f64>> = Vec::new();
        for replicate in 0..replicates {
            for own in &variables[..outer.len()] {
                for point in of_replicate(replicate, each) {
                    drawn.push(values(own, &problem.levels(point)));
                    cubes.push(point);
                }
            }
        }
        let ranges: Vec<[f64; 2]> = (0..moving.len())
            .map(|k| drawn.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[l, h], x| [l.min(x[k]), h.max(x[k])]))
            .collect();
        if ranges.iter().any(|[low, high]| !(high > low && (high - low).is_finite())) {
            return None;
        }
        let mut axes = plan.random_axes();
        for &input in &moving {
            axes[input] = Axis::Legendre;
        }
        let fixed = |point: &[f64]| -> Vec<f64> {
            point.iter().zip(&axes).map(|(&omega, axis)| axis.coordinate(omega)).collect()
        };
        let mut ground = Self {
            problem: problem.clone(),
            epistemic_box: plan.epistemic_box().clone(),
            basis: plan.inner_basis_shared(),
            replicates,
            each,
            runs: outer.len() * each,
            points,
            coordinates: Vec::new(),
            asked: cube
                .iter()
                .map(|point| {
                    let levels = problem.levels(point);
                    (fixed(point), moving.iter().map(|&input| levels[input]).collect())
                })
                .collect(),
            moving,
            ranges,
            drawn,
            axes: axes.clone(),
            places,
            variables,
        };
        ground.coordinates =
            cubes.iter().zip(&ground.drawn).map(|(point, drawn)| ground.moved(fixed(point), drawn)).collect();
        Some(ground)
    }

    /// Coordinates with those of the moving inputs from their values: from -1 to 1 over all runs.
    fn moved(&self, mut coordinates: Vec<f64>, values: &[f64]) -> Vec<f64> {
        for ((&input, value), [low, high]) in self.moving.iter().zip(values).zip(&self.ranges) {
            coordinates[input] = 2.0 * (value - low) / (high - low) - 1.0;
        }
        coordinates
    }

    /// Polynomials on the pool, from the lowest degree to the highest.
    fn designs(&self) -> Vec<Arc<Design>> {
        let design = |degree| Design::new(&self.axes, degree, &self.coordinates, self.replicates).map(Arc::new);
        (1..=super::inner_basis::MOST_DEGREE).map_while(design).collect()
    }

    fn outer(&self) -> usize {
        self.runs / self.each
    }

    /// f at these values of the moving inputs.
    fn density(variables: &[RandomVariable], values: &[f64]) -> f64 {
        variables.iter().zip(values).map(|(variable, &x)| variable.density(x).unwrap_or(f64::NAN)).product()
    }

    fn mixture(&self, values: &[f64]) -> f64 {
        let members = &self.variables[..self.outer()];
        members.iter().map(|own| Self::density(own, values)).sum::<f64>() / members.len() as f64
    }

    fn view(&self) -> View {
        let drawn: Vec<f64> = self.drawn.par_iter().map(|values| self.mixture(values)).collect();
        let seen = self
            .places
            .par_iter()
            .zip(&self.variables)
            .map(|(place, own)| {
                let mut weights: Vec<f64> =
                    self.drawn.iter().zip(&drawn).map(|(values, q)| Self::density(own, values) / q).collect();
                let sum: f64 = weights.iter().sum();
                let square: f64 = weights.iter().map(|w| w * w).sum();
                let kish = sum * sum / square;
                // Where the pool does not go the weights of its runs say nothing: the same from points at u itself.
                let at_place = |(_, levels): &(Vec<f64>, Vec<Level>)| {
                    let values: Vec<f64> = own.iter().zip(levels).map(|(v, &level)| v.at(level)).collect();
                    Self::density(own, &values) / self.mixture(&values)
                };
                let some = || self.asked.iter().step_by(self.asked.len().div_ceil(MOST_POINTS_AT_A_PLACE));
                let expected = some().map(at_place).sum::<f64>() / some().count() as f64;
                let effective = kish.min(weights.len() as f64 / expected);
                for weight in &mut weights {
                    *weight /= sum;
                }
                Seen { place: place.clone(), weights, effective: if effective.is_finite() { effective } else { 0.0 } }
            })
            .collect();
        View { outer: self.outer(), seen, replicates: self.replicates, runs: self.runs, points: self.points }
    }

    /// What the polynomials of every replicate give at its first `count` points at a place; not beyond the values of the runs where
    /// `is_held`.
    fn expected(
        &self,
        (design, fit): (&Design, &CrossFit),
        variables: &[RandomVariable],
        count: usize,
        is_held: bool,
    ) -> Vec<f64> {
        let each = self.asked.len() / self.replicates;
        let value = |replicate: usize, (coordinates, levels): &(Vec<f64>, Vec<Level>)| {
            let own = variables.iter().zip(levels).zip(&self.ranges);
            let inside = |x: f64, [low, high]: &[f64; 2]| if is_held { x.clamp(*low, *high) } else { x };
            let values: Vec<f64> = own.map(|((v, &level), range)| inside(v.at(level), range)).collect();
            design.value(&fit.coefficients[replicate], &self.moved(coordinates.clone(), &values))
        };
        let of_replicate = |replicate: usize| {
            let own = &self.asked[replicate * each..replicate * each + count];
            own.iter().map(move |point| value(replicate, point))
        };
        (0..self.replicates).flat_map(of_replicate).collect()
    }
}

impl StandIn {
    /// The sample at `variables`, without its polynomials.
    fn sample(ground: &Ground, by: (&Design, &CrossFit), variables: &[RandomVariable]) -> Sample {
        let values = ground.expected(by, variables, ground.each, false);
        Sample::new(values.chunks(ground.each).map(|own| own.iter().copied()))
    }

    /// The sample at `place`; nothing where the polynomials are not smooth there.
    fn at(&self, place: &Place) -> Option<Sample> {
        let ground = &self.ground;
        let epistemic = ground.epistemic_box.values_at(place);
        let variables: Option<Vec<RandomVariable>> =
            ground.moving.iter().map(|&input| ground.problem.variable_at(input, &epistemic)).collect();
        let mut sample = Self::sample(ground, (&self.design, &self.fit), &variables?);
        smooth(ground.basis.as_deref()?, &mut [&mut sample]);
        sample.smooth().is_some().then_some(sample)
    }
}

impl Pooled {
    fn new(ground: &Arc<Ground>, designs: &[Arc<Design>], view: &Arc<View>, samples: &[&Sample]) -> Option<Self> {
        if samples.iter().any(|sample| sample.failed() > 0) {
            return None;
        }
        let each = ground.each;
        let mut values = Vec::with_capacity(ground.drawn.len());
        for replicate in 0..ground.replicates {
            for sample in samples {
                values.extend_from_slice(&sample.values()[replicate * each..(replicate + 1) * each]);
            }
        }
        let square = |values: &[f64]| values.iter().map(|value| value * value).sum::<f64>();
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        let spread = values.iter().map(|value| (value - mean) * (value - mean)).sum::<f64>();
        let best = |most_degree: usize| {
            let mut least = spread;
            let mut best: Option<(&Arc<Design>, CrossFit)> = None;
            for design in designs.iter().filter(|design| design.degree <= most_degree) {
                let fit = design.fit(&values);
                let left = square(&fit.residuals);
                if left < CLEARLY_LESS * least {
                    least = left;
                    best = Some((design, fit));
                }
            }
            best
        };
        let places = 0..view.seen.len();
        let deviation = (spread / values.len() as f64).sqrt();
        let is_asked = samples.iter().all(|sample| sample.smooth().is_some());
        if let Some((design, fit)) = is_asked.then(|| best(usize::MAX)).flatten() {
            let left = fit.residuals.iter().fold(0.0_f64, |most, left| most.max(left.abs()));
            let sample = |place: usize| StandIn::sample(ground, (design, &fit), &ground.variables[place]);
            if let Some(basis) = ground.basis.as_deref().filter(|_| left <= LARGEST_RESIDUAL * deviation) {
                let mut at: Vec<Sample> = places.clone().into_par_iter().map(sample).collect();
                smooth(basis, &mut at.iter_mut().collect::<Vec<_>>());
                if at.iter().all(|sample| sample.smooth().is_some()) {
                    let (design, left) = (design.clone(), RESIDUAL_MARGIN * left);
                    let smooth = Some(StandIn { ground: ground.clone(), design, fit, samples: at, left });
                    let (explained, expected) = (Vec::new(), Vec::new());
                    return Some(Self { view: view.clone(), values, explained, expected, smooth });
                }
            }
        }
        let Some((design, fit)) = best(MOST_DEGREE_BESIDE) else {
            let expected = vec![vec![mean; ground.points * ground.replicates]; view.seen.len()];
            let explained = vec![mean; values.len()];
            return Some(Self { view: view.clone(), values, explained, expected, smooth: None });
        };
        let explained = values.iter().zip(&fit.residuals).map(|(value, left)| value - left).collect();
        let at = |place: usize| ground.expected((design, &fit), &ground.variables[place], ground.points, true);
        let expected = places.into_par_iter().map(at).collect();
        Some(Self { view: view.clone(), values, explained, expected, smooth: None })
    }

    /// Whether the polynomials stand for the response.
    pub fn is_smooth(&self) -> bool {
        self.smooth.is_some()
    }

    /// By how much the statistic of `sample` may lie beyond `value`, where the response is within `left` of it.
    fn smooth_gain(
        (sample, left): (&Sample, f64),
        sought: Sought,
        direction: Direction,
        value: f64,
        confidence: &Confidence,
    ) -> Option<f64> {
        let sign = direction.sign();
        let outward = |at: Estimate| {
            let error = if direction == Direction::Maximum { at.above } else { at.below };
            sign * at.value + error
        };
        let gain = match sought {
            Sought::Mean => outward(mean(sample, confidence)) + left - sign * value,
            Sought::Variance => {
                let deviation = (sign * (outward(standard_deviation(variance(sample, confidence))) + left)).max(0.0);
                sign * (deviation * deviation - value * value)
            }
            Sought::Quantile(probability) => {
                let at = quantile(sample, confidence, probability);
                outward(if direction == Direction::Maximum { at.high } else { at.low }) + left - sign * value
            }
            Sought::Probability(event) => {
                let smooth = sample.smooth()?;
                let moved = [left, -left].map(|shift| outward(smooth.probability(event, shift)));
                moved[0].max(moved[1]) - sign * value
            }
        };
        Some(gain)
    }

    /// E h(Y) at `place` as each replicate sees it.
    fn expectation(&self, place: usize, h: impl Fn(f64) -> f64) -> Vec<f64> {
        let View { replicates, runs, points, ref seen, .. } = *self.view;
        let weights = &seen[place].weights;
        let change = |run: usize| h(self.values[run]) - h(self.explained[run]);
        let total: f64 = weights.iter().enumerate().map(|(run, w)| w * change(run)).sum();
        (0..replicates)
            .map(|replicate| {
                let own = replicate * runs..(replicate + 1) * runs;
                let beyond: f64 = own.map(|run| weights[run] * (change(run) - total)).sum();
                let asked = &self.expected[place][replicate * points..(replicate + 1) * points];
                let expected = asked.iter().map(|&value| h(value)).sum::<f64>() / points as f64;
                expected + total + replicates as f64 * beyond
            })
            .collect()
    }

    /// Independent runs that the weights must be worth.
    fn needed(&self, sought: Sought) -> f64 {
        match sought {
            // Polynomials only need runs wherever they are asked.
            _ if self.is_smooth() => LEAST_EFFECTIVE,
            Sought::Quantile(probability) => (LEAST_BEYOND / probability.min(1.0 - probability)).max(LEAST_EFFECTIVE),
            Sought::Mean | Sought::Variance | Sought::Probability(_) => LEAST_EFFECTIVE,
        }
    }

    /// The place in `region` where the weights are worth least, if that is too little for the statistic.
    fn unseen(&self, sought: Sought, region: &Region) -> Option<&Seen> {
        let needed = self.needed(sought);
        let own = self.view.seen.iter().filter(|seen| region.holds(&seen.place.at) && seen.effective < needed);
        own.min_by(|a, b| a.effective.total_cmp(&b.effective))
    }

    /// Where the statistic, `value` at the outer point `witness`, goes furthest beyond that in `region`, errors conceded.
    ///
    /// # Errors
    ///
    /// A place at which the pool cannot tell.
    pub fn furthest(
        &self,
        sought: Sought,
        direction: Direction,
        (witness, value): (usize, f64),
        region: &Region,
        confidence: &Confidence,
    ) -> Result<Beyond, Place> {
        if let Some(seen) = self.unseen(sought, region) {
            return Err(seen.place.clone());
        }
        let places: Vec<usize> =
            (0..self.view.seen.len()).filter(|&k| region.holds(&self.view.seen[k].place.at)).collect();
        let gain: Gain<'_> = match &self.smooth {
            Some(stand_in) => Box::new(move |place| {
                // The runs at an outer point speak for themselves.
                if place < self.view.outer {
                    return Some(0.0);
                }
                let sample = (&stand_in.samples[place], stand_in.left);
                Self::smooth_gain(sample, sought, direction, value, confidence)
            }),
            None => self.weighted_gain(sought, direction, (witness, value), confidence),
        };
        let gains: Result<Vec<f64>, Place> =
            places.par_iter().map(|&place| gain(place).ok_or_else(|| self.view.seen[place].place.clone())).collect();
        let mut beyond = Beyond { gain: 0.0, place: self.view.seen[witness].place.clone() };
        for (&place, gain) in places.iter().zip(gains?) {
            if gain > beyond.gain {
                beyond = Beyond { gain, place: self.view.seen[place].place.clone() };
            }
        }
        if let Some(stand_in) = &self.smooth {
            let gain = |place: &Place| {
                let sample = stand_in.at(place)?;
                Self::smooth_gain((&sample, stand_in.left), sought, direction, value, confidence)
            };
            // From the outer point as well, whose own gain is 0 by its runs.
            let from = [beyond.place.clone(), self.view.seen[witness].place.clone()];
            for place in from {
                let climbed = climb(stand_in.ground.epistemic_box.axes(), place, region, &gain);
                if climbed.gain > beyond.gain {
                    beyond = climbed;
                }
            }
        }
        Ok(beyond)
    }

    /// How far `h` of the response may go in `direction` at the outer point `witness` itself, in units of what is searched, by the runs of
    /// all points: those at this point alone may agree by chance (each replicate of a stratified sample meets a jump as often as the
    /// others). Nothing where polynomials stand for the response, and for shares, whose errors know that.
    pub fn outermost(
        &self,
        sought: Sought,
        direction: Direction,
        witness: usize,
        confidence: &Confidence,
    ) -> Option<f64> {
        if self.is_smooth() {
            return None;
        }
        let plain = self.expectation(witness, |y| y);
        let at = match sought {
            Sought::Mean => plain,
            Sought::Variance => {
                let centre = average(&plain);
                self.expectation(witness, |y| (y - centre) * (y - centre))
            }
            Sought::Quantile(_) | Sought::Probability(_) => return None,
        };
        Some(direction.sign() * beyond(&at, &vec![0.0; at.len()], direction, confidence))
    }

    fn weighted_gain<'s>(
        &'s self,
        sought: Sought,
        direction: Direction,
        (witness, value): (usize, f64),
        confidence: &'s Confidence,
    ) -> Gain<'s> {
        match sought {
            Sought::Mean => self.gain(direction, witness, confidence, |_| Some(|y: f64| y)),
            Sought::Variance => self.gain(direction, witness, confidence, |place| {
                let centre = average(&self.expectation(place, |y| y));
                Some(move |y: f64| (y - centre) * (y - centre))
            }),
            Sought::Probability(event) => self.share_gain(direction, witness, confidence, event),
            Sought::Quantile(_) => self.quantile_gain(direction, (witness, value), confidence),
        }
    }

    /// By how much E h(Y) may lie beyond that at `witness`.
    fn gain<'s, H: Fn(f64) -> f64 + 's>(
        &'s self,
        direction: Direction,
        witness: usize,
        confidence: &'s Confidence,
        h: impl Fn(usize) -> Option<H> + Sync + 's,
    ) -> Gain<'s> {
        let at_witness = h(witness).map(|h| self.expectation(witness, h));
        Box::new(move |place| {
            Some(beyond(&self.expectation(place, h(place)?), at_witness.as_ref()?, direction, confidence))
        })
    }

    /// The same for a probability; nothing where the pool holds too few hits or misses.
    fn share_gain<'s>(
        &'s self,
        direction: Direction,
        witness: usize,
        confidence: &'s Confidence,
        event: Event,
    ) -> Gain<'s> {
        let hits = self.values.iter().filter(|&&value| event.holds(value)).count();
        let least = LEAST_PER_REPLICATE * self.view.replicates;
        if hits < least || self.values.len() - hits < least {
            return Box::new(|_| None);
        }
        let indicator = move |y: f64| if event.holds(y) { 1.0 } else { 0.0 };
        let paired = self.gain(direction, witness, confidence, move |_| Some(indicator));
        let at_witness = average(&self.expectation(witness, indicator));
        Box::new(move |place| {
            // Where hardly any weight lies on hits the spread of the replicates is too small: not less than as many independent runs.
            let seen = &self.view.seen[place];
            let weight = |k: usize| {
                let own = self.view.seen[k].weights.iter().zip(&self.values);
                own.filter(|(_, value)| event.holds(**value)).map(|(w, _)| w).sum::<f64>()
            };
            let share = weight(place);
            let independent = wilson(share, seen.effective, confidence.normal);
            let is_counted = (share.min(1.0 - share) * seen.effective) >= least as f64;
            let far = if is_counted || place == witness {
                0.0
            } else {
                match direction {
                    Direction::Maximum => independent.1 - at_witness,
                    Direction::Minimum => at_witness - independent.0,
                }
            };
            Some(paired(place)?.max(far))
        })
    }

    /// How far the quantile may lie beyond `value`, that at `witness`: the distribution function there, its error conceded, must have
    /// reached the probability.
    fn quantile_gain<'s>(
        &'s self,
        direction: Direction,
        (witness, value): (usize, f64),
        confidence: &'s Confidence,
    ) -> Gain<'s> {
        let indicator = |limit: f64| move |y: f64| if y <= limit { 1.0 } else { 0.0 };
        let at_witness = self.expectation(witness, indicator(value));
        let sign = direction.sign();
        let outermost =
            self.values.iter().chain(self.expected.iter().flatten()).map(|y| sign * y).fold(f64::MIN, f64::max);
        Box::new(move |place| {
            if place == witness {
                return Some(0.0);
            }
            let opposite = if direction == Direction::Maximum { Direction::Minimum } else { Direction::Maximum };
            // F(x) at the place less that of `value` at the witness, which is the probability.
            let is_reached =
                |x: f64| beyond(&self.expectation(place, indicator(x)), &at_witness, opposite, confidence) <= 0.0;
            if is_reached(value) {
                return Some(0.0);
            }
            let (mut near, mut far) = (value, sign * outermost);
            if !(sign * (far - near) > 0.0) || !is_reached(far) {
                return None;
            }
            for _ in 0..HALVINGS {
                let middle = 0.5 * (near + far);
                if is_reached(middle) { far = middle } else { near = middle }
            }
            Some((sign * (far - value)).max(0.0))
        })
    }
}

/// The nearest place of `region` from which no step along an axis gains; it gains without limit where nothing is known.
fn climb(axes: &Axes, mut place: Place, region: &Region, gain: &impl Fn(&Place) -> Option<f64>) -> Beyond {
    let gain = |place: &Place| gain(place).unwrap_or(f64::INFINITY);
    let mut best = gain(&place);
    let mut step = FIRST_STEP;
    while step >= LAST_STEP {
        let mut has_moved = false;
        for axis in 0..place.at.len() {
            for signed in [step, -step] {
                let mut trial = place.clone();
                trial.at[axis] = axes.inside(axis, trial.at[axis] + signed, [region.lower[axis], region.upper[axis]]);
                if trial.at[axis] == place.at[axis] {
                    continue;
                }
                let at_trial = gain(&trial);
                if at_trial > best {
                    (best, place, has_moved) = (at_trial, trial, true);
                    break;
                }
            }
        }
        if !has_moved {
            step *= 0.25;
        }
    }
    Beyond { gain: best, place }
}

/// By how much the mean of one number a replicate may lie beyond that of others, from the differences of both.
fn beyond(at: &[f64], other: &[f64], direction: Direction, confidence: &Confidence) -> f64 {
    let differences: Vec<f64> = at.iter().zip(other).map(|(a, b)| a - b).collect();
    let (below, above) = replicate_error(&differences, confidence);
    match direction {
        Direction::Maximum => average(&differences) + above,
        Direction::Minimum => below - average(&differences),
    }
}

fn average(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}
