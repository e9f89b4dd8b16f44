//! Worst cases over a cycle: found, and proven.

use super::motion::plan;
use super::{Built, build_case, build_case_with};
use loosepin_simulate::accuracy::motion_with_worst_cases;
use loosepin_simulate::accuracy::record::MotionRecord;

pub(super) fn worst_of(built: &Built, positions: usize) -> MotionRecord {
    motion_with_worst_cases(&built.mechanism, &built.values, &plan(built, positions)).expect("it moves")
}

fn largest(values: &[f64]) -> f64 {
    values.iter().copied().fold(0.0, f64::max)
}

#[test]
fn scratch() {
    for c in [1e-4, 2e-4, 4e-4, 5e-4, 6e-4] {
        let built = build_case_with(
            "slider_crank_5000",
            &[("parameter.rod_length", 0.0505), ("joint.gudgeon.radial_clearance", c)],
        );
        let start = std::time::Instant::now();
        let record = worst_of(&built, 360);
        let answer = &record.outputs[0].clearance;
        println!(
            "{c}: first {} found {} proven {} {} | {:?} {:?} {:?}",
            largest(&answer.first_order_si),
            largest(&answer.worst_case_si),
            largest(&answer.proven_highest_si),
            largest(&answer.proven_lowest_si.iter().map(|v| -v).collect::<Vec<_>>()),
            answer.witness,
            record.unproven_spans,
            start.elapsed()
        );
    }
    for case in [
        "slider_crank_5000",
        "slider_crank_two_clearances",
        "four_bar_three_clearances",
        "six_bar",
        "slider_crank_guide",
        "scotch_yoke",
        "eight_bar",
        "double_four_bar",
        "geared_four_bar_backlash",
        "five_bar_two_drives",
        "four_bar_coupler_path",
    ] {
        let built = build_case(case);
        let start = std::time::Instant::now();
        let record = super::motion::motion_of(&built, 360);
        let plain = start.elapsed();
        let record = worst_of(&built, 360);
        println!(
            "{case} {} plays {:?} then {:?} {:?}",
            built.mechanism.plays.len(),
            plain,
            start.elapsed(),
            record.unproven_spans
        );
        for output in &record.outputs {
            let answer = &output.clearance;
            let excess: Vec<f64> = (0..answer.worst_case_si.len())
                .map(|k| {
                    f64::max(answer.proven_highest_si[k], -answer.proven_lowest_si[k]) / answer.worst_case_si[k] - 1.0
                })
                .collect();
            println!(
                "   {} first {:e} found {:e} proven {:e} {:e} excess by row {:e}..{:e}",
                output.name,
                largest(&answer.first_order_si),
                largest(&answer.worst_case_si),
                largest(&answer.proven_highest_si),
                largest(&answer.proven_lowest_si.iter().map(|v| -v).collect::<Vec<_>>()),
                excess.iter().copied().fold(f64::INFINITY, f64::min),
                excess.iter().copied().fold(0.0, f64::max),
            );
        }
    }
}
