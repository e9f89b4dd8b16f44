//! The promise of a study, once the runs are made.

use crate::error::StudyError;
use crate::question::CurveBand;
use loosepin_bounds::{PromisePlan, PromisedBound, SampleTable, SimultaneousBand};

/// The promised bounds.
pub struct Promised<'p> {
    pub plan: &'p PromisePlan,
    /// Ends of single numbers.
    pub ends: &'p [PromisedBound],
    /// Bands over curves: the band of the double loop, and the factor of its shape; a band without a shape is left out.
    pub bands: Vec<(SimultaneousBand, PromisedBound)>,
}

impl<'p> Promised<'p> {
    /// The `ends`, and those of `bands` that are promised: their shapes come from the runs of the double loop, and so were fixed
    /// without a look at those of the promise.
    ///
    /// # Errors
    /// The table lacks runs.
    pub fn new(
        plan: &'p PromisePlan,
        ends: &'p [PromisedBound],
        bands: &[CurveBand],
        table: &SampleTable,
    ) -> Result<Self, StudyError> {
        let promised = bands.iter().filter(|band| band.is_promised);
        let shaped = promised.filter_map(|band| Some((&band.columns, band.found.clone()?)));
        let factor = |(columns, band): (&Vec<usize>, SimultaneousBand)| {
            let factor = plan.band(table, columns, &band)?;
            Ok((band, factor))
        };
        let bands = shaped.map(factor).collect::<Result<_, StudyError>>()?;
        Ok(Self { plan, ends, bands })
    }
}
