//! Many runs side by side: every lane has its own time, step and contact state, and takes the next run when one is over.
//!
//! A pass tries one step in every lane at once, and in every lane at once accepts it or shortens it. Where more may follow from it it is
//! decided lane by lane: try again, accept, begin or end a contact, finish.
//! Nothing that happens in one lane can be seen in another, so a run has the same bits alone, in any lane, beside any others.

mod compiled_lately;
mod depth;
mod follow;
mod queue;
mod seats;
mod switch;

pub use queue::{Queue, Run};
pub(crate) use seats::{HandledQueue, QueueOfHandles, RunHandle};

use crate::depth_limit::DepthLimit;
use crate::failure::RunFailure;
use crate::follow::{Follow, FollowLayout, LaneFollow};
use crate::lanes::batch::compiled_lately::Fingerprint;
use crate::lanes::core::{Core, PendingInstant, lanes_of, move_flag};
use crate::lanes::execution::{Execution, LANES_OF_A_VECTOR};
use crate::lanes::lane::{Decision, Event, LaneRun, Phase};
use crate::lanes::lane_step::LaneStep;
use crate::lanes::memory::{LaneLayout, NextStepRule};
use crate::lanes::pass::{shrinkage, smallest_step_s, step_in_time};
use crate::lanes::reads::ReadLayout;
use crate::observer::{DenseOutput, Source, Step};
use crate::recording::report::{FrictionPath, PlaySummary, RunReport, smallest_exchange_j};
use crate::settings::{Settings, Window};
use crate::start::resting;
use crate::start::static_equilibrium::static_equilibrium;
use crate::stepping::gap::{ContactStep, GapJet};
use crate::stepping::motion::Motion;
use crate::stepping::pace::{energy_at_pace_j, fastest_drive_rad_s, pace_of_start_rad_s};
use crate::stepping::projection::Projection;
use loosepin_mechanics::dynamics::PlayState;
use loosepin_mechanics::mechanism::{GapMeasure, Mechanism, Sample};
use loosepin_mechanics::model::Reading;
use loosepin_result::simulation::RunCounters;

/// Largest step as a share of a turn of the fastest drive. Quintic interpolation over it errs by (2πk/96)⁶/46080 of the k-th
/// harmonic of a motion: 2e-12 for the first, 2e-9 for the third.
pub(crate) const MAX_STEP_TURNS: f64 = 1.0 / 96.0;
/// A motion that starts from rest is taken to have at least this share of the energy of all masses at the pace of the start over the
/// size of the mechanism: tolerances of the energy account need a size.
const MIN_ENERGY_SHARE: f64 = 1e-3;
/// Smallest step as a share of a turn of the fastest drive, apart from the steps onto events.
const MIN_STEP_TURNS: f64 = 1e-14;
/// Evaluations after which a single run continues as machine code: about as many take as long as compiling it does (12,500 of
/// `slider_crank_5000`, 11,200 of `six_bar`), so that no run takes more than twice as long as without.
const EVALUATIONS_ALONE: u64 = 12_000;
/// The same where such a run was compiled lately: about as many take as long as writing the programs down does.
const EVALUATIONS_ALONE_IF_COMPILED: u64 = 3_000;
/// Passes after which runs are asked whether they are stopped: a millisecond or so.
const PASSES_PER_QUESTION: u64 = 64;

/// Cache of consecutive single runs of one mechanism: the machine code of the long ones.
#[derive(Default)]
pub(crate) struct CompiledCodeCache<'a> {
    core: Option<Core<'a>>,
    /// Evaluations of all of them.
    evaluations: u64,
    /// Whether there is no machine code for them.
    is_refused: bool,
}

#[cfg(test)]
impl CompiledCodeCache<'_> {
    pub fn has_machine_code(&self) -> bool {
        self.core.is_some()
    }
}

/// The passes over all lanes.
pub(crate) struct Batch<'a> {
    mechanism: &'a Mechanism,
    core: Core<'a>,
    runs: Vec<Option<LaneRun>>,
    /// Equations on one lane at a time, for evaluations inside a step.
    view: Motion<'a, f64>,
    view_projection: Option<Projection<f64>>,
    view_state: Vec<f64>,
    /// Number of the run whose sample `view` holds, and of the run started last.
    viewed: u64,
    started: u64,
    output_jets: Vec<[[f64; 3]; 2]>,
    settings: Settings,
    /// Layout of the numbers of the followed quantities.
    follow: FollowLayout,
    /// What is looked at inside the steps.
    inside: Vec<Reading>,
    /// What is followed in the run of each lane.
    follows: Vec<LaneFollow>,
    /// The events at the ends of the current steps, in the lanes that are looked at in this pass.
    events: Vec<Option<Event>>,
    /// Instants that wait to be read at.
    waiting: Vec<PendingInstant>,
    /// Lanes with a run; those whose recorded part has begun; those whose derivative is to be evaluated again before the next step; those
    /// whose energy account begins then.
    active: u32,
    recorded: u32,
    restarts: u32,
    openings: u32,
    /// Lanes whose current step ends their run.
    ending: u32,
    /// Whether all runs have begun.
    is_exhausted: bool,
    /// Number of lanes in use, from the first one.
    used: usize,
    passes: u64,
}

impl<'a> Batch<'a> {
    /// Runs everything in `queue`.
    pub fn run(
        mechanism: &'a Mechanism,
        follow: &Follow,
        settings: &Settings,
        execution: Execution,
        queue: &mut dyn QueueOfHandles,
    ) {
        Self::run_until_long(mechanism, follow, settings, (execution, None), queue);
    }

    /// The one run in `queue`, which follows nothing, by itself; and where it is long, with those of `kept` before it, from then on by the
    /// execution `later`. `kept` is of this mechanism and these settings.
    pub fn run_alone(
        mechanism: &'a Mechanism,
        settings: &Settings,
        later: Option<Execution>,
        kept: &mut CompiledCodeCache<'a>,
        queue: &mut dyn QueueOfHandles,
    ) {
        let later = later.map(|execution| (execution, kept));
        Self::run_until_long(mechanism, &Follow::default(), settings, (Execution::Scalar, later), queue);
    }

    fn run_until_long(
        mechanism: &'a Mechanism,
        follow: &Follow,
        settings: &Settings,
        (execution, mut later): (Execution, Option<(Execution, &mut CompiledCodeCache<'a>)>),
        queue: &mut dyn QueueOfHandles,
    ) {
        let Some(first) = queue.next() else { return };
        let fingerprint = later.is_some().then(|| Fingerprint::new(mechanism, &first.sample));
        let is_known = fingerprint.is_some_and(Fingerprint::is_known);
        let evaluations_alone = if is_known { EVALUATIONS_ALONE_IF_COMPILED } else { EVALUATIONS_ALONE };
        let view = Motion::new(mechanism, &first.sample);
        let mut batch = Self {
            mechanism,
            core: Core::new(mechanism, &first.sample, &first.arms, follow, settings, (execution, execution.lanes())),
            follows: vec![LaneFollow::default(); execution.lanes()],
            runs: (0..execution.lanes()).map(|_| None).collect(),
            view_projection: Projection::<f64>::is_needed(mechanism).then(|| Projection::new(mechanism)),
            view_state: vec![0.0; view.layout.length()],
            view,
            viewed: 0,
            started: 0,
            output_jets: vec![[[0.0; 3]; 2]; follow.readings.len()],
            events: vec![None; execution.lanes()],
            waiting: Vec::with_capacity(execution.lanes()),
            settings: *settings,
            follow: FollowLayout::new(follow),
            inside: follow.inside.clone(),
            active: 0,
            recorded: 0,
            restarts: 0,
            openings: 0,
            ending: 0,
            is_exhausted: false,
            used: execution.lanes(),
            passes: 0,
        };
        let mut is_by_later = false;
        batch.start(0, first, queue);
        batch.refill(queue);
        while batch.active != 0 {
            batch.pass(queue);
            batch.refill(queue);
            if let Some((execution, kept)) = &mut later
                && !is_by_later
                && !kept.is_refused
                && kept.evaluations + batch.core.evaluations(0) > evaluations_alone
            {
                is_by_later = batch.go_on_later(*execution, kept);
                fingerprint.filter(|_| is_by_later).into_iter().for_each(Fingerprint::remember);
            }
            if batch.is_exhausted {
                batch.draw_together();
            }
        }
        if let Some((_, kept)) = later {
            kept.evaluations += batch.core.evaluations(0);
            if is_by_later {
                kept.core = Some(batch.core);
            }
        }
    }

    /// Continues a single run by a later execution, with the same bits, if that is machine code; returns whether it does.
    fn go_on_later(&mut self, execution: Execution, kept: &mut CompiledCodeCache<'a>) -> bool {
        let Some(run) = &self.runs[0] else { return false };
        let LaneRun { sample, arms, .. } = run;
        let lanes = execution.lanes_alone();
        let new = || Core::new(self.mechanism, sample, arms, &Follow::default(), &self.settings, (execution, lanes));
        let mut core = kept.core.take().unwrap_or_else(new);
        if !core.is_machine_code() {
            kept.is_refused = true;
            return false;
        }
        core.use_lanes(lanes);
        core.take_over(&self.core, sample, arms);
        self.core = core;
        self.used = lanes;
        self.runs.resize_with(self.used, || None);
        self.events.resize(self.used, None);
        self.follows.resize_with(self.used, LaneFollow::default);
        true
    }

    /// Puts the last runs into the first lanes where that leaves vectors without any: these are computed no more.
    fn draw_together(&mut self) {
        let used = (self.active.count_ones() as usize).next_multiple_of(LANES_OF_A_VECTOR);
        if used == 0 || used >= self.used {
            return;
        }
        // They are said by their lanes.
        self.look_at_waiting();
        let free = !self.active & lanes_before(used);
        let behind = self.active & !lanes_before(used);
        // There are as many free lanes as runs behind them, or more.
        for (lane, to) in lanes_of(behind).zip(lanes_of(free)) {
            self.core.move_lane(lane, to);
            self.runs.swap(lane, to);
            self.follows.swap(lane, to);
            for flags in [&mut self.active, &mut self.recorded, &mut self.restarts, &mut self.openings] {
                move_flag(flags, lane, to);
            }
        }
        self.used = used;
        self.core.use_lanes(used);
    }

    /// Puts waiting runs into the free lanes.
    fn refill(&mut self, queue: &mut dyn QueueOfHandles) {
        if self.is_exhausted || self.active.count_ones() as usize == self.runs.len() {
            return;
        }
        for lane in 0..self.runs.len() {
            while self.active >> lane & 1 == 0 && !self.is_exhausted {
                match queue.next() {
                    Some(run) => self.start(lane, run, queue),
                    None => self.is_exhausted = true,
                }
            }
        }
    }

    /// Starts `run` in `lane`, at its ideal position and velocities with journals centred or at their offsets, or at its resumed state.
    fn start(&mut self, lane: usize, run: Run<RunHandle>, queue: &mut dyn QueueOfHandles) {
        let Run { mut sample, arms, window, observer, followed, resume } = run;
        let n = self.mechanism.real.free;
        let state = &mut self.view_state;
        let mut start_s = 0.0;
        match &resume {
            Some(resume) => {
                start_s = resume.time_s(&self.view.layout);
                sample.take_pieces_at(start_s);
                state.copy_from_slice(&resume.state);
            }
            None => {
                let (coordinates, rates) = match resting::start(self.mechanism, &sample) {
                    Ok(start) => start,
                    Err(failure) => return queue.finished(observer, Err(failure)),
                };
                state.fill(0.0);
                state[..n].copy_from_slice(&coordinates[..n]);
                state[n..2 * n].copy_from_slice(&rates[..n]);
            }
        }
        let mut rate_1_s = fastest_drive_rad_s(self.mechanism, &sample, window.end_s);
        self.started += 1;
        self.viewed = self.started;
        self.view.dynamics.sample_mut().clone_from(&sample);
        if resume.is_none()
            && let Err(failure) = static_equilibrium(&mut self.view, state)
        {
            return queue.finished(observer, Err(failure));
        }
        self.view.set_state(start_s, state);
        if !self.mechanism.is_driven() {
            self.view.states.fill(PlayState::flight());
            self.view.evaluate(start_s, state);
            rate_1_s = rate_1_s.max(pace_of_start_rad_s(&self.view));
        }
        let at_start = self.view.dynamics.energy(|_| false);
        let mut energy_j = at_start.kinetic_j;
        if !(energy_j > 0.0) || !self.mechanism.is_driven() {
            energy_j = energy_j.max(MIN_ENERGY_SHARE * energy_at_pace_j(self.mechanism, &sample, rate_1_s));
        }
        self.core.load(lane, &sample, &arms, state, rate_1_s, energy_j);
        if let Some(resume) = &resume {
            self.core.resume(lane, resume);
        }
        let turn_s = std::f64::consts::TAU / rate_1_s;
        let longest_s = MAX_STEP_TURNS * turn_s;
        let stop_s = next_stop_s(&sample, start_s, &window);
        let awaited_s = queue.observer(observer).map_or(f64::INFINITY, |observer| observer.awaits_s());
        self.follows[lane] = LaneFollow::new(&self.follow, followed, window);
        self.runs[lane] = Some(LaneRun {
            number: self.started,
            depth_limits: (0..sample.contacts.len()).map(|contact| DepthLimit::new(sample.play_of(contact))).collect(),
            sample,
            window,
            observer,
            awaited_s,
            is_recorded: false,
            longest_s,
            smallest_s: MIN_STEP_TURNS * turn_s,
            phase: Phase::Stepping,
            last_event: None,
            after_event: [0.0; 2],
            arms,
            stop_s,
            reaches_stop: false,
            stalled: 0,
            events: 0,
            smallest_exchange_j: smallest_exchange_j(&at_start),
            contacts: vec![PlaySummary::default(); self.mechanism.contacts.len()],
            paths_before: Vec::new(),
            root: None,
        });
        for (place, number) in [
            (LaneLayout::STOP, stop_s),
            (LaneLayout::LONGEST, longest_s),
            (LaneLayout::SMALLEST, MIN_STEP_TURNS * turn_s),
            (LaneLayout::NEXT, 1e-3 * longest_s),
            (LaneLayout::WAS_REJECTED, 0.0),
            (LaneLayout::IS_RECORDED, 0.0),
            (LaneLayout::EVALUATIONS, 0.0),
            (LaneLayout::STEPS, 0.0),
            (LaneLayout::REJECTIONS, 0.0),
            (LaneLayout::FACTORIZATIONS, 0.0),
            (LaneLayout::IS_FIRST, 0.0),
            (LaneLayout::FIRST_STEP, 0.0),
            (LaneLayout::MINIMA, 0.0),
        ] {
            self.core.set_number(lane, place, number);
        }
        self.core.set_turn(lane, NextStepRule::Choose);
        self.active |= 1 << lane;
        self.restarts |= 1 << lane;
        self.openings |= 1 << lane;
        if start_s >= window.start_s {
            self.begin_record(lane, start_s);
        }
        self.watch(lane);
    }

    /// Evaluates the start of the flagged lanes again.
    fn restart(&mut self, lanes: u32) {
        if lanes == 0 {
            return;
        }
        self.core.restart(lanes);
        for lane in lanes_of(std::mem::take(&mut self.openings)) {
            if let Some(run) = &self.runs[lane] {
                self.core.open_account(lane, run.smallest_exchange_j);
            }
        }
    }

    /// Says which attempts of a lane are to be looked at.
    fn watch(&mut self, lane: usize) {
        let Some(run) = &self.runs[lane] else { return };
        let is_watched = !matches!(run.phase, Phase::Stepping) || run.stalled > 0;
        let awaited_s = if run.is_recorded { run.awaited_s } else { f64::INFINITY };
        self.core.set_number(lane, LaneLayout::IS_WATCHED, f64::from(u8::from(is_watched)));
        self.core.set_number(lane, LaneLayout::AWAITED, awaited_s);
    }

    /// Tries a step in every lane and acts on it.
    fn pass(&mut self, queue: &mut dyn QueueOfHandles) {
        let restarts = std::mem::take(&mut self.restarts);
        self.restart(restarts);
        self.core.attempt();
        self.ending = 0;
        let watched = self.core.flags(LaneLayout::ATTENTION) & self.active;
        for lane in lanes_of(watched) {
            self.events[lane] = self.look(lane, queue);
        }
        let accepted = self.core.flags(LaneLayout::CHOSEN) & self.active;
        if accepted != 0 {
            self.follow(accepted, watched);
            let cut = self.hold_first(accepted & watched);
            self.core.accept();
            for lane in lanes_of(cut) {
                let is_first = self.runs[lane].as_ref().map_or(0.0, LaneRun::is_first);
                self.core.set_number(lane, LaneLayout::IS_FIRST, is_first);
            }
            if self.view_projection.is_some() {
                self.restart(accepted);
                self.core.close_accounts();
            }
            for lane in lanes_of(accepted & watched) {
                self.go_on(lane, self.events[lane], queue);
            }
        }
        for lane in lanes_of(watched & self.active) {
            self.watch(lane);
        }
        self.passes += 1;
        if self.passes.is_multiple_of(PASSES_PER_QUESTION) {
            self.ask_whether_stopped(queue);
        }
    }

    /// Steps that an event or a stop has cut are not used to predict the first step after an event: the lanes of `looked` whose prediction
    /// waits for another step.
    fn hold_first(&mut self, looked: u32) -> u32 {
        let mut cut = 0;
        for lane in lanes_of(looked) {
            let reaches_stop = self.runs[lane].as_ref().is_some_and(|run| run.reaches_stop);
            if (self.events[lane].is_some() || reaches_stop) && self.core.is_set(lane, LaneLayout::IS_FIRST) {
                self.core.set_number(lane, LaneLayout::IS_FIRST, 0.0);
                cut |= 1 << lane;
            }
        }
        cut
    }

    /// Looks at the attempt of a lane, and accepts it where it is good; gives the event at its end.
    fn look(&mut self, lane: usize, queue: &mut dyn QueueOfHandles) -> Option<Event> {
        let Some(run) = &mut self.runs[lane] else { return None };
        // A step onto an event is part of a good one; where it is not good itself, the search is given up.
        if !(self.core.number(lane, LaneLayout::ERROR) < 1.0 + f64::EPSILON) {
            run.phase = Phase::Stepping;
            self.reject(lane, queue);
            return None;
        }
        let decision = if matches!(run.phase, Phase::Stepping) {
            let passes_stop = self.core.end_read(lane, ReadLayout::TIME) > run.stop_s;
            let is_eventful = passes_stop || self.core.is_set(lane, LaneLayout::EVENTFUL);
            if is_eventful { self.decide(lane) } else { Decision::Accept(None) }
        } else {
            self.decide(lane)
        };
        let event = match decision {
            Decision::Retry(step) => {
                self.core.set_step(lane, step);
                return None;
            }
            Decision::SwitchAtStart(event) => {
                if let Some(failure) = self.too_many_evaluations(lane) {
                    self.finish(lane, Err(failure), queue);
                } else {
                    self.count_event(lane, event);
                    self.act(lane, event, queue);
                }
                return None;
            }
            Decision::Move(event, by) => {
                self.core.move_end(lane, by);
                Some(event)
            }
            Decision::Accept(event) => event,
        };
        match self.show(lane, event, queue) {
            Ok(()) => {
                self.core.set_number(lane, LaneLayout::CHOSEN, 1.0);
                event
            }
            Err(failure) => {
                self.finish(lane, Err(failure), queue);
                None
            }
        }
    }

    /// Gives up the runs that are stopped.
    fn ask_whether_stopped(&mut self, queue: &mut dyn QueueOfHandles) {
        for lane in lanes_of(self.active) {
            let Some(run) = &self.runs[lane] else { continue };
            if queue.observer(run.observer).is_some_and(|observer| observer.is_stopped()) {
                let time_s = self.core.start_read(lane, ReadLayout::TIME);
                self.finish(lane, Err(RunFailure::Stopped { time_s }), queue);
            }
        }
    }

    /// Whether a run is to be given up.
    fn too_many_evaluations(&self, lane: usize) -> Option<RunFailure> {
        let limit = self.settings.largest_evaluations;
        (self.core.evaluations(lane) > limit).then(|| {
            let time_s = self.core.start_read(lane, ReadLayout::TIME);
            RunFailure::TooManyEvaluations { time_s, limit }
        })
    }

    /// The decision on an attempt in `lane` that may hold an event.
    fn decide(&mut self, lane: usize) -> Decision {
        match &mut self.runs[lane] {
            Some(run) => run.decide(&LaneStep::new(&self.core, lane), self.settings.event_tolerance_m()),
            None => Decision::Accept(None),
        }
    }

    /// Shortens the step after too large an error.
    fn reject(&mut self, lane: usize, queue: &mut dyn QueueOfHandles) {
        let [error, growth] = [LaneLayout::ERROR, LaneLayout::GROWTH].map(|place| self.core.number(lane, place));
        let [time_s, pace, change] = self.times(lane)[0].jet;
        let next_s = step_in_time([pace, change], self.core.step(lane) * shrinkage(error, growth));
        let smallest_s = smallest_step_s(self.core.number(lane, LaneLayout::SMALLEST), time_s);
        let friction = self.check_joint_friction(lane);
        let failure = if next_s < smallest_s
            && let Err(jams) = friction
        {
            jams
        } else if next_s < smallest_s
            && let Some(lost) = self.element_without_value(lane)
        {
            RunFailure::without_value(time_s, Some(lost))
        } else if next_s < smallest_s && error.is_finite() {
            RunFailure::StepTooSmall { time_s, step_s: next_s, smallest_s }
        } else if next_s < smallest_s {
            RunFailure::NotFinite { time_s, element: self.beam_beyond_steps(lane, smallest_s) }
        } else if let Some(failure) = self.too_many_evaluations(lane) {
            failure
        } else {
            return self.core.set_turn(lane, NextStepRule::Shrink);
        };
        self.finish(lane, Err(failure), queue);
    }

    /// Notes what an accepted step shows before it is left behind.
    fn show(&mut self, lane: usize, event: Option<Event>, queue: &mut dyn QueueOfHandles) -> Result<(), RunFailure> {
        let step = self.core.step(lane);
        let end_s = self.core.end_read(lane, ReadLayout::TIME);
        let start_s = self.core.start_read(lane, ReadLayout::TIME);
        self.check_bearings(lane)?;
        self.check_joint_friction(lane)?;
        let Some(run) = &mut self.runs[lane] else { return Ok(()) };
        run.reaches_stop = event == Some(Event::Stop) || (event.is_none() && step == run.stop_s - start_s);
        self.ending |= u32::from(run.is_at_end()) << lane;
        let end_s = if run.reaches_stop { run.stop_s } else { end_s };
        // With a root a step may be too short for the time to show it.
        if !run.is_recorded || end_s <= start_s {
            return Ok(());
        }
        let is_awaited = end_s >= run.awaited_s;
        if self.core.is_set(lane, LaneLayout::NOTABLE) {
            self.note_penetrations(lane);
        }
        if !is_awaited {
            return Ok(());
        }
        for (output, jets) in self.output_jets.iter_mut().enumerate() {
            let [start, end] = self.core.jets(lane, self.core.pass.reads.output(output));
            *jets = [start.jet, end.jet];
        }
        let time = self.times(lane);
        let Some(run) = &mut self.runs[lane] else { return Ok(()) };
        let mut dense = LaneDense { core: &mut self.core, lane, is_prepared: false, evaluations: 0 };
        let source = Source::Integrated {
            dense: &mut dense,
            sample: &run.sample,
            view: &mut self.view,
            projection: self.view_projection.as_mut(),
            state: &mut self.view_state,
            viewed: &mut self.viewed,
            run: run.number,
        };
        let mut step = Step { source, start_s, end_s, length: step, time, outputs: &self.output_jets };
        if let Some(observer) = queue.observer(run.observer) {
            observer.step(&mut step);
            run.awaited_s = observer.awaits_s();
        }
        let evaluations = dense.evaluations;
        self.core.add_evaluations(lane, evaluations);
        Ok(())
    }

    /// Takes in the largest penetration and force of a step that may hold a record.
    fn note_penetrations(&mut self, lane: usize) {
        let time = self.times(lane);
        for contact in 0..self.mechanism.contacts.len() {
            let (state, is_root) = self.core.contact(lane, contact);
            if !(state.contact > 0.0) {
                continue;
            }
            let gap = self.gap(lane, contact);
            let Some(run) = &mut self.runs[lane] else { return };
            let (numbers, summary) = (run.sample.play_of(contact), &mut run.contacts[contact]);
            let step = ContactStep { gap, time, step: self.core.step(lane), is_root };
            let depth_m = step.largest_penetration_m(GapMeasure::of(numbers));
            summary.largest_penetration_m = summary.largest_penetration_m.max(depth_m);
            let shares = self
                .core
                .pass
                .reads
                .share(contact)
                .map_or([1.0; 2], |place| [self.core.start_read(lane, place), self.core.end_read(lane, place)]);
            summary.peak_force_n = summary.peak_force_n.max(step.largest_force_n(numbers, &state, shares));
            self.core.set_records(lane, contact, summary);
        }
    }

    /// Goes on from an accepted step that was looked at.
    fn go_on(&mut self, lane: usize, event: Option<Event>, queue: &mut dyn QueueOfHandles) {
        let Some(run) = &mut self.runs[lane] else { return };
        let was_searching = !matches!(run.phase, Phase::Stepping);
        run.phase = Phase::Stepping;
        if run.is_at_end() {
            return self.succeed(lane, queue);
        }
        if let Some(failure) = self.too_many_evaluations(lane) {
            return self.finish(lane, Err(failure), queue);
        }
        let Some(run) = &mut self.runs[lane] else { return };
        if run.reaches_stop {
            return self.stop(lane, queue);
        }
        match event {
            None => {
                // After a search that found nothing the step that was good stays the next one.
                if was_searching {
                    self.core.set_number(lane, LaneLayout::WAS_REJECTED, 0.0);
                }
                self.core.set_turn(lane, if was_searching { NextStepRule::Choose } else { NextStepRule::Grow });
                self.watch_stalling(lane);
            }
            Some(event) => {
                self.count_event(lane, event);
                self.act(lane, event, queue);
            }
        }
    }

    fn succeed(&mut self, lane: usize, queue: &mut dyn QueueOfHandles) {
        let findings = self.findings(lane);
        let Some(run) = &self.runs[lane] else { return };
        let mut plays = vec![PlaySummary::default(); self.mechanism.plays.len()];
        for (at, summary) in self.mechanism.contacts.iter().zip(&run.contacts) {
            plays[at.play].take_in(summary);
        }
        let report = RunReport {
            counters: self.counters(lane, run.events),
            plays,
            energy: Some(self.core.account(lane)),
            friction_losses: self.core.friction_losses(lane, &run.sample),
            friction_paths: recorded_paths(self.core.friction_paths(lane), &run.paths_before),
            findings,
        };
        self.finish(lane, Ok(report), queue);
    }

    fn finish(&mut self, lane: usize, outcome: Result<RunReport, RunFailure>, queue: &mut dyn QueueOfHandles) {
        self.look_at_waiting();
        if let Some(run) = self.runs[lane].take() {
            queue.finished(run.observer, outcome);
        }
        self.active &= !(1 << lane);
        self.recorded &= !(1 << lane);
        self.restarts &= !(1 << lane);
        self.openings &= !(1 << lane);
        self.core.leave(lane);
    }

    fn counters(&self, lane: usize, contact_changes: u64) -> RunCounters {
        let counted = [LaneLayout::STEPS, LaneLayout::REJECTIONS, LaneLayout::FACTORIZATIONS];
        let [steps, rejections, factorizations] = counted.map(|place| self.core.number(lane, place) as u64);
        let evaluations = self.core.evaluations(lane);
        RunCounters { steps, rejections, evaluations, factorizations, contact_changes }
    }

    fn times(&self, lane: usize) -> [GapJet; 2] {
        LaneStep::new(&self.core, lane).time()
    }

    fn gap(&self, lane: usize, contact: usize) -> [GapJet; 2] {
        let step = LaneStep::new(&self.core, lane);
        match &self.runs[lane] {
            Some(run) => step.gap(contact, &run.sample),
            None => [GapJet::default(); 2],
        }
    }
}

/// Friction paths over the recorded part: those at its end without those before.
fn recorded_paths(mut at_end: Vec<FrictionPath>, before: &[FrictionPath]) -> Vec<FrictionPath> {
    for (path, before) in at_end.iter_mut().zip(before) {
        path.path_j -= before.path_j;
    }
    at_end
}

/// The flags of the first `end` lanes, 31 or fewer.
fn lanes_before(end: usize) -> u32 {
    (1 << end) - 1
}

/// Next stop of a run that is at `time_s`: where the pieces of a drive's motion meet, and at both ends of its recorded part, so that no
/// step lies in it with a part alone.
fn next_stop_s(sample: &Sample<f64>, time_s: f64, window: &Window) -> f64 {
    let end_s = if time_s < window.start_s { window.start_s } else { window.end_s };
    sample.next_break_s(time_s).min(end_s)
}

/// Dense output of one lane.
struct LaneDense<'s, 'a> {
    core: &'s mut Core<'a>,
    lane: usize,
    /// Whether a look has been taken inside.
    is_prepared: bool,
    /// Evaluations that this lane's looks have cost.
    evaluations: u64,
}

impl DenseOutput for LaneDense<'_, '_> {
    fn interpolate(&mut self, share: f64, for_forces: bool, state: &mut [f64]) {
        // Its ends are known.
        if !self.is_prepared && share > 0.0 && share < 1.0 {
            self.is_prepared = true;
            self.evaluations += self.core.evaluations_for_dense();
            self.core.prepare_dense();
        }
        self.core.interpolate(self.lane, share, state);
        if for_forces {
            self.evaluations += self.core.correct(share, state);
        }
    }

    fn contact(&self, contact: usize) -> PlayState<f64> {
        self.core.contact(self.lane, contact).0
    }
}
