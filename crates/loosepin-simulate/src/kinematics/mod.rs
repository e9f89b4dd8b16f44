//! Kinematic properties of the ideal motion: what a designer asks first, without play.

mod advantage;
mod loops;
mod quantity;
mod still;
#[cfg(test)]
mod tests;
mod turning;

use std::f64::consts::{PI, TAU};

use loosepin_mechanics::mechanism::{IdealMotion, Mechanism, point_m};
use loosepin_mechanics::model::{CycleInput, Model, PointId, Values};
use loosepin_result::kinematics::{KinematicProperties, LoopProperties, MotionRange, TransmissionAngle};
use loosepin_text::units::SiUnit;

pub use advantage::{MovedOutput, mechanical_advantages};
use loops::{GroundLoop, ground_loops};
use quantity::{Angle, Quantity, Travel};
pub use still::{FIRST_LOOK_STEPS, bodies_that_move};
pub use turning::Walked;
use turning::crossings;

/// A swing below it is round-off of a body that only translates, rad, or of a joint that does not slide, as a share of the mechanism's size.
const ROUND_OFF: f64 = 1e-9;

/// Classes of the four-bar loops and slider-cranks of `model` through the ground, by their lengths.
pub fn loop_properties(model: &Model, values: &Values) -> Vec<LoopProperties> {
    properties_of(&ground_loops(model), model, values)
}

fn properties_of(loops: &[GroundLoop], model: &Model, values: &Values) -> Vec<LoopProperties> {
    loops.iter().map(|each| each.properties(model, values)).collect()
}

/// Properties of the motion through `states`, in the order of the drive's angle.
pub fn kinematic_properties(
    mechanism: &Mechanism,
    values: &Values,
    states: &[IdealMotion<'_>],
    input: &CycleInput,
) -> KinematicProperties {
    let model = &mechanism.model;
    let walked = Walked { states, input };
    let loops = ground_loops(model);
    let mut found = KinematicProperties { loops: properties_of(&loops, model, values), ..Default::default() };
    if !walked.is_whole_turn() {
        return found;
    }
    let arm_m = |point: PointId| point_m(model, values, point);
    let slot = |body: usize| mechanism.ideal.slot_of_body[body];
    let is_at_ground = |body: usize| {
        model.joints.iter().any(|joint| {
            let [first, second] = joint.kind.points().map(|point| point.body.0);
            first.min(second) == 0 && first.max(second) == body
        })
    };
    for (body, entry) in model.bodies.iter().enumerate().skip(1) {
        let angle = Angle { first: slot(0), second: slot(body), offset_rad: 0.0 };
        let range = range(&walked, &entry.name, SiUnit::ANGLE, is_at_ground(body), &angle, ROUND_OFF);
        found.ranges.extend(range);
    }
    for joint in &model.joints {
        let Some(guide) = joint.kind.prismatic() else { continue };
        let travel = Travel {
            guide: slot(guide.guide.body.0),
            slider: slot(guide.slider.body.0),
            guide_m: arm_m(guide.guide),
            slider_m: arm_m(guide.slider),
            angle_rad: values[guide.guide_angle_rad],
        };
        let is_at_ground = guide.guide.body.0 == 0 || guide.slider.body.0 == 0;
        let least = ROUND_OFF * mechanism.size_m;
        found.ranges.extend(range(&walked, &joint.name, SiUnit::LENGTH, is_at_ground, &travel, least));
    }
    let angles = loops.iter().filter_map(|each| transmission_angle(mechanism, values, &walked, each));
    found.transmission_angles.extend(angles);
    found
}

/// Extent of a quantity that goes to and fro; none where it does not turn back.
fn range(
    walked: &Walked<'_, '_>,
    name: &str,
    unit: SiUnit,
    is_at_ground: bool,
    quantity: &dyn Quantity,
    least: f64,
) -> Option<MotionRange> {
    // What stays at its value has rates of round-off, whose signs change at every other state.
    let values = || walked.states.iter().map(|state| quantity.value(state));
    if values().fold(f64::MIN, f64::max) - values().fold(f64::MAX, f64::min) <= least {
        return None;
    }
    let ends = walked.turning_points(quantity);
    let lowest = ends.iter().min_by(|a, b| a.value.total_cmp(&b.value))?;
    let highest = ends.iter().max_by(|a, b| a.value.total_cmp(&b.value))?;
    // What drifts over a turn has no ends.
    let drift = quantity.value(walked.states.last()?) - quantity.value(&walked.states[0]);
    let extent_si = highest.value - lowest.value;
    if extent_si <= least || drift.abs() > least.max(ROUND_OFF * extent_si) {
        return None;
    }
    let ends_rad = [lowest.angle_rad, highest.angle_rad];
    let share = (ends_rad[1] - ends_rad[0]).abs() / TAU;
    let time_ratio = walked.input.is_drive.then(|| share.max(1.0 - share) / share.min(1.0 - share));
    let mut dead_centres_rad: Vec<f64> = ends.iter().map(|end| end.angle_rad).collect();
    dead_centres_rad.sort_by(f64::total_cmp);
    Some(MotionRange { name: name.to_owned(), unit, is_at_ground, extent_si, ends_rad, dead_centres_rad, time_ratio })
}

/// The transmission angle of a loop of which a drive turns a link at the ground.
fn transmission_angle(
    mechanism: &Mechanism,
    values: &Values,
    walked: &Walked<'_, '_>,
    each: &GroundLoop,
) -> Option<TransmissionAngle> {
    let model = &mechanism.model;
    let is_driven = |joint: usize| model.drives.iter().any(|drive| drive.joint.0 == joint);
    let (coupler, output, is_pressure_angle) = each.transmission(model, values, &is_driven)?;
    let slot = |body: usize| mechanism.ideal.slot_of_body[body];
    let angle = Angle { first: slot(coupler.0), second: slot(output.0), offset_rad: output.1 - coupler.1 };
    // To 0 .. 180°; between two lines without a sense to 0 .. 90°.
    let folded = |angle_rad: f64| {
        let within = (angle_rad - TAU * (angle_rad / TAU).round()).abs();
        if is_pressure_angle { within.min(PI - within) } else { within }
    };
    let value_rad: Vec<f64> = walked.states.iter().map(|state| folded(angle.value(state))).collect();
    let angles_rad = walked.states.iter().map(|state| walked.input.angle_rad(state.time_s()));
    let mut candidates: Vec<(f64, f64)> = value_rad.iter().copied().zip(angles_rad).collect();
    for end in walked.turning_points(&angle) {
        candidates.push((folded(end.value), end.angle_rad));
    }
    for crossing in crossings(walked, &|state| angle.value(state).sin()) {
        candidates.push((folded(angle.value(&crossing)), walked.input.angle_rad(crossing.time_s())));
    }
    if is_pressure_angle {
        for crossing in crossings(walked, &|state| angle.value(state).cos()) {
            candidates.push((folded(angle.value(&crossing)), walked.input.angle_rad(crossing.time_s())));
        }
    }
    let smallest = candidates.iter().min_by(|a, b| a.0.total_cmp(&b.0))?;
    let largest = candidates.iter().max_by(|a, b| a.0.total_cmp(&b.0))?;
    Some(TransmissionAngle {
        bodies: [coupler.0, output.0].map(|body| model.bodies[body].name.clone()),
        is_pressure_angle,
        extremes_rad: [smallest.0, largest.0],
        at_rad: [smallest.1, largest.1],
        value_rad,
    })
}
