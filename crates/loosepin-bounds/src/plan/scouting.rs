//! The runs of the probability-only treatment, read as scouts of the double loop.

use std::collections::BTreeSet;

use super::double_loop::DoubleLoop;
use super::steering::SoughtExtremes;
use crate::data::table::{Purpose, SampleTable};
use crate::estimators::pool::Pool;
use crate::estimators::sample::Sample;
use crate::measures::mean::Mean;
use crate::measures::measure::Estimator;
use crate::parallel;
use crate::search::models::of_points::Search;
use crate::search::models::prediction::Allowance;
use crate::search::models::shared_grids::SharedGrids;
use crate::search::scouts::{Observed, ends_by_chance};
use crate::search::search_box::BoxPoint;
use crate::search::target::Target;

/// Largest number of columns that are read; of more, which are the poses of curves, this many, evenly among them.
const MAX_COLUMNS: usize = 16;

impl DoubleLoop {
    /// At most `count` places of runs of the probability-only treatment that lie where no model expects them ([`Search::calls`]), those
    /// of the columns in turn.
    pub(super) fn called_places(
        &self,
        table: &SampleTable,
        pool: &Pool,
        searched: &[SoughtExtremes],
        (search, grids): (&Search<'_>, &SharedGrids),
        count: usize,
    ) -> Vec<BoxPoint> {
        let inputs = table.inputs().iter().enumerate();
        let runs: Vec<usize> =
            inputs.filter(|(_, run)| run.purpose == Purpose::Mixture).map(|(index, _)| index).collect();
        if runs.is_empty() || count == 0 {
            return Vec::new();
        }
        let place = |&run: &usize| self.setup.epistemic_box.place_of(&table.inputs()[run].epistemic);
        let places: Vec<BoxPoint> = runs.iter().map(place).collect();
        let columns: BTreeSet<usize> = searched.iter().map(|(request, _)| request.column).collect();
        let step = columns.len().div_ceil(MAX_COLUMNS).max(1);
        let columns: Vec<usize> = columns.into_iter().step_by(step).collect();
        let mean = |&column: &usize| Mean.measure(&pool.samples(column), &self.setup.confidence).target;
        let means: Vec<Target> = columns.iter().map(mean).collect();
        let points = self.setup.outer_places(pool);
        let at: Vec<Vec<f64>> = places.iter().map(|place| place.at.clone()).collect();
        let models = Search::sharing(grids, self.setup.epistemic_box.axes(), &points, &at, &means);
        let scouts = search.scouts(&places);
        let calls = |index: usize| {
            let (column, mean) = (&columns[index], &means[index]);
            let values: Vec<f64> = runs.iter().map(|&run| table.values(run)[*column]).collect();
            let mut scatter = Scatter::new(&pool.samples(*column));
            let Some(ends) = ends_by_chance(&mut scatter.standardised, places.len()) else { return Vec::new() };
            let means = expected(&models, mean, &places);
            let observed = Observed { values: &values, moments: &scatter.moments, means: &means, ends };
            search.calls(&scouts, &observed, count)
        };
        let calls: Vec<Vec<BoxPoint>> = parallel::map_indices(columns.len(), calls);
        let turns = (0..count).flat_map(|turn| calls.iter().filter_map(move |own| own.get(turn).cloned()));
        search.new_places(turns, count)
    }
}

/// The mean at every one of `places`, those of the candidates of `models`; NaN if there is no model.
fn expected(models: &Search<'_>, mean: &Target, places: &[BoxPoint]) -> Vec<f64> {
    let branches = models.branches(mean);
    let of_branch: Vec<Vec<f64>> = branches
        .iter()
        .map(|branch| {
            branch.at_candidates(Allowance::NONE).into_iter().flatten().map(|forecast| forecast.mean()).collect()
        })
        .collect();
    let at = |(index, place): (usize, &BoxPoint)| {
        let own = of_branch.get(place.combination).and_then(|means: &Vec<f64>| means.get(index));
        own.copied().unwrap_or(f64::NAN)
    };
    places.iter().enumerate().map(at).collect()
}

/// How the runs at the outer points lie about their means.
struct Scatter {
    /// Mean and standard deviation at every point.
    moments: Vec<(f64, f64)>,
    /// All of them, less the mean of their point and in its standard deviations.
    standardised: Vec<f64>,
}

impl Scatter {
    fn new(samples: &[&Sample]) -> Self {
        let moments = |sample: &&Sample| (sample.sums().mean, sample.sums().deviation());
        let moments: Vec<(f64, f64)> = samples.iter().map(moments).collect();
        let standardised: Vec<f64> = samples
            .iter()
            .zip(&moments)
            .flat_map(|(sample, (mean, deviation))| sample.values().iter().map(move |y| (y - mean) / deviation))
            .filter(|out| out.is_finite())
            .collect();
        Self { moments, standardised }
    }
}
