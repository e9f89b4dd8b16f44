//! Work against error: runs of a reference case with one method at one tolerance, held against finer runs.

use crate::compiled;
use loosepin::math::Quintic;
use loosepin::mechanism::{Mechanism, Sample};
use loosepin::model::{Axis, BodyId, Model, PointId, Position, QuantityId, Relative};
use loosepin::simulate::{
    Arms, Counters, Execution, Follow, FollowedRun, Observer, Queue, Reading, Run, RunFailure, RunReport, Settings,
    Step, Window, conduct,
};

/// A folder of `cases/` and what is watched in it.
#[derive(Debug, Clone, Copy)]
pub struct Case {
    /// Name of the folder.
    pub name: &'static str,
    /// What makes it a case of its own.
    pub about: &'static str,
    /// The point whose position is watched, `body.point`.
    pub point: &'static str,
    /// Quantities that differ from sample to sample, and by which share of their nominal values at most.
    pub varied: &'static [(&'static str, f64)],
    /// Tolerance of the reference runs, m: tight, and yet so that steps are not lost in rounding.
    pub reference_m: f64,
}

/// Times within the half turn at which positions are compared.
pub const TIMES: usize = 32;

/// One run: the watched point's coordinates at [`TIMES`] times, m, x and y in turn; and what they cost.
type Outcome = Result<(Vec<f64>, Counters), RunFailure>;

/// A compiled case with its samples.
pub struct Samples {
    name: &'static str,
    mechanism: Mechanism,
    readings: [Reading; 2],
    samples: Vec<(Sample<f64>, Arms)>,
    window: Window,
    times_s: Vec<f64>,
}

/// Work and error of all samples at one tolerance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// The tolerance asked for, m.
    pub tolerance_m: f64,
    /// Right-hand sides of a run, the median; repeated and rejected steps included.
    pub evaluations: u64,
    /// Error of a run: the watched point's largest distance from the reference at any of the times. Median, m.
    pub median_m: f64,
    /// Its 90 % quantile, m; infinite where more than a tenth of the runs failed.
    pub quantile_m: f64,
    /// Its largest value among the finished runs, m.
    pub worst_m: f64,
    /// Runs that failed; their errors count as infinite.
    pub failed: usize,
}

impl Samples {
    /// Reads and compiles `case` with `count` samples: the varied quantities fill their box evenly (multiples of the square
    /// roots of the primes), so that a few samples already see different sequences of contacts.
    ///
    /// # Panics
    /// When the case, the point or a quantity does not exist: a mistake in this crate.
    pub fn new(case: &Case, count: usize) -> Self {
        let (mechanism, nominal, turn_s) = compiled(case.name);
        let model = &mechanism.model;
        let varied: Vec<(QuantityId, f64)> = case
            .varied
            .iter()
            .map(|(path, share)| (model.quantities.id(path).expect("the case has this quantity"), *share))
            .collect();
        let samples = (0..count)
            .map(|k| {
                let place = |root: f64| ((k + 1) as f64 * root.sqrt()).fract();
                let set: Vec<(QuantityId, f64)> = varied
                    .iter()
                    .zip([2.0, 3.0, 5.0, 7.0])
                    .map(|((id, share), root)| (*id, nominal[*id] * (1.0 + share * (2.0 * place(root) - 1.0))))
                    .collect();
                let values = model.quantities.evaluate(&set).expect("the values are possible");
                let sample = Sample::new(&mechanism, &values).expect("the sample fits the mechanism");
                (sample, Arms::new(&mechanism, &values))
            })
            .collect();
        let point = watched(model, case.point).expect("the case has this point");
        let half_turn_s = 0.5 * turn_s;
        Self {
            name: case.name,
            readings: [Axis::X, Axis::Y]
                .map(|axis| Reading::Position(Position::Point(Relative::to_ground(point), axis))),
            mechanism,
            samples,
            window: Window { start_s: 0.0, end_s: half_turn_s },
            times_s: (1..=TIMES).map(|k| half_turn_s * k as f64 / TIMES as f64).collect(),
        }
    }

    /// Runs all samples over the first half turn, on the widest lanes of this processor, which does not show in the numbers.
    pub fn run(&self, settings: &Settings) -> Vec<Outcome> {
        let mut waiting = Waiting { samples: self, next: 0, outcomes: self.samples.iter().map(|_| None).collect() };
        conduct(&self.mechanism, &Follow::readings(&self.readings), settings, Execution::best(), &mut waiting);
        waiting.outcomes.into_iter().map(|outcome| outcome.expect("every run comes back")).collect()
    }

    /// Work and error of all samples with `settings` against `reference`. Names every run that fails.
    ///
    /// # Panics
    /// When a run of the reference failed.
    pub fn measure(&self, settings: &Settings, reference: &[Outcome]) -> Point {
        let outcomes = self.run(settings);
        let mut evaluations: Vec<u64> = outcomes.iter().flatten().map(|(_, counters)| counters.evaluations).collect();
        let mut errors_m: Vec<f64> = outcomes
            .iter()
            .zip(reference)
            .map(|(found, exact)| {
                let (exact, _) = exact.as_ref().expect("the reference is finished");
                found.as_ref().map_or(f64::INFINITY, |(found, _)| largest_distance_m(found, exact))
            })
            .collect();
        for (k, failure) in outcomes.iter().enumerate().filter_map(|(k, outcome)| Some((k, outcome.as_ref().err()?))) {
            let Settings { method, tolerance_m, .. } = settings;
            eprintln!("{}: {} at {tolerance_m:.1e} m, sample {k}: {failure}", self.name, method.name);
        }
        evaluations.sort_unstable();
        errors_m.sort_by(f64::total_cmp);
        Point {
            tolerance_m: settings.tolerance_m,
            evaluations: quantile(&evaluations, 0.5),
            median_m: quantile(&errors_m, 0.5),
            quantile_m: quantile(&errors_m, 0.9),
            worst_m: errors_m.iter().copied().filter(|error_m| error_m.is_finite()).fold(0.0, f64::max),
            failed: outcomes.iter().filter(|outcome| outcome.is_err()).count(),
        }
    }
}

/// The tolerance at which the 90 % quantile of the error meets `error_m`, and the work there, between the measured points in
/// logarithms: at the loosest place beyond which no finer point errs more. None where that lies outside the points.
pub fn work_at(points: &[Point], error_m: f64) -> Option<(f64, f64)> {
    let mut points: Vec<&Point> = points.iter().collect();
    points.sort_by(|a, b| a.tolerance_m.total_cmp(&b.tolerance_m));
    let above = points.iter().position(|point| point.quantile_m > error_m)?;
    let (low, high) = (points[above.checked_sub(1)?], points[above]);
    if !high.quantile_m.is_finite() {
        return Some((low.tolerance_m, low.evaluations as f64));
    }
    let share = (error_m / low.quantile_m).ln() / (high.quantile_m / low.quantile_m).ln();
    let between = |from: f64, to: f64| from * (to / from).powf(share);
    let work = between(low.evaluations as f64, high.evaluations as f64);
    Some((between(low.tolerance_m, high.tolerance_m), work))
}

/// The smallest of the sorted `values` that a share `level` of them does not exceed; zero where there are none.
fn quantile<T: Copy + Default>(values: &[T], level: f64) -> T {
    let rank = (level * values.len() as f64).ceil() as usize;
    values.get(rank.max(1) - 1).copied().unwrap_or_default()
}

fn largest_distance_m(found: &[f64], exact: &[f64]) -> f64 {
    let distance_m = |(a, b): (&[f64], &[f64])| (a[0] - b[0]).hypot(a[1] - b[1]);
    found.chunks_exact(2).zip(exact.chunks_exact(2)).map(distance_m).fold(0.0, f64::max)
}

fn watched(model: &Model, path: &str) -> Option<PointId> {
    let (body_name, point_name) = path.split_once('.')?;
    let body = model.bodies.iter().position(|body| body.name == body_name)?;
    let point = model.bodies[body].points.iter().position(|point| point.name == point_name)?;
    Some(PointId { body: BodyId(body), point })
}

/// Samples that wait for a lane.
struct Waiting<'s> {
    samples: &'s Samples,
    next: usize,
    outcomes: Vec<Option<Outcome>>,
}

impl<'s> Queue for Waiting<'s> {
    type Observer = Watch<'s>;

    fn next(&mut self) -> Option<Run<Watch<'s>>> {
        let (sample, arms) = self.samples.samples.get(self.next)?;
        let observer =
            Watch { index: self.next, times_s: &self.samples.times_s, positions_m: Vec::with_capacity(2 * TIMES) };
        self.next += 1;
        Some(Run {
            sample: sample.clone(),
            arms: arms.clone(),
            window: self.samples.window,
            observer,
            followed: FollowedRun::default(),
            resume: None,
        })
    }
    fn finished(&mut self, observer: Watch<'s>, outcome: Result<RunReport, RunFailure>) {
        self.outcomes[observer.index] = Some(outcome.map(|report| (observer.positions_m, report.counters)));
    }
}

/// Reads the watched point at the times, as studies read their outputs.
struct Watch<'s> {
    index: usize,
    times_s: &'s [f64],
    positions_m: Vec<f64>,
}

impl Observer for Watch<'_> {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        while let Some(&time_s) = self.times_s.get(self.positions_m.len() / 2).filter(|time_s| **time_s <= step.end_s) {
            let share = step.share(time_s);
            for [start, end] in step.outputs {
                self.positions_m.push(Quintic::new(*start, *end, step.length).value(share));
            }
        }
    }
}
