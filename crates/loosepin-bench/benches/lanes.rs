//! Runs a second on one core, one run at a time, on lanes evaluated operation by operation, and on lanes as machine code, by
//! processor time; and on two threads, by the clock. Every block of runs is repeated in turn, so that a noisy machine
//! disturbs all alike; printed is the median. Bits are compared on the way.
//!
//! `cargo bench --package loosepin-bench --bench lanes` for four mechanisms, three of which stand in the table of `measured/performance.md`; case names as
//! arguments choose others.

use loosepin::simulate::{Execution, Settings};
use loosepin_bench::batch::{Case, FinishedRun, Plan};
use loosepin_bench::{Watch, median, named_cases};

const CASES: [&str; 4] = ["slider_crank_5000", "four_bar_600", "slider_crank_two_clearances", "six_bar"];
/// Rounds, and runs of each block: those on lanes take about as long as those without.
const ROUNDS: usize = 5;
const RUNS: usize = 768;
const SCALAR_RUNS: usize = 48;
/// Lanes of a batch.
const LANES: usize = 32;

struct Way {
    name: String,
    execution: Execution,
    threads: usize,
    seconds_a_run: Vec<f64>,
}

fn main() {
    for name in named_cases(&CASES) {
        measure(&Case::read(&name));
    }
}

fn measure(case: &Case) {
    let mut ways = Vec::new();
    for execution in Execution::available().into_iter().rev() {
        ways.push(Way { name: execution.name(), execution, threads: 1, seconds_a_run: Vec::new() });
    }
    let execution = Execution::best();
    let name = format!("{}, two threads", execution.name());
    ways.push(Way { name, execution, threads: 2, seconds_a_run: Vec::new() });
    let mut reference: Option<Vec<FinishedRun>> = None;
    for _ in 0..ROUNDS {
        for way in &mut ways {
            let runs = if way.execution == Execution::Scalar { SCALAR_RUNS } else { RUNS };
            let plan = Plan { runs, turns: 2, readings_per_turn: 1000, settings: Settings::for_study() };
            let watch = Watch::start();
            let finished = match way.threads {
                // On this thread: the system forgets the time of one that has ended.
                1 => case.run_all(&plan, way.execution),
                threads => case.run_on_threads(&plan, way.execution, threads),
            };
            let seconds = if way.threads == 1 { watch.processor_s() } else { watch.clock_s() };
            way.seconds_a_run.push(seconds / runs as f64);
            if runs == RUNS {
                let reference = reference.get_or_insert_with(|| finished.clone());
                assert!(*reference == finished, "{}: {} has other bits", case.name, way.name);
            }
        }
    }
    let reference = reference.unwrap_or_default();
    let turns = (2 * reference.len()) as f64;
    let per_turn = |count: fn(&FinishedRun) -> u64| reference.iter().map(count).sum::<u64>() as f64 / turns;
    println!(
        "{}: {:.0} evaluations, {:.0} steps, {:.0} rejections, {:.1} events a turn",
        case.name,
        per_turn(|run| run.counters.evaluations),
        per_turn(|run| run.counters.steps),
        per_turn(|run| run.counters.rejections),
        per_turn(|run| run.counters.contact_changes),
    );
    for runs in [64, 256, RUNS] {
        let idle = 100.0 * idle_share(&reference[..runs]);
        println!("  idle lanes at the end of a batch of {runs}: {idle:.1} %");
    }
    let scalar_s = median(&ways[0].seconds_a_run);
    for way in &ways {
        let seconds = median(&way.seconds_a_run);
        println!("  {:28} {:8.0} runs/s   {:6.2} times scalar", way.name, 1.0 / seconds, scalar_s / seconds);
    }
}

/// Which share of the lanes' time is idle because no run is left: each run goes to the lane that is free first, and takes as
/// long as its evaluations.
fn idle_share(finished: &[FinishedRun]) -> f64 {
    let mut lanes = [0; LANES];
    for run in finished {
        lanes.sort_unstable();
        lanes[0] += run.counters.evaluations;
    }
    let (busy, longest) = (lanes.iter().sum::<u64>(), lanes.iter().max().copied().unwrap_or(0));
    1.0 - busy as f64 / (LANES as u64 * longest) as f64
}
