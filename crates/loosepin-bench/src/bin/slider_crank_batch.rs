//! Runs of the slider-crank of `cases/slider_crank_5000` with clearances around the nominal one, on one thread: the part of
//! this library in `tools/compare`, whose README says what is compared.
//!
//! `slider_crank_batch --runs N` prints one line, `{"runs":N,"seconds":S,"evaluations_per_run":E}`, S the processor time of all
//! runs; `slider_crank_batch --history` prints the nominal run as a table of `time_s,slider_x_m`.

use loosepin::mechanism::{Mechanism, Sample};
use loosepin::model::{Model, QuantityId};
use loosepin::simulate::{Observer, Settings, Step, Window, run};
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

/// Turns of the crank in a run.
const TURNS: usize = 2;

/// Times at which the slider's position is read, in a turn.
const READINGS_PER_TURN: usize = 1000;

/// The clearances of a batch lie evenly between 1 - `VARIATION` and 1 + `VARIATION` times the nominal one.
const VARIATION: f64 = 0.1;

/// What positions keep over the first half turn, m.
const TOLERANCE_M: f64 = 1e-8;

/// Runs before the clock starts: they fill caches.
const RUNS_AHEAD: usize = 3;

/// Reads the slider's position at equidistant times.
struct Readings {
    /// Slot of the slider among the poses.
    slot: usize,
    /// Time between two readings, s.
    interval_s: f64,
    /// Positions so far, m.
    slider_x_m: Vec<f64>,
}

impl Observer for Readings {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        while self.slider_x_m.len() <= TURNS * READINGS_PER_TURN {
            let time_s = self.slider_x_m.len() as f64 * self.interval_s;
            // The last reading is the end of the run, where the two may differ by rounding.
            if time_s > step.end_s * (1.0 + 1e-12) {
                break;
            }
            self.slider_x_m.push(step.set_state(time_s).kinematics.poses[self.slot].position_m.x);
        }
    }
}

/// The compiled case.
struct Case {
    model: Model,
    mechanism: Mechanism,
    clearance: QuantityId,
    nominal_clearance_m: f64,
    turn_s: f64,
}

impl Case {
    fn read() -> Self {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/slider_crank_5000/model.toml");
        let model = Model::from_path(&file).unwrap_or_else(|complaints| panic!("{complaints}"));
        let clearance = model.quantities.id("joint.gudgeon.radial_clearance").expect("the case has this quantity");
        let nominal = model.quantities.nominal();
        let mechanism = Mechanism::new(&model, &nominal).expect("the case is a mechanism");
        let turn_s = std::f64::consts::TAU / nominal[model.drives[0].speed];
        Self { mechanism, clearance, nominal_clearance_m: nominal[clearance], turn_s, model }
    }

    fn sample(&self, clearance_m: f64) -> Sample<f64> {
        let values = self.model.quantities.evaluate(&[(self.clearance, clearance_m)]);
        let values = values.expect("the clearance is possible");
        Sample::new(&self.mechanism, &values).expect("the sample fits the mechanism")
    }

    /// Samples whose clearances are spread evenly.
    fn samples(&self, runs: usize) -> Vec<Sample<f64>> {
        let share = |index: usize| (index as f64 + 0.5) / runs as f64;
        let clearance_m = |index| self.nominal_clearance_m * (1.0 + VARIATION * (2.0 * share(index) - 1.0));
        (0..runs).map(|index| self.sample(clearance_m(index))).collect()
    }

    /// Runs one sample; gives the readings and the number of right-hand sides.
    fn run(&self, sample: &Sample<f64>) -> (Readings, u64) {
        let body = self.model.bodies.iter().position(|body| body.name == "slider").expect("the case has a slider");
        let mut readings = Readings {
            slot: self.mechanism.real.slot_of_body[body],
            interval_s: self.turn_s / READINGS_PER_TURN as f64,
            slider_x_m: Vec::with_capacity(TURNS * READINGS_PER_TURN + 1),
        };
        let window = Window { start_s: 0.0, end_s: TURNS as f64 * self.turn_s };
        let settings = Settings { tolerance_m: TOLERANCE_M, ..Settings::for_study() };
        let report = run(&self.mechanism, sample, &window, &settings, &mut readings);
        (readings, report.expect("the runs of the case succeed").counters.evaluations)
    }
}

/// Processor time of all threads of this process so far, s; none where the system does not tell.
fn processor_time_s() -> Option<f64> {
    let mut nanoseconds = 0;
    for thread in std::fs::read_dir("/proc/self/task").ok()? {
        let text = std::fs::read_to_string(thread.ok()?.path().join("schedstat")).ok()?;
        nanoseconds += text.split_whitespace().next()?.parse::<u64>().ok()?;
    }
    Some(nanoseconds as f64 * 1e-9)
}

fn print_history(case: &Case) {
    let (readings, _) = case.run(&case.sample(case.nominal_clearance_m));
    println!("time_s,slider_x_m");
    for (index, slider_x_m) in readings.slider_x_m.iter().enumerate() {
        println!("{:.12e},{slider_x_m:.15e}", index as f64 * readings.interval_s);
    }
}

fn print_batch(case: &Case, runs: usize) {
    for sample in case.samples(RUNS_AHEAD) {
        std::hint::black_box(case.run(&sample));
    }
    let (started, started_s) = (Instant::now(), processor_time_s());
    let evaluations: u64 = case.samples(runs).iter().map(|sample| std::hint::black_box(case.run(sample)).1).sum();
    let seconds = match (started_s, processor_time_s()) {
        (Some(start_s), Some(end_s)) => end_s - start_s,
        _ => started.elapsed().as_secs_f64(),
    };
    let evaluations_per_run = evaluations as f64 / runs as f64;
    println!(r#"{{"runs":{runs},"seconds":{seconds:.6},"evaluations_per_run":{evaluations_per_run:.1}}}"#);
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["--history"] => print_history(&Case::read()),
        ["--runs", runs] if runs.parse::<usize>().is_ok_and(|runs| runs > 0) => {
            print_batch(&Case::read(), runs.parse().expect("checked above"));
        }
        _ => {
            eprintln!("usage: slider_crank_batch --history | --runs N (N >= 1)");
            return ExitCode::from(2);
        }
    }
    ExitCode::SUCCESS
}
