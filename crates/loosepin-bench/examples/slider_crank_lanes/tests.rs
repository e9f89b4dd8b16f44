//! The kernel computes the reference motion, and the same in every lane.

use crate::model::SliderCrank;
use crate::program::{Work, errors_m, is_possible, plan, run_plan};
use loosepin_bench::case_file;

/// Largest difference of positions over the first half turn, m: what the comparison demands of the library; the play is 5e-4 m.
const TOLERANCE_M: f64 = 1e-8;
/// Largest residual of the energy account over the largest exchange: what the case demands.
const ENERGY_TOLERANCE: f64 = 1e-8;
/// Rows of the reference over the first half turn; it has 500 a turn, half as many as are read here.
const REFERENCE_ROWS: usize = 251;

/// The model, or nothing and a message where the kernel cannot run.
fn model() -> Option<SliderCrank> {
    if !is_possible() {
        eprintln!("skipped: the processor has no AVX-512");
        return None;
    }
    Some(SliderCrank::read())
}

#[test]
fn peer_the_nominal_history_is_that_of_the_reference() {
    let Some(model) = model() else { return };
    let text = std::fs::read_to_string(case_file("slider_crank_5000", "reference.csv")).expect("the case has it");
    let mut lines = text.lines();
    let names = lines.next().expect("there is a head");
    let column = names.split(',').position(|name| name == "b3_x").expect("it has the slider's position");
    let run = &run_plan(&model, &plan(1), Work::Full).runs[0];
    let mut rows = 0;
    for (row, line) in lines.take(REFERENCE_ROWS).enumerate() {
        let expected_m: f64 = line.split(',').nth(column).and_then(|cell| cell.parse().ok()).expect("a number");
        let found_m = run.readings[2 * row];
        assert!((found_m - expected_m).abs() < TOLERANCE_M, "row {row}: {found_m} for {expected_m}");
        rows += 1;
    }
    assert_eq!(rows, REFERENCE_ROWS);
    assert!(run.energy_residual < ENERGY_TOLERANCE, "{}", run.energy_residual);
}

#[test]
fn identity_a_run_is_the_same_in_any_lane_and_with_less_work() {
    let Some(model) = model() else { return };
    // Runs of 21 and of 63 with the same clearances: number i of the one is number 3 i + 1 of the other, in another lane beside others.
    let (few, many) = (run_plan(&model, &plan(21), Work::Full), run_plan(&model, &plan(63), Work::Full));
    let bare = run_plan(&model, &plan(63), Work::Bare);
    for (index, run) in few.runs.iter().enumerate() {
        let other = &many.runs[3 * index + 1];
        let clearances_m = [model.clearance_of_m(index, 21), model.clearance_of_m(3 * index + 1, 63)];
        assert_eq!(clearances_m[0], clearances_m[1], "(2 i + 1)/21 and (6 i + 3)/63 are the same number");
        assert_eq!((&run.readings, run.events), (&other.readings, other.events), "run {index}");
    }
    for (run, bare) in many.runs.iter().zip(&bare.runs) {
        assert_eq!((run.end_m.to_bits(), run.events), (bare.end_m.to_bits(), bare.events), "run {}", run.index);
        assert!(run.energy_residual < ENERGY_TOLERANCE, "run {}: {}", run.index, run.energy_residual);
    }
}

#[test]
fn identity_the_error_is_that_of_the_library_at_the_same_tolerance() {
    let Some(model) = model() else { return };
    // The library's 90 % quantile over the same clearances at 1e-8 m is 2.2e-9 m. Ten times as much would be another accuracy.
    let errors_m = errors_m(&model, 41);
    assert!(errors_m[20] < 5e-9 && errors_m[36] < 2.2e-8, "median {}, 90 % {}", errors_m[20], errors_m[36]);
}
