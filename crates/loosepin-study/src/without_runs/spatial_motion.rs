//! The motion of a mechanism in space, with what its play and its scatter do to it.

use crate::file::Study;
use crate::written::input_file::InputFile;
use loosepin_result::spatial_motion::SpatialMotionRecord;
use loosepin_space::{SpatialModel, SpatialScatterPlan};
use loosepin_text::diagnostics::Diagnostics;
use loosepin_text::numbers::QuantityId;

impl InputFile {
    /// The motion over the turn of `model`, the one of this file, with the worst cases of its play and what random inputs of a study do; `set` are
    /// settings `path=value`. Clearances that are uncertain are taken where there is most play. Ends of worst cases are proven where that is asked, and
    /// can be.
    ///
    /// # Errors
    /// A setting that the model does not take; loops that do not close; positions in which an output has no answer.
    pub fn motion_in_space(
        &self,
        model: &SpatialModel,
        set: &[String],
        is_proven: bool,
    ) -> Result<SpatialMotionRecord, Diagnostics> {
        let set = self.model().spatial_settings(&self.with_widest_play(set))?;
        let evaluated = model.quantities.evaluate(&set);
        let values = evaluated.map_err(|error| Diagnostics::one(&error, self.model().place(error.path())))?;
        let mut record = if is_proven { model.proven_motion_record(&values)? } else { model.motion_record(&values)? };
        let InputFile::Study(study) = self else { return Ok(record) };
        let scatter = model.scatter(&scatter_plan(study, set))?;
        record.outputs.iter_mut().zip(scatter).for_each(|(output, scatter)| output.scatter = scatter);
        Ok(record)
    }
}

/// What is random of a study, by its standard deviations.
fn scatter_plan(study: &Study, set: Vec<(QuantityId, f64)>) -> SpatialScatterPlan {
    let random = study.random.iter();
    let quantities: Vec<(QuantityId, f64)> =
        random.map(|input| (input.quantity, input.largest_standard_deviation(&study.epistemic))).collect();
    let place = |quantity: QuantityId| quantities.iter().position(|(known, _)| *known == quantity);
    let correlations = study.linear_correlations();
    let correlations = correlations.iter().filter_map(|own| Some((place(own.first)?, place(own.second)?, own.linear)));
    SpatialScatterPlan { correlations: correlations.collect(), set, quantities }
}
