//! The motion of a mechanism in space, with what its play and its scatter do to it.

use crate::written::input_file::InputFile;
use loosepin_result::motion::{
    ClearanceAnswer, DimensionContributor, JointContributor, MotionRecord, NamedEffect, PoseEffect,
};
use loosepin_result::simulation::Override;
use loosepin_simulate::accuracy::AskedPose;
use loosepin_space::{IsStopped, PointId, SpatialModel, SpatialScatter, SpatialScatterPlan};
use loosepin_text::diagnostics::Diagnostics;
use loosepin_text::numbers::QuantityId;
use std::f64::consts::TAU;

impl InputFile {
    /// The motion over the turn of `model`, the one of this file, with the worst cases of its play and what random inputs of a study do; `set` are
    /// settings `path=value`. Clearances that are uncertain are taken where there is most play. Ends of worst cases are proven where that is asked, and
    /// can be; the requirements of a study are then judged by them.
    ///
    /// # Errors
    /// Those of [`Self::play_in_space`] and of [`Self::add_scatter`]; a path of a point that the model does not have, or that has no answer.
    pub(super) fn moved_in_space(
        &self,
        model: &SpatialModel,
        set: &[String],
        paths: &[String],
        is_proven: bool,
        is_stopped: IsStopped,
    ) -> Result<MotionRecord, Diagnostics> {
        let points = model.points_of_paths(paths)?;
        let mut record = self.play_with_paths(model, set, &points, is_proven, is_stopped)?;
        self.add_scatter(model, set, &mut record, is_stopped)?;
        if is_proven {
            record.requirements = self.judged_in_space(model, set, is_stopped)?;
        }
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
    ) -> Result<MotionRecord, Diagnostics> {
        self.play_with_paths(model, set, &[], is_proven, is_stopped)
    }

    /// The same with the paths of points.
    fn play_with_paths(
        &self,
        model: &SpatialModel,
        set: &[String],
        points: &[PointId],
        is_proven: bool,
        is_stopped: IsStopped,
    ) -> Result<MotionRecord, Diagnostics> {
        let settings = self.with_widest_play(set);
        let values = self.model().spatial_values(&settings)?;
        let record = model.motion_with_paths_until(&values, points, is_proven, is_stopped)?;
        Ok(MotionRecord { overrides: Override::from_settings(&settings), ..record })
    }

    /// Adds what random inputs do to a record of [`Self::play_in_space`] with the same settings, until it is stopped.
    ///
    /// # Errors
    /// A setting that the model does not take; values near those of the model with which the loops do not close; that it was stopped.
    pub fn add_scatter(
        &self,
        model: &SpatialModel,
        set: &[String],
        record: &mut MotionRecord,
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
        for (output, scatter) in record.outputs.iter_mut().zip(model.scatter_until(&plan, is_stopped)?) {
            output.dimensional_standard_deviation_si = scatter.standard_deviation_si;
            output.dimensional_contributors = scatter.contributors;
        }
        record.asked = self.asked_in_space(model, &plan, record, is_stopped)?;
        Ok(())
    }

    /// What play and scatter do at the poses that the study asks about.
    fn asked_in_space(
        &self,
        model: &SpatialModel,
        plan: &SpatialScatterPlan,
        record: &MotionRecord,
        is_stopped: IsStopped,
    ) -> Result<Vec<PoseEffect>, Diagnostics> {
        let InputFile::Study(study) = self else { return Ok(Vec::new()) };
        let values = model.quantities.evaluate(&plan.set).map_err(|error| Diagnostics::one(&error, None))?;
        let input = study.model.input(study.cycle.span, &values);
        let turn = |pose_rad: f64| (input.speed_rad_s.signum() * (pose_rad - input.start_rad) / TAU).rem_euclid(1.0);
        let mut found = Vec::new();
        for asked in study.asked_poses() {
            let Some(number) = record.outputs.iter().position(|own| own.name == asked.output) else { continue };
            let turn = turn(asked.pose_rad);
            let play = model.play_at(&values, turn, is_stopped)?;
            let scatter = model.scatter_at(plan, &[turn], is_stopped)?;
            found.push(pose_effect(asked, &play[number], &scatter[number]));
        }
        Ok(found)
    }
}

/// Of an answer that has one position.
fn pose_effect(asked: AskedPose, play: &ClearanceAnswer, scatter: &SpatialScatter) -> PoseEffect {
    let AskedPose { output, pose_rad, is_required } = asked;
    let at_pose = |values_si: &[f64]| values_si.first().copied().unwrap_or_default();
    let joint =
        |own: &JointContributor| NamedEffect { name: own.joint.clone(), value_si: at_pose(&own.first_order_si) };
    let dimension = |own: &DimensionContributor| NamedEffect {
        name: own.path.clone(),
        value_si: at_pose(&own.standard_deviation_si),
    };
    PoseEffect {
        output,
        pose_rad,
        is_required,
        first_order_si: at_pose(&play.first_order_si),
        joints: play.contributors.iter().map(joint).collect(),
        standard_deviation_si: at_pose(&scatter.standard_deviation_si),
        dimensions: scatter.contributors.iter().map(dimension).collect(),
    }
}
