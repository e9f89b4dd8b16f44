//! The command line.

use crate::batch::{CompletedBatch, Plan, run_batch};
use crate::model::SliderCrank;
use loosepin_bench::{Watch, largest};
use std::process::ExitCode;

/// Turns of the crank in a run.
const TURNS: usize = 2;
/// Times at which the slider's position is read, in a turn.
const READINGS_PER_TURN: usize = 1000;
/// Local error allowed in a step, m. Over 401 clearances the error over the first half turn has the 90 % quantile 6e-10 m, with 2e-10 m
/// 1.2e-9 m, with 3e-10 m 4e-9 m; the library's is 1.2e-9 m at 1e-8 m.
pub const LOCAL_M: f64 = 1.2e-10;
/// The local error of the runs that accuracy is measured by, m. They agree with those of 2e-15 m to 5e-13 m (90 % quantile).
const FINE_LOCAL_M: f64 = 5e-15;
/// Clearances over which accuracy is measured.
const CLEARANCES: usize = 41;
/// Runs before the clock starts: they fill caches.
const RUNS_AHEAD: usize = 32;

/// What is done with the runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Work {
    /// Positions are read and energy accounts are kept, as in the library.
    Full,
    /// Neither.
    Bare,
}

/// What a batch of the comparison does.
pub fn plan(runs: usize) -> Plan {
    Plan { runs, turns: TURNS, readings_per_turn: READINGS_PER_TURN, local_m: LOCAL_M }
}

/// Whether the processor has what the kernel needs.
pub fn is_possible() -> bool {
    std::is_x86_feature_detected!("avx512f")
}

/// Conducts a plan. Vectors that are stepped through together: one with all the work, two without, as measured.
///
/// # Panics
/// If the processor has no AVX-512.
#[allow(unsafe_code, reason = "instructions may be named only where the processor was found to have them")]
pub fn run_plan(model: &SliderCrank, plan: &Plan, work: Work) -> CompletedBatch {
    assert!(is_possible(), "the processor has no AVX-512");
    // SAFETY: the processor has AVX-512, as was just asserted.
    unsafe {
        match work {
            Work::Full => run_batch::<1, true>(model, plan),
            Work::Bare => run_batch::<2, false>(model, plan),
        }
    }
}

fn print_history(model: &SliderCrank) {
    println!("time_s,slider_x_m");
    // One run alone has the nominal clearance.
    for run in run_plan(model, &plan(1), Work::Full).runs {
        for (index, slider_x_m) in run.readings.iter().enumerate() {
            println!("{:.12e},{slider_x_m:.15e}", index as f64 * model.turn_s / READINGS_PER_TURN as f64);
        }
    }
}

fn print_batch(model: &SliderCrank, work: Work, runs: usize) {
    std::hint::black_box(run_plan(model, &plan(RUNS_AHEAD), work));
    let watch = Watch::start();
    let done = std::hint::black_box(run_plan(model, &plan(runs), work));
    let seconds = watch.processor_s();
    let [evaluations, accepted, rejected, onto_events] =
        [done.evaluations, done.accepted, done.rejected, done.onto_events].map(|count| count as f64 / runs as f64);
    let events = done.runs.iter().map(|run| f64::from(run.events)).sum::<f64>() / runs as f64;
    print!(r#"{{"runs":{runs},"seconds":{seconds:.6},"evaluations_per_run":{evaluations:.1},"#);
    print!(
        r#""accepted_per_run":{accepted:.1},"rejected_per_run":{rejected:.1},"onto_events_per_run":{onto_events:.1},"#
    );
    print!(r#""events_per_run":{events:.1}"#);
    if work == Work::Full {
        let residuals: Vec<f64> = done.runs.iter().map(|run| run.energy_residual).collect();
        print!(r#","largest_energy_residual":{:.1e}"#, largest(&residuals));
    }
    println!("}}");
}

/// Largest errors over the first half turn, against runs with a far smaller tolerance, from small to large, m.
pub fn errors_m(model: &SliderCrank, runs: usize) -> Vec<f64> {
    let coarse = run_plan(model, &plan(runs), Work::Full);
    let fine = run_plan(model, &Plan { local_m: FINE_LOCAL_M, ..plan(runs) }, Work::Full);
    let pairs = coarse.runs.iter().zip(&fine.runs);
    let mut errors_m: Vec<f64> = pairs
        .map(|(coarse, fine)| {
            let half_turn = coarse.readings.iter().zip(&fine.readings).take(READINGS_PER_TURN / 2 + 1);
            // A reading that is no number is the largest error.
            half_turn.map(|(coarse, fine)| (coarse - fine).abs()).max_by(f64::total_cmp).unwrap_or(f64::NAN)
        })
        .collect();
    errors_m.sort_by(f64::total_cmp);
    errors_m
}

/// Runs what the arguments ask for.
pub fn run() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let mut arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let mut work = Work::Full;
    if arguments.first() == Some(&"--bare") {
        work = Work::Bare;
        arguments.remove(0);
    }
    if !is_possible() {
        eprintln!("error: this program needs a processor with AVX-512");
        return ExitCode::FAILURE;
    }
    let model = SliderCrank::read();
    match arguments[..] {
        ["--history"] => print_history(&model),
        ["--accuracy"] => {
            let errors_m = errors_m(&model, CLEARANCES);
            let quantile = |share: f64| errors_m[((errors_m.len() - 1) as f64 * share).round() as usize];
            let [median_m, ninety_m, largest_m] = [0.5, 0.9, 1.0].map(quantile);
            println!(
                "{CLEARANCES} clearances: median {median_m:.1e} m, 90 % {ninety_m:.1e} m, largest {largest_m:.1e} m"
            );
        }
        ["--runs", runs] if runs.parse::<usize>().is_ok_and(|runs| runs > 0) => {
            print_batch(&model, work, runs.parse().expect("checked above"));
        }
        _ => {
            eprintln!("usage: slider_crank_lanes [--bare] --history | --accuracy | --runs N (N >= 1)");
            return ExitCode::from(2);
        }
    }
    ExitCode::SUCCESS
}
