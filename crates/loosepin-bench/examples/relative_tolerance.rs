//! Evaluations and errors of `cases/flexible_slider_crank` over 2 and 10 ms by tolerance: which one gives positions a relative error of 1e-6.
//!
//! `cargo run --package loosepin-bench --example relative_tolerance`. The error of a run is the largest distance of the slider from its place in the
//! reference run, over the largest displacement of the slider in that time; measured/performance.md has the table.

use loosepin::simulate::Settings;
use loosepin_bench::diagram::with_thousands_separators;
use loosepin_bench::precision::{Case, Samples};
use loosepin_bench::precision_cases::FLEXIBLE_CASES;

/// Durations of which the first half is run, and the largest displacement of the slider of the ideal mechanism in that half, m:
/// r (1 - cos ωt) + l (1 - √(1 - (r/l)² sin² ωt)) with r = 0.15 m, l = 0.3 m, ω = 150 rad/s.
const SPANS: [&[(&str, &str)]; 2] =
    [&[("duration = \"10 ms\"", "duration = \"4 ms\"")], &[("duration = \"10 ms\"", "duration = \"20 ms\"")]];

/// Tolerance of the reference, and that of the runs that check it, m.
const REFERENCE_M: f64 = 1e-13;
const CHECK_M: f64 = 1e-12;

/// Displacement of the slider, m.
fn displacement_m(time_s: f64) -> f64 {
    let (crank_m, rod_m) = (0.15_f64, 0.3_f64);
    let (sine, cosine) = (150.0 * time_s).sin_cos();
    crank_m * (1.0 - cosine) + rod_m * (1.0 - (1.0 - (crank_m / rod_m * sine).powi(2)).sqrt())
}

fn main() {
    for (changes, end_s) in SPANS.into_iter().zip([2e-3, 10e-3]) {
        let samples = Samples::new(&Case { changes, ..FLEXIBLE_CASES[0] });
        let of = |tolerance_m| Settings { tolerance_m, ..Settings::for_study() };
        let reference = samples.run(&of(REFERENCE_M));
        let moved_m = displacement_m(end_s);
        println!("{} ms: the slider moves by {:.1} mm", end_s * 1e3, moved_m * 1e3);
        println!("| tolerance | evaluations | error, median | 90 % | worst | 90 % over displacement |");
        println!("|---|--:|--:|--:|--:|--:|");
        for tolerance_m in [1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, CHECK_M] {
            let point = samples.measure(&of(tolerance_m), &reference);
            let [median_m, quantile_m, worst_m] = [point.median_m, point.quantile_m, point.worst_m];
            let evaluations = with_thousands_separators(point.evaluations as f64);
            let relative = quantile_m / moved_m;
            println!(
                "| {tolerance_m:.0e} m | {evaluations} | {median_m:.1e} m | {quantile_m:.1e} m | {worst_m:.1e} m | {relative:.1e} |"
            );
        }
    }
}
