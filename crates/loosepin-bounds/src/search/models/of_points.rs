//! Points so far, and models of targets on them.

use std::collections::BTreeMap;

use crate::data::direction::{Direction, extreme_among};
use crate::parallel;
use crate::search::models::grid::Grid;
use crate::search::models::local::LocalSmoothers;
use crate::search::models::prediction::Allowance;
use crate::search::models::shared_grids::SharedGrids;
use crate::search::models::target_model::{Forecast, TargetModel};
use crate::search::search_box::{Axes, BoxPoint};
use crate::search::target::Target;
use loosepin_math::sort_by_number;

/// So many targets are modelled together.
pub(crate) const TARGETS_AT_ONCE: usize = 16;

/// Two new points of one round keep this distance, in units of the box.
pub(in crate::search) const MIN_DISTANCE_IN_ROUND: f64 = 0.02;

/// A new point keeps this distance from all earlier ones.
pub(in crate::search) const MIN_DISTANCE: f64 = 1e-6;

/// With more targets than this (the poses of curves) next points are sought at the candidates alone, and the reach of each is found by a few
/// short climbs.
pub(crate) const MAX_LOCATED_TARGETS: usize = 256;

/// From this share of noise on, what values differ by from one point to the next says more of it than of the statistic.
const MOSTLY_NOISE: f64 = 0.5;

/// Around this many points, those that are extremes of the most targets, the near surroundings are candidates too.
const MAX_NEIGHBOURHOODS: usize = 12;

/// Distances of these surroundings along each axis, in units of the box.
const NEIGHBOUR_DISTANCES: [f64; 4] = [0.1, 0.02, 0.004, 0.000_5];

/// All points so far, and the models that targets share.
///
/// Every combination of the discrete inputs has models of its own, which know nothing of the others; the extremes are taken
/// over all of them.
pub(crate) struct Search<'a> {
    pub(in crate::search) axes: &'a Axes,
    pub(in crate::search) points: &'a [BoxPoint],
    /// The points of each combination.
    pub(in crate::search) groups: Vec<Vec<usize>>,
    smoothers: BTreeMap<Vec<usize>, Option<LocalSmoothers>>,
    targets: usize,
}

/// The model of a target in one combination of the discrete inputs.
pub(crate) struct Branch<'a> {
    /// The points of the combination.
    pub points: Vec<usize>,
    /// Points at which the target is defined.
    pub(in crate::search) defined: Vec<usize>,
    /// The model; `None` if the target is defined at too few points.
    pub(in crate::search) model: Option<TargetModel<'a>>,
}

impl Branch<'_> {
    /// Variance of the sampling noise that the model sees between the points, where most of what it sees there is noise; else 0.
    pub fn averaged_noise(&self) -> f64 {
        let noisy = self.model.as_ref().filter(|model| model.noise_share() >= MOSTLY_NOISE);
        noisy.map_or(0.0, TargetModel::noise_variance)
    }

    /// Whether the model smooths the values instead of interpolating them.
    pub fn is_regressing(&self) -> bool {
        self.model.as_ref().is_some_and(TargetModel::is_regressing)
    }

    /// Whether the target is treated as rough.
    pub fn is_rough(&self) -> bool {
        self.model.as_ref().is_some_and(TargetModel::is_rough)
    }

    /// Predictions at the candidates of the search, in their order, then at other places; `None` without a model.
    pub fn at_candidates(&self, allowance: Allowance) -> Option<impl Iterator<Item = Forecast>> {
        self.model.as_ref().map(|model| model.at_places(allowance))
    }

    /// Prediction at `place`; `None` without a model.
    pub fn at(&self, place: &[f64], allowance: Allowance) -> Option<Forecast> {
        self.model.as_ref().map(|model| model.at(place, allowance))
    }
}

/// Targets with the ends that are sought of each, and their models.
#[derive(Clone, Copy)]
pub(in crate::search) struct Modelled<'m> {
    pub targets: &'m [(Target, Vec<Direction>)],
    /// Branches of each target: [`Search::branches_of_targets`].
    pub branches: &'m [Vec<Branch<'m>>],
}

impl<'a> Search<'a> {
    /// Prepares models for all `targets`; points at which a target is undefined do not take part in its model.
    pub fn new<'t>(
        axes: &'a Axes,
        points: &'a [BoxPoint],
        candidates: &[Vec<f64>],
        targets: impl IntoIterator<Item = &'t Target>,
    ) -> Self {
        Self::sharing(&SharedGrids::default(), axes, points, candidates, targets)
    }

    /// [`Self::new`] with the `grids` of other searches over the same points.
    pub fn sharing<'t>(
        grids: &SharedGrids,
        axes: &'a Axes,
        points: &'a [BoxPoint],
        candidates: &[Vec<f64>],
        targets: impl IntoIterator<Item = &'t Target>,
    ) -> Self {
        let combinations = points.iter().map(|point| point.combination + 1).max().unwrap_or(1);
        let mut groups = vec![Vec::new(); combinations];
        for (index, point) in points.iter().enumerate() {
            groups[point.combination].push(index);
        }
        // For each set of defined points: how often each point is an extreme.
        let mut sets: BTreeMap<Vec<usize>, BTreeMap<usize, usize>> = BTreeMap::new();
        let mut target_count = 0;
        for target in targets {
            target_count += 1;
            for group in &groups {
                let extremes = sets.entry(defined(target, group)).or_default();
                for direction in Direction::BOTH {
                    if let Some(point) = extreme_among(&target.values, group.iter().copied(), direction) {
                        *extremes.entry(point).or_default() += 1;
                    }
                }
            }
        }
        let prepare = |(defined, extremes): (Vec<usize>, BTreeMap<usize, usize>)| {
            let mut extremes: Vec<(usize, usize)> = extremes.into_iter().collect();
            sort_by_number(&mut extremes, |&(_, count)| -(count as f64));
            let near = extremes
                .into_iter()
                .take(MAX_NEIGHBOURHOODS)
                .flat_map(|(point, _)| neighbours(axes, &points[point].at));
            let places: Vec<Vec<f64>> = candidates.iter().cloned().chain(near).collect();
            let known = defined.iter().map(|&i| points[i].at.clone()).collect();
            let grid = |part: usize, points: &[Vec<f64>]| {
                grids.of(&defined, part, |earlier| Grid::try_new(points, true, axes, earlier))
            };
            let smoother = LocalSmoothers::with(known, &places, axes, grid);
            (defined, smoother)
        };
        Self { axes, points, groups, smoothers: sets.into_iter().map(prepare).collect(), targets: target_count }
    }

    /// Whether the targets are numerous enough to be the poses of curves.
    pub fn is_of_curves(&self) -> bool {
        self.targets > MAX_LOCATED_TARGETS
    }

    /// The models of `target`, one for each combination of the discrete inputs.
    pub fn branches(&self, target: &Target) -> Vec<Branch<'_>> {
        let branch = |points: &Vec<usize>| {
            let defined = defined(target, points);
            Branch { points: points.clone(), model: self.model(target, &defined), defined }
        };
        self.groups.iter().map(branch).collect()
    }

    /// [`Self::branches`] of each of several targets, whose models are made together: [`TARGETS_AT_ONCE`] of them are enough.
    pub fn branches_of_all(&self, targets: &[&Target]) -> Vec<Vec<Branch<'_>>> {
        let mut branches: Vec<Vec<Branch<'_>>> = targets.iter().map(|_| Vec::new()).collect();
        for points in &self.groups {
            // Nearly always all targets are defined at the same points.
            let mut sets: BTreeMap<Vec<usize>, Vec<usize>> = BTreeMap::new();
            for (index, target) in targets.iter().enumerate() {
                sets.entry(defined(target, points)).or_default().push(index);
            }
            for (defined, own) in sets {
                let among: Vec<&Target> = own.iter().map(|&index| targets[index]).collect();
                let smoother = self.smoothers.get(&defined).and_then(Option::as_ref);
                let mut models =
                    smoother.map_or_else(Vec::new, |own| TargetModel::all(own, &among, &defined)).into_iter();
                for index in own {
                    let (points, defined) = (points.clone(), defined.clone());
                    branches[index].push(Branch { points, defined, model: models.next() });
                }
            }
        }
        branches
    }

    /// [`Self::branches`] of each of any number of `targets`, in parallel.
    pub(in crate::search) fn branches_of_targets(&self, targets: &[(Target, Vec<Direction>)]) -> Vec<Vec<Branch<'_>>> {
        let of = |targets: &[(Target, Vec<Direction>)]| {
            self.branches_of_all(&targets.iter().map(|(target, _)| target).collect::<Vec<_>>())
        };
        let chunks: Vec<&[(Target, Vec<Direction>)]> = targets.chunks(TARGETS_AT_ONCE).collect();
        parallel::flat_map(&chunks, |targets| of(targets))
    }

    /// The model of `target` on the points at which it is `defined`; `None` if these are too few.
    pub(in crate::search) fn model(&self, target: &Target, defined: &[usize]) -> Option<TargetModel<'_>> {
        Some(TargetModel::new(self.smoothers.get(defined)?.as_ref()?, target, defined))
    }

    /// The first `count` of `places` that keep their distances.
    pub fn new_places(&self, places: impl IntoIterator<Item = BoxPoint>, count: usize) -> Vec<BoxPoint> {
        let mut chosen: Vec<BoxPoint> = Vec::new();
        for place in places {
            let is_new = self.points.iter().all(|point| self.axes.distance(point, &place) > MIN_DISTANCE)
                && chosen.iter().all(|point| self.axes.distance(point, &place) > MIN_DISTANCE_IN_ROUND);
            if is_new && chosen.len() < count {
                chosen.push(place);
            }
        }
        chosen
    }
}

/// The values of `target` as its models see them: unchanged unless a model takes part of their differences for noise, and never
/// moved by more than the error of each value itself.
pub(crate) fn smoothed(target: &Target, branches: &[Branch<'_>], errors: impl Fn(usize) -> (f64, f64)) -> Vec<f64> {
    let mut values = target.values.clone();
    for branch in branches {
        let Some(model) = branch.model.as_ref().filter(|fit| fit.is_regressing()) else { continue };
        let means = model.at_places(Allowance::NONE).skip(model.places().len() - branch.defined.len());
        let share = model.noise_share();
        for (&point, forecast) in branch.defined.iter().zip(means) {
            let (below, above) = errors(point);
            let heard = values[point] + share * (forecast.mean() - values[point]);
            values[point] = heard.max(values[point] - below).min(values[point] + above);
        }
    }
    values
}

/// Places near `point` along the axes, inside the box.
fn neighbours<'p>(axes: &'p Axes, point: &'p [f64]) -> impl Iterator<Item = Vec<f64>> + 'p {
    let steps = NEIGHBOUR_DISTANCES.into_iter().flat_map(|distance| [distance, -distance]);
    steps.flat_map(move |step| {
        (0..point.len()).filter_map(move |axis| {
            let mut place = point.to_vec();
            place[axis] = axes.inside(axis, place[axis] + step, [0.0, 1.0]);
            (place[axis] != point[axis]).then_some(place)
        })
    })
}

/// The points of `group` at which `target` is defined.
pub(in crate::search) fn defined(target: &Target, group: &[usize]) -> Vec<usize> {
    let mut defined = Vec::with_capacity(group.len());
    defined.extend(group.iter().copied().filter(|&i| target.values[i].is_finite()));
    defined
}
