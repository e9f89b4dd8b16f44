//! Processor time of the runs at values of the unknowns: `cargo run --release --package loosepin-bench --example cost_of_values COUNT`.
//! Prints which values are kept as well, which must not change where only the time does.

use loosepin::identify::{CONFIDENCE, MotionRig, MotionValues};
use loosepin::study::{MeasuredMotion, Study};
use loosepin_bench::{case_file, processor_time};

fn main() {
    let count = std::env::args().nth(1).and_then(|count| count.parse().ok()).unwrap_or(4);
    let path = case_file("slider_crank_worn_pin", "measured.toml");
    let study = Study::from_path(&path).unwrap_or_else(|complaints| panic!("{complaints}"));
    let features: Vec<&MeasuredMotion> = study.motion.iter().collect();
    let values_si: Vec<f64> = features.iter().filter_map(|feature| feature.mean_si()).collect();
    let asked =
        MotionValues { confidence: CONFIDENCE, points: count, threads: 0, with_posterior: false, with_lengths: false };
    let mut rig = MotionRig::new(&study, &features, &asked, 0).unwrap_or_else(|complaints| panic!("{complaints}"));
    let begin = processor_time::of_process_ns();
    let kept = rig.kept(&[count], &values_si).unwrap_or_else(|complaints| panic!("{complaints}"));
    let spent_s = (processor_time::of_process_ns() - begin) as f64 * 1e-9;
    println!("{count} values: {spent_s:.2} processor s, {:.3} a value; kept {kept:?}", spent_s / count as f64);
}
