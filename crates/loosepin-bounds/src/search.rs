//! Where to look next: where a model of a statistic promises the most beyond what has been attained.

mod kink;
mod summits;
mod surroundings;

use std::collections::BTreeMap;

use rayon::prelude::*;

use super::search_box::{Axes, Place, Region};
use super::smoother::Smoother;
use super::structure::Element;
use super::target::{Forecast, Target, TargetModel};
use kink::reach_of_kink;

/// The model's error bar in an optimistic prediction, in standard deviations.
const OPTIMISM: f64 = 2.5;

/// The model's error bar in what is conceded, in standard deviations: a model that is wrong about its own error near an extreme
/// costs a bound that is too narrow, where in the search it costs a point.
const CONCEDED: f64 = 4.0;

/// Two new points of one round keep this distance, in units of the box.
const LEAST_DISTANCE_IN_ROUND: f64 = 0.02;

/// A new point keeps this distance from all earlier ones.
const LEAST_DISTANCE: f64 = 1e-6;

/// This many promising places for each new point are located precisely.
const LOCATED_PER_POINT: usize = 2;

/// With more targets than this (the poses of curves) the reach of each is taken over the candidates alone.
pub(super) const MOST_LOCATED_TARGETS: usize = 256;

/// What a search resolves, as a share of the range of its target: gains below it are not pursued, so it is always conceded.
pub(super) const SEARCH_RESOLUTION: f64 = 1e-6;

/// Around this many points, those that are extremes of the most targets, the near surroundings are candidates too.
const MOST_NEIGHBOURHOODS: usize = 12;

/// Distances of these surroundings along each axis, in units of the box.
const NEIGHBOUR_DISTANCES: [f64; 4] = [0.1, 0.02, 0.004, 0.000_5];

/// Which end is sought.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Direction {
    Minimum,
    Maximum,
}

impl Direction {
    /// Both ends.
    pub const BOTH: [Self; 2] = [Self::Minimum, Self::Maximum];

    /// 0 for the minimum, 1 for the maximum.
    pub fn index(self) -> usize {
        self as usize
    }

    /// +1 for the maximum, -1 for the minimum.
    pub fn sign(self) -> f64 {
        match self {
            Self::Minimum => -1.0,
            Self::Maximum => 1.0,
        }
    }

    /// The other one.
    pub fn opposite(self) -> Self {
        match self {
            Self::Minimum => Self::Maximum,
            Self::Maximum => Self::Minimum,
        }
    }

    /// Whether `value` lies beyond `other`.
    pub fn is_beyond(self, value: f64, other: f64) -> bool {
        self.sign() * value > self.sign() * other
    }
}

/// All points so far, and the models that targets share.
///
/// Every combination of the discrete inputs has models of its own, which know nothing of the others; the extremes are taken
/// over all of them.
pub(super) struct Search<'a> {
    axes: &'a Axes,
    points: &'a [Place],
    /// The points of each combination.
    groups: Vec<Vec<usize>>,
    smoothers: BTreeMap<Vec<usize>, Option<Smoother>>,
    targets: usize,
}

/// The model of a target in one combination of the discrete inputs.
pub(super) struct Branch<'a> {
    /// The points of the combination.
    pub points: Vec<usize>,
    /// Those at which the target is defined.
    defined: Vec<usize>,
    /// The model; nothing where the target is defined at too few points.
    model: Option<TargetModel<'a>>,
}

impl Branch<'_> {
    /// What the model takes of the differences between the points for noise, as a variance.
    pub fn noise_variance(&self) -> f64 {
        self.model.as_ref().map_or(0.0, TargetModel::noise_variance)
    }

    /// What the model says at the candidates of the search, in their order, then at other places; nothing without a model.
    pub fn at_candidates(&self) -> Option<impl Iterator<Item = Forecast>> {
        self.model.as_ref().map(|model| model.at_places())
    }

    /// What the model says at `place`; nothing without one.
    pub fn at(&self, place: &[f64]) -> Option<Forecast> {
        self.model.as_ref().map(|model| model.at(place))
    }
}

/// How far a target may go beyond what has been attained, by its model.
#[derive(Debug, Clone)]
struct Reach {
    /// Most that the model allows, at `optimistic_at`.
    pub optimistic: f64,
    pub optimistic_at: Vec<f64>,
    /// Most that the model expects, at `expected_at`.
    pub expected: f64,
    pub expected_at: Vec<f64>,
}

impl<'a> Search<'a> {
    /// Prepares models for all `targets`; points at which a target is undefined do not take part in its model.
    pub fn new<'t>(
        axes: &'a Axes,
        points: &'a [Place],
        candidates: &[Vec<f64>],
        targets: impl IntoIterator<Item = &'t Target>,
    ) -> Self {
        let combinations = points.iter().map(|point| point.combination + 1).max().unwrap_or(1);
        let mut groups = vec![Vec::new(); combinations];
        for (index, point) in points.iter().enumerate() {
            groups[point.combination].push(index);
        }
        // For each set of defined points: whether any target has noise, and how often each point is an extreme.
        let mut sets: BTreeMap<Vec<usize>, (bool, BTreeMap<usize, usize>)> = BTreeMap::new();
        let mut target_count = 0;
        for target in targets {
            target_count += 1;
            for group in &groups {
                let (has_noise, extremes) = sets.entry(defined(target, group)).or_default();
                *has_noise |= target.noise_variance > 0.0;
                for direction in Direction::BOTH {
                    if let Some(point) = extreme_among(&target.values, group.iter().copied(), direction) {
                        *extremes.entry(point).or_default() += 1;
                    }
                }
            }
        }
        let prepare = |(defined, (has_noise, extremes)): (Vec<usize>, (bool, BTreeMap<usize, usize>))| {
            let mut extremes: Vec<(usize, usize)> = extremes.into_iter().collect();
            extremes.sort_by_key(|&(point, count)| (core::cmp::Reverse(count), point));
            let near = extremes
                .into_iter()
                .take(MOST_NEIGHBOURHOODS)
                .flat_map(|(point, _)| neighbours(axes, &points[point].at));
            let places: Vec<Vec<f64>> = candidates.iter().cloned().chain(near).collect();
            let known = defined.iter().map(|&i| points[i].at.clone()).collect();
            let smoother = Smoother::try_new(known, &places, has_noise, axes);
            (defined, smoother)
        };
        Self { axes, points, groups, smoothers: sets.into_iter().map(prepare).collect(), targets: target_count }
    }

    /// The models of `target`, one for each combination of the discrete inputs.
    pub fn branches(&self, target: &Target) -> Vec<Branch<'_>> {
        let branch = |points: &Vec<usize>| {
            let defined = defined(target, points);
            Branch { points: points.clone(), model: self.model(target, &defined), defined }
        };
        self.groups.iter().map(branch).collect()
    }

    fn model(&self, target: &Target, defined: &[usize]) -> Option<TargetModel<'_>> {
        Some(TargetModel::new(self.smoothers.get(defined)?.as_ref()?, target, defined))
    }

    /// The most that the model of `target` in one combination, `branch`, allows in `direction`, anywhere in `region`; infinite
    /// without one.
    pub fn reach(&self, target: &Target, branch: &Branch<'_>, direction: Direction, region: &Region) -> f64 {
        let Some(model) = &branch.model else { return direction.sign() * f64::INFINITY };
        let is_located = self.targets <= MOST_LOCATED_TARGETS;
        let most = if is_located {
            located_reach(self.axes, model, direction, region)
        } else {
            reach(model, direction, region, CONCEDED).optimistic
        };
        // Noise does not become less towards an extreme, so that it looks like a kink.
        let kink = if branch.noise_variance() > 0.0 {
            None
        } else {
            reach_of_kink(self.axes, self.points, &target.values, &branch.defined, direction, region)
        };
        let most = kink.filter(|kink| direction.is_beyond(*kink, most)).unwrap_or(most);
        most + direction.sign() * SEARCH_RESOLUTION * target.range()
    }

    /// The furthest that any of the models of `target` allows in `direction`, anywhere in `region`.
    pub fn furthest_reach(
        &self,
        target: &Target,
        branches: &[Branch<'_>],
        direction: Direction,
        region: &Region,
    ) -> f64 {
        let reaches = branches.iter().map(|branch| self.reach(target, branch, direction, region));
        reaches.reduce(|a, b| if direction.is_beyond(b, a) { b } else { a }).unwrap_or(direction.sign() * f64::INFINITY)
    }

    /// At most `count` new points for the ends of `targets` that are sought in each of `elements`, most promising first; none
    /// where no gain, times the mass of its element, exceeds the resolution, and none in a combination that has `most_points`
    /// already.
    pub fn next_points(
        &self,
        targets: &[(Target, Vec<Direction>)],
        elements: &[Element],
        count: usize,
        most_points: usize,
    ) -> Vec<Place> {
        let members: Vec<Vec<usize>> = elements.iter().map(|element| element.region.members(self.points)).collect();
        let mut promises: Vec<Promise> = targets
            .par_iter()
            .enumerate()
            .flat_map_iter(|(index, (target, directions))| {
                self.promises(index, target, directions, (elements, &members), most_points)
            })
            .collect();
        promises.sort_by(|a, b| b.merit.total_cmp(&a.merit));
        // What a model expects and what it merely allows take turns: every target allows more than it expects.
        let (expected, allowed): (Vec<Promise>, Vec<Promise>) =
            promises.into_iter().partition(|promise| promise.optimism == 0.0);
        let most = LOCATED_PER_POINT * count;
        let (mut expected, mut allowed) =
            (distinct(self.axes, expected, most).into_iter(), distinct(self.axes, allowed, most).into_iter());
        let turns = (0..most).flat_map(|_| [expected.next(), allowed.next()]).flatten();
        let located: Vec<Place> = turns
            .collect::<Vec<Promise>>()
            .into_par_iter()
            .filter_map(|promise| {
                let target = &targets[promise.target].0;
                let combination = promise.place.combination;
                let model = self.model(target, &defined(target, &self.groups[combination]))?;
                let region = &elements[promise.element].region;
                Some(Place {
                    combination,
                    at: locate(self.axes, &model, promise.direction, promise.optimism, promise.place.at, region),
                })
            })
            .collect();
        self.new_places(located, count)
    }

    /// The first `count` of `places` that keep their distances.
    fn new_places(&self, places: impl IntoIterator<Item = Place>, count: usize) -> Vec<Place> {
        let mut chosen: Vec<Place> = Vec::new();
        for place in places {
            let is_new = self.points.iter().all(|point| self.axes.distance(point, &place) > LEAST_DISTANCE)
                && chosen.iter().all(|point| self.axes.distance(point, &place) > LEAST_DISTANCE_IN_ROUND);
            if is_new && chosen.len() < count {
                chosen.push(place);
            }
        }
        chosen
    }

    /// Where the models of a target promise more than has been attained in any combination, element by element.
    fn promises(
        &self,
        index: usize,
        target: &Target,
        directions: &[Direction],
        (elements, members): (&[Element], &[Vec<usize>]),
        most_points: usize,
    ) -> Vec<Promise> {
        let mut promises = Vec::new();
        for (combination, branch) in self.branches(target).iter().enumerate() {
            let Some(model) = branch.model.as_ref().filter(|_| branch.points.len() < most_points) else { continue };
            for (element, (part, members)) in elements.iter().zip(members).enumerate() {
                for &direction in directions {
                    let reach = reach(model, direction, &part.region, OPTIMISM);
                    let attained = extreme_among(&target.values, members.iter().copied(), direction)
                        .map_or(-direction.sign() * f64::INFINITY, |point| target.values[point]);
                    let mut promise = |value: f64, optimism: f64, at: Vec<f64>| {
                        let gain = part.mass * direction.sign() * (value - attained);
                        let merit = gain / target.resolution(direction, attained);
                        if merit > 1.0 {
                            let place = Place { combination, at };
                            promises.push(Promise { target: index, element, direction, optimism, merit, place });
                        }
                    };
                    promise(reach.optimistic, OPTIMISM, reach.optimistic_at);
                    promise(reach.expected, 0.0, reach.expected_at);
                }
            }
        }
        promises
    }
}

struct Promise {
    target: usize,
    element: usize,
    direction: Direction,
    optimism: f64,
    merit: f64,
    place: Place,
}

/// The first `count` promises that are not near each other.
fn distinct(axes: &Axes, promises: Vec<Promise>, count: usize) -> Vec<Promise> {
    let mut kept: Vec<Promise> = Vec::new();
    for promise in promises {
        if kept.len() == count {
            break;
        }
        if kept.iter().all(|other| axes.distance(&other.place, &promise.place) > LEAST_DISTANCE_IN_ROUND) {
            kept.push(promise);
        }
    }
    kept
}

/// How far the model lets its target go in `direction`, by `optimism` standard deviations, over all candidates and points in `region`.
fn reach(model: &TargetModel<'_>, direction: Direction, region: &Region, optimism: f64) -> Reach {
    let sign = direction.sign();
    let (mut optimistic, mut expected) = ((f64::NEG_INFINITY, 0), (f64::NEG_INFINITY, 0));
    for (place, forecast) in model.at_places().enumerate() {
        if !region.holds(&model.places()[place]) {
            continue;
        }
        let most = sign * forecast.moved(sign * optimism);
        let expectation = sign * forecast.mean();
        // A model that overflows allows anything.
        let most = if most.is_nan() { f64::INFINITY } else { most };
        if most > optimistic.0 {
            optimistic = (most, place);
        }
        if expectation > expected.0 {
            expected = (expectation, place);
        }
    }
    if optimistic.0 == f64::NEG_INFINITY {
        // No place of the region is known: the model says nothing there.
        let centre = region.at(&vec![0.5; region.lower.len()]);
        let unlimited = sign * f64::INFINITY;
        let (optimistic_at, expected_at) = (centre.clone(), centre);
        return Reach { optimistic: unlimited, optimistic_at, expected: f64::NAN, expected_at };
    }
    Reach {
        optimistic: sign * optimistic.0,
        optimistic_at: model.places()[optimistic.1].clone(),
        expected: sign * expected.0,
        expected_at: model.places()[expected.1].clone(),
    }
}

/// The same over the whole region: the most that the model allows, located from the best of the places.
fn located_reach(axes: &Axes, model: &TargetModel<'_>, direction: Direction, region: &Region) -> f64 {
    let coarse = reach(model, direction, region, OPTIMISM);
    let place = locate(axes, model, direction, CONCEDED, coarse.optimistic_at, region);
    let located = model.at(&place).moved(direction.sign() * CONCEDED);
    if direction.is_beyond(located, coarse.optimistic) { located } else { coarse.optimistic }
}

/// The values of `target` as its models see them: unchanged unless a model takes part of their differences for noise, and never
/// moved by more than the error of each value itself.
pub(super) fn smoothed(target: &Target, branches: &[Branch<'_>], errors: impl Fn(usize) -> (f64, f64)) -> Vec<f64> {
    let mut values = target.values.clone();
    for branch in branches {
        let Some(model) = branch.model.as_ref().filter(|fit| fit.is_smoothed()) else { continue };
        let means = model.at_places().skip(model.places().len() - branch.defined.len());
        for (&point, forecast) in branch.defined.iter().zip(means) {
            let (below, above) = errors(point);
            values[point] = forecast.mean().max(values[point] - below).min(values[point] + above);
        }
    }
    values
}

/// The extreme of the finite values; infinite where there are none.
pub(super) fn extreme(values: &[f64], direction: Direction) -> f64 {
    extreme_point(values, direction).map_or(-direction.sign() * f64::INFINITY, |point| values[point])
}

/// Where the extreme of the finite values is.
pub(super) fn extreme_point(values: &[f64], direction: Direction) -> Option<usize> {
    extreme_among(values, 0..values.len(), direction)
}

/// Where the extreme of the finite values at `points` is.
pub(super) fn extreme_among(
    values: &[f64],
    points: impl Iterator<Item = usize>,
    direction: Direction,
) -> Option<usize> {
    let mut best: Option<usize> = None;
    for point in points {
        let value = values[point];
        if value.is_finite() && best.is_none_or(|best| direction.is_beyond(value, values[best])) {
            best = Some(point);
        }
    }
    best
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

/// Moves `place` to the nearest local extreme of mean + optimism x deviation: pattern search along the axes and the last
/// successful move, step halved down to 1e-7 of the box.
fn locate(
    axes: &Axes,
    model: &TargetModel<'_>,
    direction: Direction,
    optimism: f64,
    mut place: Vec<f64>,
    region: &Region,
) -> Vec<f64> {
    let inside = |axis: usize, value: f64| axes.inside(axis, value, [region.lower[axis], region.upper[axis]]);
    const FIRST_STEP: f64 = 0.1;
    const LAST_STEP: f64 = 1e-7;
    const MOST_MOVES: usize = 400;
    const FACE_THICKNESS: f64 = 1e-4;
    let sign = direction.sign();
    let value = |place: &[f64]| sign * model.at(place).moved(sign * optimism);
    let mut best = value(&place);
    let mut step = FIRST_STEP;
    let mut moves = 0;
    while step >= LAST_STEP && moves < MOST_MOVES {
        let before = place.clone();
        let mut has_moved = false;
        for axis in 0..place.len() {
            for signed in [step, -step] {
                let mut trial = place.clone();
                trial[axis] = inside(axis, trial[axis] + signed);
                if trial[axis] == place[axis] {
                    continue;
                }
                let found = value(&trial);
                if found > best {
                    (best, place, has_moved) = (found, trial, true);
                    break;
                }
            }
        }
        if has_moved {
            moves += 1;
            let ahead = place.iter().zip(&before).enumerate();
            let trial: Vec<f64> = ahead.map(|(axis, (x, y))| inside(axis, 2.0 * x - y)).collect();
            let found = value(&trial);
            if found > best {
                (best, place) = (found, trial);
            }
        } else {
            step *= 0.5;
        }
    }
    // What the model cannot tell from a face is a face: corners and edges are then met exactly.
    for (axis, (coordinate, (lower, upper))) in place.iter_mut().zip(region.lower.iter().zip(&region.upper)).enumerate()
    {
        if axes.is_periodic(axis) {
            continue;
        }
        if *coordinate < lower + FACE_THICKNESS {
            *coordinate = *lower;
        } else if *coordinate > upper - FACE_THICKNESS {
            *coordinate = *upper;
        }
    }
    place
}

/// The points of `group` at which `target` is defined.
fn defined(target: &Target, group: &[usize]) -> Vec<usize> {
    group.iter().copied().filter(|&i| target.values[i].is_finite()).collect()
}

#[cfg(test)]
mod tests {
    use super::{Direction, Search, Target, extreme};
    use crate::points::{candidates, first_points};
    use crate::search_box::{Axes, Place, Region};
    use crate::structure::Element;
    use crate::target::TargetKind;

    /// Searches both ends of `function` with `count` points in rounds of five.
    fn ends(dimensions: usize, count: usize, function: impl Fn(&[f64]) -> f64) -> (f64, f64) {
        let candidates = candidates(dimensions).unwrap();
        let place = |at| Place { combination: 0, at };
        let mut points: Vec<Place> = first_points(11, dimensions, count / 2).unwrap().into_iter().map(place).collect();
        loop {
            let values: Vec<f64> = points.iter().map(|u| function(&u.at)).collect();
            let resolutions = [1e-9; 2];
            let target = Target { values: values.clone(), kind: TargetKind::Plain, noise_variance: 0.0, resolutions };
            let axes = Axes::open(dimensions);
            let search = Search::new(&axes, &points, &candidates, [&target]);
            let elements = [Element { mass: 1.0, region: Region::whole(dimensions) }];
            let targets = [(target, Direction::BOTH.to_vec())];
            let next = search.next_points(&targets, &elements, 5.min(count - points.len()), 512);
            if next.is_empty() {
                return (extreme(&values, Direction::Minimum), extreme(&values, Direction::Maximum));
            }
            points.extend(next);
        }
    }

    #[test]
    fn analytic_extremes_inside_a_box() {
        const TOLERANCE: f64 = 1e-4; // of a range of about 2
        let (low, high) = ends(1, 24, |u| (7.0 * u[0]).sin());
        assert!(low + 1.0 < TOLERANCE && 1.0 - high < TOLERANCE, "{low} {high}");
        let (low, high) = ends(2, 50, |u| (5.0 * u[0] + 1.0).sin() * (4.0 * u[1]).cos());
        assert!(low + 1.0 < TOLERANCE && 1.0 - high < TOLERANCE, "{low} {high}");
    }

    #[test]
    fn analytic_extreme_on_a_corner_that_was_not_looked_at() {
        // Seven inputs: 16 of 128 corners are looked at first; the maximum 7 is at a corner, the minimum -7 opposite.
        const TOLERANCE: f64 = 1e-9;
        let signs = [1.0, -1.0, -1.0, 1.0, 1.0, 1.0, -1.0];
        let (low, high) = ends(7, 60, |u| u.iter().zip(signs).map(|(x, sign)| sign * (2.0 * x - 1.0)).sum());
        assert!((low + 7.0).abs() < TOLERANCE && (high - 7.0).abs() < TOLERANCE, "{low} {high}");
    }
}
