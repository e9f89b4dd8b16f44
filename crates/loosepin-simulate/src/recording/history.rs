//! One run recorded in full: histories, impacts, extremes, energy, orbits, poses.

use crate::engine::{least_evaluations, longest_step_s, run_from};
use crate::failure::RunFailure;
use crate::ideal::column::columns;
use crate::ideal::reference::IdealReference;
use crate::input_files::input_files;
use crate::lanes::batch::CompiledCodeCache;
use crate::observer::{Observer, Onset, Separation, Step};
use crate::recording::bending::BendingRecorder;
use crate::recording::column_reader::{ColumnReader, Ideal};
use crate::recording::contact_basis::{contact_basis, long_pin_force};
use crate::recording::control_history::ControlRecorder;
use crate::recording::drawing::{add_bending, add_pose, skeleton};
use crate::recording::extremes::{ExtremeRecorder, times_s};
use crate::recording::flight::FlightClock;
use crate::recording::report::RunReport;
use crate::repeats::lyapunov::{ExponentPlan, largest_exponent};
use crate::repeats::sections::SectionRecorder;
use crate::repeats::trust::{PositionHistory, measure_trust};
use crate::repeats::turns::Turns;
use crate::resume::MotionState;
use crate::settings::{Integrator, Settings, Window};
use crate::stepping::motion::EnergyTotals;
use crate::stepping::search::maximum_within;
use crate::stoppable_observer::StoppableObserver;
use crate::wear::{LifePlan, WearRecorder, worn_life};
use loosepin_math::Vec2;
use loosepin_mechanics::dynamics::Dynamics;
use loosepin_mechanics::mechanism::{Mechanism, Sample, acceleration_at};
use loosepin_mechanics::model::{Cycle, CycleInput, CycleSpan, Model, Output, PartNames, Values, relative_words};
use loosepin_result::repeat::Repeat;
use loosepin_result::simulation::{
    ContactForceHistory, Drawing, EnergyAccount, ImpactRecord, JointSummary, JointWearRecord, JournalOrbit,
    OutputHistory, Override, RunPath, SimulationRecord, SimulationSettings, StopReason, Trust,
};
use loosepin_text::units::DisplayUnits;
use std::sync::atomic::AtomicBool;

/// Plan of a run that is recorded in full.
#[derive(Debug, Clone)]
pub struct Plan {
    /// Drive, transient and recorded turns, samples.
    pub cycle: Cycle,
    /// Accuracy.
    pub settings: Settings,
    /// Whether positions, velocities and accelerations of all bodies are recorded.
    pub with_states: bool,
    /// Turns over which the largest Lyapunov exponent is measured, in runs of their own; `None` if it is not asked for.
    pub lyapunov_turns: Option<u32>,
    /// Whether a second run measures how long the positions can be trusted; that costs about as much again.
    pub second_run: bool,
    /// Values set on the command line, for the record.
    pub overrides: Vec<Override>,
}

impl Plan {
    /// The cycle that `model` states, with the accuracy of a single run and without further records.
    pub fn of_model(model: &Model) -> Self {
        let (cycle, settings) = (model.cycle.clone(), Settings::for_simulation());
        Self { cycle, settings, with_states: false, lyapunov_turns: None, second_run: false, overrides: Vec::new() }
    }

    /// Checks that the run ends within its limit of evaluations, and that its history fits the limits of a record. Nothing is run.
    ///
    /// # Errors
    /// One of these, or the drive of the cycle stands still.
    pub fn check(&self, mechanism: &Mechanism, sample: &Sample<f64>, values: &Values) -> Result<(), RunFailure> {
        if self.settings.integrator == Integrator::Implicit && mechanism.real.nodal_beams.is_empty() {
            return Err(RunFailure::ImplicitWithoutNodes);
        }
        let rows = self.cycle.recorded_turns * self.cycle.samples_per_turn as f64;
        if !(rows <= MAX_ROWS as f64) {
            return Err(RunFailure::TooManyRows { rows, most: MAX_ROWS });
        }
        let states = if self.with_states { NUMBERS_OF_A_STATE * mechanism.model.bodies.len() } else { 0 };
        // The ideal values stand beside those of the run.
        let numbers = 2 * columns(&mechanism.model).len() + mechanism.contacts.len() + states + NUMBERS_OF_A_ROW;
        if rows * numbers as f64 > MAX_NUMBERS as f64 {
            return Err(RunFailure::TooManyNumbers { rows, numbers, most: MAX_NUMBERS });
        }
        let least = least_evaluations(mechanism, sample, &self.window(mechanism, values)?, &self.settings);
        let limit = self.settings.largest_evaluations;
        if least > limit as f64 {
            let turns = self.cycle.transient_turns + self.cycle.recorded_turns;
            return Err(RunFailure::TooManyTurns { turns, least, limit });
        }
        Ok(())
    }

    /// The recorded part of the run.
    ///
    /// # Errors
    /// The drive of the cycle stands still.
    pub fn window(&self, mechanism: &Mechanism, values: &Values) -> Result<Window, RunFailure> {
        let turn_s = input(mechanism, values, self.cycle.span)?.turn_s();
        let start_s = self.cycle.transient_turns * turn_s;
        Ok(Window { start_s, end_s: start_s + self.cycle.recorded_turns * turn_s })
    }
}

/// The input of a cycle that counts by `span`, which has turns.
///
/// # Errors
/// The drive stands still.
pub fn input(mechanism: &Mechanism, values: &Values, span: CycleSpan) -> Result<CycleInput, RunFailure> {
    let input = mechanism.model.input(span, values);
    if input.speed_rad_s.abs() > 0.0 { Ok(input) } else { Err(RunFailure::StandsStill { drive: input.name }) }
}

/// Rows of a history, at most: a million rows of ten columns are 200 MB of text.
pub const MAX_ROWS: usize = 1_000_000;
/// Numbers of a history, at most: a gibibyte.
pub const MAX_NUMBERS: usize = 1 << 27;
/// Numbers of a row beside those of outputs, contacts and bodies: the time and the energies.
const NUMBERS_OF_A_ROW: usize = 10;
/// Numbers of a row for each body where states are recorded: three coordinates, their rates and accelerations.
const NUMBERS_OF_A_STATE: usize = 9;

/// A finished run.
#[derive(Debug, Clone)]
pub struct Simulation {
    /// Everything for pages and tables.
    pub record: SimulationRecord,
    /// States of all bodies, where asked for.
    pub states: Option<BodyStates>,
    /// Counters, energy account and joints of the run.
    pub report: RunReport,
    /// Why the run counts as failed though it came to its end: its energy account does not bear it out.
    pub failure: Option<RunFailure>,
}

/// Motion of the centres of mass (of a flexible body of the middle of its straight frame) at the sample times: for each moving body x, y, angle, then their rates, then their
/// accelerations; m, rad, s.
#[derive(Debug, Clone, Default)]
pub struct BodyStates {
    /// Names of the bodies.
    pub bodies: Vec<String>,
    /// One row for each sample: positions of all bodies, velocities of all, accelerations of all.
    pub rows: Vec<Vec<f64>>,
}

/// Runs `mechanism` with `values` and records everything.
///
/// # Errors
/// The one reason why the run failed.
pub fn simulate(mechanism: &Mechanism, values: &Values, plan: &Plan) -> Result<Simulation, RunFailure> {
    simulate_until(mechanism, values, plan, &AtomicBool::new(false))
}

/// As [`simulate`], until `stop` is set, in a moment's time. The run of a Lyapunov exponent goes on to its end.
///
/// # Errors
/// As for [`simulate`]; [`RunFailure::Stopped`].
pub fn simulate_until(
    mechanism: &Mechanism,
    values: &Values,
    plan: &Plan,
    stop: &AtomicBool,
) -> Result<Simulation, RunFailure> {
    simulate_from(mechanism, values, plan, None, stop)
}

/// As [`simulate_until`], from the state at the end of another run, whose time goes on; from the initial state of the model where there is
/// none. Turns before those that are recorded, where the plan has any, are run from there.
///
/// # Errors
/// As for [`simulate_until`].
pub fn simulate_from(
    mechanism: &Mechanism,
    values: &Values,
    plan: &Plan,
    start: Option<&MotionState>,
    stop: &AtomicBool,
) -> Result<Simulation, RunFailure> {
    record_until(mechanism, values, plan, (start, Extremes::Sought), stop)
}

/// As [`simulate`], for callers that need the poses and the paths of journals alone: extremes of outputs are not sought between the
/// samples, which takes most of the time of a recorded run, and none are in the record.
///
/// # Errors
/// As for [`simulate`].
pub fn simulate_poses(mechanism: &Mechanism, values: &Values, plan: &Plan) -> Result<Simulation, RunFailure> {
    record_until(mechanism, values, plan, (None, Extremes::LeftOut), &AtomicBool::new(false))
}

/// Whether the extremes of outputs are sought within every step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Extremes {
    Sought,
    LeftOut,
}

fn record_until(
    mechanism: &Mechanism,
    values: &Values,
    plan: &Plan,
    (start, sought): (Option<&MotionState>, Extremes),
    stop: &AtomicBool,
) -> Result<Simulation, RunFailure> {
    let mut sample = Sample::new(mechanism, values)?;
    plan.check(mechanism, &sample, values)?;
    if plan.lyapunov_turns.is_some() && mechanism.is_ideal() {
        return Err(RunFailure::NothingIsFree);
    }
    let begins_s = start.map_or(0.0, |start| start.at_s(mechanism, &sample));
    let window = plan.window(mechanism, values)?.later_by(begins_s);
    let (ideal, ideal_sample) = (mechanism.without_play(), sample.clone().without_play());
    let input = input(mechanism, values, plan.cycle.span)?;
    if mechanism.is_driven() {
        // A loop that cannot turn fully is better told now than where the dynamics run against it.
        let turns = (plan.cycle.transient_turns + plan.cycle.recorded_turns).min(1.0);
        IdealReference::new(&ideal, &ideal_sample, window.end_s, &plan.settings)?.at(turns * input.turn_s(), false)?;
    }
    let (turns, settings) = (plan.cycle.recorded_turns, &plan.settings);
    let life = worn_life(mechanism, &mut sample, &LifePlan { values, window, turns, settings }, stop)?;
    let reference = IdealReference::new(&ideal, &ideal_sample, window.end_s, &plan.settings)?;
    let columns = columns(&mechanism.model);
    let longest_s = longest_step_s(mechanism, &sample, &window);
    let reader = ColumnReader::new((mechanism, values), columns, reference, plan.with_states, longest_s);
    let mut recorder = Recorder::new(mechanism, values, reader, input.clone(), plan, &window);
    recorder.wear.life = life;
    if sought == Extremes::LeftOut {
        recorder.extremes = ExtremeRecorder::new(0);
    }
    let mut watched = StoppableObserver { observer: &mut recorder, stop };
    let mut code = CompiledCodeCache::default();
    let report = run_from(mechanism, &sample, (&window, &plan.settings), start.cloned(), &mut code, &mut watched)?;
    if let Some(failure) = recorder.reader.failure {
        return Err(failure.into());
    }
    let wear = recorder.wear.records(mechanism, &report)?;
    let positions = recorder.positions.take();
    let end_state = MotionState::record(mechanism, &sample, values, (recorder.end.as_ref(), window.end_s));
    let mut simulation = recorder.into_simulation(&sample, plan, report, wear);
    // All of it is kept: whoever asked may want to see what went wrong.
    if let Err(failure) = simulation.report.check_energy(&mechanism.model) {
        simulation.record.stop = StopReason::Failed { code: failure.code().to_owned(), words: failure.to_string() };
        simulation.failure = Some(failure);
    }
    if simulation.failure.is_some() {
        return Ok(simulation);
    }
    simulation.record.end_state = Some(end_state);
    if start.is_some() {
        // No command has such a start.
        simulation.record.settings.continued_at_s = Some(begins_s);
        simulation.record.repeat = Repeat::default();
    }
    if let Some(positions) = &positions {
        let (run, window) = ((mechanism, &sample), (&window, input.turn_s()));
        simulation.record.trust =
            measure_trust(run, window, &plan.settings, (start, positions, &simulation.report), stop)?;
    }
    if let Some(turns) = plan.lyapunov_turns {
        let (transient_turns, turn_s) = (plan.cycle.transient_turns, input.turn_s());
        let exponent = ExponentPlan { transient_turns, turns, turn_s, settings: plan.settings };
        simulation.record.lyapunov = Some(largest_exponent(mechanism, &sample, &exponent, start, stop)?);
    }
    Ok(simulation)
}

struct Recorder<'a> {
    mechanism: &'a Mechanism,
    values: &'a Values,
    reader: ColumnReader<'a>,
    sample_times_s: Vec<f64>,
    next_sample: usize,
    window: Window,
    input: CycleInput,
    /// Values and ideal values by column.
    value_si: Vec<Vec<f64>>,
    ideal_si: Vec<Vec<f64>>,
    extremes: ExtremeRecorder,
    energy: EnergyAccount,
    energy_at_zero_j: Option<f64>,
    contact_forces: Vec<Vec<f64>>,
    controls: ControlRecorder,
    impacts: Vec<ImpactRecord>,
    /// Index of the current impact, by contact.
    open_impacts: Vec<Option<usize>>,
    peak_forces_n: Vec<f64>,
    largest_speeds_m_s: Vec<f64>,
    orbits: Vec<(Vec<f64>, Vec<f64>)>,
    drawing: Drawing,
    states: Option<BodyStates>,
    flight: FlightClock,
    sections: SectionRecorder,
    wear: WearRecorder,
    bending: BendingRecorder,
    /// What a second run is compared with, where there is one.
    positions: Option<PositionHistory>,
    /// State at the end, where the motion was integrated.
    end: Option<MotionState>,
    has_dampers: bool,
}

impl<'a> Recorder<'a> {
    fn new(
        mechanism: &'a Mechanism,
        values: &'a Values,
        reader: ColumnReader<'a>,
        input: CycleInput,
        plan: &Plan,
        window: &Window,
    ) -> Self {
        let columns = reader.columns.len();
        let rows = (plan.cycle.recorded_turns * plan.cycle.samples_per_turn as f64).round().max(1.0) as usize;
        let span_s = window.end_s - window.start_s;
        let at =
            |row: usize| if row == rows { window.end_s } else { window.start_s + span_s * row as f64 / rows as f64 };
        let (plays, contacts) = (mechanism.plays.len(), mechanism.contacts.len());
        let positions = || PositionHistory::new(mechanism, values, *window, input.turn_s(), rows);
        let positions = plan.second_run.then(positions);
        let sections = SectionRecorder::new(Turns::within(*window, input.turn_s()), plays, columns);
        let names = mechanism.model.bodies[1..].iter().map(|body| body.name.clone()).collect();
        Self {
            mechanism,
            values,
            sample_times_s: (0..=rows).map(at).collect(),
            next_sample: 0,
            window: *window,
            input,
            value_si: vec![Vec::with_capacity(rows + 1); columns],
            ideal_si: vec![Vec::with_capacity(rows + 1); columns],
            extremes: ExtremeRecorder::new(reader.series()),
            energy: EnergyAccount::default(),
            energy_at_zero_j: None,
            contact_forces: vec![Vec::new(); contacts],
            controls: ControlRecorder::new(mechanism, plan.settings.tolerance_m),
            impacts: Vec::new(),
            open_impacts: vec![None; contacts],
            peak_forces_n: vec![0.0; contacts],
            largest_speeds_m_s: vec![0.0; contacts],
            orbits: vec![(Vec::new(), Vec::new()); plays],
            drawing: skeleton(mechanism, values),
            states: plan.with_states.then(|| BodyStates { bodies: names, rows: Vec::new() }),
            flight: FlightClock::new(mechanism, window.start_s),
            sections,
            wear: WearRecorder::new(mechanism, values),
            bending: BendingRecorder::new(mechanism),
            positions,
            end: None,
            has_dampers: mechanism.has_dampers(),
            reader,
        }
    }

    fn record_sections(&mut self, step: &mut Step<'_, '_>) {
        while let Some(time_s) = self.sections.next_s().filter(|&time_s| time_s <= step.end_s) {
            let looks = self.reader.look(step, time_s, Ideal::Solved);
            self.sections.look(step.set_state(time_s), &looks[self.reader.columns.len()..]);
        }
    }

    fn drive_angle_rad(&self, time_s: f64) -> f64 {
        self.input.angle_rad(time_s)
    }

    /// The largest forces of a step.
    fn note_peak_forces(&mut self, step: &mut Step<'_, '_>) {
        for contact in 0..self.open_impacts.len() {
            if !step.is_in_contact(contact) {
                continue;
            }
            let points = times_s(step).map(|time_s| (time_s, step.normal_force_n(contact, time_s)));
            let peak = maximum_within(&points, |time_s| step.normal_force_n(contact, time_s));
            let largest_n = &mut self.peak_forces_n[contact];
            *largest_n = largest_n.max(peak.value);
            if let Some(index) = self.open_impacts[contact] {
                let impact = &mut self.impacts[index];
                impact.peak_force_n = impact.peak_force_n.max(peak.value);
            }
        }
    }

    fn record_samples(&mut self, step: &mut Step<'_, '_>) {
        while let Some(&time_s) = self.sample_times_s.get(self.next_sample).filter(|&&time_s| time_s <= step.end_s) {
            self.next_sample += 1;
            self.record_sample(step, time_s);
        }
    }

    fn record_sample(&mut self, step: &mut Step<'_, '_>, time_s: f64) {
        let values = self.reader.look(step, time_s, Ideal::Solved);
        let count = self.reader.columns.len();
        for k in 0..count {
            self.value_si[k].push(values[k]);
            self.ideal_si[k].push(values[k] - values[count + k]);
        }
        let angle_rad = self.drive_angle_rad(time_s);
        let contacts = 0..self.contact_forces.len();
        let in_contact: Vec<bool> = contacts.map(|contact| step.is_in_contact(contact)).collect();
        for (contact, is_in_contact) in in_contact.iter().enumerate() {
            let force_n = step.normal_force_n(contact, time_s);
            self.contact_forces[contact].push(if *is_in_contact { force_n } else { 0.0 });
        }
        let dynamics = step.set_state(time_s);
        for (play, (motion, slots)) in dynamics.plays().iter().zip(dynamics.play_slots()).enumerate() {
            let bearing = &dynamics.kinematics.poses[slots[0]];
            let e = bearing.turn_back(motion.eccentricity_m);
            self.orbits[play].0.push(e.x);
            self.orbits[play].1.push(e.y);
        }
        add_pose(&mut self.drawing.poses, &self.mechanism.real, &dynamics.kinematics, angle_rad);
        add_bending(&mut self.drawing, self.mechanism, dynamics);
        let energy = dynamics.energy(|contact| in_contact[contact]);
        let total_j = energy.total_j();
        let at_zero_j = *self.energy_at_zero_j.get_or_insert(total_j);
        let account = step.account(time_s).unwrap_or(EnergyTotals {
            supplied_j: total_j - at_zero_j,
            contact_loss_j: 0.0,
            friction_loss_j: 0.0,
            damping_loss_j: 0.0,
        });
        self.energy.kinetic_j.push(energy.kinetic_j);
        self.energy.potential_j.push(energy.potential_j);
        self.energy.stored_j.push(energy.stored_j);
        self.energy.contact_loss_j.push(account.contact_loss_j);
        self.energy.friction_loss_j.push(account.friction_loss_j);
        self.energy.supplied_j.push(account.supplied_j);
        if self.has_dampers {
            self.energy.damping_loss_j.push(account.damping_loss_j);
        }
        if !self.controls.is_empty() {
            self.controls.record(step.evaluate(time_s));
        }
        if let Some(states) = &mut self.states {
            let dynamics = step.evaluate(time_s);
            states.rows.push(body_states(self.mechanism, self.values, dynamics));
        }
        if let Ok(ideal) = self.reader.reference.at(time_s, false) {
            let tree = &self.mechanism.ideal;
            add_pose(&mut self.drawing.ideal_poses, tree, &ideal.kinematics, angle_rad);
        }
    }

    fn into_simulation(
        mut self,
        sample: &Sample<f64>,
        plan: &Plan,
        report: RunReport,
        wear: Vec<JointWearRecord>,
    ) -> Simulation {
        let at_zero_j = report.energy.map_or(self.energy_at_zero_j.unwrap_or(0.0), |account| account.at_start_j);
        let energy = &mut self.energy;
        energy.relative_residual = report.energy.map_or(0.0, |account| account.relative_residual());
        energy.residual_j = (0..energy.kinetic_j.len())
            .map(|k| {
                energy.kinetic_j[k] + energy.potential_j[k] + energy.stored_j[k] - at_zero_j
                    + energy.contact_loss_j[k]
                    + energy.friction_loss_j[k]
                    + energy.damping_loss_j.get(k).unwrap_or(&0.0)
                    - energy.supplied_j[k]
            })
            .collect();
        let joints = self.joint_summaries(sample, plan, &report);
        let extremes = self.extremes.records(&self.reader.columns, |time_s| self.drive_angle_rad(time_s));
        let name_of = |play: usize| self.mechanism.model.play_name(self.mechanism.plays[play]).to_owned();
        let outputs = self
            .reader
            .columns
            .iter()
            .enumerate()
            .map(|(k, column)| OutputHistory {
                name: column.name.clone(),
                words: column.words.clone(),
                unit: column.unit.clone(),
                magnitude_of_force_in: column
                    .reading
                    .force_in()
                    .filter(|_| column.reading.is_never_negative())
                    .map(|joint| self.mechanism.model.joints[joint.0].name.clone()),
                deviation_si: self.value_si[k].iter().zip(&self.ideal_si[k]).map(|(a, b)| a - b).collect(),
                value_si: self.value_si[k].clone(),
                ideal_si: self.ideal_si[k].clone(),
            })
            .collect();
        let kind =
            self.sections.kind(self.mechanism, sample, &self.reader.columns, self.drive_angle_rad(self.window.start_s));
        let drive_angle_rad: Vec<f64> =
            self.sample_times_s.iter().map(|&time_s| self.drive_angle_rad(time_s)).collect();
        let record = SimulationRecord {
            model: self.mechanism.model.name.clone(),
            version: loosepin_text::VERSION.to_owned(),
            overrides: plan.overrides.clone(),
            settings: SimulationSettings {
                drive: self.input.name.clone(),
                drive_speed_rad_s: self.input.is_drive.then_some(self.input.speed_rad_s),
                continued_at_s: None,
                transient_turns: plan.cycle.transient_turns,
                recorded_turns: plan.cycle.recorded_turns,
                samples_per_turn: plan.cycle.samples_per_turn,
                tolerance_m: plan.settings.tolerance_m,
                method: plan.settings.method_name(),
            },
            stop: StopReason::Finished,
            repeat: repeat(&self.mechanism.model, plan),
            counters: report.counters,
            extremes,
            joints,
            kind,
            lyapunov: None,
            trust: Trust::NotMeasured,
            display_units: self.mechanism.model.shown_in(DisplayUnits::for_duration_s(self.window.end_s)),
            outputs,
            paths: paths(&self.mechanism.model),
            contact_forces: (0..self.contact_forces.len())
                .map(|contact| ContactForceHistory {
                    joint: self.mechanism.contact_name(contact),
                    force_n: self.contact_forces[contact].clone(),
                })
                .collect(),
            // What is no pin has no orbit in a hole.
            orbits: (0..self.orbits.len())
                .filter(|&play| sample.plays[play].shape.hole().is_some())
                .map(|play| JournalOrbit {
                    joint: name_of(play),
                    label: String::new(),
                    radial_clearance_m: sample.plays[play].clearance_m,
                    x_m: self.orbits[play].0.clone(),
                    y_m: self.orbits[play].1.clone(),
                    drive_angle_rad: drive_angle_rad.clone(),
                    // A pin touches its hole at one place.
                    force_n: self
                        .contact_forces
                        .get(self.mechanism.contacts_of(play).start)
                        .cloned()
                        .unwrap_or_default(),
                })
                .collect(),
            drive_angle_rad,
            controls: self.controls.into_histories(&self.sample_times_s),
            time_s: self.sample_times_s,
            energy: self.energy,
            impacts: self.impacts,
            drawing: self.drawing,
            leans: self.mechanism.has_leaning_pins(),
            quasi_static_check: Vec::new(),
            measured: Vec::new(),
            wear,
            life: self.wear.life_record(self.mechanism),
            bending: self.bending.records(self.mechanism),
            end_state: None,
        };
        Simulation { record, states: self.states, report, failure: None }
    }

    fn joint_summaries(&self, sample: &Sample<f64>, plan: &Plan, report: &RunReport) -> Vec<JointSummary> {
        let model = &self.mechanism.model;
        let turns = plan.cycle.recorded_turns;
        let plays = self.mechanism.plays.iter().zip(&sample.plays).zip(&report.plays).enumerate();
        plays
            .filter_map(|(index, ((&play, numbers), summary))| {
                let contact = &model.contacts[model.play_contact(play)?.0];
                let impacts = summary.contacts - summary.floored_contacts;
                let contacts = self.mechanism.contacts_of(index);
                let largest = |values: &[f64]| values[contacts.clone()].iter().copied().fold(0.0, f64::max);
                Some(JointSummary {
                    joint: model.play_name(play).to_owned(),
                    radial_clearance_m: numbers.clearance_m,
                    law: contact.law.name().to_owned(),
                    basis: contact_basis(self.mechanism, play, numbers, self.values),
                    long_pin: long_pin_force(self.mechanism, play, numbers, self.values, summary.largest_penetration_m),
                    contacts: summary.contacts,
                    impacts,
                    impacts_per_turn: Some(impacts as f64 / turns),
                    largest_penetration_m: summary.largest_penetration_m,
                    peak_force_n: largest(&self.peak_forces_n),
                    largest_speed_m_s: largest(&self.largest_speeds_m_s),
                    nominal_restitution: contact.law.restitution().map(|id| self.values[id]),
                    delivered_restitution: numbers.delivered_restitution,
                    share_outside_validity: (numbers.largest_valid_impact_speed_m_s.is_finite() && impacts > 0)
                        .then(|| summary.impacts_beyond_validity as f64 / impacts as f64),
                    floored_contacts: summary.floored_contacts,
                    flight_share: self.flight.share(index, self.window.end_s),
                    losses_per_turn: self.flight.losses(index) as f64 / turns,
                })
            })
            .collect()
    }
}

impl Observer for Recorder<'_> {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        self.reader.reference.hold_pieces(0.5 * (step.start_s + step.end_s));
        self.flight.step(step);
        self.record_samples(step);
        self.record_sections(step);
        self.extremes.step(step, &mut self.reader);
        self.note_peak_forces(step);
        self.wear.step(step);
        self.bending.step(step);
        if let Some(positions) = &mut self.positions {
            positions.step(step);
        }
        if step.end_s >= self.window.end_s {
            self.end = step.last_state();
        }
    }

    fn contact_begins(&mut self, onset: &Onset) {
        if onset.time_s < self.window.start_s {
            return;
        }
        let largest_m_s = &mut self.largest_speeds_m_s[onset.contact];
        *largest_m_s = largest_m_s.max(onset.speed_m_s);
        if onset.is_floored {
            return;
        }
        self.open_impacts[onset.contact] = Some(self.impacts.len());
        self.impacts.push(ImpactRecord {
            time_s: onset.time_s,
            drive_angle_rad: self.drive_angle_rad(onset.time_s),
            joint: self.mechanism.contact_name(onset.contact),
            speed_m_s: onset.speed_m_s,
            duration_s: self.window.end_s - onset.time_s,
            peak_force_n: 0.0,
            separation_speed_m_s: None,
        });
    }

    fn contact_ends(&mut self, separation: &Separation) {
        if let Some(index) = self.open_impacts[separation.contact].take() {
            let impact = &mut self.impacts[index];
            impact.duration_s = separation.time_s - impact.time_s;
            impact.separation_speed_m_s = Some(separation.speed_m_s);
        }
    }
}

/// Positions of all centres of mass, then velocities, then accelerations; of a flexible body those of the middle of its straight frame.
fn body_states(mechanism: &Mechanism, values: &Values, dynamics: &Dynamics<'_, f64>) -> Vec<f64> {
    let (mut positions, mut velocities, mut accelerations) = (Vec::new(), Vec::new(), Vec::new());
    for (index, body) in mechanism.model.bodies.iter().enumerate().skip(1) {
        let slot = mechanism.real.slot_of_body[index];
        let centre = body.centre_of_mass_m.map_or(Vec2::zero(), |c| Vec2::new(values[c[0]], values[c[1]]));
        let pose = &dynamics.kinematics.poses[slot];
        let twist = &dynamics.kinematics.twists[slot];
        let change = dynamics.acceleration(slot);
        let arm = pose.turn(centre);
        let (position, velocity) = (pose.position_m + arm, twist.at(arm));
        let acceleration = acceleration_at(&change, twist, arm);
        positions.extend([position.x, position.y, pose.angle_rad()]);
        velocities.extend([velocity.x, velocity.y, twist.angular]);
        accelerations.extend([acceleration.x, acceleration.y, change.angular]);
    }
    positions.into_iter().chain(velocities).chain(accelerations).collect()
}

/// The outputs that are paths of points.
fn paths(model: &Model) -> Vec<RunPath> {
    let path = |output: &Output| {
        let point = output.kind.path()?;
        Some(RunPath { name: output.name.clone(), point: relative_words(model, point) })
    };
    model.outputs.iter().filter_map(path).collect()
}

/// The command by which the run that `plan` asks of `model` is made again: what differs from the file is in it.
fn repeat(model: &Model, plan: &Plan) -> Repeat {
    let mut arguments: Vec<String> = Vec::new();
    let mut add = |name: &str, value: String| arguments.extend([name.to_owned(), value]);
    for change in &plan.overrides {
        add("--set", format!("{}={}", change.path, change.written));
    }
    let (cycle, own) = (&model.cycle, &plan.cycle);
    if own.recorded_turns != cycle.recorded_turns {
        add("--turns", own.recorded_turns.to_string());
    }
    if own.transient_turns != cycle.transient_turns {
        add("--transient", own.transient_turns.to_string());
    }
    if own.samples_per_turn != cycle.samples_per_turn {
        add("--samples", own.samples_per_turn.to_string());
    }
    if plan.settings.tolerance_m != Settings::for_simulation().tolerance_m {
        add("--tolerance", format!("{:e} m", plan.settings.tolerance_m));
    }
    if plan.settings.integrator == Integrator::Implicit {
        add("--integrator", "implicit".to_owned());
    }
    if let Some(turns) = plan.lyapunov_turns {
        add("--lyapunov", turns.to_string());
    }
    if !plan.second_run {
        arguments.push("--no-second-run".to_owned());
    }
    if plan.with_states {
        arguments.push("--states".to_owned());
    }
    for point in &model.asked_paths {
        arguments.extend(["--path".to_owned(), model.point(*point)]);
    }
    Repeat::new("simulate", &arguments, input_files(model))
}
