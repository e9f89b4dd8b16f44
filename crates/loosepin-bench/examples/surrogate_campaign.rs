//! How often bounds by surrogates hold on the slider-crank with play, and how wide they are: `just campaign surrogates [SEEDS]
//! [TRAINING] [KIND]`, KIND being auto, chaos, kriging or network.

use loosepin::bounds::{
    ColumnGroup, Problem, Response, SampleTable, Statistic, SurrogateBounds, SurrogatePlan, SurrogateSettings, execute,
};
use loosepin_bench::known_bounds::slider_crank_with_play;
use loosepin_bench::{largest, median, surrogate_choice};
use std::f64::consts::FRAC_PI_3;
use std::time::Instant;

/// Round-off of numbers about 1.
const ROUND_OFF: f64 = 1e-12;
/// A width is near the true one up to this factor.
const NEAR: f64 = 1.03;
/// Direct runs at each witness.
const CONFIRMING: usize = 64;

/// What all seeds said of one statistic.
struct Tally {
    statistic: Statistic,
    exact: (f64, f64),
    held: u64,
    /// Width over the true one: as found, and widened.
    found: Vec<f64>,
    widened: Vec<f64>,
}

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let number =
        |place: usize, otherwise: usize| words.get(place).map_or(otherwise, |word| word.parse().expect("a number"));
    let (seeds, training) = (number(0, 100), number(1, 100));
    let choice = surrogate_choice(words.get(2).map_or("auto", String::as_str)).expect("a kind");
    let case = slider_crank_with_play(FRAC_PI_3).without_periodic_inputs();
    let settings = SurrogateSettings {
        choice,
        training,
        confirming: CONFIRMING,
        groups: vec![ColumnGroup { name: "slider".into(), columns: vec![0] }],
    };
    let mut tallies: Vec<Tally> = case
        .statistics
        .iter()
        .map(|&(statistic, exact)| Tally { statistic, exact, held: 0, found: Vec::new(), widened: Vec::new() })
        .collect();
    let (started, mut runs, mut all_held) = (Instant::now(), 0, 0);
    for seed in 1..=seeds as u64 {
        let bounds = bounds(&case, case.problem(seed), &settings);
        runs = runs.max(bounds.training_runs + bounds.confirming_runs);
        let group = &bounds.groups[0];
        let mut is_held = true;
        let mut missed = Vec::new();
        for tally in &mut tallies {
            let pair = &bounds.pair(0, tally.statistic).expect("the statistic was asked").pair;
            let (low, high) = tally.exact;
            let holds = pair.lower.widened <= low + ROUND_OFF && pair.upper.widened >= high - ROUND_OFF;
            is_held &= holds;
            if !holds {
                missed.push(format!("{:?}", tally.statistic));
            }
            tally.held += u64::from(holds);
            let width = if high > low { high - low } else { 1.0 };
            tally.found.push((pair.upper.value - pair.lower.value) / width);
            tally.widened.push((pair.upper.widened - pair.lower.widened) / width);
        }
        all_held += u64::from(is_held);
        let output = group.learned.surrogates.as_ref().expect("the case can be learned")[0].outputs()[0].clone();
        println!(
            "seed {seed}: {:?}, held-out rms {:.2e}, {:?}, ratio {:.2}, reach {:.1} {}",
            output.kinds(),
            output.quality.rms,
            output.residual.verdict,
            group.largest_ratio,
            group.reach,
            missed.join(" ")
        );
    }
    println!(
        "{:32} {:>26} {:>9} {:>10} {:>10} {:>10} {:>11}",
        "statistic", "exact", "held", "found", "widened", "most", "within 3 %"
    );
    for tally in &tallies {
        println!(
            "{:32} {:>26} {:>5}/{seeds:<4} {:>10.4} {:>10.4} {:>10.4} {:>11}",
            format!("{:?}", tally.statistic),
            format!("{:.6}..{:.6}", tally.exact.0, tally.exact.1),
            tally.held,
            median(&tally.found),
            median(&tally.widened),
            largest(&tally.widened),
            tally.widened.iter().filter(|&&width| width <= NEAR).count(),
        );
    }
    println!(
        "all statistics held in {all_held} of {seeds} seeds; {training} training runs, at most {runs} in all; {:.2} s a seed",
        started.elapsed().as_secs_f64() / seeds as f64
    );
}

fn bounds(case: &impl Response, problem: Problem, settings: &SurrogateSettings) -> SurrogateBounds {
    let plan = SurrogatePlan::try_new(problem, settings.clone()).expect("the case can be planned");
    let mut table = SampleTable::new(plan.problem().columns);
    execute(plan.training_round(0).expect("few inputs"), case, &mut table).expect("rows fit");
    let learned = plan.learn(&table);
    let confirmation = plan.confirmation(&learned, 1, &table).expect("the surrogate can be searched");
    execute(confirmation.round.clone(), case, &mut table).expect("rows fit");
    plan.results(learned, &confirmation, &table).expect("the surrogate can be searched")
}
