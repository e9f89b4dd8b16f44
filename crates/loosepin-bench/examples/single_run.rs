//! Milliseconds of processor time for one recorded run of the reference slider-crank, as `loosepin simulate` makes it without its page:
//! with and without the second run, and with few and many rows. `cargo run --release -p loosepin-bench --example single_run [REPEATS]`

use loosepin::mechanism::Mechanism;
use loosepin::model::Model;
use loosepin::simulate::{Plan, simulate};
use loosepin_bench::Watch;
use std::path::Path;

fn main() {
    let repeats: u32 = std::env::args().nth(1).map_or(20, |word| word.parse().expect("a number"));
    let path = Path::new("cases/slider_crank_5000/model.toml");
    let model = Model::from_path(path).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    for (samples, second_run) in [(500, true), (500, false), (1, false), (2000, true)] {
        let mut plan = Plan::of_model(&model);
        plan.cycle.recorded_turns = 2.0;
        plan.cycle.samples_per_turn = samples;
        plan.settings.tolerance_m = 1e-8;
        plan.second_run = second_run;
        let started = Watch::start();
        for _ in 0..repeats {
            let values = model.quantities.nominal();
            let mechanism = Mechanism::new(&model, &values).expect("the case is whole");
            let simulation = simulate(&mechanism, &values, &plan).expect("the case runs");
            assert!(simulation.failure.is_none());
        }
        let each_ms = 1e3 * started.processor_s() / f64::from(repeats);
        println!("{samples:5} samples a turn, second run {second_run:5}: {each_ms:.2} ms");
    }
}
