//! The nominal motion, from which samples are closed.

use super::error::SamplingError;
use super::part::{PartOfOutput, SampledPart};
use crate::accuracy::PoseAccuracy;
use crate::closure::assembly::Starts;
use crate::closure::bordered::Bordered;
use crate::closure::cycle::{Cycle, cycle_from};
use crate::closure::error::ClosureError;
use crate::closure::loops::Loops;
use crate::closure::position::Position;
use crate::mechanism::drive::DriveValue;
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use crate::model::{ModelOutput, SpatialModel};
use crate::motion::path_direction;
use crate::output::SpatialOutput;
use crate::output::kind_of_output::{KindOfOutput, OutputState};
use crate::stop::IsStopped;
use loosepin_math::{Pose, Vec3};
use loosepin_text::numbers::Values;
use std::f64::consts::FRAC_PI_2;

/// Longest step, in turns, in which turns of a body are counted.
const LONGEST_STEP_TURNS: f64 = 1.0 / 36.0;
/// Share of the way to a dead centre that play may go in the nominal position for samples, which differ from it, not to be looked at.
const FAR_FROM_DEAD: f64 = 0.03;

/// The nominal motion at the places of all samples.
#[derive(Debug, Clone)]
pub(super) struct Nominal {
    /// The nominal mechanism.
    pub mechanism: SpatialMechanism,
    pub places: Vec<NominalPlace>,
    /// Poses at time zero, where these are not those that the file leads to.
    pub start: Option<Vec<Pose>>,
}

/// A place of the nominal motion.
#[derive(Debug, Clone)]
pub(super) struct NominalPlace {
    /// In turns.
    pub turn: f64,
    pub base: Base,
    /// Nominal values of each part: of `Along`, `Across` and `Magnitude` 0.
    pub values: Vec<f64>,
    /// Unit vector along the nominal path, for the parts that need it.
    pub tangents: Vec<Option<Vec3>>,
    /// Whether play may take samples to a dead centre there.
    pub is_near_dead_centre: bool,
}

/// A position that samples are closed from.
#[derive(Debug, Clone)]
pub(super) struct Base {
    pub position: Position,
    /// Values of all drives.
    pub drives: Vec<f64>,
    /// The bordered loop equations.
    pub system: Bordered,
    /// Sign of their determinant.
    pub sign: f64,
    /// Size of their smallest pivot over that of the largest.
    pub pivot_ratio: f64,
}

impl Base {
    pub(super) fn new(loops: &Loops, position: Position) -> Self {
        let mut system = Bordered::default();
        system.factor(loops, &loops.frames(&position.poses, &[]), &position.borders);
        let (sign, pivot_ratio) = (system.sign(), system.pivot_ratio());
        Self { drives: position.drive_values(), position, system, sign, pivot_ratio }
    }
}

/// Values of all drives at places in turns.
pub(super) fn drives_at(model: &SpatialModel, values: &Values, turn_s: f64, turn: f64) -> Vec<DriveValue> {
    model.drive_values(values, turn * turn_s)
}

/// Follows a mechanism from time zero to all places, looking at each gap in steps that are short enough to count turns. Positions with those in
/// between; the second list says where the places are among them.
pub(super) fn followed(
    mechanism: &SpatialMechanism,
    turns: &[f64],
    drives: &dyn Fn(f64) -> Vec<DriveValue>,
    starts: Starts,
    is_stopped: IsStopped,
) -> Result<(Vec<Position>, Vec<usize>), SamplingError> {
    let (mut inputs, mut places) = (vec![0.0], Vec::with_capacity(turns.len()));
    for turn in turns {
        let from = inputs.last().copied().unwrap_or_default();
        let steps = ((turn - from).abs() / LONGEST_STEP_TURNS - 1e-9).ceil().max(1.0);
        inputs.extend((1..steps as usize).map(|step| from + (turn - from) * step as f64 / steps));
        inputs.push(*turn);
        places.push(inputs.len() - 1);
    }
    let Cycle { positions, stopped } = cycle_from(mechanism, &inputs, drives, starts, is_stopped);
    match stopped {
        None => Ok((positions, places)),
        Some(why) => {
            let reached = positions.len().saturating_sub(1);
            Err(SamplingError::DoesNotClose { turn: inputs.get(reached).copied().unwrap_or_default(), why })
        }
    }
}

/// Ends the work at a place, in turns, where it is stopped.
pub(super) fn go_on(is_stopped: IsStopped, turn: f64) -> Result<(), SamplingError> {
    if is_stopped() { Err(SamplingError::DoesNotClose { turn, why: ClosureError::Stopped }) } else { Ok(()) }
}

impl Nominal {
    pub(super) fn new(
        model: &SpatialModel,
        values: &Values,
        turns: &[f64],
        parts: &[SampledPart],
        is_stopped: IsStopped,
    ) -> Result<Self, SamplingError> {
        let is_ascending = turns.windows(2).all(|pair| pair[0] <= pair[1]);
        if turns.is_empty() || !is_ascending || !turns.iter().all(|turn| turn.is_finite()) {
            return Err(SamplingError::BadTurns);
        }
        let mechanism = model.mechanism(values)?;
        let turn_s = model.cycle_input(values)?.turn_s;
        let drives = |turn: f64| drives_at(model, values, turn_s, turn);
        let (positions, numbers) = followed(&mechanism, turns, &drives, Starts::Nearby, is_stopped)?;
        let mut places = Vec::with_capacity(turns.len());
        let loops = Loops::new(&mechanism);
        for (turn, number) in turns.iter().zip(&numbers) {
            go_on(is_stopped, *turn)?;
            let base = Base::new(&loops, positions[*number].clone());
            // What is singular or does not fit is said when the place is read.
            let accuracy = PoseAccuracy::new(&mechanism, &base.position);
            let is_near_dead_centre = accuracy.is_ok_and(|own| own.dead_centre_share() > FAR_FROM_DEAD);
            let (values, tangents) = (Vec::new(), Vec::new());
            places.push(NominalPlace { turn: *turn, base, values, tangents, is_near_dead_centre });
        }
        for part in parts {
            let components = components_of(model, values, part)?;
            let output = &model.outputs[part.output];
            let counted = match (part.part, components.as_slice()) {
                (PartOfOutput::Number, [own]) if own.point().is_none() => {
                    Some(turned(own, &mechanism, &positions, &numbers, output)?)
                }
                _ => None,
            };
            for (number, place) in places.iter_mut().enumerate() {
                let value = match &counted {
                    Some(counted) => counted.get(number).copied().unwrap_or_default(),
                    None => place_of(part.part, &components, &place.base.position.poses),
                };
                place.values.push(value);
                let tangent = match part.part.needs_path() {
                    true => Some(tangent(&mechanism, place, &components, turn_s, output)?),
                    false => None,
                };
                place.tangents.push(tangent);
            }
        }
        let start = positions.first().filter(|first| first.is_other_start).map(|first| first.poses.clone());
        Ok(Self { mechanism, places, start })
    }
}

/// The components of the output of a part, if it has that part.
pub(super) fn components_of(
    model: &SpatialModel,
    values: &Values,
    part: &SampledPart,
) -> Result<Vec<SpatialOutput>, SamplingError> {
    let Some(output) = model.outputs.get(part.output) else {
        return Err(SamplingError::NoOutput { output: part.output, outputs: model.outputs.len() });
    };
    if !output.kind.has_part(part.part) {
        return Err(SamplingError::PartDoesNotFit { output: output.name.clone(), part: part.part.word() });
    }
    Ok(model.outputs_of(part.output, values)?)
}

/// The place of a point along the direction of a part; 0 of what has none.
pub(super) fn place_of(part: PartOfOutput, components: &[SpatialOutput], poses: &[Pose]) -> f64 {
    let own = part.component().and_then(|number| components.get(number)).and_then(SpatialOutput::point);
    own.map_or(0.0, |own| poses[own.body].point_m(own.point_m).dot(own.direction))
}

/// Turns of a body at the places, counted from the first of them.
fn turned(
    output: &SpatialOutput,
    mechanism: &SpatialMechanism,
    positions: &[Position],
    places: &[usize],
    own: &ModelOutput,
) -> Result<Vec<f64>, SamplingError> {
    let mut counted = vec![0.0];
    for pair in positions.windows(2) {
        let [from, to] = [&pair[0], &pair[1]].map(|position| OutputState { mechanism, poses: &position.poses });
        let step = output.deviation(&from, &to);
        if !(step.abs() <= FRAC_PI_2) {
            return Err(SamplingError::CoarseTurn { output: own.name.clone() });
        }
        counted.push(counted.last().copied().unwrap_or_default() + step);
    }
    let first = places.first().map_or(0.0, |place| counted[*place]);
    Ok(places.iter().map(|place| counted[*place] - first).collect())
}

/// The direction of the nominal path: that of the velocity, or where the point turns back that of the acceleration.
fn tangent(
    mechanism: &SpatialMechanism,
    place: &NominalPlace,
    components: &[SpatialOutput],
    turn_s: f64,
    output: &ModelOutput,
) -> Result<Vec3, SamplingError> {
    let at_rest = || SamplingError::AtRest { output: output.name.clone(), turn: place.turn };
    let point = components.first().and_then(SpatialOutput::point).ok_or_else(at_rest)?;
    path_direction(mechanism, &place.base.position, &point, turn_s).ok_or_else(at_rest)
}
