//! A model over its turn: ideal motion, worst cases, and who contributes, as a record.

use super::compile::CycleInput;
use super::drawn::Trace;
use super::parts::{ModelCycleSpan, ModelOutput, ModelOutputKind, SpatialModel};
use super::problem::SpatialMotionProblem;
use super::round_off::drop_round_off;
use crate::accuracy::{AccuracyError, FirstOrder, Gains, PlayDistribution, PoseAccuracy, SearchOptions};
use crate::closure::assembly::Starts;
use crate::closure::cycle::{Cycle, cycle_from};
use crate::closure::error::ClosureError;
use crate::closure::position::Position;
use crate::kind::SpatialPlay;
use crate::mechanism::joint::Joint;
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use crate::output::SpatialOutput;
use crate::output::kind_of_output::{KindOfOutput, OutputState};
use crate::picture::Zones;
use crate::play::block::PlayPart;
use crate::stop::{IsStopped, NEVER};
use loosepin_math::{Pose, Vec3};
use loosepin_result::repeat::{InputRole, Repeat};
use loosepin_result::spatial_motion::{
    SpatialContributor, SpatialMotionRecord, SpatialOutputRecord, SpatialScatter, SpatialWorstCase,
};
use loosepin_result::spatial_picture::SpatialPicture;
use loosepin_text::diagnostics::{Diagnostic, Diagnostics, Place};
use loosepin_text::numbers::Values;
use loosepin_text::units::{Dimension, SiUnit, format_value};
use std::f64::consts::FRAC_PI_2;
use std::rc::Rc;

impl SpatialModel {
    /// Moves the mechanism over its turn. Ends of worst cases are not proven: see [`SpatialModel::motion_record_until`].
    ///
    /// # Errors
    /// What [`SpatialModel::mechanism`] and [`SpatialModel::cycle_input`] refuse; loops that do not close; positions in which an output has no
    /// answer.
    pub fn motion_record(&self, values: &Values) -> Result<SpatialMotionRecord, Diagnostics> {
        self.motion_record_until(values, false, NEVER)
    }

    /// The same, until it is stopped; with proven ends of the worst case of each output on demand, which take a tenth of a second each and more.
    ///
    /// # Errors
    /// As for [`SpatialModel::motion_record`]; that it was stopped.
    pub fn motion_record_until(
        &self,
        values: &Values,
        is_proven: bool,
        is_stopped: IsStopped,
    ) -> Result<SpatialMotionRecord, Diagnostics> {
        let go_on = || if is_stopped() { Err(self.not_closed(&ClosureError::Stopped)) } else { Ok(()) };
        let mechanism = self.mechanism(values).map_err(|error| self.diagnostic(&error))?;
        let input = self.cycle_input(values).map_err(|error| self.diagnostic(&error))?;
        let positions = self.turn(&mechanism, values, &input.times_s(), Starts::Nearby, is_stopped).whole();
        let positions = positions.map_err(|error| self.not_with_ideal_joints(values, &error, is_stopped))?;
        let inputs_si: Vec<f64> = positions.iter().map(|position| input.at(position.input)).collect();
        let courses = (0..self.outputs.len()).map(|number| self.outputs_of(number, values).map(Course::new));
        let mut courses: Vec<Course> = courses.collect::<Result<_, _>>().map_err(|error| self.diagnostic(&error))?;
        let has_play = mechanism.joints().iter().any(has_play);
        let zones = Zones::new(positions.len());
        let points = self.traced_points(&mechanism, values).into_iter();
        let mut traces: Vec<Trace> = points.map(|point| Trace { point, zones: Vec::new() }).collect();
        let (mut poses, mut dead_centre_samples) = (Vec::with_capacity(positions.len()), Vec::new());
        // One after the other: the loop equations of all positions at once may be gigabytes.
        for (sample, (position, at)) in positions.iter().zip(&inputs_si).enumerate() {
            go_on()?;
            let accuracy = PoseAccuracy::new(&mechanism, position).map_err(|error| self.no_answer("", *at, error))?;
            let accuracy = Rc::new(accuracy);
            let reaches_dead_centre = has_play && accuracy.reaches_dead_centre();
            let is_regular = !reaches_dead_centre && (!has_play || accuracy.dead_centre_share() < 1.0);
            if reaches_dead_centre {
                dead_centre_samples.push(sample);
            }
            for (course, output) in courses.iter_mut().zip(&self.outputs) {
                course.add(sample, &accuracy, is_regular).map_err(|error| self.no_answer(&output.name, *at, error))?;
            }
            poses.push(accuracy.position().poses.clone());
            for trace in traces.iter_mut().filter(|own| has_play && own.point.output.is_some() && zones.has(sample)) {
                trace.zones.extend(zones.zone(&accuracy, &trace.point, sample));
            }
        }
        for Trace { point, zones: own } in traces.iter_mut().filter(|_| has_play) {
            let Some(course) = point.output.and_then(|output| courses.get(output)) else { continue };
            let place = own.partition_point(|zone| zone.sample < course.sample);
            if let Some(worst) = course.worst.as_ref().filter(|_| !zones.has(course.sample)) {
                zones.zone(&worst.accuracy, point, course.sample).into_iter().for_each(|zone| own.insert(place, zone));
            }
        }
        let worst: Vec<usize> = courses.iter().map(|course| course.sample).collect();
        let is_other_start = positions.first().is_some_and(|position| position.is_other_start);
        let picture = self.picture(&mechanism, values, &poses, traces, &worst);
        let states: Vec<OutputState> = poses.iter().map(|poses| OutputState { mechanism: &mechanism, poses }).collect();
        let outputs = courses.into_iter().zip(&self.outputs).map(|(course, output)| {
            go_on()?;
            let at = inputs_si.get(course.sample).copied().unwrap_or_default();
            let refused = |error| self.no_answer(&output.name, at, error);
            let worst = course.worst_case(is_proven, is_stopped).map_err(refused)?;
            let worst_regular = course.worst_regular_case(is_proven, is_stopped).map_err(refused)?;
            let record = self.output_record(output, course, worst, &states)?;
            Ok(SpatialOutputRecord { worst_regular, ..record })
        });
        let mut outputs: Vec<SpatialOutputRecord> = outputs.collect::<Result<_, Diagnostics>>()?;
        outputs.iter_mut().for_each(|output| drop_round_off(output, mechanism.characteristic_length_m()));
        let record = self.record(&mechanism, &input, inputs_si, (outputs, picture));
        Ok(SpatialMotionRecord { is_proven, dead_centre_samples, is_other_start, ..record })
    }

    /// The mechanism moving over its turn, to be drawn: without outputs and what play does to them. Until it is stopped.
    ///
    /// # Errors
    /// As for [`SpatialModel::motion_record_until`], but for answers.
    pub fn drawn_motion_until(
        &self,
        values: &Values,
        is_stopped: IsStopped,
    ) -> Result<SpatialMotionRecord, Diagnostics> {
        let mechanism = self.mechanism(values).map_err(|error| self.diagnostic(&error))?;
        let input = self.cycle_input(values).map_err(|error| self.diagnostic(&error))?;
        let positions = self.positions_until(&mechanism, values, is_stopped)?;
        let poses: Vec<Vec<Pose>> = positions.iter().map(|position| position.poses.clone()).collect();
        let picture = self.picture(&mechanism, values, &poses, Vec::new(), &[]);
        let inputs_si = positions.iter().map(|position| input.at(position.input)).collect();
        Ok(self.record(&mechanism, &input, inputs_si, (Vec::new(), picture)))
    }

    fn record(
        &self,
        mechanism: &SpatialMechanism,
        input: &CycleInput,
        inputs_si: Vec<f64>,
        (outputs, picture): (Vec<SpatialOutputRecord>, SpatialPicture),
    ) -> SpatialMotionRecord {
        SpatialMotionRecord {
            model: self.name.clone(),
            input: input.drive.clone().unwrap_or_else(|| "time".to_owned()),
            repeat: Repeat::new("motion", &[], [(InputRole::Model, &**self.source())]),
            drive_speed_rad_s: input.drive.as_ref().map(|_| input.rate),
            input_unit: if input.drive.is_some() { SiUnit::ANGLE } else { SiUnit::TIME },
            has_play: mechanism.joints().iter().any(has_play),
            is_proven: false,
            dead_centre_samples: Vec::new(),
            is_other_start: false,
            asked: Vec::new(),
            outputs,
            inputs_si,
            picture,
        }
    }

    /// The positions of the turn, until it is stopped.
    ///
    /// # Errors
    /// There is no turn, or the loops do not close all over it; that it was stopped.
    pub fn positions_until(
        &self,
        mechanism: &SpatialMechanism,
        values: &Values,
        is_stopped: IsStopped,
    ) -> Result<Vec<Position>, Diagnostics> {
        let input = self.cycle_input(values).map_err(|error| self.diagnostic(&error))?;
        let positions = self.turn(mechanism, values, &input.times_s(), Starts::Nearby, is_stopped).whole();
        positions.map_err(|error| self.not_closed(&error))
    }

    /// The first positions of the turn, as far as it is not stopped: at all of them the loops close.
    ///
    /// # Errors
    /// There is no turn, or the loops do not close where it was looked at.
    pub fn first_positions(
        &self,
        mechanism: &SpatialMechanism,
        values: &Values,
        is_stopped: IsStopped,
    ) -> Result<Vec<Position>, Diagnostics> {
        let input = self.cycle_input(values).map_err(|error| self.diagnostic(&error))?;
        let Cycle { positions, stopped } = self.turn(mechanism, values, &input.times_s(), Starts::Nearby, is_stopped);
        match stopped {
            None | Some(ClosureError::Stopped) => Ok(positions),
            Some(error) => Err(self.not_closed(&error)),
        }
    }

    /// The positions at these times, as far as the loops close.
    pub(super) fn turn(
        &self,
        mechanism: &SpatialMechanism,
        values: &Values,
        times_s: &[f64],
        starts: Starts,
        is_stopped: IsStopped,
    ) -> Cycle {
        cycle_from(mechanism, times_s, &|time_s| self.drive_values(values, time_s), starts, is_stopped)
    }

    /// Why loops do not close, at the joint.
    pub fn not_closed(&self, error: &ClosureError) -> Diagnostics {
        self.open(error).into()
    }

    /// The same, with the play that it would take where constraints repeat others.
    fn not_with_ideal_joints(&self, values: &Values, error: &ClosureError, is_stopped: IsStopped) -> Diagnostics {
        if matches!(error, ClosureError::Stopped | ClosureError::TooLong { .. }) {
            return self.not_closed(error);
        }
        let by_play = self.assembly_until(values, is_stopped).ok().and_then(|assembly| assembly.sentence());
        if is_stopped() {
            return self.not_closed(&ClosureError::Stopped);
        }
        let Some(by_play) = by_play else { return self.not_closed(error) };
        let problem = SpatialMotionProblem::NotWithIdealJoints { why: error.to_string(), by_play };
        Diagnostic::error(&problem, self.place_of_joint(error.joint())).into()
    }

    pub(super) fn open(&self, error: &ClosureError) -> Diagnostic {
        match error {
            ClosureError::Stopped => Diagnostic::error(&SpatialMotionProblem::Stopped, None),
            ClosureError::TooLong { joint, .. } => {
                let problem = SpatialMotionProblem::TooLong { why: error.to_string() };
                Diagnostic::error(&problem, self.place_of_way(joint))
            }
            _ => {
                let problem = SpatialMotionProblem::DoesNotClose { why: error.to_string() };
                Diagnostic::error(&problem, self.place_of_joint(error.joint()))
            }
        }
    }

    /// What makes the way of the drive of a joint long: the duration of the cycle, or its speed where another drive is counted.
    fn place_of_way(&self, joint: &str) -> Option<Place> {
        if let Some(ModelCycleSpan::Duration(_)) = self.cycle.map(|cycle| cycle.span) {
            return self.place("cycle.duration");
        }
        let drive = self.drives.iter().find(|drive| self.joints[drive.joint].name == joint)?;
        self.place(&format!("drive.{}.speed", drive.name))
    }

    /// The table of a joint, where one is at fault.
    pub(super) fn place_of_joint(&self, joint: Option<&str>) -> Option<Place> {
        self.place(&format!("joint.{}", joint?))
    }

    fn output_record(
        &self,
        output: &ModelOutput,
        course: Course<'_>,
        worst: SpatialWorstCase,
        states: &[OutputState<'_>],
    ) -> Result<SpatialOutputRecord, Diagnostics> {
        let ideal_si = ideal(&course.components, states);
        let is_turn = matches!(output.kind, ModelOutputKind::Turn { .. });
        let is_coarse = |pair: &[f64]| matches!(pair, [before, after] if (after - before).abs() > FRAC_PI_2);
        if is_turn && (ideal_si.len() <= MIN_STEPS_OF_TURN || ideal_si.windows(2).any(is_coarse)) {
            let problem = SpatialMotionProblem::CoarseTurn { output: output.name.clone() };
            return Err(Diagnostics::one(&problem, self.place(&format!("output.{}", output.name))));
        }
        let is_whole = course.variances.len() == course.first_order_si.len();
        let (words, unit) = self.words(output.kind);
        Ok(SpatialOutputRecord {
            name: output.name.clone(),
            words,
            unit,
            ideal_si,
            standard_deviation_si: match is_whole {
                true => course.variances.iter().map(|own| own.sqrt()).collect(),
                false => Vec::new(),
            },
            first_order_si: course.first_order_si,
            worst,
            worst_regular: None,
            scatter: SpatialScatter::default(),
        })
    }

    /// A place of the input for people.
    pub(super) fn input_words(&self, input: f64) -> String {
        let is_time = self.cycle.is_none_or(|cycle| matches!(cycle.span, ModelCycleSpan::Duration(_)));
        format_value(input, if is_time { Dimension::TIME } else { Dimension::ANGLE })
    }

    /// Why an output has no answer at a place of the input, at the table of the output; of all outputs where it has no name.
    pub(super) fn no_answer(&self, output: &str, input: f64, error: AccuracyError) -> Diagnostic {
        if error == AccuracyError::Stopped {
            return self.open(&ClosureError::Stopped);
        }
        let at = self.input_words(input);
        let subject = if output.is_empty() { "the motion".to_owned() } else { format!("output '{output}'") };
        let problem = SpatialMotionProblem::NoAnswer { subject, at, why: error.to_string() };
        let table = if output.is_empty() { "cycle".to_owned() } else { format!("output.{output}") };
        Diagnostic::error(&problem, self.place(&table))
    }

    /// Unit of an output.
    pub(super) fn unit_of(&self, output: usize) -> SiUnit {
        self.words(self.outputs[output].kind).1
    }

    fn words(&self, kind: ModelOutputKind) -> (String, SiUnit) {
        match kind {
            ModelOutputKind::Position { point, .. } => {
                (format!("position of {}", self.point_name(point)), SiUnit::LENGTH)
            }
            ModelOutputKind::Path { point } => (format!("displacement of {}", self.point_name(point)), SiUnit::LENGTH),
            ModelOutputKind::Turn { body, .. } => (format!("turn of {}", self.bodies[body].name), SiUnit::ANGLE),
            ModelOutputKind::Orientation { body } => (format!("rotation of {}", self.bodies[body].name), SiUnit::ANGLE),
        }
    }
}

/// Whether play moves the journal of a joint; a clearance of zero moves nothing.
fn has_play(joint: &Joint) -> bool {
    joint.play.iter().flat_map(SpatialPlay::blocks).any(|block| block.radius > 0.0)
}

/// Fewest steps of a turn for the angle of a body: a whole turn in one step would look like none.
const MIN_STEPS_OF_TURN: usize = 8;
/// Relative difference of worst cases that is round-off.
const SAME: f64 = 1e-9;

/// What is known of an output after some positions.
struct Course<'a> {
    components: Vec<SpatialOutput>,
    first_order_si: Vec<f64>,
    /// Where there is a closed form.
    variances: Vec<f64>,
    /// The position with the largest worst case of first order.
    sample: usize,
    worst: Option<Worst<'a>>,
    /// That of the positions in which play comes near no dead centre.
    regular_sample: usize,
    worst_regular: Option<Worst<'a>>,
}

/// The largest worst case of first order so far.
struct Worst<'a> {
    size: f64,
    /// What it is of.
    along: SpatialOutput,
    accuracy: Rc<PoseAccuracy<'a>>,
}

impl<'a> Course<'a> {
    fn new(components: Vec<SpatialOutput>) -> Self {
        let (first_order_si, variances) = (Vec::new(), Vec::new());
        Self { components, first_order_si, variances, sample: 0, worst: None, regular_sample: 0, worst_regular: None }
    }

    fn add(&mut self, sample: usize, accuracy: &Rc<PoseAccuracy<'a>>, is_regular: bool) -> Result<(), AccuracyError> {
        let (size, variance, along) = at_position(accuracy, &self.components)?;
        self.first_order_si.push(size);
        self.variances.extend(variance);
        // Round-off decides nothing: the first of several alike.
        let is_worse = |known: &Option<Worst<'_>>| known.as_ref().is_none_or(|known| size > known.size * (1.0 + SAME));
        let worst = || Worst { size, along, accuracy: Rc::clone(accuracy) };
        if is_worse(&self.worst) {
            (self.sample, self.worst) = (sample, Some(worst()));
        }
        if is_regular && is_worse(&self.worst_regular) {
            (self.regular_sample, self.worst_regular) = (sample, Some(worst()));
        }
        Ok(())
    }

    fn worst_case(&self, is_proven: bool, is_stopped: IsStopped) -> Result<SpatialWorstCase, AccuracyError> {
        let worst = self.worst.as_ref().ok_or(AccuracyError::NotAPosition)?;
        worst_case(&worst.accuracy, &worst.along, self.sample, (is_proven, is_stopped))
    }

    /// The worst case where play comes near no dead centre; `None` where that is the worst one, or nowhere.
    fn worst_regular_case(
        &self,
        is_proven: bool,
        is_stopped: IsStopped,
    ) -> Result<Option<SpatialWorstCase>, AccuracyError> {
        let other = self.worst_regular.as_ref().filter(|_| self.regular_sample != self.sample);
        let how = (is_proven, is_stopped);
        other.map(|worst| worst_case(&worst.accuracy, &worst.along, self.regular_sample, how)).transpose()
    }
}

/// Worst case of first order, variance if there is a closed form, and the output that the worst case is of: of a vector its component along the
/// direction in which it is longest.
fn at_position(
    accuracy: &PoseAccuracy<'_>,
    components: &[SpatialOutput],
) -> Result<(f64, Option<f64>, SpatialOutput), AccuracyError> {
    let gains = components.iter().map(|output| accuracy.gains(output)).collect::<Result<Vec<Gains>, _>>()?;
    let deviation = |gains: &Gains| accuracy.standard_deviation(gains, PlayDistribution::Inside);
    let variance = gains.iter().map(|own| deviation(own).map(|own| own * own)).sum::<Option<f64>>();
    if let ([output], [gains]) = (components, gains.as_slice()) {
        return Ok((accuracy.first_order(gains)?.worst, variance, *output));
    }
    let longest = accuracy.largest_norm(&gains)?;
    let direction = <[f64; 3]>::try_from(longest.direction).map_or(None, |n| Vec3::from(n).normalised());
    let along = components.first().and_then(|first| first.component(direction.unwrap_or(Vec3::X)));
    Ok((longest.largest, variance, along.ok_or(AccuracyError::OutputDoesNotFit)?))
}

/// Ideal values: of a point its place along the direction, of a turn the sum of the turns from position to position.
fn ideal(components: &[SpatialOutput], states: &[OutputState<'_>]) -> Vec<f64> {
    let [output] = components else { return Vec::new() };
    if let Some(own) = output.point() {
        return states.iter().map(|state| state.poses[own.body].point_m(own.point_m).dot(own.direction)).collect();
    }
    let mut turned = vec![0.0];
    for pair in states.windows(2) {
        let before = turned.last().copied().unwrap_or_default();
        turned.push(before + output.deviation(&pair[0], &pair[1]));
    }
    turned.truncate(states.len());
    turned
}

fn worst_case(
    accuracy: &PoseAccuracy<'_>,
    output: &SpatialOutput,
    sample: usize,
    (is_proven, is_stopped): (bool, IsStopped),
) -> Result<SpatialWorstCase, AccuracyError> {
    let gains = accuracy.gains(output)?;
    let first_order = accuracy.first_order(&gains)?;
    let exact = accuracy.worst_case_until(output, &SearchOptions::default(), is_stopped)?;
    let proven = if is_proven { accuracy.proven_end(output) } else { None };
    Ok(SpatialWorstCase {
        sample,
        largest_si: exact.largest.deviation,
        smallest_si: exact.smallest.deviation,
        proven_largest_si: proven.map(|ends| ends.largest),
        proven_smallest_si: proven.map(|ends| ends.smallest),
        conditions: accuracy.conditions(),
        contributors: contributors(accuracy, &gains, &first_order),
    })
}

/// What each joint with play does: g + λ·h in place of g, where the plays must meet conditions together.
fn contributors(accuracy: &PoseAccuracy<'_>, gains: &Gains, first_order: &FirstOrder) -> Vec<SpatialContributor> {
    let mut by_play = gains.by_play.clone();
    for (row, multiplier) in accuracy.conditions_by_play().iter().zip(&first_order.multipliers) {
        by_play.iter_mut().zip(row).for_each(|(gain, h)| *gain += multiplier * h);
    }
    let joints = accuracy.mechanism().joints().iter().enumerate().filter(|(_, joint)| joint.play.is_some());
    joints
        .map(|(number, joint)| {
            let of = |part: PlayPart| {
                let block = gains.blocks.iter().find(|block| block.joint == number && block.part == part)?;
                Some((by_play.get(block.range())?, block.radius))
            };
            let alone = |part: PlayPart| of(part).map(|(own, radius_m)| radius_m * length(own.iter().copied()));
            // u1 = u2 = c is an offset, u2 = -u1 a lean.
            let of_ends =
                of(PlayPart::FirstEnd).zip(of(PlayPart::SecondEnd)).map(|((first, radius_m), (second, _))| {
                    let both = |sign: f64| radius_m * length(first.iter().zip(second).map(|(a, b)| a + sign * b));
                    [both(1.0), both(-1.0)]
                });
            SpatialContributor {
                joint: joint.name.clone(),
                part_si: first_order.by_joint.get(number).copied().unwrap_or_default(),
                offset_si: of_ends
                    .map(|[offset, _]| offset)
                    .or_else(|| alone(PlayPart::Ball))
                    .or_else(|| alone(PlayPart::Across))
                    .unwrap_or_default(),
                lean_si: of_ends.map(|[_, lean]| lean).or_else(|| alone(PlayPart::Lean)),
                axial_si: alone(PlayPart::Axial),
            }
        })
        .collect()
}

fn length(components: impl Iterator<Item = f64>) -> f64 {
    components.map(|own| own * own).sum::<f64>().sqrt()
}
