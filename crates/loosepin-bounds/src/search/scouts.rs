//! Single runs at random u as scouts: where they lie further from what the models expect than chance lets them, nobody has looked.

use super::search_box::BoxPoint;
use crate::data::direction::Direction;
use crate::search::models::of_points::Search;
use loosepin_math::sort_by_number;

/// Least standard deviation of the runs at a point, as a share of the largest at any point.
const MIN_DEVIATION: f64 = 1e-3;

/// Single runs, each at a u of its own, with the nearest outer point in the same combination of the discrete inputs.
pub(crate) struct Scouts<'a> {
    places: &'a [BoxPoint],
    nearest: Vec<Option<usize>>,
}

/// A column of the scouts, and its prediction.
pub(crate) struct Observed<'a> {
    /// Values of the scouts; NaN if a run failed.
    pub values: &'a [f64],
    /// Mean and standard deviation of the runs at every outer point, in the order of the points.
    pub moments: &'a [(f64, f64)],
    /// Mean at the place of every scout, as a model of the means has it.
    pub means: &'a [f64],
    /// How far chance alone brings a scout from its mean to either side, in standard deviations: [`ends_by_chance`].
    pub ends: [f64; 2],
}

/// Range of the runs at outer points, `standardised` (less their mean, in standard deviations), that all but one of `scouts` further runs
/// stay within by chance on either side; `None` if there are none. The runs are put in another order.
pub(crate) fn ends_by_chance(standardised: &mut [f64], scouts: usize) -> Option<[f64; 2]> {
    let most = standardised.len().checked_sub(1)?;
    let further_out = standardised.len().checked_div(scouts)?.min(most);
    let mut at = |place: usize| *standardised.select_nth_unstable_by(place, f64::total_cmp).1;
    Some([at(further_out), at(most - further_out)])
}

impl Search<'_> {
    /// The scouts at `places`.
    pub fn scouts<'s>(&self, places: &'s [BoxPoint]) -> Scouts<'s> {
        let nearest = |place: &BoxPoint| {
            let group = self.groups.get(place.combination).map_or(&[][..], |group| group);
            let distances = group.iter().map(|&point| (self.axes.distance(&self.points[point], place), point));
            distances.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, point)| point)
        };
        Scouts { places, nearest: places.iter().map(nearest).collect() }
    }

    /// The places of those of `scouts` that lie further out, in standard deviations of the runs at the nearest outer point, than runs at
    /// the outer points lie from their own mean in all but one of as many: chance alone brings one of them to either side. The furthest
    /// first; at most `count`.
    pub fn calls(&self, scouts: &Scouts<'_>, observed: &Observed<'_>, count: usize) -> Vec<BoxPoint> {
        let deviations = observed.moments.iter().map(|(_, deviation)| *deviation);
        let least = MIN_DEVIATION * deviations.filter(|deviation| deviation.is_finite()).fold(0.0, f64::max);
        let mut calls: Vec<(f64, &BoxPoint)> = Vec::new();
        for (scout, place) in scouts.places.iter().enumerate() {
            let Some(nearest) = scouts.nearest[scout] else { continue };
            let out = (observed.values[scout] - observed.means[scout]) / observed.moments[nearest].1.max(least);
            let further = Direction::BOTH.map(|direction| direction.sign() * (out - observed.ends[direction.index()]));
            let furthest = further[0].max(further[1]);
            if furthest > 0.0 {
                calls.push((furthest, place));
            }
        }
        sort_by_number(&mut calls, |a| -a.0);
        self.new_places(calls.into_iter().map(|(_, place)| place.clone()), count)
    }
}

#[cfg(test)]
mod tests {
    use super::{Observed, ends_by_chance};
    use crate::data::direction::Direction;
    use crate::search::models::of_points::Search;
    use crate::search::search_box::{Axes, BoxPoint};
    use loosepin_uncertainty::normal_quantile;

    /// 1,000 scouts of a response whose mean is 0 and whose standard deviation is 0.1, but for a hill 1 high between 0.62 and 0.63.
    #[test]
    fn analytic_a_hill_that_only_scouts_have_met_is_called() {
        let axes = Axes::open(1);
        let place = |x: f64| BoxPoint { combination: 0, at: vec![x] };
        let points: Vec<BoxPoint> = (0..=10).map(|i| place(0.1 * f64::from(i))).collect();
        let level = |run: usize| (run as f64 + 0.5) / 1000.0;
        let places: Vec<BoxPoint> = (0..1000).map(|run| place(level(run))).collect();
        let value = |run: usize| {
            let hill = if (0.62..0.63).contains(&level(run)) { 1.0 } else { 0.0 };
            // Every run has another one of as many quantiles.
            hill + 0.1 * normal_quantile(level(7 * run % 1000))
        };
        let values: Vec<f64> = (0..1000).map(value).collect();
        // In another order than that of their values.
        let mut scatter: Vec<f64> =
            (0..10_000).map(|run| normal_quantile((f64::from(7 * run % 10_000) + 0.5) / 10_000.0)).collect();
        let ends = ends_by_chance(&mut scatter, places.len()).unwrap();
        // Ten runs of 10,000 lie beyond the one that is taken.
        let expected = normal_quantile(10.5 / 10_000.0);
        assert!((ends[0] - expected).abs() < 1e-12 && (ends[1] + expected).abs() < 1e-12, "{ends:?}, not ±{expected}");
        let observed = Observed { values: &values, moments: &[(0.0, 0.1); 11], means: &[0.0; 1000], ends };
        let search = Search::new(&axes, &points, &[], []);
        let called = search.calls(&search.scouts(&places), &observed, 4);
        assert!((0.62..0.63).contains(&called[0].at[0]), "{called:?}");
        // Two places of a round are not nearer than 0.02: one on the hill, and at most one of chance to either side.
        assert!(called.len() <= 1 + Direction::BOTH.len(), "{called:?}");
    }
}
