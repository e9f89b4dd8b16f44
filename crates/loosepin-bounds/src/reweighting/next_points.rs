//! Where runs are made next, where those at few points are weighted for all others.

use rayon::prelude::*;

use super::Pooled;
use crate::assemble::{Evidence, Modelled, Part};
use crate::measure::{Measure, MeasureKind, target};
use crate::plan::DoubleLoop;
use crate::points::structural_point_count;
use crate::pool::Pool;
use crate::problem::Request;
use crate::sample::Sample;
use crate::search::{Direction, Search};
use crate::search_box::{Place, Region};
use crate::table::SampleTable;

/// Weighted runs are looked at for so many new points a round, and gains below this share of the range are not pursued.
const REWEIGHTED_POINTS_PER_ROUND: usize = 4;
const REWEIGHTED_RESOLUTION: f64 = 1e-3;

/// Where weights leave an error, points up to this part of all make it smaller.
const REWEIGHTED_SHARE: usize = 4;

/// Two of these points are never nearer, in units of the box; where they carry weights alone.
const LEAST_DISTANCE_APART: f64 = 1e-4;
const LEAST_DISTANCE_OF_WEIGHTED: f64 = 0.05;

impl DoubleLoop {
    /// Where the weighted runs of all points promise more than has been attained, or cannot tell; where more points do not help, where
    /// the search without weights goes.
    pub(crate) fn next_reweighted(&self, table: &SampleTable, pool: &Pool, count: usize) -> Vec<Place> {
        let most = self.most_reweighted();
        let columns: Vec<usize> = self.searched().iter().map(|(request, _)| request.column).collect();
        if columns.iter().any(|&column| of_column(pool, column).is_none()) {
            return self.next_without_weights(table, pool, count);
        }
        let is_smooth = columns.iter().all(|&column| of_column(pool, column).is_some_and(Pooled::is_smooth));
        let promises = self.promises(table, pool);
        let cannot_tell = promises.first().is_some_and(|(merit, _)| merit.is_infinite());
        // Beside a point that is there another one hardly changes what weights are worth.
        let apart = if is_smooth { LEAST_DISTANCE_APART } else { LEAST_DISTANCE_OF_WEIGHTED };
        let known = self.outer_places(pool);
        let mut chosen: Vec<Place> = Vec::new();
        for (_, place) in promises {
            let is_apart = |other: &Place| self.epistemic_box().axes().distance(other, &place) > apart;
            if known.iter().all(is_apart) && chosen.iter().all(is_apart) {
                chosen.push(place);
            }
        }
        chosen.truncate(count.min(REWEIGHTED_POINTS_PER_ROUND));
        let is_spent = pool.points.len() >= most;
        if cannot_tell && (is_spent || chosen.is_empty()) {
            return self.next_without_weights(table, pool, count);
        }
        if is_spent {
            return Vec::new();
        }
        chosen.truncate(most - pool.points.len());
        chosen
    }

    /// The first points of the search without weights that have no runs yet, then where it goes.
    fn next_without_weights(&self, table: &SampleTable, pool: &Pool, count: usize) -> Vec<Place> {
        let (known, axes) = (self.outer_places(pool), self.epistemic_box().axes());
        let is_new = |place: &&Place| known.iter().all(|other| axes.distance(other, place) > LEAST_DISTANCE_APART);
        let first: Vec<Place> = self.first_outer().iter().filter(is_new).cloned().collect();
        if first.is_empty() { self.next_outer(table, pool, count) } else { first }
    }

    /// Places that promise more than the bounds from these runs would concede anyway, by how many times; the most promising first, and
    /// before all of them those where the weights cannot tell.
    fn promises(&self, table: &SampleTable, pool: &Pool) -> Vec<(f64, Place)> {
        let evidence = Evidence::new(self, pool, table);
        let searched = self.searched();
        let measured: Vec<(&Request, &[Direction], Measure)> = searched
            .iter()
            .filter_map(|(request, directions)| {
                let samples = pool.samples(request.column);
                let measure = Measure::new(&samples, request.statistic, self.confidence())?;
                Some((request, &directions[..], measure))
            })
            .collect();
        let search = evidence.search(measured.iter().map(|(_, _, measure)| measure));
        let of_statistic = |(request, directions, measure): &(&Request, &[Direction], Measure)| -> Vec<(f64, Place)> {
            let Some(pooled) = of_column(pool, request.column) else { return Vec::new() };
            let promise = |&direction: &Direction| self.promise(pooled, &search, measure, direction);
            directions.iter().filter_map(promise).collect()
        };
        let mut promises: Vec<(f64, Place)> = measured.par_iter().flat_map_iter(of_statistic).collect();
        promises.sort_by(|a, b| b.0.total_cmp(&a.0));
        promises
    }

    /// The furthest place of one end of a statistic from the witness of its bound, and how many times what is conceded it gains; nothing
    /// where that is no more than once.
    fn promise(
        &self,
        pooled: &Pooled,
        search: &Search<'_>,
        measure: &Measure,
        direction: Direction,
    ) -> Option<(f64, Place)> {
        let estimates = if direction == Direction::Minimum { &measure.low } else { &measure.high };
        let region = Region::whole(self.epistemic_box().dimensions());
        let part = Part { region: &region, members: (0..estimates.len()).collect() };
        let (witness, sampling) = Modelled::new(search, measure).witness(direction, &part)?;
        let value = estimates[witness].value;
        let beyond = match pooled.furthest(measure.sought, direction, (witness, value), &region, self.confidence()) {
            Err(place) => return Some((f64::INFINITY, place)),
            Ok(beyond) => beyond,
        };
        let is_square = measure.kind == MeasureKind::Deviation;
        let sampling = if is_square { sampling * (sampling + 2.0 * value) } else { sampling };
        let is_index = matches!(measure.kind, MeasureKind::SmoothProbability(_));
        let range = if is_index { target(estimates, self.confidence()).range() } else { measure.target.range() };
        let merit = beyond.gain / sampling.max(REWEIGHTED_RESOLUTION * range);
        (merit > 1.0).then_some((merit, beyond.place))
    }

    /// Points whose runs are weighted for other u, at most: with more of them the search goes without weights. None where the problem
    /// does not ask for it.
    pub(crate) fn most_reweighted(&self) -> usize {
        if !self.problem().sampling.reweighting {
            return 0;
        }
        let structural =
            structural_point_count(self.epistemic_box().dimensions()) * self.epistemic_box().combinations();
        (structural + REWEIGHTED_POINTS_PER_ROUND).max(self.problem().sampling.outer / REWEIGHTED_SHARE)
    }
}

/// The column as the weighted runs know it; nothing where they do not.
fn of_column(pool: &Pool, column: usize) -> Option<&Pooled> {
    pool.samples(column).first().copied().and_then(Sample::pooled)
}
