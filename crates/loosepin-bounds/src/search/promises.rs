//! Places at which a model promises the most beyond what has been attained.

use super::parts::Element;
use super::reach::{locate, reach, reach_with_kinks};
use super::search_box::{Axes, BoxPoint, Region};
use super::target::Target;
use crate::data::direction::{Direction, extreme_among};
use crate::parallel;
use crate::search::models::of_points::{Branch, MIN_DISTANCE_IN_ROUND, Modelled, Search};
use crate::search::models::prediction::Allowance;
use crate::search::models::target_model::Forecast;
use loosepin_math::sort_by_number;

/// This many promising places for each new point are located precisely.
const LOCATED_PER_POINT: usize = 2;

/// Share of the side of a box for each point that places which are merely hoped for are apart.
const SHARE_OF_SIDE: f64 = 0.5;

impl Search<'_> {
    /// At most `count` new points for the ends of targets that are sought in each of `elements`, most promising first, by what models
    /// expect and by what they allow with `allowance`; empty if no gain, times the mass of its element, exceeds the resolution.
    pub(super) fn next_points(
        &self,
        Modelled { targets, branches }: Modelled<'_>,
        elements: &[Element],
        count: usize,
        allowance: Allowance,
    ) -> Vec<BoxPoint> {
        let members: Vec<Vec<usize>> = elements.iter().map(|element| element.region.members(self.points)).collect();
        let of_target = |index: usize| {
            let ((target, directions), branches) = (&targets[index], &branches[index]);
            promises((index, target), directions, branches, (elements, &members), (allowance, self.is_of_curves()))
        };
        let mut promises: Vec<Promise> =
            parallel::map_indices(targets.len(), of_target).into_iter().flatten().collect();
        sort_by_number(&mut promises, |a| -a.merit);
        // What a model expects and what it merely allows take turns: every target allows more than it expects.
        let (expected, others): (Vec<Promise>, Vec<Promise>) =
            promises.into_iter().partition(|promise| promise.kind == Kind::Expected);
        let (kinked, allowed): (Vec<Promise>, Vec<Promise>) =
            others.into_iter().partition(|promise| promise.kind == Kind::WithKinks);
        let most = LOCATED_PER_POINT * count;
        let [mut expected, mut allowed, mut kinked] =
            [expected, allowed, kinked].map(|own| distinct(self.axes, own, most).into_iter());
        // Where kinks are conceded most, half of the points go, and all where nothing else is expected: nothing else makes these concessions less.
        let turns = (0..most).flat_map(|_| [kinked.next(), kinked.next(), expected.next(), allowed.next()]).flatten();
        let located = parallel::flat_map(&turns.collect::<Vec<Promise>>(), |promise| {
            let combination = promise.place.combination;
            let model = branches[promise.target][combination].model.as_ref()?;
            // A smooth model does not know where a kink leads.
            if promise.kind == Kind::WithKinks {
                return Some(promise.place.clone());
            }
            let region = &elements[promise.element].region;
            let from = promise.place.at.clone();
            let at = locate(self.axes, model, promise.direction, promise.allowance, from, region);
            Some(BoxPoint { combination, at })
        });
        self.new_places(located, count)
    }
}

impl Search<'_> {
    /// `places` and others up to `count`, at which models hope for more than was attained by more than the resolution: most first.
    pub(super) fn further_points(
        &self,
        Modelled { targets, branches }: Modelled<'_>,
        elements: &[Element],
        mut places: Vec<BoxPoint>,
        count: usize,
    ) -> Vec<BoxPoint> {
        if places.len() >= count {
            return places;
        }
        let mut hopes: Vec<Hope<'_>> = Vec::new();
        for element in elements {
            let members = element.region.members(self.points);
            for ((target, directions), branches) in targets.iter().zip(branches) {
                for &direction in directions {
                    let attained = extreme_among(&target.values, members.iter().copied(), direction)
                        .map_or(-direction.sign() * f64::INFINITY, |point| target.values[point]);
                    let resolution = target.resolution(direction, attained) / element.mass;
                    let of_branch = |own| hopes_of(own, direction, &element.region, (attained, resolution));
                    hopes.extend(branches.iter().enumerate().flat_map(of_branch));
                }
            }
        }
        sort_by_number(&mut hopes, |a| -a.merit);
        let apart = self.least_distance_of_hopes();
        for Hope { combination, at, .. } in hopes {
            if places.len() == count {
                break;
            }
            let place = BoxPoint { combination, at: at.clone() };
            if self.points.iter().chain(&places).all(|other| self.axes.distance(other, &place) > apart) {
                places.push(place);
            }
        }
        places
    }

    /// Least distance of an optimistic place from all points and from others of its round: values at one of them say little about the
    /// others. Half of the side of a box for each point.
    fn least_distance_of_hopes(&self) -> f64 {
        let dimensions = self.points.first().map_or(1, |point| point.at.len().max(1));
        SHARE_OF_SIDE * libm::pow(self.points.len() as f64, -1.0 / dimensions as f64)
    }
}

/// A place at which a model hopes for more than was attained.
struct Hope<'m> {
    /// The gain over the resolution.
    merit: f64,
    combination: usize,
    at: &'m Vec<f64>,
}

/// Optimistic places of the model of one combination among its candidates in `region`.
fn hopes_of<'m>(
    (combination, branch): (usize, &'m Branch<'_>),
    direction: Direction,
    region: &Region,
    (attained, resolution): (f64, f64),
) -> Vec<Hope<'m>> {
    let Some(model) = &branch.model else { return Vec::new() };
    let sign = direction.sign();
    let forecasts = model.places().iter().zip(model.at_places(Allowance::HOPED));
    let hope = |(at, forecast): (&'m Vec<f64>, Forecast)| Hope {
        merit: sign * (forecast.moved(Allowance::HOPED, sign) - attained) / resolution,
        combination,
        at,
    };
    forecasts.map(hope).filter(|hope| hope.merit > 1.0 && region.holds(hope.at)).collect()
}

/// Places where the models of a target promise more than was attained in any combination, element by element; also where kinks do, if the
/// target `may_have_kinks` that no point shows.
fn promises(
    (index, target): (usize, &Target),
    directions: &[Direction],
    branches: &[Branch<'_>],
    (elements, members): (&[Element], &[Vec<usize>]),
    (allowed, may_have_kinks): (Allowance, bool),
) -> Vec<Promise> {
    let mut promises = Vec::new();
    for (combination, branch) in branches.iter().enumerate() {
        let Some(model) = &branch.model else { continue };
        for (element, (part, members)) in elements.iter().zip(members).enumerate() {
            for &direction in directions {
                let reach = reach(model, direction, &part.region, allowed);
                let kinked = if may_have_kinks { reach_with_kinks(model, direction, &part.region) } else { None };
                let attained = extreme_among(&target.values, members.iter().copied(), direction)
                    .map_or(-direction.sign() * f64::INFINITY, |point| target.values[point]);
                let mut promise = |value: f64, (kind, allowance): (Kind, Allowance), at: Vec<f64>| {
                    let gain = part.mass * direction.sign() * (value - attained);
                    let merit = gain / target.resolution(direction, attained);
                    if merit > 1.0 {
                        let place = BoxPoint { combination, at };
                        promises.push(Promise { target: index, element, direction, kind, allowance, merit, place });
                    }
                };
                promise(reach.optimistic, (Kind::Allowed, allowed), reach.optimistic_at);
                promise(reach.expected, (Kind::Expected, Allowance::NONE), reach.expected_at);
                if let Some((value, at)) = kinked {
                    promise(value, (Kind::WithKinks, allowed), at.clone());
                }
            }
        }
    }
    promises
}

/// The source of a promise.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// What a model expects.
    Expected,
    /// What it allows.
    Allowed,
    /// What is conceded to values of curves that may have kinks.
    WithKinks,
}

struct Promise {
    target: usize,
    element: usize,
    direction: Direction,
    kind: Kind,
    allowance: Allowance,
    merit: f64,
    place: BoxPoint,
}

/// The first `count` promises that are not near each other.
fn distinct(axes: &Axes, promises: Vec<Promise>, count: usize) -> Vec<Promise> {
    let mut kept: Vec<Promise> = Vec::new();
    for promise in promises {
        if kept.len() == count {
            break;
        }
        if kept.iter().all(|other| axes.distance(&other.place, &promise.place) > MIN_DISTANCE_IN_ROUND) {
            kept.push(promise);
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use crate::data::direction::{Direction, extreme};
    use crate::search::design::{candidates, first_points};
    use crate::search::models::noise::Noise;
    use crate::search::models::of_points::{Modelled, Search};
    use crate::search::models::prediction::Allowance;
    use crate::search::parts::Element;
    use crate::search::search_box::{Axes, BoxPoint, Region};
    use crate::search::target::{Target, TargetKind};

    /// Searches both ends of `function` with `count` points in rounds of five.
    fn ends(dimensions: usize, count: usize, function: impl Fn(&[f64]) -> f64) -> (f64, f64) {
        let candidates = candidates(dimensions).unwrap();
        let place = |at| BoxPoint { combination: 0, at };
        let mut points: Vec<BoxPoint> =
            first_points(11, dimensions, count / 2).unwrap().into_iter().map(place).collect();
        loop {
            let values: Vec<f64> = points.iter().map(|u| function(&u.at)).collect();
            let resolutions = [1e-9; 2];
            let target = Target { values: values.clone(), kind: TargetKind::Plain, noise: Noise::NONE, resolutions };
            let axes = Axes::open(dimensions);
            let search = Search::new(&axes, &points, &candidates, [&target]);
            let elements = [Element { mass: 1.0, region: Region::whole(dimensions) }];
            let targets = [(target, Direction::BOTH.to_vec())];
            let modelled = Modelled { targets: &targets, branches: &search.branches_of_targets(&targets) };
            let next = search.next_points(modelled, &elements, 5.min(count - points.len()), Allowance::HOPED);
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

    /// The next places of both ends of a function of two numbers of which 24 values are known.
    fn next_of(count: usize, is_filled: bool, function: impl Fn(&[f64]) -> f64) -> (Vec<BoxPoint>, Vec<BoxPoint>) {
        let points: Vec<BoxPoint> =
            first_points(11, 2, 24).unwrap().into_iter().map(|at| BoxPoint { combination: 0, at }).collect();
        let values = points.iter().map(|point| function(&point.at)).collect();
        let target = Target { values, kind: TargetKind::Plain, noise: Noise::NONE, resolutions: [1e-9; 2] };
        let axes = Axes::open(2);
        let search = Search::new(&axes, &points, &candidates(2).unwrap(), [&target]);
        let elements = [Element { mass: 1.0, region: Region::whole(2) }];
        let targets = [(target, Direction::BOTH.to_vec())];
        let next = if is_filled { Search::filled_places } else { Search::next_places };
        (next(&search, &targets, &elements, count), points)
    }

    #[test]
    fn identity_a_round_is_filled_behind_what_is_promised_most() {
        const COUNT: usize = 11;
        // Too rough for 24 points: a model hopes for more nearly everywhere.
        let ripple = |u: &[f64]| (23.0 * u[0]).sin() + (31.0 * u[1] + 3.0 * u[0]).cos();
        let (few, _) = next_of(COUNT, false, ripple);
        let (filled, points) = next_of(COUNT, true, ripple);
        assert!(!few.is_empty() && few.len() <= 4, "{few:?}");
        assert_eq!((&filled[..few.len()], filled.len()), (&few[..], COUNT));
        let apart = 0.5 / (points.len() as f64).sqrt();
        for (index, place) in filled.iter().enumerate().skip(few.len()) {
            let others = points.iter().chain(&filled[..index]);
            let nearest = others.map(|other| Axes::open(2).distance(other, place)).fold(f64::INFINITY, f64::min);
            assert!(nearest > apart, "{place:?}: {nearest}");
        }
    }

    #[test]
    fn identity_nothing_is_filled_where_nothing_is_hoped_for() {
        // A plane is known everywhere.
        let plane = |u: &[f64]| u[0] - 0.3 * u[1];
        assert_eq!(next_of(11, true, plane).0, next_of(11, false, plane).0);
    }
}
