//! What a study has found: its bounds, then what its questions add.

use super::curve_bands::{CurveBand, curve_bands};
use super::rare::Rare;
use super::surrogate::{LearnedBounds, SavedSurrogates};
use crate::assemble::Material;
use crate::error::StudyError;
use crate::file::Study;
use crate::goals::Ended;
use crate::sheet::Sheet;
use loosepin_bounds::{Bounds, DoubleLoop};
use loosepin_result::study::StudyResult;

/// What a study has found so far.
pub struct Found {
    /// The study with the samples that it came to have.
    pub study: Study,
    /// The double loop of the last round; `None` if the surrogate stands alone.
    pub double_loop: Option<DoubleLoop>,
    pub bounds: Bounds,
    /// How the steps towards the goals ended.
    pub ended: Ended,
    /// Small probabilities that were not counted.
    pub rare: Vec<Rare>,
    pub surrogate: Option<LearnedBounds>,
    /// Bands for whole curves.
    pub curve_bands: Vec<CurveBand>,
    /// Bounds by the other readings of intervals.
    pub other_readings: Vec<Bounds>,
}

/// The result while questions write their answers into it.
pub struct Conclusion<'c> {
    pub material: Material<'c>,
    pub found: &'c Found,
    pub input_hash: &'c str,
    pub result: StudyResult,
    /// The surrogates, to be saved; `None` if the study asks for none.
    pub surrogates: Option<SavedSurrogates>,
}

impl Found {
    /// Nothing but bounds.
    pub fn new(study: Study, bounds: Bounds, ended: Ended) -> Self {
        let (rare, curve_bands, other_readings) = (Vec::new(), Vec::new(), Vec::new());
        Self { study, double_loop: None, bounds, ended, rare, surrogate: None, curve_bands, other_readings }
    }

    /// Completes the bounds once all runs are made: by the other readings of intervals, and for whole curves.
    ///
    /// # Errors
    /// The table lacks runs.
    pub fn complete(&mut self, sheet: &Sheet<'_>) -> Result<(), StudyError> {
        let Some(plan) = &self.double_loop else { return Ok(()) };
        let pool = sheet.runner.pool;
        for &reading in &sheet.study.readings[1..] {
            let bounds = pool.install(|| plan.read_as(reading).statistics_alone().results(&sheet.table))?;
            self.other_readings.push(bounds);
        }
        self.curve_bands = pool.install(|| curve_bands(&self.material(sheet), plan))?;
        Ok(())
    }

    /// What a result is made from.
    pub fn material<'m>(&'m self, sheet: &'m Sheet<'_>) -> Material<'m> {
        let (study, response, table, bounds) = (&self.study, sheet.response, &sheet.table, &self.bounds);
        Material { study, response, table, bounds, pairs: &bounds.pairs, rare: &self.rare }
    }
}
