//! Climbs of models to their summits between the candidates, by their slopes. The targets of curves are thousands: each end takes some ten
//! evaluations of a model, where the search along the axes for a single number takes a hundred and more.

use super::search_box::{Axes, Region};
use crate::data::direction::Direction;
use crate::search::models::prediction::Allowance;
use crate::search::models::target_model::TargetModel;
use loosepin_math::descent::minimise;

/// A step of a climb, in units of the box: about the distance of candidates in a plane.
const STEP: f64 = 0.05;

/// Steps of a climb, at most.
const MAX_STEPS: usize = 30;

/// A climb ends where two steps in turn gain less than this share of the range of the target: a tenth of what is always conceded.
const MIN_STEP: f64 = 1e-7;

/// The way up a model in `direction` over `region`.
pub(super) struct Climb<'a> {
    axes: &'a Axes,
    model: &'a TargetModel<'a>,
    direction: Direction,
    region: &'a Region,
    tolerance: f64,
}

impl<'a> Climb<'a> {
    /// The climb on the model of a target with this `range`.
    pub fn new(
        axes: &'a Axes,
        model: &'a TargetModel<'a>,
        direction: Direction,
        region: &'a Region,
        range: f64,
    ) -> Self {
        Self { axes, model, direction, region, tolerance: MIN_STEP * range }
    }

    /// Allowance for model error at the end of a climb from `start`. What is rough is no part of the slopes that are climbed.
    pub fn concession_above(&self, start: &[f64]) -> f64 {
        let summit = self.summit(start);
        self.model.at(&summit, Allowance::CONCESSION).moved(Allowance::CONCESSION, self.direction.sign())
    }

    /// The smooth part of what is conceded, upwards in `direction`, with its slopes.
    fn height(&self, place: &[f64]) -> (f64, Vec<f64>) {
        let sign = self.direction.sign();
        let (moved, slopes) = self.model.moved_and_slopes(place, Allowance::CONCEDED_TREND, sign);
        (sign * moved, slopes.into_iter().map(|slope| sign * slope).collect())
    }

    /// Whether a rounded summit within `distance` of `place` may be higher than `furthest`: it is higher than the place by half of the
    /// slope there times its distance.
    pub fn may_exceed(&self, furthest: f64, place: &[f64], distance: f64) -> bool {
        let (height, slopes) = self.height(place);
        let is_free = |axis: usize| {
            let ahead = if slopes[axis] > 0.0 { self.region.upper[axis] } else { self.region.lower[axis] };
            self.axes.is_periodic(axis) || place[axis] != ahead
        };
        let square: f64 = (0..place.len()).filter(|&axis| is_free(axis)).map(|axis| slopes[axis] * slopes[axis]).sum();
        height + 0.5 * distance * square.sqrt() > self.direction.sign() * furthest
    }

    /// The nearest place from which the model goes no further.
    fn summit(&self, start: &[f64]) -> Vec<f64> {
        let moved = |steps: &[f64]| -> Vec<f64> {
            let of = |(axis, step): (usize, &f64)| {
                let ends = [self.region.lower[axis], self.region.upper[axis]];
                self.axes.inside(axis, start[axis] + STEP * step, ends)
            };
            steps.iter().enumerate().map(of).collect()
        };
        let depth = |steps: &[f64]| {
            let (height, slopes) = self.height(&moved(steps));
            height.is_finite().then(|| (-height, slopes.into_iter().map(|slope| -STEP * slope).collect()))
        };
        let ends = |axis: usize| match self.axes.is_periodic(axis) {
            true => (-0.5 / STEP, 0.5 / STEP),
            false => ((self.region.lower[axis] - start[axis]) / STEP, (self.region.upper[axis] - start[axis]) / STEP),
        };
        let ends: Vec<(f64, f64)> = (0..start.len()).map(ends).collect();
        let found = minimise(depth, &vec![0.0; start.len()], &ends, MAX_STEPS, self.tolerance);
        found.map_or_else(|| start.to_vec(), |found| moved(&found.place))
    }
}

#[cfg(test)]
mod tests {
    use crate::data::direction::Direction;
    use crate::search::design::{candidates, first_points};
    use crate::search::models::local::LocalSmoothers;
    use crate::search::models::noise::Noise;
    use crate::search::models::of_points::{MAX_LOCATED_TARGETS, Search};
    use crate::search::models::prediction::Allowance;
    use crate::search::models::target_model::TargetModel;
    use crate::search::search_box::{Axes, BoxPoint, Region};
    use crate::search::target::{Target, TargetKind};

    fn target(values: Vec<f64>, kind: TargetKind) -> Target {
        Target { values, kind, noise: Noise::NONE, resolutions: [1e-9; 2] }
    }

    /// Excess over 1 of the reach of each of many targets, the greatest value of `function` of a place and of the place of its summit.
    fn beyond_summits(axes: &Axes, function: impl Fn(&[f64], &[f64]) -> f64) -> Vec<f64> {
        let summits = first_points(17, 2, 5 + MAX_LOCATED_TARGETS + 1).unwrap().split_off(5);
        let points: Vec<BoxPoint> =
            first_points(5, 2, 40).unwrap().into_iter().map(|at| BoxPoint { combination: 0, at }).collect();
        let of = |summit: &Vec<f64>| {
            target(points.iter().map(|point| function(&point.at, summit)).collect(), TargetKind::Plain)
        };
        let targets: Vec<Target> = summits.iter().map(of).collect();
        let search = Search::new(axes, &points, &candidates(2).unwrap(), &targets);
        assert!(search.is_of_curves());
        let whole = Region::whole(2);
        let beyond = |target: &Target| {
            let branches = search.branches(target);
            search.furthest_reach(target, &branches, Direction::Maximum, &whole) - 1.0
        };
        targets.iter().map(beyond).collect()
    }

    #[test]
    fn analytic_a_summit_of_one_of_many_targets_is_met_between_the_candidates() {
        // Before, the best candidate stood for it: up to 2e-3 short.
        const ROUND_OFF: f64 = 1e-9;
        const MOST: f64 = 1e-5;
        let bowl = |at: &[f64], summit: &[f64]| 1.0 - (at[0] - summit[0]).powi(2) - (at[1] - summit[1]).powi(2);
        let beyond = beyond_summits(&Axes::open(2), bowl);
        assert!(beyond.iter().all(|beyond| *beyond > -ROUND_OFF && *beyond < MOST), "{beyond:?}");
    }

    #[test]
    fn analytic_a_summit_is_met_where_an_angle_closes() {
        // Four deviations of a model of 40 points.
        const MOST: f64 = 5e-3;
        let hill = |at: &[f64], summit: &[f64]| {
            let angle = core::f64::consts::TAU * (at[0] - summit[0]);
            angle.cos() - (at[1] - summit[1]).powi(2)
        };
        let beyond = beyond_summits(&Axes { is_periodic: vec![true, false] }, hill);
        assert!(beyond.iter().all(|beyond| *beyond >= 0.0 && *beyond < MOST), "{beyond:?}");
    }

    #[test]
    fn identity_slopes_are_those_of_differences() {
        const STEP: f64 = 1e-4;
        // Of slopes up to 6. Central differences err by 4e-7 (third derivatives of 250), and by the round-off of a deviation of a model without
        // noise, 1e-9, over the step. That of either of two events is itself a difference of indices over 1e-4.
        const TOLERANCE: f64 = 2e-4;
        let axes = Axes { is_periodic: vec![false, true, false] };
        let points = first_points(3, 3, 40).unwrap();
        let wave = |shift: f64| -> Vec<f64> {
            let of = |u: &Vec<f64>| (3.0 * u[0] + shift).sin() + (6.3 * u[1]).cos() * (0.5 + u[2] * u[2]);
            points.iter().map(of).collect()
        };
        let roof: Vec<f64> = points.iter().map(|u| (u[0] - 0.4).abs() + (u[2] - 0.7).abs()).collect();
        let noisy: Vec<f64> = wave(0.3).iter().zip(0..).map(|(own, i)| own + 0.2 * f64::from(i * 7 % 11)).collect();
        let noise = Noise { variance: 0.4, replicates: Vec::new() };
        let targets = [
            target(wave(0.0), TargetKind::Plain),
            target(roof, TargetKind::Plain),
            Target { noise, ..target(noisy, TargetKind::Plain) },
            target(wave(0.7), TargetKind::Index),
            target(wave(0.7), TargetKind::Either([wave(0.1), wave(1.3)])),
        ];
        let smoother = LocalSmoothers::try_new(points.clone(), &[], true, &axes).unwrap();
        let all: Vec<usize> = (0..points.len()).collect();
        let models = targets.each_ref().map(|target| TargetModel::new(&smoother, target, &all));
        for (kind, model) in models.iter().enumerate() {
            for place in [[0.3, 0.2, 0.6], [0.85, 0.95, 0.15], [0.05, 0.6, 0.9]] {
                for sign in [-1.0, 1.0] {
                    let allowance = Allowance::CONCEDED_TREND;
                    let (moved, slopes) = model.moved_and_slopes(&place, allowance, sign);
                    let at = |place: &[f64]| model.at(place, allowance).moved(allowance, sign);
                    assert!((moved - at(&place)).abs() < 1e-9, "{kind}: {moved}");
                    for (axis, slope) in slopes.iter().enumerate() {
                        let beside = |step: f64| {
                            let mut place = place;
                            place[axis] += step;
                            at(&place)
                        };
                        let expected = (beside(STEP) - beside(-STEP)) / (2.0 * STEP);
                        assert!((slope - expected).abs() < TOLERANCE, "{kind}, axis {axis}: {slope} {expected}");
                    }
                }
            }
        }
    }
}
