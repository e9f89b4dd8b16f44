//! The motion of a mechanism in space, with what its play and its scatter do to it.

use crate::written::input_file::InputFile;
use loosepin_result::motion::{DimensionContributor, NamedEffect, PoseEffect};
use loosepin_result::spatial_motion::SpatialMotionRecord;
use loosepin_simulate::accuracy::AskedPose;
use loosepin_space::{IsStopped, SpatialModel, SpatialScatterPlan};
use loosepin_text::diagnostics::Diagnostics;
use loosepin_text::numbers::QuantityId;
use std::f64::consts::TAU;

impl InputFile {
    /// The motion over the turn of `model`, the one of this file, with the worst cases of its play and what random inputs of a study do; `set` are
    /// settings `path=value`. Clearances that are uncertain are taken where there is most play. Ends of worst cases are proven where that is asked, and
    /// can be.
    ///
    /// # Errors
    /// Those of [`Self::play_in_space`] and of [`Self::add_scatter`].
    pub fn motion_in_space(
        &self,
        model: &SpatialModel,
        set: &[String],
        is_proven: bool,
    ) -> Result<SpatialMotionRecord, Diagnostics> {
        let never = || false;
        let mut record = self.play_in_space(model, set, is_proven, &never)?;
        self.add_scatter(model, set, &mut record, &never)?;
        Ok(record)
    }

    /// The same without what random inputs do, until it is stopped.
    ///
    /// # Errors
    /// A setting that the model does not take; loops that do not close; positions in which an output has no answer; that it was stopped.
    pub fn play_in_space(
        &self,
        model: &SpatialModel,
        set: &[String],
        is_proven: bool,
        is_stopped: IsStopped,
    ) -> Result<SpatialMotionRecord, Diagnostics> {
        let values = self.model().spatial_values(&self.with_widest_play(set))?;
        model.motion_record_until(&values, is_proven, is_stopped)
    }

    /// Adds what random inputs do to a record of [`Self::play_in_space`] with the same settings, until it is stopped.
    ///
    /// # Errors
    /// A setting that the model does not take; values near those of the model with which the loops do not close; that it was stopped.
    pub fn add_scatter(
        &self,
        model: &SpatialModel,
        set: &[String],
        record: &mut SpatialMotionRecord,
        is_stopped: IsStopped,
    ) -> Result<(), Diagnostics> {
        let random = self.scatter();
        let place = |quantity: QuantityId| random.iter().position(|known| known.quantity == quantity);
        let correlations = self.linear_correlations();
        let correlations =
            correlations.iter().filter_map(|own| Some((place(own.first)?, place(own.second)?, own.linear)));
        let plan = SpatialScatterPlan {
            set: self.model().spatial_settings(&self.with_widest_play(set))?,
            correlations: correlations.collect(),
            quantities: random.iter().map(|own| (own.quantity, own.standard_deviation_si)).collect(),
        };
        let scatter = model.scatter_until(&plan, is_stopped)?;
        record.outputs.iter_mut().zip(scatter).for_each(|(output, scatter)| output.scatter = scatter);
        record.asked = self.asked_in_space(model, &plan, record, is_stopped)?;
        Ok(())
    }

    /// What scatter does at the poses that the study asks about.
    fn asked_in_space(
        &self,
        model: &SpatialModel,
        plan: &SpatialScatterPlan,
        record: &SpatialMotionRecord,
        is_stopped: IsStopped,
    ) -> Result<Vec<PoseEffect>, Diagnostics> {
        let InputFile::Study(study) = self else { return Ok(Vec::new()) };
        if plan.quantities.is_empty() {
            return Ok(Vec::new());
        }
        let values = model.quantities.evaluate(&plan.set).map_err(|error| Diagnostics::one(&error, None))?;
        let input = study.model.input(study.cycle.span, &values);
        let turn = |pose_rad: f64| (input.speed_rad_s.signum() * (pose_rad - input.start_rad) / TAU).rem_euclid(1.0);
        let mut found = Vec::new();
        for AskedPose { output, pose_rad, is_required } in study.asked_poses() {
            let Some(number) = record.outputs.iter().position(|own| own.name == output) else { continue };
            let scatter = model.scatter_at(plan, &[turn(pose_rad)], is_stopped)?;
            let at_pose = |values_si: &[f64]| values_si.first().copied().unwrap_or_default();
            let own = &scatter[number];
            let dimension = |own: &DimensionContributor| NamedEffect {
                name: own.path.clone(),
                value_si: at_pose(&own.standard_deviation_si),
            };
            found.push(PoseEffect {
                output,
                pose_rad,
                is_required,
                first_order_si: 0.0,
                joints: Vec::new(),
                standard_deviation_si: at_pose(&own.standard_deviation_si),
                dimensions: own.contributors.iter().map(dimension).collect(),
            });
        }
        Ok(found)
    }
}
