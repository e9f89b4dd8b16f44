//! The motion of a mechanism in space, with what its play and its scatter do to it.

use super::kind::KindOfModel;
use super::motion_request::MotionRequest;
use super::spatial_settings::SpatialSettings;
use loosepin_result::motion::{
    ClearanceAnswer, DimensionContributor, JointContributor, MotionRecord, NamedEffect, PoseEffect,
};
use loosepin_result::simulation::Override;
use loosepin_simulate::accuracy::AskedPose;
use loosepin_space::{SpatialModel, SpatialScatter, SpatialScatterPlan};
use loosepin_text::diagnostics::Diagnostics;
use loosepin_text::numbers::{QuantityId, Values};

/// The motion over the turn of `model`, with the worst cases of its play and what scatters. Ends of worst cases are proven where that is asked,
/// and can be.
///
/// # Errors
/// A setting that the model does not take; those of [`play`] and of [`add_scatter`].
pub(super) fn moved(model: &SpatialModel, request: &MotionRequest<'_>) -> Result<MotionRecord, Diagnostics> {
    let settings = SpatialSettings::read(model, &request.settings)?;
    let mut record = play(model, request, &settings)?;
    add_scatter(model, request, settings, &mut record)?;
    Ok(record)
}

/// The same, without what scatters where that has no answer, which is said beside it.
pub(super) fn play_with_scatter(
    model: &SpatialModel,
    request: &MotionRequest<'_>,
) -> (Option<MotionRecord>, Diagnostics) {
    let moved = SpatialSettings::read(model, &request.settings)
        .and_then(|settings| Ok((play(model, request, &settings)?, settings)));
    match moved {
        Ok((mut record, settings)) => {
            let found = add_scatter(model, request, settings, &mut record).err().unwrap_or_default();
            (Some(record), found)
        }
        Err(found) => (None, found),
    }
}

/// The motion without what scatters.
///
/// # Errors
/// A path of a point that the model does not have; loops that do not close; positions in which an output has no answer; that it was stopped.
fn play(
    model: &SpatialModel,
    request: &MotionRequest<'_>,
    settings: &SpatialSettings,
) -> Result<MotionRecord, Diagnostics> {
    let points = model.points_of_paths(request.paths)?;
    let is_stopped = || request.is_stopped();
    let record = model.motion_with_paths_until(&settings.values, &points, request.has_worst_cases, &is_stopped)?;
    Ok(MotionRecord { overrides: Override::from_settings(&request.settings), ..record })
}

/// Adds what scatters to a record of [`play`].
///
/// # Errors
/// Values near those of the model with which the loops do not close; that it was stopped.
fn add_scatter(
    model: &SpatialModel,
    request: &MotionRequest<'_>,
    SpatialSettings { set, values }: SpatialSettings,
    record: &mut MotionRecord,
) -> Result<(), Diagnostics> {
    let random = &request.scatter;
    let place = |quantity: QuantityId| random.iter().position(|known| known.quantity == quantity);
    let correlations = request.correlations.iter();
    let correlations = correlations.filter_map(|own| Some((place(own.first)?, place(own.second)?, own.linear)));
    let plan = SpatialScatterPlan {
        set,
        correlations: correlations.collect(),
        quantities: random.iter().map(|own| (own.quantity, own.standard_deviation_si)).collect(),
    };
    let scattered = model.scatter_until(&plan, &|| request.is_stopped())?;
    for (output, scatter) in record.outputs.iter_mut().zip(scattered) {
        output.dimensional_standard_deviation_si = scatter.standard_deviation_si;
        output.dimensional_contributors = scatter.contributors;
    }
    record.asked = asked(model, request, &plan, &values, record)?;
    Ok(())
}

/// What play and scatter do at the poses that are asked about.
fn asked(
    model: &SpatialModel,
    request: &MotionRequest<'_>,
    plan: &SpatialScatterPlan,
    values: &Values,
    record: &MotionRecord,
) -> Result<Vec<PoseEffect>, Diagnostics> {
    let input = model.input(request.asked_span, values);
    let is_stopped = || request.is_stopped();
    // Each answer is of all outputs.
    let mut answered: Vec<(f64, Vec<ClearanceAnswer>, Vec<SpatialScatter>)> = Vec::new();
    let mut found = Vec::new();
    for asked in &request.asked {
        let Some(number) = record.outputs.iter().position(|own| own.name == asked.output) else { continue };
        let turn = input.turn_at(asked.pose_rad);
        if answered.iter().all(|(known, ..)| *known != turn) {
            let play = model.play_at(values, turn, &is_stopped)?;
            answered.push((turn, play, model.scatter_at(plan, &[turn], &is_stopped)?));
        }
        let answer = answered.iter().find(|(known, ..)| *known == turn);
        found.extend(answer.map(|(_, play, scatter)| pose_effect(asked.clone(), &play[number], &scatter[number])));
    }
    Ok(found)
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
