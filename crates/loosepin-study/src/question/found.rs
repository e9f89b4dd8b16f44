//! Findings of a study: its bounds, then the results of its questions.

use super::curve_bands::{CurveBand, curve_bands};
use super::rare::Rare;
use super::surrogate::{LearnedBounds, SavedSurrogates};
use crate::assemble::Material;
use crate::error::StudyError;
use crate::file::Sampling;
use crate::planning::goals::RoundsEnd;
use crate::runs::all_runs::Runs;
use crate::runs::table::RunsTable;
use loosepin_bounds::{Bounds, DoubleLoop};
use loosepin_result::study::StudyResult;

/// Findings of a study so far.
pub struct Found {
    /// The double loop of the last round; `None` if the surrogate stands alone.
    pub double_loop: Option<DoubleLoop>,
    pub bounds: Bounds,
    /// How the steps towards the goals ended.
    pub ended: RoundsEnd,
    /// Small probabilities that were not counted.
    pub rare: Vec<Rare>,
    pub surrogate: Option<LearnedBounds>,
    /// Bands for whole curves.
    pub curve_bands: Vec<CurveBand>,
    /// Bounds by the other readings of intervals.
    pub other_readings: Vec<Bounds>,
}

/// A finished study.
pub struct StudyRun {
    /// Everything for pages and files.
    pub result: StudyResult,
    /// Every run.
    pub runs: RunsTable,
    /// The surrogates, to be saved; `None` if the study asks for none.
    pub surrogates: Option<SavedSurrogates>,
}

impl Found {
    /// Bounds alone.
    pub fn new(bounds: Bounds, ended: RoundsEnd) -> Self {
        let (rare, curve_bands, other_readings) = (Vec::new(), Vec::new(), Vec::new());
        Self { double_loop: None, bounds, ended, rare, surrogate: None, curve_bands, other_readings }
    }

    /// Completes the bounds once all runs are made: by the other readings of intervals, and for whole curves.
    ///
    /// # Errors
    /// The table lacks runs.
    pub fn complete(&mut self, runs: &Runs<'_>) -> Result<(), StudyError> {
        let Some(plan) = &self.double_loop else { return Ok(()) };
        let pool = &runs.pool;
        for &reading in &runs.study.readings[1..] {
            let bounds = pool.install(|| plan.read_as(reading).statistics_alone().results(&runs.table))?;
            self.other_readings.push(bounds);
        }
        self.curve_bands = pool.install(|| curve_bands(&self.material(runs), plan))?;
        Ok(())
    }

    /// The inputs of a result.
    pub fn material<'m>(&'m self, runs: &'m Runs<'_>) -> Material<'m> {
        let Runs { study, response, table, .. } = runs;
        let Self { double_loop, bounds, rare, .. } = self;
        let sampling = double_loop.as_ref().map_or(study.sampling, |plan| {
            let loosepin_bounds::Sampling { outer, inner, replicates, .. } = plan.problem().sampling;
            Sampling { outer, inner, replicates, ..study.sampling }
        });
        Material { sampling, rare, ..Material::of_bounds(study, response, table, bounds) }
    }
}
