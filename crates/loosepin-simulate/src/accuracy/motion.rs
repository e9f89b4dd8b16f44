//! The ideal motion over one cycle with the quasi-static answer: what `loosepin motion` shows.

use super::accuracy_output::{AccuracyOutput, AccuracyOutputKind, round_off_m_s};
use super::cycle::Cycle;
use super::cycle_worst_case::{WalkedCycle, add_worst_cases};
use super::dimension::{DimensionDirection, dimension_direction};
use super::efforts::ideal_efforts;
use super::error::AccuracyError;
use super::in_space::is_asked_in_space;
use super::loops::DisplacedLoops;
use super::overhang::{Overhangs, overhanging};
use super::path::{PathRecorder, points_of_paths, reach_by_gradients_m};
use super::play_effect::PlayEffect;
use super::play_reach::PlayReach;
use super::position::{PositionOutput, position_outputs};
use super::round_off::drop_round_off_of;
use super::sensitivity::{dimension_derivatives, play_gradients};
use super::together::Together;
use crate::kinematics::{MovedOutput, Walked, kinematic_properties, mechanical_advantages};
use crate::{add_pose, skeleton};
use loosepin_math::Vec2;
use loosepin_mechanics::mechanism::{IdealMotion, Mechanism, Sample, point_m};
use loosepin_mechanics::model::{CycleSpan, PointId, Position, QuantityId, Values};
use loosepin_result::motion::{
    ClearanceAnswer, DimensionContributor, JointContributor, MotionRecord, NamedEffect, OutputMotion, PoseEffect,
};
use loosepin_result::repeat::Repeat;
use loosepin_result::round_off::round_off_si;
use loosepin_result::simulation::Override;
use loosepin_result::spatial_picture::SpatialPicture;
use loosepin_text::units::{DisplayUnits, SiUnit};
use std::f64::consts::{PI, TAU};
use std::sync::atomic::{AtomicBool, Ordering};

/// Fewest positions in a cycle: with fewer, neither extremes nor singular positions would be seen.
const MIN_POSITIONS: usize = 12;

/// Plan of a quasi-static answer.
#[derive(Debug, Clone)]
pub struct MotionPlan {
    /// The turn that is walked through.
    pub span: CycleSpan,
    /// Steps of the cycle, at least 12; the record has one position more where the mechanism can turn fully.
    pub positions: usize,
    /// Dimensions that scatter; empty without a study.
    pub scatter: Vec<Scatter>,
    /// Correlations of dimensions that do not scatter independently of each other.
    pub correlations: Vec<ScatterCorrelation>,
    /// Points whose paths are recorded, besides those of outputs.
    pub paths: Vec<PointId>,
    /// Poses that a study asks about; empty without a study.
    pub asked: Vec<AskedPose>,
    /// Values set on the command line, for the record.
    pub overrides: Vec<Override>,
}

/// An output at a pose.
#[derive(Debug, Clone, PartialEq)]
pub struct AskedPose {
    /// Name of the output, as in the record. One that the record does not have is left out of it, as a force is.
    pub output: String,
    /// Angle of the drive; whole turns do not matter.
    pub pose_rad: f64,
    /// Whether a requirement names it, not a question alone.
    pub is_required: bool,
}

/// A quantity that scatters.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scatter {
    /// The quantity; one that can be set.
    pub quantity: QuantityId,
    /// Its standard deviation, SI, >= 0.
    pub standard_deviation_si: f64,
}

/// Two quantities that scatter together.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ScatterCorrelation {
    /// One quantity.
    pub first: QuantityId,
    /// The other one.
    pub second: QuantityId,
    /// Linear correlation of their values, -1 to 1.
    pub linear: f64,
}

/// The ideal motion of `mechanism` with `values` over one turn of a drive, what clearances do to it quasi-statically and to first order, and
/// what scattering dimensions do to first order: a preview, without worst cases.
///
/// Where the mechanism cannot go through a whole turn, the record holds the positions that it can reach from its start in
/// both directions, and its singular positions name the ends.
///
/// # Errors
/// An impossible sample, loops that do not close at the start, a drive that stands still, too few positions, a standard
/// deviation or a quantity that cannot be used.
pub fn motion(mechanism: &Mechanism, values: &Values, plan: &MotionPlan) -> Result<MotionRecord, AccuracyError> {
    motion_until(mechanism, values, plan, &AtomicBool::new(false))
}

/// As [`motion`], until `stop` is set: it is looked at before each position.
///
/// # Errors
/// As for [`motion`]; [`AccuracyError::Stopped`].
pub fn motion_until(
    mechanism: &Mechanism,
    values: &Values,
    plan: &MotionPlan,
    stop: &AtomicBool,
) -> Result<MotionRecord, AccuracyError> {
    motion_with(mechanism, values, plan, stop, false)
}

/// As [`motion`], with the worst cases of the loops themselves: the largest deviations found, and ends that are proven.
///
/// # Errors
/// As for [`motion`].
pub fn motion_with_worst_cases(
    mechanism: &Mechanism,
    values: &Values,
    plan: &MotionPlan,
) -> Result<MotionRecord, AccuracyError> {
    motion_with_worst_cases_until(mechanism, values, plan, &AtomicBool::new(false))
}

/// As [`motion_with_worst_cases`], until `stop` is set: it is looked at before each position.
///
/// # Errors
/// As for [`motion`]; [`AccuracyError::Stopped`].
pub fn motion_with_worst_cases_until(
    mechanism: &Mechanism,
    values: &Values,
    plan: &MotionPlan,
    stop: &AtomicBool,
) -> Result<MotionRecord, AccuracyError> {
    motion_with(mechanism, values, plan, stop, true)
}

fn motion_with(
    mechanism: &Mechanism,
    values: &Values,
    plan: &MotionPlan,
    stop: &AtomicBool,
    has_worst_cases: bool,
) -> Result<MotionRecord, AccuracyError> {
    let go_on = || if stop.load(Ordering::Relaxed) { Err(AccuracyError::Stopped) } else { Ok(()) };
    if !mechanism.is_driven() {
        return Err(AccuracyError::NotDriven);
    }
    let input = mechanism.model.input(plan.span, values);
    if input.speed_rad_s == 0.0 {
        return Err(AccuracyError::StandsStill { drive: input.name });
    }
    if plan.positions < MIN_POSITIONS {
        return Err(AccuracyError::TooFewPositions { positions: plan.positions, least: MIN_POSITIONS });
    }
    let directions = directions(mechanism, values, &plan.scatter)?;
    let sample = Sample::new(mechanism, values)?;
    let reaches = PlayReach::of_sample(mechanism, &sample, sample.plays.iter().map(|_| 0.0))?;
    let start = Cycle::start(mechanism, &sample, &input)?;
    let cycle = Cycle::walk(mechanism, start, &input, plan.positions, stop);
    go_on()?;

    let outputs = position_outputs(mechanism);
    let mut readings: Vec<Position> = outputs.iter().map(|output| output.reading).collect();
    let mut paths = points_of_paths(mechanism, &plan.paths, &mut readings);
    let jets: Vec<Vec<[f64; 3]>> = cycle.states.iter().map(|state| jets(mechanism, values, &readings, state)).collect();
    let round_off_m_s = round_off_m_s(input.speed_rad_s, mechanism.size_m);
    paths.take_directions(&jets, round_off_m_s);
    let mut overhangs = Overhangs::default();
    let measured = Measured { outputs: &outputs, readings, paths, jets: &jets, round_off_m_s };
    let mut recorder = Recorder::new(mechanism, values, &sample, reaches.clone(), measured, plan, &directions);
    let mut drawing = skeleton(mechanism, values);
    let mut drive_angle_rad = Vec::with_capacity(cycle.states.len());
    let mut overhanging_joints = Vec::with_capacity(cycle.states.len());
    for (state, jets) in cycle.states.iter().zip(&jets) {
        go_on()?;
        let angle_rad = input.angle_rad(state.time_s());
        drive_angle_rad.push(angle_rad);
        recorder.record(state, jets)?;
        let over: Vec<String> = overhanging(mechanism, &sample, &reaches, state.kinematics())
            .map(|play| mechanism.model.play_name(mechanism.plays[play]).to_owned())
            .collect();
        overhanging_joints.push(over.first().cloned());
        overhangs.record(angle_rad, over.into_iter());
        add_pose(&mut drawing.poses, &mechanism.ideal, state.kinematics(), angle_rad);
    }
    drawing.ideal_poses = Default::default();
    let (mut unproven_spans, mut is_proven_between_angles) = (Vec::new(), false);
    let is_stopped = || stop.load(Ordering::Relaxed);
    match &recorder.plays {
        Plays::Together(together) if has_worst_cases => {
            let searched = together.search((&cycle.states, &drive_angle_rad), &mut recorder.outputs, &is_stopped);
            go_on()?;
            match searched {
                Ok(spans) => unproven_spans = spans,
                Err(reason) => recorder.forget_play(reason),
            }
        }
        Plays::Apart if has_worst_cases => {
            let walked = WalkedCycle {
                mechanism,
                values,
                sample: &sample,
                states: &cycle.states,
                drive_angle_rad: &drive_angle_rad,
                reaches: &reaches,
                // Paths of further points have no worst cases.
                readings: &recorder.readings[..outputs.len()],
                parts: &recorder.parts,
                velocities: jets.iter().map(|jets| jets[..outputs.len()].iter().map(|jet| jet[1]).collect()).collect(),
                overhanging: overhanging_joints,
                change_points: cycle.change_points(&input),
            };
            let proofs = add_worst_cases(&walked, &mut recorder.outputs, &is_stopped);
            go_on()?;
            if let Some(proofs) = proofs {
                (unproven_spans, is_proven_between_angles) = (proofs.unproven_spans, proofs.is_between_angles);
            }
        }
        _ => {}
    }
    let remarks = match &recorder.plays {
        Plays::Unknown(reason) => vec![unknown_words(mechanism, reason)],
        Plays::Apart | Plays::Together(_) => Vec::new(),
    };
    let asked = recorder.effects_at(&plan.asked, &Walked { states: &cycle.states, input: &input }, plan.positions);
    drop_round_off_of(&mut recorder.outputs, mechanism.size_m);
    let moved = recorder.moved_outputs();
    let paths = recorder.paths.into_paths();
    let mut kinematics = kinematic_properties(mechanism, values, &cycle.states, &input);
    // With several drives, or a phase in the place of an angle, no torque is the one that is balanced.
    if input.is_drive && mechanism.model.drives.len() == 1 {
        let walked = Walked { states: &cycle.states, input: &input };
        let jet = |state: &IdealMotion<'_>, reading: Position| {
            let acceleration = |slot| state.acceleration(slot);
            reading.jet(&mechanism.ideal, state.kinematics(), acceleration, |point| {
                point_m(&mechanism.model, values, point)
            })
        };
        kinematics.mechanical_advantages = mechanical_advantages(mechanism, &moved, &walked, &jet);
    }
    Ok(MotionRecord {
        model: mechanism.model.name.clone(),
        version: loosepin_text::VERSION.to_owned(),
        overrides: plan.overrides.clone(),
        drive_speed_rad_s: input.is_drive.then_some(input.speed_rad_s),
        mobility: mobility_words(mechanism),
        singular_positions: cycle.singular_positions(&input),
        kinematics,
        guide_overhangs: overhangs.into_found(),
        unproven_spans,
        is_proven_between_angles,
        drive: input.name,
        repeat: Repeat::default(),
        remarks,
        display_units: mechanism.model.shown_in(DisplayUnits::default()),
        drive_angle_rad,
        time_s: Vec::new(),
        outputs: recorder.outputs,
        paths,
        // Without masses nothing is known of them.
        efforts: match mechanism.model.demand_dynamics() {
            Ok(()) => ideal_efforts(mechanism, &sample, &cycle.states),
            Err(_) => Vec::new(),
        },
        requirements: Vec::new(),
        allowances: Vec::new(),
        asked,
        drawing,
        picture: SpatialPicture::default(),
    })
}

/// Value, velocity and acceleration of each position.
fn jets(mechanism: &Mechanism, values: &Values, readings: &[Position], state: &IdealMotion<'_>) -> Vec<[f64; 3]> {
    let arm_m = |point| point_m(&mechanism.model, values, point);
    let jet =
        |reading: &Position| reading.jet(&mechanism.ideal, state.kinematics(), |slot| state.acceleration(slot), arm_m);
    readings.iter().map(jet).collect()
}

/// Directions of all scattering quantities that have to do with the motion.
fn directions(
    mechanism: &Mechanism,
    values: &Values,
    scatter: &[Scatter],
) -> Result<Vec<(Scatter, DimensionDirection)>, AccuracyError> {
    let mut directions = Vec::new();
    for entry in scatter {
        if !(entry.standard_deviation_si >= 0.0 && entry.standard_deviation_si.is_finite()) {
            return Err(AccuracyError::BadStandardDeviation {
                path: mechanism.model.quantities[entry.quantity].path.clone(),
                standard_deviation_si: entry.standard_deviation_si,
            });
        }
        let direction = dimension_direction(mechanism, values, entry.quantity)?;
        if !direction.leaves_motion_alone(mechanism) {
            directions.push((*entry, direction));
        }
    }
    Ok(directions)
}

/// What is read at each position.
struct Measured<'m> {
    outputs: &'m [PositionOutput],
    /// Readings of the outputs, then of paths alone.
    readings: Vec<Position>,
    paths: PathRecorder,
    /// Value, velocity and acceleration of each reading at each position.
    jets: &'m [Vec<[f64; 3]>],
    /// Speeds up to this are round-off.
    round_off_m_s: f64,
}

/// Fills the histories of all outputs, position by position.
struct Recorder<'a> {
    mechanism: &'a Mechanism,
    values: &'a Values,
    loops: DisplacedLoops<'a>,
    /// Of the outputs, then of paths alone.
    readings: Vec<Position>,
    paths: PathRecorder,
    /// What each of the outputs is.
    parts: Vec<AccuracyOutputKind>,
    reaches: Vec<PlayReach>,
    input: CycleSpan,
    directions: &'a [(Scatter, DimensionDirection)],
    /// Places of two correlated directions, and twice their correlation.
    correlated: Vec<(usize, usize, f64)>,
    outputs: Vec<OutputMotion>,
    plays: Plays<'a>,
}

/// How it is found what play does.
enum Plays<'a> {
    /// Each play by itself.
    Apart,
    /// As plays must meet conditions together, in space.
    Together(Box<Together<'a>>),
    /// Not at all, with the reason in words.
    Unknown(String),
}

impl<'a> Recorder<'a> {
    fn new(
        mechanism: &'a Mechanism,
        values: &'a Values,
        sample: &Sample<f64>,
        reaches: Vec<PlayReach>,
        Measured { outputs, readings, paths, jets, round_off_m_s }: Measured<'_>,
        plan: &MotionPlan,
        directions: &'a [(Scatter, DimensionDirection)],
    ) -> Self {
        let model = &mechanism.model;
        let contributors = mechanism.plays.iter().zip(&sample.plays).map(|(joint, play)| JointContributor {
            joint: model.play_name(*joint).to_owned(),
            radial_clearance_m: play.clearance_m,
            ..JointContributor::default()
        });
        let clearance = ClearanceAnswer { contributors: contributors.collect(), ..ClearanceAnswer::default() };
        let dimensional_contributors: Vec<DimensionContributor> = directions
            .iter()
            .map(|(entry, _)| DimensionContributor {
                path: model.quantities[entry.quantity].path.clone(),
                standard_deviation_si: Vec::new(),
            })
            .collect();
        let speeds = |[x, y]: [usize; 2]| jets.iter().map(|jets| jets[x][1].hypot(jets[y][1])).collect();
        let parts = AccuracyOutput::all(outputs, speeds, round_off_m_s);
        let names = || parts.iter().map(|output| output.name.clone()).collect();
        let together = || Together::new((mechanism, values), &reaches, names());
        let plays = match is_asked_in_space(mechanism).then(together) {
            Some(Ok(together)) => Plays::Together(Box::new(together)),
            Some(Err(reason)) => Plays::Unknown(reason),
            None => Plays::Apart,
        };
        let motions = parts.iter().map(|output| OutputMotion {
            name: output.name.clone(),
            words: output.words.clone(),
            unit: output.unit.clone(),
            coordinate_of: output.coordinate_of.clone(),
            path_error: output.path_error.clone(),
            value_si: Vec::new(),
            velocity_si: Vec::new(),
            acceleration_si: Vec::new(),
            clearance: clearance.clone(),
            dimensional_standard_deviation_si: Vec::new(),
            dimensional_contributors: dimensional_contributors.clone(),
        });
        Self {
            mechanism,
            values,
            loops: DisplacedLoops::new(mechanism, values),
            readings,
            paths,
            parts: parts.iter().map(|part| part.kind).collect(),
            reaches,
            input: plan.span,
            directions,
            correlated: correlated(directions, &plan.correlations),
            outputs: motions.collect(),
            plays,
        }
    }

    /// Nothing is known of play.
    fn forget_play(&mut self, reason: String) {
        self.outputs.iter_mut().for_each(|output| output.clearance.forget());
        self.paths.forget_play();
        self.plays = Plays::Unknown(reason);
    }

    /// The outputs that move by themselves, then the points of the paths.
    fn moved_outputs(&self) -> Vec<MovedOutput> {
        let own = |(output, kind): (&OutputMotion, &AccuracyOutputKind)| {
            let AccuracyOutputKind::Position(place) = *kind else { return None };
            let readings = vec![self.readings[place]];
            (!output.is_of_path()).then(|| MovedOutput {
                name: output.name.clone(),
                unit: output.unit.clone(),
                readings,
            })
        };
        let of_outputs = self.outputs.iter().zip(&self.parts).filter_map(own);
        let of_paths = self.paths.places().map(|(name, places)| MovedOutput {
            name: name.to_owned(),
            unit: SiUnit::LENGTH,
            readings: places.map(|place| self.readings[place]).into(),
        });
        of_outputs.chain(of_paths).collect()
    }

    fn record(&mut self, state: &IdealMotion<'_>, jets: &[[f64; 3]]) -> Result<(), AccuracyError> {
        let effects = self.effects(state, jets)?;
        for (output, part) in self.outputs.iter_mut().zip(&self.parts) {
            // The ideal motion has no error.
            if let AccuracyOutputKind::Position(place) = *part {
                output.value_si.push(self.loops.value(self.readings[place]));
                output.velocity_si.push(jets[place][1]);
                output.acceleration_si.push(jets[place][2]);
            }
        }
        self.record_play(state, &effects, jets);
        for ((entry, _), derivatives) in self.directions.iter().zip(&effects.derivatives) {
            self.paths.add_scatter(entry.standard_deviation_si, derivatives);
        }
        if !self.directions.is_empty() {
            self.paths.end_scatter(&self.correlated);
            for (number, output) in self.outputs.iter_mut().enumerate() {
                let signed_si = effects.signed_si(number, self.directions);
                for (contributor, signed_si) in output.dimensional_contributors.iter_mut().zip(&signed_si) {
                    contributor.standard_deviation_si.push(signed_si.abs());
                }
                output.dimensional_standard_deviation_si.push(root_sum_of_squares(&signed_si, &self.correlated));
            }
        }
        Ok(())
    }

    fn record_play(&mut self, state: &IdealMotion<'_>, effects: &StateEffects, jets: &[[f64; 3]]) {
        let not_known = |_: [usize; 2], directions: &[Vec2<f64>]| vec![f64::NAN; directions.len()];
        let found = match &mut self.plays {
            Plays::Apart => {
                let reach_m =
                    |places, direction| reach_by_gradients_m(&effects.gradients, &self.reaches, places, direction);
                self.paths.record(jets, |places, directions| {
                    directions.iter().map(|direction| reach_m(places, *direction)).collect()
                });
                let joints = (0..self.outputs.len()).map(|output| effects.joints(output, &self.reaches));
                Ok(joints.map(|joints| PlayEffect::of_joints(&joints)).collect())
            }
            Plays::Together(together) => {
                let asked = (self.readings.as_slice(), effects.weights.as_slice());
                together.record(state, asked, (&mut self.paths, jets))
            }
            Plays::Unknown(_) => return self.paths.record(jets, not_known),
        };
        match found {
            Ok(found) => {
                let outputs = self.outputs.iter_mut().zip::<Vec<PlayEffect>>(found);
                outputs.for_each(|(output, effect)| effect.add_to(&mut output.clearance));
            }
            Err(reason) => {
                self.forget_play(reason);
                self.paths.record(jets, not_known);
            }
        }
    }

    /// What play and dimensions do at a state, to first order.
    fn effects(&mut self, state: &IdealMotion<'_>, jets: &[[f64; 3]]) -> Result<StateEffects, AccuracyError> {
        let (mechanism, values) = (self.mechanism, self.values);
        self.loops.set_position(state.coordinates());
        let gradients = match self.plays {
            Plays::Apart => play_gradients(&mut self.loops, &self.readings)?,
            Plays::Together(_) | Plays::Unknown(_) => Vec::new(),
        };
        let velocities: Vec<f64> = jets.iter().map(|jet| jet[1]).collect();
        let weights = self.parts.iter().map(|part| part.weights(&velocities)).collect();
        let (input, time_s) = (self.input, state.time_s());
        let derivatives = self.directions.iter().map(|(_, direction)| {
            dimension_derivatives(&mut self.loops, mechanism, values, direction, input, time_s, &self.readings)
        });
        let derivatives = derivatives.collect::<Result<_, _>>()?;
        Ok(StateEffects { gradients, derivatives, weights })
    }

    /// The effects at the poses that are asked about, each reached from the nearest of the walked states. Poses that the mechanism does not reach
    /// are left out, as are singular ones.
    fn effects_at(&mut self, asked: &[AskedPose], walked: &Walked<'_, '_>, positions: usize) -> Vec<PoseEffect> {
        let mut found = Vec::new();
        for AskedPose { output, pose_rad, is_required } in asked {
            let Some(number) = self.outputs.iter().position(|own| own.name == *output) else { continue };
            let Some(state) = state_at(walked, *pose_rad, positions) else { continue };
            let jets = jets(self.mechanism, self.values, &self.readings, &state);
            // Nothing is known of first order in a singular position.
            let Ok(effects) = self.effects(&state, &jets) else { continue };
            let of_play = match &self.plays {
                Plays::Apart => Some(PlayEffect::of_joints(&effects.joints(number, &self.reaches))),
                Plays::Together(together) => {
                    let all = together.effects(&state, &self.readings, &effects.weights);
                    all.ok().map(|mut all| all.swap_remove(number))
                }
                Plays::Unknown(_) => None,
            };
            // Where nothing is known of play.
            let nothing = || (f64::NAN, Vec::new());
            let (worst_si, by_joint_si) = of_play.map_or_else(nothing, |own| (own.worst_si, own.by_joint_si));
            let signed_si = effects.signed_si(number, self.directions);
            let own = &self.outputs[number];
            let threshold_si = round_off_si(&own.unit, self.mechanism.size_m);
            let effect = |name: &String, value_si: f64| {
                let value_si = if value_si < threshold_si { 0.0 } else { value_si };
                NamedEffect { name: name.clone(), value_si }
            };
            let of_joints = own.clearance.contributors.iter().zip(by_joint_si);
            let of_dimensions = own.dimensional_contributors.iter().zip(&signed_si);
            let all = effect(output, worst_si);
            let scatter = effect(output, root_sum_of_squares(&signed_si, &self.correlated));
            found.push(PoseEffect {
                output: output.clone(),
                pose_rad: *pose_rad,
                is_required: *is_required,
                first_order_si: all.value_si,
                joints: of_joints.map(|(known, effect_si)| effect(&known.joint, effect_si)).collect(),
                standard_deviation_si: scatter.value_si,
                dimensions: of_dimensions.map(|(known, signed_si)| effect(&known.path, signed_si.abs())).collect(),
            });
        }
        found
    }
}

/// What play and dimensions do at a state, to first order.
struct StateEffects {
    /// Of each reading by each play.
    gradients: Vec<Vec<Vec2<f64>>>,
    /// Of each reading by each direction of dimensions, direction by direction.
    derivatives: Vec<Vec<f64>>,
    /// The readings that each output is made of, with their weights.
    weights: Vec<Vec<(usize, f64)>>,
}

impl StateEffects {
    /// Reach and gradient of each play for an output.
    fn joints(&self, output: usize, reaches: &[PlayReach]) -> Vec<(PlayReach, Vec2<f64>)> {
        let weights = &self.weights[output];
        let gradient = |play: usize| {
            weights
                .iter()
                .fold(Vec2::zero(), |sum: Vec2<f64>, (place, weight)| sum + self.gradients[*place][play] * *weight)
        };
        reaches.iter().enumerate().map(|(play, reach)| (*reach, gradient(play))).collect()
    }

    /// Effect of a standard deviation of each dimension on an output, with its sign.
    fn signed_si(&self, output: usize, directions: &[(Scatter, DimensionDirection)]) -> Vec<f64> {
        let derivative = |derivatives: &Vec<f64>| -> f64 {
            self.weights[output].iter().map(|(place, weight)| derivatives[*place] * weight).sum()
        };
        let each = directions.iter().zip(&self.derivatives);
        each.map(|((entry, _), derivatives)| derivative(derivatives) * entry.standard_deviation_si).collect()
    }
}

/// Standard deviation of a sum of effects; `correlated` holds two of them and twice their correlation.
fn root_sum_of_squares(signed_si: &[f64], correlated: &[(usize, usize, f64)]) -> f64 {
    let mut variance = signed_si.iter().fold(0.0, |sum, own| sum + own.abs() * own.abs());
    for &(first, second, twice) in correlated {
        variance += twice * signed_si[first] * signed_si[second];
    }
    // What cancels in full leaves round-off, of either sign.
    variance.max(0.0).sqrt()
}

/// The ideal motion at an angle of the drive, from the nearest state of a walk in `positions` steps; `None` if that is more than a step away, or
/// the way there is not possible.
fn state_at<'a>(walked: &Walked<'_, 'a>, pose_rad: f64, positions: usize) -> Option<IdealMotion<'a>> {
    /// Angles nearer to each other are one.
    const SAME_RAD: f64 = 1e-12;
    let away_rad = |state: &IdealMotion<'_>| {
        let away = (pose_rad - walked.input.angle_rad(state.time_s())).rem_euclid(TAU);
        if away > PI { away - TAU } else { away }
    };
    let near = walked.states.iter().map(|state| (away_rad(state), state));
    let (away_rad, nearest) = near.min_by(|a, b| a.0.abs().total_cmp(&b.0.abs()))?;
    if away_rad.abs() * positions as f64 > TAU * (1.0 + SAME_RAD) {
        return None;
    }
    let mut state = nearest.clone();
    if away_rad.abs() > SAME_RAD {
        state.move_to(state.time_s() + away_rad / walked.input.speed_rad_s).ok()?;
    }
    Some(state)
}

/// Places of correlated quantities among the directions; a quantity that has nothing to do with the motion has none.
fn correlated(
    directions: &[(Scatter, DimensionDirection)],
    correlations: &[ScatterCorrelation],
) -> Vec<(usize, usize, f64)> {
    let place = |quantity: QuantityId| directions.iter().position(|(entry, _)| entry.quantity == quantity);
    let both = |each: &ScatterCorrelation| Some((place(each.first)?, place(each.second)?, 2.0 * each.linear));
    correlations.iter().filter_map(both).collect()
}

/// That nothing is known of play, in words.
fn unknown_words(mechanism: &Mechanism, reason: &str) -> String {
    if mechanism.has_leaning_pins() {
        return format!(
            "pins lean out of the plane, which is asked in space, but {reason}: what play does is not known"
        );
    }
    let owners = mechanism.redundant.iter().map(|(owner, _)| owner.words(&mechanism.model)).collect::<Vec<_>>();
    format!(
        "constraints of {} repeat others, so that the plays must meet conditions together; that is found as in space, but {reason}: \
         what play does is not known",
        owners.join(" and ")
    )
}

/// The mobility in words, for example `1 degree of freedom, 1 drive`.
fn mobility_words(mechanism: &Mechanism) -> String {
    let counted = |count: usize, one: &str, many: &str| format!("{count} {}", if count == 1 { one } else { many });
    let mut words = format!(
        "{}, {}",
        counted(mechanism.degrees_of_freedom, "degree of freedom", "degrees of freedom"),
        counted(mechanism.model.drives.len(), "drive", "drives")
    );
    for (owner, constraints) in &mechanism.redundant {
        let counted = counted(*constraints, "constraint", "constraints");
        words.push_str(&format!("; {counted} of {} redundant", owner.words(&mechanism.model)));
    }
    words
}
