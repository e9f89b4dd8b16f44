//! Single runs at random u as scouts: where they lie further from what the models expect than chance lets them, nobody has looked.

use super::models::Search;
use super::search_box::Place;
use crate::data::direction::{Direction, extreme_among};

/// Where the runs at a point hardly differ they have this share of the largest standard deviation at any point.
const LEAST_DEVIATION: f64 = 1e-3;

/// A run at a u of its own.
#[derive(Debug, Clone)]
pub(crate) struct Scout {
    pub place: Place,
    pub value: f64,
}

/// What scouts of a column are held against.
pub(crate) struct Expectation<'a> {
    /// Mean and standard deviation of the runs at every outer point, in the order of the points.
    pub moments: &'a [(f64, f64)],
    /// Mean at the place of every scout, as a model of the means has it.
    pub means: &'a [f64],
    /// The runs at all outer points less their mean, in standard deviations, in increasing order.
    pub scatter: &'a [f64],
}

impl Search<'_> {
    /// The places of those of `scouts` that lie further out, in standard deviations of the runs at the nearest outer point, than runs at
    /// the outer points lie from their own mean in all but one of as many: chance alone brings one of them to either side. The furthest
    /// first; at most `count`.
    pub fn calls(&self, scouts: &[Scout], expectation: &Expectation<'_>, count: usize) -> Vec<Place> {
        let runs = expectation.scatter.len();
        if runs == 0 || scouts.is_empty() {
            return Vec::new();
        }
        // One in as many runs as there are scouts lies further out.
        let further_out = (runs / scouts.len()).min(runs - 1);
        let ends = [expectation.scatter[further_out], expectation.scatter[runs - 1 - further_out]];
        let deviations = expectation.moments.iter().map(|(_, deviation)| *deviation);
        let least = LEAST_DEVIATION * deviations.filter(|deviation| deviation.is_finite()).fold(0.0, f64::max);
        let mut calls: Vec<(f64, &Place)> = Vec::new();
        for (scout, mean) in scouts.iter().zip(expectation.means) {
            let group = self.groups.get(scout.place.combination).map_or(&[][..], |group| group);
            let near: Vec<f64> = self.points.iter().map(|point| self.axes.distance(point, &scout.place)).collect();
            let Some(nearest) = extreme_among(&near, group.iter().copied(), Direction::Minimum) else { continue };
            let out = (scout.value - mean) / expectation.moments[nearest].1.max(least);
            let further = Direction::BOTH.map(|direction| direction.sign() * (out - ends[direction.index()]));
            let furthest = further[0].max(further[1]);
            if furthest > 0.0 {
                calls.push((furthest, &scout.place));
            }
        }
        calls.sort_by(|a, b| b.0.total_cmp(&a.0));
        self.new_places(calls.into_iter().map(|(_, place)| place.clone()), count)
    }
}

#[cfg(test)]
mod tests {
    use super::{Expectation, Scout};
    use crate::data::direction::Direction;
    use crate::search::models::Search;
    use crate::search::search_box::{Axes, Place};
    use loosepin_uncertainty::normal_quantile;

    /// 1,000 scouts of a response whose mean is 0 and whose standard deviation is 0.1, but for a hill 1 high between 0.62 and 0.63.
    #[test]
    fn analytic_a_hill_that_only_scouts_have_met_is_called() {
        let axes = Axes::open(1);
        let place = |x: f64| Place { combination: 0, at: vec![x] };
        let points: Vec<Place> = (0..=10).map(|i| place(0.1 * f64::from(i))).collect();
        let level = |run: usize| (run as f64 + 0.5) / 1000.0;
        let scouts: Vec<Scout> = (0..1000)
            .map(|run| {
                let x = level(run);
                let hill = if (0.62..0.63).contains(&x) { 1.0 } else { 0.0 };
                // Every run has another one of as many quantiles.
                Scout { place: place(x), value: hill + 0.1 * normal_quantile(level(7 * run % 1000)) }
            })
            .collect();
        let scatter: Vec<f64> = (0..10_000).map(|run| normal_quantile((f64::from(run) + 0.5) / 10_000.0)).collect();
        let expectation = Expectation { moments: &[(0.0, 0.1); 11], means: &[0.0; 1000], scatter: &scatter };
        let search = Search::new(&axes, &points, &[], []);
        let called = search.calls(&scouts, &expectation, 4);
        assert!((0.62..0.63).contains(&called[0].at[0]), "{called:?}");
        // Two places of a round are not nearer than 0.02: one on the hill, and at most one of chance to either side.
        assert!(called.len() <= 1 + Direction::BOTH.len(), "{called:?}");
    }
}
