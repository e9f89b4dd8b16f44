//! Single runs at random u as scouts: where they lie further from what the models expect than chance lets them, nobody has looked.

use super::models::Search;
use super::search_box::Place;
use crate::data::direction::{Direction, extreme_among};

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
        let mut calls: Vec<(f64, &Place)> = Vec::new();
        for (scout, mean) in scouts.iter().zip(expectation.means) {
            let group = self.groups.get(scout.place.combination).map_or(&[][..], |group| group);
            let near: Vec<f64> = self.points.iter().map(|point| self.axes.distance(point, &scout.place)).collect();
            let Some(nearest) = extreme_among(&near, group.iter().copied(), Direction::Minimum) else { continue };
            let out = (scout.value - mean) / expectation.moments[nearest].1;
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
