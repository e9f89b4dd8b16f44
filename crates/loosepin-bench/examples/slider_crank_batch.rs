//! Runs of the slider-crank of `cases/slider_crank_5000` with clearances around the nominal one, on one thread: the part of
//! this library in `tools/compare`, whose README says what is compared.
//!
//! `slider_crank_batch --runs N` prints one line, `{"runs":N,"seconds":S,"evaluations_per_run":E}`, S the processor time of all
//! runs, of another case with `--case NAME`; `slider_crank_batch --history` prints the nominal run as a table of `time_s,slider_x_m`.

use loosepin::simulate::{Execution, Settings};
use loosepin_bench::Watch;
use loosepin_bench::batch::{Case, Plan};
use std::process::ExitCode;

/// Turns of the crank in a run.
const TURNS: usize = 2;

/// Times at which the slider's position is read, in a turn.
const READINGS_PER_TURN: usize = 1000;

/// What positions keep over the first half turn, m.
const TOLERANCE_M: f64 = 1e-8;

/// Runs before the clock starts: they fill caches.
const RUNS_AHEAD: usize = 32;

fn plan(runs: usize) -> Plan {
    let settings = Settings { tolerance_m: TOLERANCE_M, ..Settings::for_study() };
    Plan { runs, turns: TURNS, readings_per_turn: READINGS_PER_TURN, settings }
}

fn print_history(case: &Case) {
    println!("time_s,slider_x_m");
    // One run alone has the nominal clearance.
    for run in case.run_all(&plan(1), Execution::best()) {
        for (index, slider_x_m) in run.readings.iter().enumerate() {
            println!("{:.12e},{slider_x_m:.15e}", index as f64 * case.turn_s / READINGS_PER_TURN as f64);
        }
    }
}

fn print_batch(case: &Case, runs: usize) {
    std::hint::black_box(case.run_all(&plan(RUNS_AHEAD), Execution::best()));
    let watch = Watch::start();
    let finished = std::hint::black_box(case.run_all(&plan(runs), Execution::best()));
    let seconds = watch.processor_s();
    let evaluations: u64 = finished.iter().map(|run| run.counters.evaluations).sum();
    let evaluations_per_run = evaluations as f64 / runs as f64;
    println!(r#"{{"runs":{runs},"seconds":{seconds:.6},"evaluations_per_run":{evaluations_per_run:.1}}}"#);
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["--history"] => print_history(&Case::read("slider_crank_5000")),
        ["--runs", runs] if runs.parse::<usize>().is_ok_and(|runs| runs > 0) => {
            print_batch(&Case::read("slider_crank_5000"), runs.parse().expect("checked above"));
        }
        ["--runs", runs, "--case", case] if runs.parse::<usize>().is_ok_and(|runs| runs > 0) => {
            print_batch(&Case::read(case), runs.parse().expect("checked above"));
        }
        _ => {
            eprintln!("usage: slider_crank_batch --history | --runs N [--case NAME] (N >= 1)");
            return ExitCode::from(2);
        }
    }
    ExitCode::SUCCESS
}
