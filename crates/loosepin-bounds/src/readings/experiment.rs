//! All runs of the double loop, ready to be asked.

use super::setup::Setup;
use crate::data::bound::{Bound, Guarantee};
use crate::data::direction::Direction;
use crate::data::gaps::Gaps;
use crate::data::table::{Purpose, SampleTable};
use crate::estimators::pool::Pool;
use crate::measures::measure::Measure;
use crate::search::gaps::largest_gap;
use crate::search::models::of_points::Search;
use crate::search::models::shared_grids::SharedGrids;
use crate::search::parts::{Cut, Element};
use crate::search::search_box::{BoxPoint, Region};
use loosepin_terms::Statistic;
use loosepin_uncertainty::EpistemicVariable;

/// A value of the plan that differs from the middle by less than this share of it differs by round-off.
const MIDDLE_ROUND_OFF: f64 = 1e-12;

/// The runs at all outer points, with their places in the search box.
pub(crate) struct Experiment<'a> {
    pub setup: &'a Setup,
    pub pool: &'a Pool,
    pub table: &'a SampleTable,
    /// One for each outer point.
    pub places: Vec<BoxPoint>,
    /// Models of the outer points, which all answers share.
    grids: SharedGrids,
}

/// A focal element, or the whole box with all of the mass, and the outer points in it.
pub(crate) struct Focal<'a> {
    pub mass: f64,
    pub region: &'a Region,
    pub members: Vec<usize>,
}

impl<'a> Experiment<'a> {
    /// The runs of `pool`, gathered from `table`.
    pub fn new(setup: &'a Setup, pool: &'a Pool, table: &'a SampleTable) -> Self {
        let grids = SharedGrids::after(table, Purpose::DoubleLoop);
        Self { setup, pool, table, places: setup.outer_places(pool), grids }
    }

    /// The focal elements of `cut`.
    pub fn focal_elements<'c>(&self, cut: &'c Cut) -> Vec<Focal<'c>> {
        let focal = |Element { mass, region }: &'c Element| Focal {
            mass: *mass,
            region,
            members: region.members(&self.places),
        };
        cut.elements.iter().map(focal).collect()
    }

    /// The outer point at which every epistemic input is in its middle, lists at their first members, where all of the mass is in one
    /// element and that point in it.
    pub fn centre(&self, elements: &[Focal<'_>]) -> Option<usize> {
        let [whole] = elements else { return None };
        let middle: Vec<f64> = self.setup.problem.epistemic.iter().map(EpistemicVariable::middle).collect();
        let is_near = |(value, middle): (&f64, &f64)| (value - middle).abs() <= MIDDLE_ROUND_OFF * middle.abs();
        let is_centre = |point: &usize| self.pool.points[*point].epistemic.iter().zip(&middle).all(is_near);
        whole.members.iter().copied().find(is_centre)
    }

    /// Models for everything that `measures` search.
    pub fn search<'s>(&'s self, measures: impl Iterator<Item = &'s Measure>) -> Search<'s> {
        self.search_targets(measures.flat_map(Measure::targets))
    }

    /// Models of `targets` over the epistemic box.
    pub fn search_targets<'s>(
        &'s self,
        targets: impl IntoIterator<Item = &'s crate::search::target::Target>,
    ) -> Search<'s> {
        let axes = self.setup.epistemic_box.axes();
        Search::sharing(&self.grids, axes, &self.places, &self.setup.candidates, targets)
    }

    /// How finely the box was seen; `None` if it is a point.
    pub fn gaps(&self) -> Option<Gaps> {
        let Setup { epistemic_box, candidates, .. } = self.setup;
        if epistemic_box.is_a_point() {
            return None;
        }
        let gap =
            |places: &[BoxPoint]| largest_gap(epistemic_box.axes(), epistemic_box.combinations(), places, candidates);
        let of_mixture = self.table.inputs().iter().filter(|inputs| inputs.purpose == Purpose::Mixture);
        let single = of_mixture.map(|inputs| epistemic_box.place_of(&inputs.epistemic));
        let all: Vec<BoxPoint> = self.places.iter().cloned().chain(single).collect();
        let between_points = gap(&self.places);
        // A search for the largest one may end lower among more points.
        Some(Gaps { between_points, between_runs: gap(&all).min(between_points) })
    }

    /// Runs of `column` that failed.
    pub fn failed_runs(&self, column: usize) -> usize {
        self.pool.samples(column).iter().map(|sample| sample.failed()).sum()
    }

    /// The kind of guarantee that bounds from these runs have.
    pub fn guarantee(&self) -> Guarantee {
        let problem = &self.setup.problem;
        let (has_random, has_epistemic) = (!problem.random.is_empty(), !self.setup.has_no_epistemic_inputs());
        Guarantee::of_inputs(has_random, has_epistemic, problem.sampling.confidence)
    }

    /// The bound that says nothing.
    pub fn unknown(&self, direction: Direction) -> Bound {
        Bound::unknown(direction, self.guarantee())
    }

    /// The bound that says no more of `statistic` than what it can be at all.
    pub fn unknown_of(&self, statistic: Statistic, direction: Direction) -> Bound {
        let [least, greatest] = statistic.range();
        let unknown = self.unknown(direction);
        Bound { widened: unknown.widened.clamp(least, greatest), ..unknown }
    }
}
