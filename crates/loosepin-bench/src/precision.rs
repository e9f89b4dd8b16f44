//! Work against error: runs of a reference case with one method at one tolerance, held against finer runs.

use crate::compiled_with;
use loosepin::integrate::Tableau;
use loosepin::math::Quintic;
use loosepin::mechanism::{Mechanism, Sample};
use loosepin::model::{Axis, BodyId, Model, Motion, PointId, Position, QuantityId, Relative};
use loosepin::simulate::{
    Arms, Execution, Follow, FollowedRun, Integrator, Observer, Queue, Reading, Run, RunCounters, RunFailure,
    RunReport, Settings, Step, Window, run_batch,
};

/// A model and what is watched in it.
#[derive(Debug, Clone, Copy)]
pub struct Case {
    /// Name of the case.
    pub name: &'static str,
    /// File of the model, from the root of the repository.
    pub file: &'static str,
    /// Parts of its text, and their replacements.
    pub changes: &'static [(&'static str, &'static str)],
    /// What distinguishes this case.
    pub about: &'static str,
    /// The point whose position is watched, `body.point`.
    pub point: &'static str,
    /// Quantities that differ from sample to sample, and by which share of their nominal values at most.
    pub varied: &'static [(&'static str, f64)],
    /// Tolerance of the reference runs, m: tight, and yet so that steps are not lost in rounding.
    pub reference_m: f64,
    /// Samples of it.
    pub samples: usize,
    /// The methods compared.
    pub methods: &'static [Method],
}

/// A method, and the tolerances with which it is measured.
#[derive(Debug, Clone, Copy)]
pub struct Method {
    /// Its name in tables.
    pub name: &'static str,
    /// The embedded pair; of implicit steps that in contact.
    pub pair: &'static Tableau,
    /// Explicit or implicit steps.
    pub integrator: Integrator,
    /// First and last tolerance, in half decades below 1 m, and how many lie between two.
    pub half_decades: (i32, i32, usize),
}

/// Times within the run at which positions are compared.
pub const TIMES: usize = 32;

/// One run: the watched point's coordinates at [`TIMES`] times, m, x and y in turn; and what they cost.
type Outcome = Result<(Vec<f64>, RunCounters), RunFailure>;

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
    /// Right-hand sides of a run, the median; repeated and rejected steps included, and those for the Jacobians of implicit steps.
    pub evaluations: u64,
    /// Factorizations of a run, the median: of a real and of a complex matrix each.
    pub factorizations: u64,
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
    /// Reads and compiles `case` with its samples: the varied quantities fill their box evenly (multiples of the square
    /// roots of the primes), so that a few samples already see different sequences of contacts.
    ///
    /// # Panics
    /// When the case, the point or a quantity does not exist: a mistake in this crate.
    pub fn new(case: &Case) -> Self {
        let (mechanism, nominal, turn_s) = compiled_with(case.file, case.changes);
        let model = &mechanism.model;
        let varied: Vec<(QuantityId, f64)> = case
            .varied
            .iter()
            .map(|(path, share)| (model.quantities.id(path).expect("the case has this quantity"), *share))
            .collect();
        let samples = (0..case.samples)
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
        let end_s = 0.5 * turn_s;
        Self {
            name: case.name,
            readings: [Axis::X, Axis::Y]
                .map(|axis| Motion::position(Position::Point(Relative::to_ground(point), axis)).into()),
            mechanism,
            samples,
            window: Window { start_s: 0.0, end_s },
            times_s: (1..=TIMES).map(|k| end_s * k as f64 / TIMES as f64).collect(),
        }
    }

    /// Runs all samples over half of the cycle of the model, on the widest lanes of this processor, which does not show in the numbers.
    pub fn run(&self, settings: &Settings) -> Vec<Outcome> {
        let is_implicit = settings.integrator == Integrator::Implicit;
        let outcomes = self.samples.iter().map(|_| None).collect();
        let mut waiting = Waiting { samples: self, next: 0, is_implicit, outcomes };
        run_batch(&self.mechanism, &Follow::readings(&self.readings), settings, Execution::best(), &mut waiting);
        waiting.outcomes.into_iter().map(|outcome| outcome.expect("every run comes back")).collect()
    }

    /// Work and error of all samples with `settings` against `reference`. Names every run that fails.
    ///
    /// # Panics
    /// When a run of the reference failed.
    pub fn measure(&self, settings: &Settings, reference: &[Outcome]) -> Point {
        let outcomes = self.run(settings);
        let median = |count: fn(&RunCounters) -> u64| {
            let mut counts: Vec<u64> = outcomes.iter().flatten().map(|(_, counters)| count(counters)).collect();
            counts.sort_unstable();
            quantile(&counts, 0.5)
        };
        let mut errors_m: Vec<f64> = outcomes
            .iter()
            .zip(reference)
            .map(|(found, exact)| {
                let (exact, _) = exact.as_ref().expect("the reference is finished");
                found.as_ref().map_or(f64::INFINITY, |(found, _)| largest_distance_m(found, exact))
            })
            .collect();
        for (k, failure) in outcomes.iter().enumerate().filter_map(|(k, outcome)| Some((k, outcome.as_ref().err()?))) {
            let Settings { tolerance_m, .. } = settings;
            eprintln!("{}: {} at {tolerance_m:.1e} m, sample {k}: {failure}", self.name, settings.method_name());
        }
        errors_m.sort_by(f64::total_cmp);
        Point {
            tolerance_m: settings.tolerance_m,
            evaluations: median(|counters| counters.evaluations),
            factorizations: median(|counters| counters.factorizations),
            median_m: quantile(&errors_m, 0.5),
            quantile_m: quantile(&errors_m, 0.9),
            worst_m: errors_m.iter().copied().filter(|error_m| error_m.is_finite()).fold(0.0, f64::max),
            failed: outcomes.iter().filter(|outcome| outcome.is_err()).count(),
        }
    }
}

/// Work at an error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WorkAt {
    /// The tolerance that gives the error, m.
    pub tolerance_m: f64,
    /// Whether the loosest tolerance measured errs less: then this is the work with it, and a looser one may take less.
    pub is_most: bool,
    /// Right-hand sides.
    pub evaluations: f64,
    /// Factorizations; 0 with explicit steps.
    pub factorizations: f64,
}

/// The tolerance at which the 90 % quantile of the error meets `error_m`, and the work there, between the measured points in
/// logarithms: at the loosest place beyond which no finer point errs more. `None` if even the finest point errs more.
pub fn work_at(points: &[Point], error_m: f64) -> Option<WorkAt> {
    let mut points: Vec<&Point> = points.iter().collect();
    points.sort_by(|a, b| a.tolerance_m.total_cmp(&b.tolerance_m));
    let above = points.iter().position(|point| point.quantile_m > error_m);
    let low = points.get(above.unwrap_or(points.len()).checked_sub(1)?)?;
    let high = above.map_or(low, |above| &points[above]);
    let share = if above.is_some() && high.quantile_m.is_finite() {
        (error_m / low.quantile_m).ln() / (high.quantile_m / low.quantile_m).ln()
    } else {
        0.0
    };
    let between = |from: f64, to: f64| if from > 0.0 { from * (to / from).powf(share) } else { from };
    Some(WorkAt {
        is_most: above.is_none(),
        tolerance_m: between(low.tolerance_m, high.tolerance_m),
        evaluations: between(low.evaluations as f64, high.evaluations as f64),
        factorizations: between(low.factorizations as f64, high.factorizations as f64),
    })
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
    is_implicit: bool,
    outcomes: Vec<Option<Outcome>>,
}

impl<'s> Queue for Waiting<'s> {
    type Observer = Watch<'s>;

    fn next(&mut self) -> Option<Run<Watch<'s>>> {
        let (sample, arms) = self.samples.samples.get(self.next)?;
        let observer = Watch {
            index: self.next,
            samples: self.samples,
            arms: arms.clone(),
            is_implicit: self.is_implicit,
            positions_m: Vec::with_capacity(2 * TIMES),
        };
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

/// Reads the watched point at the times, as studies read their outputs; in implicit steps as single runs do, by their cubics.
struct Watch<'s> {
    index: usize,
    samples: &'s Samples,
    arms: Arms,
    is_implicit: bool,
    positions_m: Vec<f64>,
}

impl Observer for Watch<'_> {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        let Self { samples, arms, positions_m, .. } = self;
        while let Some(&time_s) = samples.times_s.get(positions_m.len() / 2).filter(|time_s| **time_s <= step.end_s) {
            if self.is_implicit {
                let dynamics = step.set_state(time_s);
                positions_m.extend(samples.readings.map(|reading| reading.value(arms, dynamics)));
                continue;
            }
            let share = step.share(time_s);
            for [start, end] in step.outputs {
                positions_m.push(Quintic::new(*start, *end, step.length).value(share));
            }
        }
    }
}
