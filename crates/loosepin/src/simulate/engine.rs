//! One run from the start to the end of its window: steps, events, contact states, energy account.

use super::failure::RunFailure;
use super::gap::{Crossing, GapJet, first_crossing, largest_force_n, largest_gap_m2, penetration_m};
use super::motion::{ACCOUNT, Motion, Projection, tolerances};
use super::observer::{Observer, Onset, Separation, Source, Step};
use super::settings::{STEP_SHARE, Settings, Window};
use crate::dynamics::PlayState;
use crate::integrate::{StepControl, Stepper};
use crate::math::Real;
use crate::mechanism::{IdealMotion, Mechanism, Sample, acceleration_at};

/// Largest step as a share of a turn of the fastest drive. Quintic interpolation over it errs by (2πk/96)⁶/46080 of the k-th
/// harmonic of a motion: 2e-12 for the first, 2e-9 for the third.
const LARGEST_STEP_TURNS: f64 = 1.0 / 96.0;
/// Smallest step as a share of a turn of the fastest drive, apart from the steps onto events.
const SMALLEST_STEP_TURNS: f64 = 1e-14;

/// What a run counted.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Counters {
    /// Accepted steps.
    pub steps: u64,
    /// Rejected steps.
    pub rejections: u64,
    /// Evaluations of the equations of motion.
    pub evaluations: u64,
    /// Contacts that began or ended.
    pub events: u64,
}

/// What one joint with play went through during the recorded part of a run.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct PlaySummary {
    /// Contacts that began.
    pub contacts: u64,
    /// Those among them that began slower than the floor v_min of the law.
    pub floored_contacts: u64,
    /// Impacts faster than the law is meant for.
    pub impacts_beyond_validity: u64,
    /// Largest penetration, m.
    pub largest_penetration_m: f64,
    /// Largest normal force, N, looked for at a few points of each step: it may be a few thousandths too small.
    pub peak_force_n: f64,
}

/// Energy over a run, J.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct EnergyAccount {
    /// Mechanical energy (kinetic, potential, stored in contacts) at the start.
    pub at_start_j: f64,
    /// Mechanical energy at the end.
    pub at_end_j: f64,
    /// Work of the drives.
    pub supplied_j: f64,
    /// Turned into heat by normal contact.
    pub contact_loss_j: f64,
    /// Turned into heat by friction.
    pub friction_loss_j: f64,
    /// Largest |energy + losses - supplied - energy at the start| over all steps.
    pub largest_residual_j: f64,
    /// Largest of: work of the drives, change of mechanical energy, losses.
    pub largest_exchange_j: f64,
}

impl EnergyAccount {
    /// The run's own check: largest residual over largest exchange.
    pub fn relative_residual(&self) -> f64 {
        if self.largest_exchange_j > 0.0 { self.largest_residual_j / self.largest_exchange_j } else { 0.0 }
    }
}

/// What every finished run tells.
#[derive(Debug, Clone, PartialEq)]
pub struct RunReport {
    /// Counts.
    pub counters: Counters,
    /// One for each joint with play.
    pub plays: Vec<PlaySummary>,
    /// The energy account; a mechanism without play is not integrated and has none.
    pub energy: Option<EnergyAccount>,
}

/// Runs one sample to the end of `window`, showing every step to `observer`.
///
/// Starts from the ideal positions and velocities of the sample at time zero, journals centred. A mechanism without play
/// follows its drives exactly: its loops are solved instead of integrated.
///
/// # Errors
/// The one reason why the run failed.
pub fn run(
    mechanism: &Mechanism,
    sample: &Sample<f64>,
    window: &Window,
    settings: &Settings,
    observer: &mut dyn Observer,
) -> Result<RunReport, RunFailure> {
    let ideal = IdealMotion::new(mechanism, &sample.ideal, &sample.drives)?;
    if mechanism.is_ideal() {
        run_kinematics(mechanism, sample, ideal, window, observer)
    } else {
        Engine::new(mechanism, sample, ideal, settings).run(window, settings, observer)
    }
}

/// Rate of the fastest drive, rad/s; driven lengths count as angles over the size of the mechanism.
fn fastest_drive_rad_s(mechanism: &Mechanism, sample: &Sample<f64>) -> f64 {
    use crate::model::JointKind;
    let rates = mechanism.model.drives.iter().zip(&sample.drives).map(|(drive, motion)| {
        match mechanism.model.joints[drive.joint.0].kind {
            JointKind::Prismatic { .. } => motion.speed.abs() / mechanism.size_m,
            _ => motion.speed.abs(),
        }
    });
    rates.fold(0.0, f64::max)
}

fn run_kinematics<'a>(
    mechanism: &'a Mechanism,
    sample: &'a Sample<f64>,
    mut ideal: IdealMotion<'a>,
    window: &Window,
    observer: &mut dyn Observer,
) -> Result<RunReport, RunFailure> {
    let mut motion = Motion::new(mechanism, sample);
    let turn_s = std::f64::consts::TAU / fastest_drive_rad_s(mechanism, sample);
    let span_s = window.end_s - window.start_s;
    let steps = (span_s / (LARGEST_STEP_TURNS * turn_s)).ceil().clamp(1.0, 1e9) as u64;
    ideal.move_to(window.start_s)?;
    let mut failure = None;
    let at = |step: u64| window.start_s + span_s * step as f64 / steps as f64;
    for step in 0..steps {
        let (start_s, end_s) = (at(step), if step + 1 == steps { window.end_s } else { at(step + 1) });
        let source = Source::Kinematic { motion: &mut motion, ideal: &mut ideal, failure: &mut failure };
        observer.step(&mut Step { source, start_s, end_s });
        if let Some(error) = failure {
            return Err(error.into());
        }
        ideal.move_to(end_s)?;
    }
    Ok(RunReport { counters: Counters { steps, ..Counters::default() }, plays: Vec::new(), energy: None })
}

/// The state of a run.
struct Engine<'a> {
    mechanism: &'a Mechanism,
    sample: &'a Sample<f64>,
    motion: Motion<'a>,
    stepper: Stepper,
    control: StepControl,
    projection: Option<Projection>,
    tolerances: Vec<f64>,
    event_tolerance_m: f64,
    /// Gap jets at the start and at the end of the step at hand, for each joint with play.
    start_jets: Vec<GapJet>,
    end_jets: Vec<GapJet>,
    /// Length of the first good step after the last onset and after the last separation, s: the first guess for the next.
    after_event_s: [f64; 2],
    scratch: Vec<f64>,
    time_s: f64,
    counters: Counters,
    plays: Vec<PlaySummary>,
    account: EnergyAccount,
}

/// An event found within a step.
struct Event {
    play: usize,
    crossing: Crossing,
    share: f64,
}

impl<'a> Engine<'a> {
    fn new(mechanism: &'a Mechanism, sample: &'a Sample<f64>, ideal: IdealMotion<'a>, settings: &Settings) -> Self {
        let n = mechanism.real.free;
        let (coordinates, rates) = mechanism.real_coordinates(ideal.kinematics(), &sample.real);
        let mut state = coordinates[..n].to_vec();
        state.extend_from_slice(&rates[..n]);
        state.resize(2 * n + ACCOUNT, 0.0);
        let mut motion = Motion::new(mechanism, sample);
        motion.evaluate(0.0, &state);
        let at_start_j = motion.dynamics.energy(|_| false).total_j();
        let kinetic_j = motion.dynamics.energy(|_| false).kinetic_j;
        let rate = fastest_drive_rad_s(mechanism, sample);
        let plays = mechanism.plays.len();
        let mut engine = Self {
            mechanism,
            sample,
            motion,
            stepper: Stepper::new(settings.method, state.len()),
            control: StepControl::new(settings.method.order),
            projection: Projection::is_needed(mechanism).then(|| Projection::new(mechanism)),
            tolerances: tolerances(mechanism, settings.tolerance_m * STEP_SHARE, rate, kinetic_j),
            event_tolerance_m: settings.event_tolerance_m(),
            start_jets: vec![GapJet::default(); plays],
            end_jets: vec![GapJet::default(); plays],
            after_event_s: [0.0; 2],
            scratch: vec![0.0; state.len()],
            time_s: 0.0,
            counters: Counters::default(),
            plays: vec![PlaySummary::default(); plays],
            account: EnergyAccount { at_start_j, at_end_j: at_start_j, ..EnergyAccount::default() },
        };
        engine.stepper.restart(&mut engine.motion, 0.0, &state);
        engine.read_jets();
        std::mem::swap(&mut engine.start_jets, &mut engine.end_jets);
        engine
    }

    fn run(
        mut self,
        window: &Window,
        settings: &Settings,
        observer: &mut dyn Observer,
    ) -> Result<RunReport, RunFailure> {
        let turn_s = std::f64::consts::TAU / fastest_drive_rad_s(self.mechanism, self.sample);
        let longest_s = LARGEST_STEP_TURNS * turn_s;
        let mut next_s = 1e-3 * longest_s;
        let mut last_event: Option<usize> = None;
        while self.time_s < window.end_s {
            let smallest_s = (SMALLEST_STEP_TURNS * turn_s).max(8.0 * f64::EPSILON * self.time_s);
            let left_s = window.end_s - self.time_s;
            // A last crumb is joined to the step before it.
            let mut step_s = next_s.min(longest_s);
            if step_s > left_s * (1.0 - 1e-6) {
                step_s = left_s;
            } else if step_s > 0.5 * left_s {
                step_s = 0.5 * left_s;
            }
            let error = self.stepper.attempt(&mut self.motion, step_s, &self.tolerances);
            if !(error <= 1.0) {
                self.counters.rejections += 1;
                next_s = step_s * self.control.after_rejection(error);
                if next_s < smallest_s {
                    let time_s = self.time_s;
                    return Err(if error.is_finite() {
                        RunFailure::StepTooSmall { time_s, step_s: next_s, smallest_s }
                    } else {
                        RunFailure::NotFinite { time_s }
                    });
                }
                continue;
            }
            self.finish_step();
            let event = self.locate_event(step_s);
            let reached_end = event.is_none() && step_s == left_s;
            let taken_s = self.stepper.step_s();
            let end_s = if reached_end { window.end_s } else { self.time_s + taken_s };
            if end_s > window.start_s {
                self.note_penetrations(taken_s);
            }
            self.show(window, end_s, observer);
            self.advance(end_s);
            next_s = match event {
                None => {
                    if let Some(index) = last_event.take() {
                        self.after_event_s[index] = taken_s;
                    }
                    step_s * self.control.after_acceptance(error)
                }
                Some(event) => {
                    self.switch(&event, window, observer);
                    let index = usize::from(event.crossing == Crossing::Separation);
                    last_event = Some(index);
                    // The rest of the step that was cut is the best guess before the first event of this kind.
                    if self.after_event_s[index] > 0.0 { self.after_event_s[index] } else { 0.1 * step_s }
                }
            };
            if self.stepper.evaluations() > settings.largest_evaluations {
                return Err(RunFailure::TooManyEvaluations {
                    time_s: self.time_s,
                    limit: settings.largest_evaluations,
                });
            }
        }
        self.counters.evaluations = self.stepper.evaluations();
        Ok(RunReport { counters: self.counters, plays: self.plays, energy: Some(self.account) })
    }

    /// Evaluates the end of the step and reads the gaps there.
    fn finish_step(&mut self) {
        if !self.stepper.finishes_by_itself() {
            self.stepper.finish(&mut self.motion);
        }
        self.read_jets();
    }

    /// Gap jets at the state that was evaluated last, into `end_jets`.
    fn read_jets(&mut self) {
        let dynamics = &self.motion.dynamics;
        let entries = dynamics.plays().iter().zip(dynamics.play_slots()).zip(&self.sample.plays);
        for (((motion, _), [i, j]), (play, jet)) in entries.zip(&mut self.end_jets).map(|((a, b), c)| (a, (b, c))) {
            let acceleration_j =
                acceleration_at(&dynamics.acceleration(*j), &dynamics.kinematics.twists[*j], motion.journal_arm_m);
            let acceleration_i =
                acceleration_at(&dynamics.acceleration(*i), &dynamics.kinematics.twists[*i], motion.bearing_arm_m);
            *jet = GapJet::new(motion, acceleration_j - acceleration_i, play.clearance_m);
        }
    }

    /// The event of the step at hand that comes first.
    fn earliest_event(&self, step_s: f64) -> Option<Event> {
        let mut earliest: Option<Event> = None;
        for (play, state) in self.motion.states.iter().enumerate() {
            let (start, end) = (&self.start_jets[play], &self.end_jets[play]);
            let crossing = if state.contact > 0.0 { Crossing::Separation } else { Crossing::Onset };
            let tolerance_m2 = 2.0 * self.sample.plays[play].clearance_m * self.event_tolerance_m;
            let share = match first_crossing(start, end, step_s, crossing) {
                // Beyond the tolerance at the start and going on: nothing is gained by creeping towards it.
                Some(_) if crossing.sign() * start.jet[0] > tolerance_m2 && crossing.sign() * start.jet[1] > 0.0 => 0.0,
                Some(share) => share,
                // Already across at the start, by less than the tolerance of the event before.
                None if crossing.sign() * end.jet[0] > 0.0 => 0.0,
                None => continue,
            };
            if earliest.as_ref().is_none_or(|event| share < event.share) {
                earliest = Some(Event { play, crossing, share });
            }
        }
        earliest
    }

    /// Finds the first event of the step at hand, of length `step_s`, and redoes the step so that it ends there. Without an
    /// event the step stays as it is; where an event dissolves on closer look, the step ends just before it.
    fn locate_event(&mut self, step_s: f64) -> Option<Event> {
        /// Newton steps onto an event; from the quintic's root two or three do.
        const REDOS: usize = 12;
        let mut event = self.earliest_event(step_s)?;
        let (mut low_s, mut high_s) = (0.0, step_s);
        let mut try_s = event.share * step_s;
        for _ in 0..REDOS {
            if try_s <= 0.0 {
                // The event is at the start of the step: nothing moves.
                try_s = 0.0;
            }
            self.redo(try_s);
            if let Some(other) = self.earliest_event(try_s).filter(|other| other.play != event.play) {
                // Another joint was hidden behind this one.
                high_s = try_s;
                try_s *= other.share;
                event = other;
                low_s = low_s.min(try_s);
                continue;
            }
            let clearance_m = self.sample.plays[event.play].clearance_m;
            let [gap_m2, rate_m2_s, _] = self.end_jets[event.play].jet.map(|value| event.crossing.sign() * value);
            if gap_m2.abs() <= 2.0 * clearance_m * self.event_tolerance_m || try_s == 0.0 {
                self.counters.events += 1;
                return Some(event);
            }
            if gap_m2 > 0.0 || rate_m2_s <= 0.0 {
                high_s = try_s
            } else {
                low_s = try_s
            }
            let newton_s = try_s - gap_m2 / rate_m2_s;
            try_s = if newton_s > low_s && newton_s < high_s { newton_s } else { 0.5 * (low_s + high_s) };
        }
        // A touch that does not quite happen: go to the last place before it. A half step makes sure that time goes on.
        self.redo(if low_s > 0.0 { low_s } else { 0.5 * high_s });
        None
    }

    /// Takes the step at hand again with another length.
    fn redo(&mut self, step_s: f64) {
        self.stepper.attempt(&mut self.motion, step_s, &self.tolerances);
        self.finish_step();
    }

    fn note_penetrations(&mut self, step_s: f64) {
        for (play, state) in self.motion.states.iter().enumerate() {
            if state.contact > 0.0 {
                let numbers = &self.sample.plays[play];
                let (start, end) = (&self.start_jets[play], &self.end_jets[play]);
                let depth_m = penetration_m(largest_gap_m2(start, end, step_s), numbers.clearance_m);
                let summary = &mut self.plays[play];
                summary.largest_penetration_m = summary.largest_penetration_m.max(depth_m);
                let force_n = largest_force_n(start, end, step_s, numbers, state);
                summary.peak_force_n = summary.peak_force_n.max(force_n);
            }
        }
    }

    fn show(&mut self, window: &Window, end_s: f64, observer: &mut dyn Observer) {
        if end_s > window.start_s && self.stepper.step_s() > 0.0 {
            let source = Source::Integrated {
                motion: &mut self.motion,
                stepper: &mut self.stepper,
                projection: self.projection.as_mut(),
                state: &mut self.scratch,
                is_at_end: true,
            };
            observer.step(&mut Step { source, start_s: self.time_s, end_s });
        }
    }

    /// Makes the end of the step the start of the next, holds the loops and closes the energy account.
    fn advance(&mut self, end_s: f64) {
        self.stepper.accept();
        self.time_s = end_s;
        self.counters.steps += 1;
        let n = self.motion.freedoms();
        self.scratch.copy_from_slice(self.stepper.start());
        if let Some(projection) = &mut self.projection {
            projection.apply(&mut self.motion, end_s, &mut self.scratch);
            self.stepper.restart(&mut self.motion, end_s, &self.scratch);
            self.read_jets();
        } else {
            self.motion.set_state(end_s, &self.scratch);
        }
        std::mem::swap(&mut self.start_jets, &mut self.end_jets);

        let states = &self.motion.states;
        let energy_j = self.motion.dynamics.energy(|play| states[play].contact > 0.0).total_j();
        let account = &mut self.account;
        account.at_end_j = energy_j;
        account.supplied_j = self.scratch[2 * n];
        account.contact_loss_j = self.scratch[2 * n + 1];
        account.friction_loss_j = self.scratch[2 * n + 2];
        let losses_j = account.contact_loss_j + account.friction_loss_j;
        let change_j = energy_j - account.at_start_j;
        account.largest_residual_j = account.largest_residual_j.max((change_j + losses_j - account.supplied_j).abs());
        let exchange_j = change_j.abs().max(account.supplied_j.abs()).max(losses_j.abs());
        account.largest_exchange_j = account.largest_exchange_j.max(exchange_j);
    }

    /// Lets a contact begin or end at the present time.
    fn switch(&mut self, event: &Event, window: &Window, observer: &mut dyn Observer) {
        let play = &self.sample.plays[event.play];
        let (motion, _) = self.motion.dynamics.plays()[event.play];
        let speed_m_s = motion.penetration_rate_m_s();
        let time_s = self.time_s;
        match event.crossing {
            Crossing::Onset => {
                let is_floored = !(speed_m_s > play.minimum_impact_speed_m_s);
                let impact_speed_m_s = Real::max(speed_m_s, play.minimum_impact_speed_m_s);
                self.motion.states[event.play] =
                    PlayState { contact: 1.0, inverse_impact_speed_s_m: 1.0 / impact_speed_m_s };
                if time_s >= window.start_s {
                    let summary = &mut self.plays[event.play];
                    summary.contacts += 1;
                    summary.floored_contacts += u64::from(is_floored);
                    summary.impacts_beyond_validity += u64::from(speed_m_s > play.largest_valid_impact_speed_m_s);
                }
                observer.contact_begins(&Onset { play: event.play, time_s, speed_m_s, is_floored });
            }
            Crossing::Separation => {
                self.motion.states[event.play] = PlayState::flight();
                observer.contact_ends(&Separation { play: event.play, time_s, speed_m_s: -speed_m_s });
            }
        }
        self.scratch.copy_from_slice(self.stepper.start());
        self.stepper.restart(&mut self.motion, time_s, &self.scratch);
        self.read_jets();
        std::mem::swap(&mut self.start_jets, &mut self.end_jets);
    }
}
