//! The pool of runs, the places that it is seen from, and its weights there.

use std::sync::Arc;

use rayon::prelude::*;

use crate::bounds::inner_basis::{CrossFit, Design, InnerBasis, MOST_DEGREE};
use crate::bounds::orthogonal::Axis;
use crate::bounds::plan::DoubleLoop;
use crate::bounds::pool::Pool;
use crate::bounds::problem::Problem;
use crate::bounds::search_box::{Place, SearchBox};
use crate::uncertainty::{Level, RandomVariable};

/// Points at each u at which the polynomials are asked, in each replicate; where there are many columns.
const POINTS: usize = 128;
const POINTS_OF_CURVES: usize = 64;
/// Places of each combination of the members of lists that are compared, about; where there are many columns.
const PLACES: usize = 128;
const PLACES_OF_CURVES: usize = 24;
/// Around each outer point these distances along each axis are compared too, in units of the box, but for curves.
const NEIGHBOUR_DISTANCES: [f64; 3] = [0.1, 0.02, 0.004];
const MOST_NEIGHBOURHOODS: usize = 16;
/// The worth of weights is seen from this many points at a place, at most.
const MOST_POINTS_AT_A_PLACE: usize = 256;

/// One place and the pool as it is seen from there.
#[derive(Debug)]
pub struct Seen {
    pub place: Place,
    /// Weights of all runs, replicate by replicate; their sum is 1.
    pub weights: Vec<f64>,
    /// Independent runs that would know as much.
    pub effective: f64,
}

/// All outer points, then the places that they are compared with.
#[derive(Debug)]
pub struct View {
    pub outer: usize,
    pub seen: Vec<Seen>,
    pub replicates: usize,
    /// Runs of one replicate, and points of one at each place.
    pub runs: usize,
    pub points: usize,
}

/// What is known of the runs and places before any column is looked at.
#[derive(Debug)]
pub struct Ground {
    pub problem: Problem,
    pub epistemic_box: SearchBox,
    pub basis: Option<Arc<InnerBasis>>,
    pub replicates: usize,
    /// Runs of one replicate at one outer point.
    pub each: usize,
    pub runs: usize,
    pub points: usize,
    /// Inputs with parameters.
    pub moving: Vec<usize>,
    /// Their values at all runs, replicate by replicate.
    pub drawn: Vec<Vec<f64>>,
    /// The least and the greatest of these, input by input.
    pub ranges: Vec<[f64; 2]>,
    pub axes: Vec<Axis>,
    /// Coordinates of all runs, replicate by replicate.
    pub coordinates: Vec<Vec<f64>>,
    /// Points of the unit cube, as many in each replicate as are asked for anything: coordinates, and the levels of the moving inputs.
    pub asked: Vec<(Vec<f64>, Vec<Level>)>,
    pub places: Vec<Place>,
    pub variables: Vec<Vec<RandomVariable>>,
}

impl Ground {
    /// The runs of `pool`, and the places that they are compared with: fewer where there are `many` columns. Nothing where a value of the
    /// parameters describes no distribution.
    pub fn new(plan: &DoubleLoop, pool: &Pool, many: bool) -> Option<Self> {
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
        for place in outer.iter().take(if many { 0 } else { MOST_NEIGHBOURHOODS }) {
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
    pub fn designs(&self) -> Vec<Arc<Design>> {
        let design = |degree| Design::new(&self.axes, degree, &self.coordinates, self.replicates).map(Arc::new);
        (1..=MOST_DEGREE).map_while(design).collect()
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

    /// The weights of all runs at every place.
    pub fn view(&self) -> View {
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
    pub fn expected(
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
