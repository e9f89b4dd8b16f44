//! Whether runs keep the tolerance of a study, 1e-8 m, over the first half turn, and what they cost: all mechanisms of `cases/` with a drive and
//! play, and the templates. `measured/integrators.md` has the table.
//!
//! Usage: `kept_tolerance [WORD ...]`, words of the names of cases

use loosepin::simulate::Settings;
use loosepin_bench::further_cases::FURTHER_CASES;
use loosepin_bench::precision::{Case, Samples};
use loosepin_bench::precision_cases::RIGID_CASES;

/// Tolerance of the runs against which errors are measured, m.
const REFERENCE_M: f64 = 1e-12;

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let is_named = |case: &Case| words.is_empty() || words.iter().any(|word| case.name.contains(word.as_str()));
    println!("{:32} {:>12} {:>10} {:>10} {:>10}", "", "evaluations", "median", "90 %", "worst");
    for case in RIGID_CASES.iter().chain(&FURTHER_CASES).filter(|case| is_named(case)) {
        let samples = Samples::new(case);
        let tight = Settings { tolerance_m: case.reference_m.max(REFERENCE_M), ..Settings::for_study() };
        let point = samples.measure(&Settings::for_study(), &samples.run(&tight));
        let [median_m, quantile_m, worst_m] = [point.median_m, point.quantile_m, point.worst_m];
        println!("{:32} {:12} {median_m:10.1e} {quantile_m:10.1e} {worst_m:10.1e}", case.name, point.evaluations);
    }
}
