//! Batches of runs of a reference case with varied clearances, on the lanes of one thread.

use crate::compiled;
use loosepin::mechanism::{Mechanism, Sample};
use loosepin::model::{PlayId, QuantityId};
use loosepin::simulate::{
    Arms, Execution, Follow, FollowedRun, Observer, Queue, Reading, Run, RunCounters, RunFailure, RunReport, Settings,
    Step, Window, columns, run_batch,
};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

/// The clearances of a batch lie evenly between 1 - `VARIATION` and 1 + `VARIATION` times the nominal ones.
const VARIATION: f64 = 0.1;

/// A reference case, compiled.
#[derive(Debug)]
pub struct Case {
    /// Name of its folder in `cases/`.
    pub name: String,
    /// The mechanism at its nominal values.
    pub mechanism: Mechanism,
    /// Duration of a turn of the cycle's drive, s.
    pub turn_s: f64,
    /// The first output that is a position: it is read at equidistant times.
    pub reading: Reading,
    clearances: Vec<(QuantityId, f64)>,
}

/// Settings of a run.
#[derive(Debug, Clone, Copy)]
pub struct Plan {
    /// Number of runs.
    pub runs: usize,
    /// Turns of a run.
    pub turns: usize,
    /// Times a turn at which the position is read.
    pub readings_per_turn: usize,
    /// Accuracy and limits.
    pub settings: Settings,
}

/// A finished run.
#[derive(Debug, Clone, PartialEq)]
pub struct FinishedRun {
    /// Counters of the run.
    pub counters: RunCounters,
    /// The position at the times of the plan, m or rad.
    pub readings: Vec<f64>,
}

impl Case {
    /// Compiles `cases/NAME/model.toml`.
    ///
    /// # Panics
    /// If the case is not there or is no mechanism.
    pub fn read(name: &str) -> Self {
        let (mechanism, nominal, turn_s) = compiled(name);
        let model = &mechanism.model;
        let clearances = mechanism
            .plays
            .iter()
            .filter_map(|play| match play {
                PlayId::Joint(joint) => Some(&model.joints[joint.0].kind),
                PlayId::Coupling(_) => None,
            })
            .filter_map(|kind| Some(kind.pin_clearance()?.radial_clearance_m))
            .map(|quantity| (quantity, nominal[quantity]))
            .collect();
        let position = columns(&mechanism.model).into_iter().find(|column| column.reading.is_position());
        let reading = position.unwrap_or_else(|| panic!("{name} has no output that is a position")).reading;
        Self { name: name.to_owned(), mechanism, turn_s, reading, clearances }
    }

    /// Everything for run `index` of `runs`, whose clearances are spread evenly. One run alone has the nominal ones.
    fn run(&self, index: usize, plan: &Plan, instants_s: Arc<[f64]>) -> Run<Numbered> {
        let factor = 1.0 + VARIATION * ((2 * index + 1) as f64 / plan.runs as f64 - 1.0);
        let set: Vec<(QuantityId, f64)> =
            self.clearances.iter().map(|&(id, nominal_m)| (id, factor * nominal_m)).collect();
        let values = self.mechanism.model.quantities.evaluate(&set).expect("the clearances are possible");
        Run {
            sample: Sample::new(&self.mechanism, &values).expect("the sample fits the mechanism"),
            arms: Arms::new(&self.mechanism, &values),
            window: Window { start_s: 0.0, end_s: plan.turns as f64 * self.turn_s },
            observer: Numbered(index),
            followed: FollowedRun { instants_s, ..FollowedRun::default() },
            resume: None,
        }
    }

    /// Runs the whole plan on this thread and with `execution`; the runs in their order.
    pub fn run_all(&self, plan: &Plan, execution: Execution) -> Vec<FinishedRun> {
        let next = AtomicUsize::new(0);
        in_order(self.run_shared(plan, execution, &next))
    }

    /// Runs the whole plan on `threads` threads, each taking the next run as soon as a lane is free.
    ///
    /// # Panics
    /// If a thread did.
    pub fn run_on_threads(&self, plan: &Plan, execution: Execution, threads: usize) -> Vec<FinishedRun> {
        let next = AtomicUsize::new(0);
        let parts: Vec<(usize, FinishedRun)> = std::thread::scope(|scope| {
            let workers: Vec<_> =
                (0..threads).map(|_| scope.spawn(|| self.run_shared(plan, execution, &next))).collect();
            workers.into_iter().flat_map(|worker| worker.join().expect("no thread panics")).collect()
        });
        in_order(parts)
    }

    fn run_shared(&self, plan: &Plan, execution: Execution, next: &AtomicUsize) -> Vec<(usize, FinishedRun)> {
        let interval_s = self.turn_s / plan.readings_per_turn as f64;
        let instants_s = (0..=plan.turns * plan.readings_per_turn).map(|k| k as f64 * interval_s).collect();
        let mut waiting = Waiting { case: self, plan, instants_s, next, finished: Vec::new() };
        run_batch(&self.mechanism, &Follow::readings(&[self.reading]), &plan.settings, execution, &mut waiting);
        waiting.finished
    }
}

fn in_order(mut finished: Vec<(usize, FinishedRun)>) -> Vec<FinishedRun> {
    finished.sort_by_key(|(index, _)| *index);
    finished.into_iter().map(|(_, run)| run).collect()
}

/// A run by its number; no values within its steps are read.
struct Numbered(usize);

impl Observer for Numbered {
    fn step(&mut self, _step: &mut Step<'_, '_>) {}

    fn awaits_s(&self) -> f64 {
        f64::INFINITY
    }
}

/// Runs that wait for a lane.
struct Waiting<'c> {
    case: &'c Case,
    plan: &'c Plan,
    instants_s: Arc<[f64]>,
    next: &'c AtomicUsize,
    finished: Vec<(usize, FinishedRun)>,
}

impl Queue for Waiting<'_> {
    type Observer = Numbered;

    fn next(&mut self) -> Option<Run<Numbered>> {
        let index = self.next.fetch_add(1, Ordering::Relaxed);
        (index < self.plan.runs).then(|| self.case.run(index, self.plan, Arc::clone(&self.instants_s)))
    }

    fn finished(&mut self, Numbered(index): Numbered, outcome: Result<RunReport, RunFailure>) {
        let report = outcome.unwrap_or_else(|failure| panic!("{} run {index}: {failure}", self.case.name));
        let run = FinishedRun { counters: report.counters, readings: report.findings.at_instants };
        self.finished.push((index, run));
    }
}
