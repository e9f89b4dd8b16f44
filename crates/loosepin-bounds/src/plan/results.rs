//! From the finished table to answers.

use super::double_loop::DoubleLoop;
use super::error::PlanError;
use crate::data::table::{Purpose, SampleTable};
use crate::estimators::pool::Pool;
use crate::readings::bounds::Bounds;
use crate::readings::experiment::Experiment;
use crate::readings::pinching::Pinching;
use crate::readings::probability_box::ProbabilityBox;
use crate::readings::simultaneous::{BandShape, SimultaneousBand};
use crate::readings::treatment::TreatmentComparison;

impl DoubleLoop {
    /// Bounds from the runs in `table`. The plan need not be finished, but the first round must be.
    ///
    /// # Errors
    ///
    /// [`PlanError`] where the table is empty, belongs to another problem or lacks runs.
    pub fn results(&self, table: &SampleTable) -> Result<Bounds, PlanError> {
        self.check_table(table)?;
        let problem = self.problem();
        let pool = Pool::gather(table, Purpose::DoubleLoop, self.setup.needed_columns());
        if pool.points.is_empty() {
            return Err(PlanError::NoRuns);
        }
        self.check_points(&pool)?;
        let pool = self.setup.with_polynomials(pool, table);
        let experiment = Experiment::new(&self.setup, &pool, table);
        let mut levels = experiment.cuts();
        let pairs = levels.first().map(|level| level.pairs.clone()).unwrap_or_default();
        if levels.len() == 1 {
            levels.clear();
        }
        let functions = problem.requests.iter().filter(|request| request.statistic.is_distribution_function());
        Ok(Bounds {
            reading: problem.reading,
            pairs,
            levels,
            percentiles: experiment.percentiles(),
            boxes: functions.map(|request| ProbabilityBox::new(&experiment, request.column)).collect(),
            comparisons: TreatmentComparison::all(&experiment),
            outer_points: pool.points.iter().map(|point| point.epistemic.clone()).collect(),
            centre_point: self.centre_point(),
            gaps: experiment.gaps(),
            runs: table.len(),
            failed_runs: table.failed(),
            rounds: table.rounds(),
        })
    }

    /// The pinching of the band of `columns`; `None` if a quantile has no model, as with too few points.
    ///
    /// # Errors
    ///
    /// [`PlanError`] where the table lacks runs.
    pub fn pinching(&self, table: &SampleTable, columns: &[usize]) -> Result<Option<Pinching>, PlanError> {
        let pool = Pool::gather(table, Purpose::DoubleLoop, columns.iter().copied());
        self.check_points(&pool)?;
        let pool = self.setup.with_polynomials(pool, table);
        Ok(Experiment::new(&self.setup, &pool, table).pinching(columns))
    }

    /// The band in which at least `share` of the runs stay at all of `columns` together, whatever the epistemic inputs; its form is
    /// that of `shape`, lower and upper ends column by column. `None` if the ends are not finite or nowhere apart.
    ///
    /// # Errors
    ///
    /// [`PlanError`] where the table lacks runs.
    pub fn simultaneous_band(
        &self,
        table: &SampleTable,
        columns: &[usize],
        shape: &[[f64; 2]],
        share: f64,
    ) -> Result<Option<SimultaneousBand>, PlanError> {
        let Some(shape) = BandShape::new(shape) else { return Ok(None) };
        let excesses = shape.excesses(table, columns);
        let pool = Pool::gather(&excesses, Purpose::DoubleLoop, [0]);
        self.check_points(&pool)?;
        let experiment = Experiment::new(&self.setup, &pool, &excesses);
        Ok(Some(SimultaneousBand::new(&experiment, shape, share)))
    }
}
