//! A model over its turn: ideal motion, worst cases, and who contributes, as a record.

use super::compile::CycleInput;
use super::course::{Course, has_play};
use super::drawn::Trace;
use super::marker::PointId;
use super::parts::{ModelCycleSpan, ModelOutput, SpatialModel};
use super::problem::SpatialMotionProblem;
use super::round_off::drop_round_off_of_output;
use crate::accuracy::{AccuracyError, DeadCentreNearness, PoseAccuracy};
use crate::closure::assembly::Starts;
use crate::closure::cycle::{Cycle, cycle_from};
use crate::closure::error::ClosureError;
use crate::closure::position::Position;
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use crate::mobility::mobility;
use crate::output::SpatialOutput;
use crate::output::kind_of_output::{KindOfOutput, OutputState};
use crate::picture::Zones;
use crate::stop::{IsStopped, NEVER};
use loosepin_math::Pose;
use loosepin_result::kinematics::KinematicProperties;
use loosepin_result::motion::{ClearanceAnswer, MotionRecord, OTHER_START, OutputMotion, UnprovenSpan};
use loosepin_result::repeat::{InputRole, Repeat};
use loosepin_result::round_off::round_off_si;
use loosepin_result::simulation::Drawing;
use loosepin_result::spatial_picture::SpatialPicture;
use loosepin_text::VERSION;
use loosepin_text::diagnostics::{Diagnostic, Diagnostics, Place};
use loosepin_text::numbers::Values;
use loosepin_text::units::{Dimension, DisplayUnits, SiUnit, format_value};
use std::f64::consts::{FRAC_PI_2, TAU};
use std::rc::Rc;

impl SpatialModel {
    /// Moves the mechanism over its turn. Ends of worst cases are not proven: see [`SpatialModel::motion_with_paths_until`].
    ///
    /// # Errors
    /// What [`SpatialModel::mechanism`] and [`SpatialModel::cycle_input`] refuse; loops that do not close; positions in which an output has no
    /// answer.
    pub fn motion_record(&self, values: &Values) -> Result<MotionRecord, Diagnostics> {
        self.motion_with_paths_until(values, &[], false, NEVER)
    }

    /// The same, until it is stopped, with the paths of further points, and what play makes of them to first order; with proven ends of the worst case
    /// of each output on demand, which take a tenth of a second each and more.
    ///
    /// # Errors
    /// As for [`SpatialModel::motion_record`]; positions in which a path has no answer; that it was stopped.
    pub fn motion_with_paths_until(
        &self,
        values: &Values,
        points: &[PointId],
        is_proven: bool,
        is_stopped: IsStopped,
    ) -> Result<MotionRecord, Diagnostics> {
        let go_on = || if is_stopped() { Err(self.not_closed(&ClosureError::Stopped)) } else { Ok(()) };
        let mechanism = self.mechanism(values).map_err(|error| self.diagnostic(&error))?;
        let input = self.cycle_input(values).map_err(|error| self.diagnostic(&error))?;
        let positions = self.turn(&mechanism, values, &input.times_s(), Starts::Nearby, is_stopped).whole();
        let positions = positions.map_err(|error| self.not_with_ideal_joints(values, &error, is_stopped))?;
        let record = self.moved(&mechanism, &input, &positions);
        let positions = input.ascending(positions);
        let mut courses = self.courses(&mechanism, values)?;
        let has_play = mechanism.joints().iter().any(has_play);
        let zones = Zones::new(positions.len());
        let mut paths = self.paths_over_turn(&mechanism, values, input.turn_s, points);
        let traced = self.traced_points(&mechanism, values, points).into_iter();
        let mut traces: Vec<Trace> = traced.map(|point| Trace { point, zones: Vec::new() }).collect();
        let (mut poses, mut dead_centres) = (Vec::with_capacity(positions.len()), Vec::new());
        // One after the other: the loop equations of all positions at once may be gigabytes.
        for (sample, position) in positions.iter().enumerate() {
            go_on()?;
            let at = input.at(position.input);
            let accuracy = PoseAccuracy::new(&mechanism, position).map_err(|error| self.no_answer("", at, error))?;
            let accuracy = Rc::new(accuracy);
            let nearness = if has_play { accuracy.dead_centre_nearness() } else { DeadCentreNearness::default() };
            dead_centres.push(nearness.is_reached);
            for (course, output) in courses.iter_mut().zip(&self.outputs) {
                course.add(&accuracy, !nearness.is_near).map_err(|error| self.no_answer(&output.name, at, error))?;
            }
            paths.add(&mechanism, &accuracy).map_err(|(path, error)| self.no_path(&path, at, error))?;
            poses.push(accuracy.position().poses.clone());
            for trace in traces.iter_mut().filter(|own| has_play && own.point.has_zones && zones.has(sample)) {
                trace.zones.extend(zones.zone(&accuracy, &trace.point, sample));
            }
        }
        for Trace { point, zones: own } in traces.iter_mut().filter(|_| has_play) {
            let worst = point.output.and_then(|output| courses.get(output)).and_then(Course::worst);
            if let Some(worst) = worst.filter(|worst| !zones.has(worst.position)) {
                let place = own.partition_point(|zone| zone.sample < worst.position);
                let zone = zones.zone(&worst.place.accuracy, point, worst.position);
                zone.into_iter().for_each(|zone| own.insert(place, zone));
            }
        }
        let worst: Vec<usize> = courses.iter().map(|course| course.worst().map_or(0, |worst| worst.position)).collect();
        let picture = self.picture(&mechanism, values, &poses, traces, &worst);
        let states: Vec<OutputState> = poses.iter().map(|poses| OutputState { mechanism: &mechanism, poses }).collect();
        let start = if input.rate < 0.0 { states.len() - 1 } else { 0 };
        let outputs = courses.into_iter().zip(&self.outputs).zip(worst).map(|((course, output), worst)| {
            go_on()?;
            let value_si = ideal(course.components(), &states, start);
            self.refuse_coarse_turn(output, &value_si)?;
            let at = input.at(positions[worst].input);
            let clearance =
                course.answer(is_proven, is_stopped).map_err(|error| self.no_answer(&output.name, at, error))?;
            let mut motion = OutputMotion { value_si, clearance, ..self.output_motion(output) };
            drop_round_off_of_output(&mut motion, mechanism.characteristic_length_m());
            Ok(motion)
        });
        let outputs = outputs.collect::<Result<Vec<OutputMotion>, Diagnostics>>()?;
        let unproven_spans = dead_centre_spans(&record.drive_angle_rad, &dead_centres);
        Ok(MotionRecord { outputs, paths: paths.finished(), unproven_spans, picture, ..record })
    }

    /// What play does to each output to first order at other places, as [`SpatialModel::scatter_at`] has what scatters there.
    ///
    /// # Errors
    /// As for [`SpatialModel::motion_with_paths_until`].
    pub fn play_at(
        &self,
        values: &Values,
        turn: f64,
        is_stopped: IsStopped,
    ) -> Result<Vec<ClearanceAnswer>, Diagnostics> {
        let mechanism = self.mechanism(values).map_err(|error| self.diagnostic(&error))?;
        let input = self.cycle_input(values).map_err(|error| self.diagnostic(&error))?;
        let times_s = [0.0, turn * input.turn_s];
        let positions = self.turn(&mechanism, values, &times_s, Starts::Nearby, is_stopped).whole();
        let positions = positions.map_err(|error| self.not_closed(&error))?;
        let Some(position) = positions.last() else { return Ok(Vec::new()) };
        let at = input.at(position.input);
        let accuracy = PoseAccuracy::new(&mechanism, position).map_err(|error| self.no_answer("", at, error))?;
        let accuracy = Rc::new(accuracy);
        let courses = self.courses(&mechanism, values)?.into_iter().zip(&self.outputs).map(|(mut course, output)| {
            course.add(&accuracy, true).map_err(|error| self.no_answer(&output.name, at, error))?;
            let mut answer = course.unsearched();
            let unit = SiUnit::of_dimension(output.kind.dimension());
            answer.drop_round_off(round_off_si(&unit, mechanism.characteristic_length_m()));
            Ok(answer)
        });
        courses.collect()
    }

    fn courses<'a>(&self, mechanism: &SpatialMechanism, values: &Values) -> Result<Vec<Course<'a>>, Diagnostics> {
        let outputs = (0..self.outputs.len()).map(|number| self.outputs_of(number, values));
        let courses = outputs.map(|output| output.map(|components| Course::new(components, mechanism)));
        Ok(courses.collect::<Result<_, _>>().map_err(|error| self.diagnostic(&error))?)
    }

    /// The mechanism moving over its turn, to be drawn: without outputs and what play does to them. Until it is stopped.
    ///
    /// # Errors
    /// As for [`SpatialModel::motion_with_paths_until`], but for answers.
    pub fn drawn_motion_until(&self, values: &Values, is_stopped: IsStopped) -> Result<MotionRecord, Diagnostics> {
        let mechanism = self.mechanism(values).map_err(|error| self.diagnostic(&error))?;
        let input = self.cycle_input(values).map_err(|error| self.diagnostic(&error))?;
        let positions = self.positions_until(&mechanism, values, is_stopped)?;
        let record = self.moved(&mechanism, &input, &positions);
        let positions = input.ascending(positions);
        let poses: Vec<Vec<Pose>> = positions.iter().map(|position| position.poses.clone()).collect();
        Ok(MotionRecord { picture: self.picture(&mechanism, values, &poses, Vec::new(), &[]), ..record })
    }

    /// The record of a motion through these positions, the start first, without outputs and picture.
    fn moved(&self, mechanism: &SpatialMechanism, input: &CycleInput, positions: &[Position]) -> MotionRecord {
        let start = positions.first();
        let is_drive = input.drive.is_some();
        let times_s = || input.ascending(positions.iter().map(|position| position.input).collect());
        let angle_rad = |time_s: f64| if is_drive { input.at(time_s) } else { TAU * time_s / input.turn_s };
        let is_other_start = start.is_some_and(|start| start.is_other_start);
        MotionRecord {
            model: self.name.clone(),
            version: VERSION.to_owned(),
            overrides: Vec::new(),
            repeat: Repeat::new("motion", &[], [(InputRole::Model, &**self.source())]),
            drive: input.drive.clone().unwrap_or_else(|| "time".to_owned()),
            drive_speed_rad_s: is_drive.then_some(input.rate),
            mobility: start.map_or_else(String::new, |start| mobility(mechanism, start).words()),
            singular_positions: Vec::new(),
            kinematics: KinematicProperties::default(),
            guide_overhangs: Vec::new(),
            unproven_spans: Vec::new(),
            is_proven_between_angles: false,
            remarks: if is_other_start { vec![OTHER_START.to_owned()] } else { Vec::new() },
            display_units: DisplayUnits::default(),
            drive_angle_rad: times_s().into_iter().map(angle_rad).collect(),
            time_s: if is_drive { Vec::new() } else { times_s() },
            outputs: Vec::new(),
            paths: Vec::new(),
            efforts: Vec::new(),
            requirements: Vec::new(),
            allowances: Vec::new(),
            asked: Vec::new(),
            drawing: Drawing::default(),
            picture: SpatialPicture::default(),
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

    /// An output without numbers.
    fn output_motion(&self, output: &ModelOutput) -> OutputMotion {
        OutputMotion {
            name: output.name.clone(),
            words: format!("{} of {}", output.kind.word(), self.name_of(output.kind)),
            unit: SiUnit::of_dimension(output.kind.dimension()),
            coordinate_of: None,
            path_error: None,
            value_si: Vec::new(),
            velocity_si: Vec::new(),
            acceleration_si: Vec::new(),
            clearance: ClearanceAnswer::default(),
            dimensional_standard_deviation_si: Vec::new(),
            dimensional_contributors: Vec::new(),
        }
    }

    /// Steps in which a body turns so far that its turns cannot be counted are refused.
    fn refuse_coarse_turn(&self, output: &ModelOutput, value_si: &[f64]) -> Result<(), Diagnostics> {
        let is_coarse = |pair: &[f64]| matches!(pair, [before, after] if (after - before).abs() > FRAC_PI_2);
        if output.kind.counts_turns() && (value_si.len() <= MIN_STEPS_OF_TURN || value_si.windows(2).any(is_coarse)) {
            let problem = SpatialMotionProblem::CoarseTurn { output: output.name.clone() };
            return Err(Diagnostics::one(&problem, self.place(&format!("output.{}", output.name))));
        }
        Ok(())
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
        SiUnit::of_dimension(self.outputs[output].kind.dimension())
    }
}

/// Fewest steps of a turn for the angle of a body: a whole turn in one step would look like none.
const MIN_STEPS_OF_TURN: usize = 8;
/// What is said of positions in which play reaches a dead centre.
const DEAD_CENTRE: &str = "play takes the mechanism to a dead centre there, where it can go over to its other assembly; its first-order effect says \
                           nothing, and more than what was found may be possible";

/// Positions in a row in which play reaches a dead centre.
pub fn dead_centre_spans(angles_rad: &[f64], dead_centres: &[bool]) -> Vec<UnprovenSpan> {
    let rows: Vec<(f64, bool)> = angles_rad.iter().copied().zip(dead_centres.iter().copied()).collect();
    let stretches = rows.chunk_by(|a, b| a.1 == b.1).filter(|stretch| stretch[0].1);
    let span = |stretch: &[(f64, bool)]| UnprovenSpan {
        span_rad: [stretch[0].0, stretch[stretch.len() - 1].0],
        words: DEAD_CENTRE.to_owned(),
        reaches_dead_centre: true,
    };
    stretches.map(span).collect()
}

/// Ideal values: of a point its place along the direction, of a turn the sum of the turns from the `start` to the position.
pub(super) fn ideal(components: &[SpatialOutput], states: &[OutputState<'_>], start: usize) -> Vec<f64> {
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
    let at_start = turned.get(start).copied().unwrap_or_default();
    turned.iter().map(|angle| angle - at_start).collect()
}
