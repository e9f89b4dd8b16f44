//! The runs of the probability-only treatment, read as scouts of the double loop.

use std::collections::BTreeSet;

use super::double_loop::DoubleLoop;
use crate::data::table::{Purpose, SampleTable};
use crate::estimators::pool::Pool;
use crate::search::measure::Measure;
use crate::search::models::Search;
use crate::search::scouts::{Expectation, Scout};
use crate::search::search_box::Place;

/// Of the poses of curves so many are read, evenly among them.
const MOST_COLUMNS: usize = 8;

impl DoubleLoop {
    /// At most `count` places of runs of the probability-only treatment that lie where no model expects them ([`Search::calls`]), those
    /// of the first columns first.
    pub(super) fn called_places(
        &self,
        table: &SampleTable,
        pool: &Pool,
        search: &Search<'_>,
        count: usize,
    ) -> Vec<Place> {
        let columns: BTreeSet<usize> = self.setup.searched().iter().map(|(request, _)| request.column).collect();
        let step = columns.len().div_ceil(MOST_COLUMNS).max(1);
        let calls = columns.into_iter().step_by(step).flat_map(|column| self.calls(table, pool, search, column, count));
        search.new_places(calls, count)
    }

    fn calls(&self, table: &SampleTable, pool: &Pool, search: &Search<'_>, column: usize, count: usize) -> Vec<Place> {
        let runs = table.inputs().iter().enumerate().filter(|(_, inputs)| inputs.purpose == Purpose::Mixture);
        let scouts: Vec<Scout> = runs
            .map(|(run, inputs)| Scout {
                place: self.setup.epistemic_box.place_of(&inputs.epistemic),
                value: table.values(run)[column],
            })
            .filter(|scout| scout.value.is_finite())
            .collect();
        let samples = pool.samples(column);
        let means = Measure::mean(&samples, &self.setup.confidence).target;
        let points = self.setup.outer_places(pool);
        let models = Search::new(self.setup.epistemic_box.axes(), &points, &[], [&means]);
        let branches = models.branches(&means);
        let expected = |scout: &Scout| {
            let branch = branches.get(scout.place.combination);
            branch.and_then(|branch| branch.at(&scout.place.at)).map_or(f64::NAN, |forecast| forecast.mean())
        };
        let moments: Vec<(f64, f64)> = samples.iter().map(|sample| sample.mean_and_deviation()).collect();
        let runs = samples.iter().zip(&moments);
        let mut scatter: Vec<f64> = runs
            .flat_map(|(sample, (mean, deviation))| sample.values().iter().map(move |y| (y - mean) / deviation))
            .filter(|out| out.is_finite())
            .collect();
        scatter.sort_unstable_by(f64::total_cmp);
        let means: Vec<f64> = scouts.iter().map(expected).collect();
        search.calls(&scouts, &Expectation { moments: &moments, means: &means, scatter: &scatter }, count)
    }
}
