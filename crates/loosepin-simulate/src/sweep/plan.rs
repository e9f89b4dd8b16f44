//! Running a sweep on the lanes of all threads.

use super::turns::TurnsRecorder;
use crate::{
    Arms, Column, Execution, FlightClock, Follow, FollowedRun, IdealReference, Queue, Run, RunFailure, RunReport,
    Settings, SmallestClearance, Turns, Window, columns, input, period_turns, run_batch, section_sizes,
};
use loosepin_mechanics::mechanism::{Mechanism, Sample};
use loosepin_mechanics::model::{PlayId, QuantityError, QuantityId, SetValues, SettingRange, Values};
use loosepin_result::repeat::Repeat;
use loosepin_result::simulation::Override;
use loosepin_result::sweep::{SweepPoint, SweepRecord, SweptJoint, SweptOutput};
use loosepin_text::diagnostics::{Code, Diagnostic, problems};
use loosepin_text::units::{DisplayUnits, SiUnit};
use rayon::prelude::*;
use std::ops::RangeInclusive;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// Equally spaced values of a sweep, at most and at least.
pub const SWEEP_POINTS: RangeInclusive<i64> = 2..=100_000;
/// Turns before those that are looked at.
pub const SWEEP_TRANSIENT_TURNS: RangeInclusive<i64> = 0..=1_000_000;
/// Turns that are looked at.
pub const SWEEP_TURNS: RangeInclusive<i64> = 2..=100_000;

/// Plan of a sweep.
#[derive(Debug, Clone)]
pub struct SweepPlan {
    /// The quantity and the ends of its values.
    pub range: SettingRange,
    /// Values, equally spaced, ends included; at least two where none are listed.
    pub points: usize,
    /// The values instead of equally spaced ones, SI: [`Self::points`] of them, the least and the greatest of which are the ends.
    pub listed_si: Option<Vec<f64>>,
    /// Turns before those that are looked at.
    pub transient_turns: u32,
    /// Turns that are looked at.
    pub recorded_turns: u32,
    /// Accuracy.
    pub settings: Settings,
    /// Values set on the command line, for the record.
    pub overrides: Vec<Override>,
}

impl SweepPlan {
    /// Value number `index` of [`Self::points`], SI.
    pub fn value_si(&self, index: usize) -> f64 {
        if let Some(listed_si) = &self.listed_si {
            return listed_si[index];
        }
        let share = index as f64 / (self.points - 1) as f64;
        self.range.from_si + share * (self.range.to_si - self.range.from_si)
    }

    /// The values of the model in run `index`, the others as in `set`.
    fn values(&self, set: &SetValues, index: usize) -> Result<Values, QuantityError> {
        self.values_at(set, self.value_si(index))
    }

    fn values_at(&self, set: &SetValues, value_si: f64) -> Result<Values, QuantityError> {
        let settings = set.settings.iter().map(|setting| (setting.id, setting.value_si));
        let settings: Vec<(QuantityId, f64)> = settings.chain([(self.range.id, value_si)]).collect();
        set.model.quantities.evaluate(&settings)
    }

    /// The mechanism of all runs, compiled at the middle of the range: a clearance that begins at zero then has play, as for most values.
    ///
    /// # Errors
    /// Values that the model does not allow there; a mechanism that cannot be assembled.
    pub fn compile(&self, set: &SetValues) -> Result<Mechanism, Diagnostic> {
        let middle_si = 0.5 * (self.range.from_si + self.range.to_si);
        let values = self.values_at(set, middle_si).map_err(|error| Diagnostic::error(&error, None))?;
        Mechanism::new(&set.model, &values).map_err(|error| error.diagnostic(&set.model))
    }

    /// Checks the values of all runs against the rules of the model.
    ///
    /// # Errors
    /// The number of the first run that breaks one, and the rule.
    pub fn check_values(&self, set: &SetValues) -> Result<(), (usize, QuantityError)> {
        (0..self.points).try_for_each(|index| self.values(set, index).map(drop).map_err(|error| (index, error)))
    }

    /// Numbers of the runs whose joints with play are those of `mechanism`, and of the others by theirs: where a clearance is zero, a joint
    /// has none. Values that the model does not allow are with the first, and their runs fail.
    fn by_plays(&self, mechanism: &Mechanism, set: &SetValues) -> (Vec<usize>, Vec<OtherPlays>) {
        let (mut own, mut others): (Vec<usize>, Vec<OtherPlays>) = (Vec::new(), Vec::new());
        for index in 0..self.points {
            let Ok(values) = self.values(set, index) else {
                own.push(index);
                continue;
            };
            let plays: Vec<PlayId> = set.model.plays().filter(|&play| set.model.has_play(play, &values)).collect();
            if plays == mechanism.plays {
                own.push(index);
            } else if let Some(other) = others.iter_mut().find(|other| other.plays == plays) {
                other.indices.push(index);
            } else {
                others.push(OtherPlays { plays, values, indices: vec![index] });
            }
        }
        (own, others)
    }

    /// The smallest clearance of all runs; `None` if no joint has play in any.
    pub fn smallest_clearance(&self, set: &SetValues) -> Option<SmallestClearance> {
        let of_runs =
            (0..self.points).filter_map(|index| SmallestClearance::of(&set.model, &self.values(set, index).ok()?));
        of_runs.min_by(|a, b| a.clearance_m.total_cmp(&b.clearance_m))
    }
}

/// Runs that have other joints with play than the mechanism of most runs.
struct OtherPlays {
    plays: Vec<PlayId>,
    /// Values of the first of them.
    values: Values,
    indices: Vec<usize>,
}

problems! {
    /// Why a sweep has no result.
    #[derive(Debug)]
    pub enum SweepError {
        /// The threads could not be started.
        Threads { source: rayon::ThreadPoolBuildError } => Code::NoThreads,
            says("the system refused to start the threads"),
            hint("use fewer with --threads, or raise the limit of memory (ulimit -v) or of processes (ulimit -u)");
        /// No run came to its end.
        AllFailed {
            runs: usize,
            /// Why the first one did.
            reason: String,
        } => Code::AllRunsFailed,
            says("{}: {reason}", if *runs == 1 { "the run failed".to_owned() } else { format!("all {runs} runs failed; the first one") }),
            hint("`loosepin simulate` with --set makes a single run");
        /// The sweep was interrupted.
        Interrupted { finished: usize, runs: usize } => Code::Interrupted,
            says("interrupted after {finished} of {runs} runs");
    }
}

/// Runs `mechanism` for every value of `plan`, the other values as in `set`. The result is the same for any number of threads. Values for
/// which other joints have play are runs of mechanisms of their own.
///
/// `heard` is told how many runs are finished.
///
/// # Errors
/// See [`SweepError`]; failed runs are no error as long as some succeed.
pub fn sweep(
    mechanism: &Mechanism,
    set: &SetValues,
    plan: &SweepPlan,
    threads: usize,
    heard: &(dyn Fn(usize) + Sync),
    stop: &AtomicBool,
) -> Result<SweepRecord, SweepError> {
    let outputs: Vec<Column> =
        columns(&mechanism.model).into_iter().filter(|column| column.reading.is_position()).collect();
    let (own, others) = plan.by_plays(mechanism, set);
    let model = &mechanism.model;
    let is_playing =
        |play: &PlayId| mechanism.plays.contains(play) || others.iter().any(|other| other.plays.contains(play));
    let joints: Vec<PlayId> = model.plays().filter(is_playing).collect();
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    let pool = pool.map_err(|source| SweepError::Threads { source })?;
    let finished = AtomicUsize::new(0);
    let mut points: Vec<(usize, SweepPoint)> = Vec::with_capacity(plan.points);
    let mut run = |mechanism: &Mechanism, indices: &[usize]| {
        let ideal = mechanism.without_play();
        let runs = SweepRuns { mechanism, ideal, set, plan, indices, joints: &joints, outputs: &outputs, stop };
        let taken = AtomicUsize::new(0);
        let parts: Vec<Vec<(usize, SweepPoint)>> = pool.install(|| {
            (0..threads).into_par_iter().with_max_len(1).map(|_| runs.on_a_thread(&taken, &finished, heard)).collect()
        });
        points.extend(parts.into_iter().flatten());
    };
    run(mechanism, &own);
    let mut not_compiled: Vec<(usize, String)> = Vec::new();
    for OtherPlays { values, indices, .. } in &others {
        match Mechanism::new(model, values) {
            Ok(mechanism) => run(&mechanism, indices),
            Err(error) => not_compiled.extend(indices.iter().map(|&index| (index, error.to_string()))),
        }
    }
    points.extend(not_compiled.into_iter().map(|(index, reason)| (index, failed(plan.value_si(index), reason))));
    if points.len() < plan.points {
        return Err(SweepError::Interrupted { finished: points.len(), runs: plan.points });
    }
    points.sort_by_key(|(index, _)| *index);
    let points: Vec<SweepPoint> = points.into_iter().map(|(_, point)| point).collect();
    if let Some(reason) = points.iter().map(|point| point.failure.clone()).collect::<Option<Vec<String>>>() {
        return Err(SweepError::AllFailed {
            runs: points.len(),
            reason: reason.into_iter().next().unwrap_or_default(),
        });
    }
    let quantity = &model.quantities[plan.range.id];
    let cycle = model.cycle_input(&set.values);
    Ok(SweepRecord {
        model: model.name.clone(),
        version: loosepin_text::VERSION.to_owned(),
        overrides: plan.overrides.clone(),
        repeat: Repeat::default(),
        path: quantity.path.clone(),
        unit: SiUnit::of_dimension(quantity.dimension),
        drive: cycle.name,
        section_angle_rad: cycle.start_rad,
        transient_turns: plan.transient_turns,
        recorded_turns: plan.recorded_turns,
        tolerance_m: plan.settings.tolerance_m,
        outputs: outputs
            .into_iter()
            .map(|column| SweptOutput { name: column.name, words: column.words, unit: column.unit })
            .collect(),
        joints: joints.iter().map(|&play| model.play_name(play).to_owned()).collect(),
        points,
        display_units: model.shown_in(DisplayUnits::default()),
    })
}

/// Mechanism and plan that runs share.
struct SweepRuns<'a> {
    mechanism: &'a Mechanism,
    ideal: Mechanism,
    set: &'a SetValues,
    plan: &'a SweepPlan,
    /// Numbers of these runs among all.
    indices: &'a [usize],
    /// Joints that have play in any run.
    joints: &'a [PlayId],
    outputs: &'a [Column],
    stop: &'a AtomicBool,
}

impl SweepRuns<'_> {
    fn on_a_thread(
        &self,
        taken: &AtomicUsize,
        finished: &AtomicUsize,
        heard: &(dyn Fn(usize) + Sync),
    ) -> Vec<(usize, SweepPoint)> {
        let mut queue = SweepQueue { runs: self, taken, finished, heard, points: Vec::new() };
        run_batch(self.mechanism, &Follow::default(), &self.plan.settings, Execution::best(), &mut queue);
        queue.points
    }

    fn prepare(&self, index: usize) -> Result<Run<TurnsRecorder<'_>>, RunFailure> {
        let model = &self.mechanism.model;
        let values = self.plan.values(self.set, index).map_err(|error| RunFailure::Sample(error.into()))?;
        let sample = Sample::new(self.mechanism, &values)?;
        let turn_s = input(self.mechanism, &values, model.cycle.span)?.turn_s();
        let start_s = f64::from(self.plan.transient_turns) * turn_s;
        let window = Window { start_s, end_s: start_s + f64::from(self.plan.recorded_turns) * turn_s };
        let turns = Turns { window, turn_s, count: self.plan.recorded_turns as usize };
        let ideal =
            IdealReference::new(&self.ideal, &sample.clone().without_play(), window.end_s, &self.plan.settings)?;
        let arms = Arms::new(self.mechanism, &values);
        let sizes = section_sizes(self.mechanism, &sample);
        let flight = FlightClock::new(self.mechanism, start_s);
        let observer = TurnsRecorder::new(index, turns, self.outputs, arms.clone(), ideal, sizes, flight, self.stop);
        Ok(Run { sample, arms, window, observer, followed: FollowedRun::default(), resume: None })
    }

    /// The point of the sweep for a finished run.
    fn point(&self, run: TurnsRecorder<'_>, report: &RunReport) -> Result<SweepPoint, RunFailure> {
        if let Some(failure) = run.failure {
            return Err(failure.into());
        }
        let window = run.turns().window;
        let turns = f64::from(self.plan.recorded_turns);
        let joints = self.joints.iter().map(|joint| {
            let own = self.mechanism.plays.iter().position(|play| play == joint);
            let Some((index, play)) = own.and_then(|index| Some((index, report.plays.get(index)?))) else {
                return SweptJoint::without_play();
            };
            SweptJoint {
                impacts_per_turn: (play.contacts - play.floored_contacts) as f64 / turns,
                flight_share: run.flight.share(index, window.end_s),
                losses_per_turn: run.flight.losses(index) as f64 / turns,
                peak_force_n: play.peak_force_n,
                largest_penetration_m: play.largest_penetration_m,
            }
        });
        let period = period_turns(&run.sections, &run.sizes);
        Ok(SweepPoint {
            value_si: self.plan.value_si(run.index),
            failure: None,
            period_turns: period.and_then(|turns| u32::try_from(turns).ok()),
            joints: joints.collect(),
            sections_si: run.sections_si,
        })
    }
}

/// The point of a run that failed.
fn failed(value_si: f64, reason: String) -> SweepPoint {
    SweepPoint { value_si, failure: Some(reason), period_turns: None, sections_si: Vec::new(), joints: Vec::new() }
}

/// Values that wait, and points that are finished.
struct SweepQueue<'q> {
    runs: &'q SweepRuns<'q>,
    taken: &'q AtomicUsize,
    finished: &'q AtomicUsize,
    heard: &'q (dyn Fn(usize) + Sync),
    points: Vec<(usize, SweepPoint)>,
}

impl SweepQueue<'_> {
    fn push(&mut self, index: usize, outcome: Result<SweepPoint, RunFailure>) {
        let point = outcome.unwrap_or_else(|failure| failed(self.runs.plan.value_si(index), failure.to_string()));
        self.points.push((index, point));
        (self.heard)(self.finished.fetch_add(1, Ordering::Relaxed) + 1);
    }
}

impl<'q> Queue for SweepQueue<'q> {
    type Observer = TurnsRecorder<'q>;

    fn next(&mut self) -> Option<Run<TurnsRecorder<'q>>> {
        loop {
            let index = *self.runs.indices.get(self.taken.fetch_add(1, Ordering::Relaxed))?;
            if self.runs.stop.load(Ordering::Relaxed) {
                return None;
            }
            match self.runs.prepare(index) {
                Ok(run) => return Some(run),
                Err(failure) => self.push(index, Err(failure)),
            }
        }
    }

    fn finished(&mut self, run: TurnsRecorder<'q>, outcome: Result<RunReport, RunFailure>) {
        // A run that was given up is no point: the sweep has fewer than it was to have.
        if matches!(outcome, Err(RunFailure::Stopped { .. })) {
            return;
        }
        let index = run.index;
        let model = &self.runs.mechanism.model;
        let point = outcome.and_then(|report| report.check_energy(model).and_then(|()| self.runs.point(run, &report)));
        self.push(index, point);
    }
}
