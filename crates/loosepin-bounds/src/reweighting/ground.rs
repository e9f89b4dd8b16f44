//! The pool of runs, the places that it is seen from, and its weights there.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use rayon::prelude::*;

use super::weights::{Layout, Seen, kish};
use crate::inner_basis::{CrossFit, Design, InnerBasis, MOST_DEGREE};
use crate::orthogonal::Axis;
use crate::plan::DoubleLoop;
use crate::pool::Pool;
use crate::problem::Problem;
use crate::search_box::{Place, SearchBox};
use crate::table::SampleTable;
use loosepin_uncertainty::{Level, RandomVariable};

/// Points at each u at which the polynomials are asked, in each replicate; where there are many columns.
const POINTS: usize = 128;
const POINTS_OF_CURVES: usize = 64;
/// Places of each combination of the members of lists that are compared, about; where there are many columns.
const PLACES: usize = 128;
const PLACES_OF_CURVES: usize = 24;
/// The worth of weights is seen from this many points at a place, at most.
const MOST_POINTS_AT_A_PLACE: usize = 256;

/// Places that were looked at since the first ones, by combination and coordinates.
type LookedAt = BTreeMap<(usize, Vec<u64>), Arc<Seen>>;

/// What is known of the runs and places before any column is looked at.
#[derive(Debug)]
pub struct Ground {
    problem: Problem,
    pub epistemic_box: SearchBox,
    pub basis: Option<Arc<InnerBasis>>,
    pub layout: Layout,
    /// Points of each replicate at which polynomials are asked.
    pub points: usize,
    /// Whether there are many columns.
    pub is_of_curves: bool,
    /// Inputs with parameters.
    moving: Vec<usize>,
    /// Their values at all runs, replicate by replicate.
    drawn: Vec<Vec<f64>>,
    /// q at all runs.
    densities: Vec<f64>,
    /// The least and the greatest of these, input by input.
    ranges: Vec<[f64; 2]>,
    axes: Vec<Axis>,
    /// Coordinates of all runs, replicate by replicate.
    coordinates: Vec<Vec<f64>>,
    /// Points of the unit cube, as many in each replicate as are asked for anything: coordinates, and the levels of the moving inputs.
    asked: Vec<(Vec<f64>, Vec<Level>)>,
    /// Distributions of the moving inputs at every outer point.
    members: Vec<Vec<RandomVariable>>,
    /// All outer points, then the places that they are compared with.
    pub seen: Vec<Arc<Seen>>,
    /// Those that were looked at since; columns share them.
    more: Mutex<LookedAt>,
}

impl Ground {
    /// The runs of `pool`, gathered from `table`, and the places that they are compared with: fewer where there are `many` columns.
    /// Nothing where a value of the parameters describes no distribution.
    pub fn new(plan: &DoubleLoop, table: &SampleTable, pool: &Pool, many: bool) -> Option<Self> {
        let problem = plan.problem();
        let moving = problem.inputs_with_parameters();
        let replicates = problem.sampling.replicates;
        let layout = Layout { replicates, outer: pool.points.len(), each: plan.inner_runs() / replicates };
        let drawn = drawn(table, pool, layout, &moving);
        let ranges = ranges(&drawn, moving.len())?;
        let mut axes = plan.random_axes();
        for &input in &moving {
            axes[input] = Axis::Legendre;
        }
        let points = if many { POINTS_OF_CURVES } else { POINTS };
        let cube = plan.inner_cube(layout.each.max(points));
        let fixed: Vec<Vec<f64>> = cube
            .iter()
            .map(|point| point.iter().zip(&axes).map(|(&omega, axis)| axis.coordinate(omega)).collect())
            .collect();
        let asked = |(point, coordinates): (&Vec<f64>, &Vec<f64>)| {
            let levels = problem.levels(point);
            (coordinates.clone(), moving.iter().map(|&input| levels[input]).collect())
        };
        let mut ground = Self {
            problem: problem.clone(),
            epistemic_box: plan.epistemic_box().clone(),
            basis: plan.inner_basis_shared(),
            layout,
            points,
            is_of_curves: many,
            asked: cube.iter().zip(&fixed).map(asked).collect(),
            moving,
            drawn,
            densities: Vec::new(),
            ranges,
            axes,
            coordinates: Vec::new(),
            members: Vec::new(),
            seen: Vec::new(),
            more: Mutex::default(),
        };
        let outer = plan.outer_places(pool);
        ground.members = outer.iter().map(|place| ground.variables(place)).collect::<Option<_>>()?;
        ground.coordinates = ground.coordinates_of_runs(&fixed);
        ground.densities = ground.drawn.par_iter().map(|values| ground.mixture(values)).collect();
        let compared = compared(plan, if many { PLACES_OF_CURVES } else { PLACES });
        let places: Vec<Place> = outer.into_iter().chain(compared).collect();
        ground.seen = places.par_iter().map(|place| ground.see(place).map(Arc::new)).collect::<Option<_>>()?;
        Some(ground)
    }

    /// Coordinates of all runs, from those of the points of the unit cube.
    fn coordinates_of_runs(&self, fixed: &[Vec<f64>]) -> Vec<Vec<f64>> {
        let per = fixed.len() / self.layout.replicates;
        let of_run = |(run, values): (usize, &Vec<f64>)| {
            let (replicate, index) = (run / self.layout.runs(), run % self.layout.each);
            self.moved(fixed[replicate * per + index].clone(), values)
        };
        self.drawn.iter().enumerate().map(of_run).collect()
    }

    /// Coordinates with those of the moving inputs from their values: from -1 to 1 over all runs.
    fn moved(&self, mut coordinates: Vec<f64>, values: &[f64]) -> Vec<f64> {
        for ((&input, value), [low, high]) in self.moving.iter().zip(values).zip(&self.ranges) {
            coordinates[input] = 2.0 * (value - low) / (high - low) - 1.0;
        }
        coordinates
    }

    /// Polynomials on the pool, from the lowest degree to the highest.
    pub fn designs(&self) -> Vec<Arc<Design>> {
        let replicates = self.layout.replicates;
        let design = |degree| Design::new(&self.axes, degree, &self.coordinates, replicates).map(Arc::new);
        (1..=MOST_DEGREE).map_while(design).collect()
    }

    /// Distributions of the moving inputs at a place; nothing where its parameters describe none.
    pub fn variables(&self, place: &Place) -> Option<Vec<RandomVariable>> {
        let epistemic = self.epistemic_box.values_at(place);
        self.moving.iter().map(|&input| self.problem.variable_at(input, &epistemic)).collect()
    }

    /// q at these values of the moving inputs.
    fn mixture(&self, values: &[f64]) -> f64 {
        self.members.iter().map(|own| density(own, values)).sum::<f64>() / self.members.len() as f64
    }

    /// The pool from `place`, worked out once.
    pub fn seen_from(&self, place: &Place) -> Option<Arc<Seen>> {
        let key = (place.combination, place.at.iter().map(|x| x.to_bits()).collect::<Vec<u64>>());
        let known = self.more.lock().unwrap_or_else(PoisonError::into_inner).get(&key).cloned();
        if known.is_some() {
            return known;
        }
        let seen = Arc::new(self.see(place)?);
        self.more.lock().unwrap_or_else(PoisonError::into_inner).insert(key, seen.clone());
        Some(seen)
    }

    /// The weights of all runs at a place, and what they are worth there.
    fn see(&self, place: &Place) -> Option<Seen> {
        let own = self.variables(place)?;
        let mut weights: Vec<f64> =
            self.drawn.iter().zip(&self.densities).map(|(values, q)| density(&own, values) / q).collect();
        let [draws, values] = [kish(&self.layout.by_row(|run| weights[run])), kish(&weights)];
        // Where the pool does not go the weights of its runs say nothing: the same from points at u itself.
        let at_place = |(_, levels): &(Vec<f64>, Vec<Level>)| {
            let values: Vec<f64> = own.iter().zip(levels).map(|(v, &level)| v.at(level)).collect();
            density(&own, &values) / self.mixture(&values)
        };
        let some = || self.asked.iter().step_by(self.asked.len().div_ceil(MOST_POINTS_AT_A_PLACE));
        let expected = some().map(at_place).sum::<f64>() / some().count() as f64;
        let worth = |kish: f64| Some(kish.min(weights.len() as f64 / expected)).filter(|worth| worth.is_finite());
        let [effective, covering] = [draws, values].map(|kish| worth(kish).unwrap_or(0.0));
        let sum: f64 = weights.iter().sum();
        for weight in &mut weights {
            *weight /= sum;
        }
        Some(Seen { place: place.clone(), weights, effective, covering })
    }

    /// What the polynomials of every replicate give at its first `count` points at a place; not beyond the values of the runs where
    /// `is_held`.
    pub fn expected(
        &self,
        (design, fit): (&Design, &CrossFit),
        variables: &[RandomVariable],
        count: usize,
        is_held: bool,
    ) -> Vec<f64> {
        let each = self.asked.len() / self.layout.replicates;
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
        (0..self.layout.replicates).flat_map(of_replicate).collect()
    }
}

/// f at these values of the moving inputs.
fn density(variables: &[RandomVariable], values: &[f64]) -> f64 {
    variables.iter().zip(values).map(|(variable, &x)| variable.density(x).unwrap_or(f64::NAN)).product()
}

/// The values of the `moving` inputs at all runs, as they were run.
fn drawn(table: &SampleTable, pool: &Pool, layout: Layout, moving: &[usize]) -> Vec<Vec<f64>> {
    let values = |run: &usize| -> Vec<f64> {
        let random = &table.inputs()[*run].random;
        moving.iter().map(|&input| random[input]).collect()
    };
    let of_replicate = |replicate: usize| {
        let own = replicate * layout.each..(replicate + 1) * layout.each;
        pool.points.iter().flat_map(move |point| &point.rows[own.clone()])
    };
    (0..layout.replicates).flat_map(of_replicate).map(values).collect()
}

/// The least and the greatest of the values `drawn` of each of the inputs; nothing where one does not scatter.
fn ranges(drawn: &[Vec<f64>], inputs: usize) -> Option<Vec<[f64; 2]>> {
    let range = |input: usize| {
        let own = drawn.iter().map(|x| x[input]);
        let [low, high] = own.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)]);
        (high > low && (high - low).is_finite()).then_some([low, high])
    };
    (0..inputs).map(range).collect()
}

/// About `most` places of each combination of the members of lists.
fn compared(plan: &DoubleLoop, most: usize) -> impl Iterator<Item = Place> + '_ {
    let stride = plan.candidates().len().div_ceil(most);
    let of_combination = move |combination| {
        let at = plan.candidates().iter().step_by(stride).cloned();
        at.map(move |at| Place { combination, at })
    };
    (0..plan.box_combinations()).flat_map(of_combination)
}
