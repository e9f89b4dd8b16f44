//! Places to which a smooth function is expected to lead on from the attained extremes.

use super::extremes::Extreme;
use super::search_box::{Axes, BoxPoint};
use crate::parallel;
use crate::search::models::local::LocalSmoothers;
use crate::search::models::of_points::{Search, defined};
use crate::search::models::prediction::Allowance;
use crate::search::models::target_model::TargetModel;
use loosepin_math::descent::minimise;
use loosepin_math::sort_by_number;

/// A local model has this many points for each term of a polynomial of degree 2.
const POINTS_PER_TERM: usize = 3;

/// A climb is worth a point from this share of the resolution on: a summit of something smooth takes few.
const MIN_CLIMB: f64 = 0.1;

/// Half of the distance over which a slope of a local model is taken, in units of its box.
const HALF_STEP: f64 = 1e-4;

/// A climb ends where two steps in turn gain less than this share of the resolution, and after this many.
const MIN_STEP: f64 = 1e-3;
const MAX_STEPS: usize = 60;

impl Search<'_> {
    /// At most `count` places to which a climb from `extremes` leads, those that are expected to gain the most first.
    ///
    /// Each climb follows a model of its own, of the nearest points alone. A model of all points spans far larger differences, and with
    /// what it allows for round-off it cannot tell the least ones along a curved ridge, where no candidate lies nearer to the summit.
    pub(super) fn summits(&self, extremes: &[Extreme<'_>], count: usize) -> Vec<BoxPoint> {
        let mut summits: Vec<(f64, BoxPoint)> = parallel::flat_map(extremes, |extreme| self.summit(extreme));
        sort_by_number(&mut summits, |a| -a.0);
        self.new_places(summits.into_iter().map(|(_, place)| place), count)
    }

    /// The expected gain of a climb from `extreme`, in units of the resolution, and where it ends; `None` if it is not worth a
    /// point, and where the target is not smooth.
    fn summit(&self, extreme: &Extreme<'_>) -> Option<(f64, BoxPoint)> {
        if extreme.model.is_regressing() {
            return None;
        }
        let BoxPoint { combination, ref at } = self.points[extreme.point];
        let (near, radius) = self.nearest(extreme)?;
        // The local box has the extreme in its centre and the furthest of the points on its faces.
        let local = |axis: usize, coordinate: f64| 0.5 + 0.5 * self.axes.step(axis, at[axis], coordinate) / radius;
        let seen = |place: &[f64]| place.iter().enumerate().map(|(axis, x)| local(axis, *x)).collect::<Vec<f64>>();
        let points = near.iter().map(|&point| seen(&self.points[point].at)).collect();
        let smoother = LocalSmoothers::try_new(points, &[], false, &Axes::open(at.len()))?;
        let model = TargetModel::new(&smoother, extreme.target, &near);
        if !model.is_smoothest() {
            return None;
        }
        let ends = |axis: usize| match self.axes.is_periodic(axis) {
            true => (0.0, 1.0),
            false => {
                (local(axis, extreme.region.lower[axis]).max(0.0), local(axis, extreme.region.upper[axis]).min(1.0))
            }
        };
        let ends: Vec<(f64, f64)> = (0..at.len()).map(ends).collect();
        let depth = |place: &[f64]| {
            extreme.direction.sign() * (extreme.value - model.at(place, Allowance::NONE).mean()) / extreme.resolution
        };
        let slope = |place: &[f64], axis: usize| {
            let beside = |step: f64| {
                let mut moved = place.to_vec();
                moved[axis] += step;
                depth(&moved)
            };
            (beside(HALF_STEP) - beside(-HALF_STEP)) / (2.0 * HALF_STEP)
        };
        let depth_and_slopes =
            |place: &[f64]| Some((depth(place), (0..place.len()).map(|axis| slope(place, axis)).collect()));
        let centre = vec![0.5; at.len()];
        let found = minimise(depth_and_slopes, &centre, &ends, MAX_STEPS, MIN_STEP)?;
        let gain = depth(&centre) - found.value;
        let back = |(axis, x): (usize, &f64)| {
            let (lower, upper) = (extreme.region.lower[axis], extreme.region.upper[axis]);
            self.axes.inside(axis, at[axis] + 2.0 * radius * (x - 0.5), [lower, upper])
        };
        let place = BoxPoint { combination, at: found.place.iter().enumerate().map(back).collect() };
        (gain > MIN_CLIMB).then_some((gain, place))
    }

    /// The points nearest to `extreme`, itself among them, and how far away they are at most, in units of the box; `None` if there
    /// are no others.
    fn nearest(&self, extreme: &Extreme<'_>) -> Option<(Vec<usize>, f64)> {
        let centre = &self.points[extreme.point];
        let dimensions = centre.at.len();
        let terms = (dimensions + 1) * (dimensions + 2) / 2;
        let mut near: Vec<(f64, usize)> = defined(extreme.target, &self.groups[centre.combination])
            .into_iter()
            .map(|point| (self.axes.distance(centre, &self.points[point]), point))
            .collect();
        sort_by_number(&mut near, |a| a.0);
        near.truncate(POINTS_PER_TERM * terms);
        let radius = near.last()?.0;
        (radius > 0.0).then(|| (near.into_iter().map(|(_, point)| point).collect(), radius))
    }
}

#[cfg(test)]
mod tests {
    use super::Search;
    use crate::data::direction::Direction;
    use crate::search::design::candidates;
    use crate::search::models::noise::Noise;
    use crate::search::models::of_points::Modelled;
    use crate::search::parts::Element;
    use crate::search::search_box::{Axes, BoxPoint, Region};
    use crate::search::target::{Target, TargetKind};

    /// The first of the surroundings of the maximum of `function` on a grid of five by five around `centre`.
    fn first_beside(axes: &Axes, centre: [f64; 2], function: impl Fn(f64, f64) -> f64) -> Vec<f64> {
        const STEP: f64 = 0.01;
        let beside = |axis: usize, steps: i32| axes.inside(axis, centre[axis] + STEP * f64::from(steps), [0.0, 1.0]);
        let grid = (0..25).map(|i| vec![beside(0, i % 5 - 2), beside(1, i / 5 - 2)]);
        let points: Vec<BoxPoint> = grid.map(|at| BoxPoint { combination: 0, at }).collect();
        let values = points.iter().map(|point| function(point.at[0], point.at[1])).collect();
        let target = Target { values, kind: TargetKind::Plain, noise: Noise::NONE, resolutions: [1e-8; 2] };
        let search = Search::new(axes, &points, &candidates(2).unwrap(), [&target]);
        let elements = [Element { mass: 1.0, region: Region::whole(2) }];
        let targets = [(target, vec![Direction::Maximum])];
        let modelled = Modelled { targets: &targets, branches: &search.branches_of_targets(&targets) };
        let mut places = search.surroundings(modelled, &elements, 1);
        places.remove(0).at
    }

    #[test]
    fn analytic_a_climb_ends_at_the_summit_of_a_curved_ridge() {
        const TOLERANCE: f64 = 1e-4;
        let at = first_beside(&Axes::open(2), [0.3, 0.4], |x, y| {
            let across = y - 0.4 - (x - 0.3) * (x - 0.2);
            -across * across - 0.01 * (x - 0.307) * (x - 0.307)
        });
        // (0.307, 0.4 + 0.007 · 0.107)
        assert!((at[0] - 0.307).abs() < TOLERANCE && (at[1] - 0.400_749).abs() < TOLERANCE, "{at:?}");
    }

    #[test]
    fn analytic_a_climb_goes_on_where_an_angle_closes() {
        const TOLERANCE: f64 = 1e-4;
        let at = first_beside(&Axes { is_periodic: vec![true, false] }, [0.998, 0.4], |x, y| {
            (core::f64::consts::TAU * (x - 0.003)).cos() - (y - 0.4) * (y - 0.4)
        });
        assert!((at[0] - 0.003).abs() < TOLERANCE && (at[1] - 0.4).abs() < TOLERANCE, "{at:?}");
    }
}
