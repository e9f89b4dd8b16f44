//! Processor time of the runs at values of the unknowns: `cargo run --release --package loosepin-identify --example cost_of_values COUNT`.
//! Prints which values are kept as well, which must not change where only the time does.

use loosepin_identify::{CONFIDENCE, MotionRig, MotionValues};
use loosepin_study::{MeasuredMotion, Study};
use std::path::Path;

/// Processor time of this process so far, s: user and system, in hundredths.
fn processor_s() -> f64 {
    let text = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    let after = text.rsplit(')').next().unwrap_or_default();
    let ticks = |place: usize| after.split_whitespace().nth(place).and_then(|t| t.parse::<f64>().ok()).unwrap_or(0.0);
    // Fields 14 and 15 of the line, of which two stand before the bracket.
    (ticks(11) + ticks(12)) / 100.0
}

fn main() {
    let count = std::env::args().nth(1).and_then(|count| count.parse().ok()).unwrap_or(4);
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/slider_crank_worn_pin");
    let study = Study::from_path(&folder.join("measured.toml")).unwrap_or_else(|complaints| panic!("{complaints}"));
    let features: Vec<&MeasuredMotion> = study.motion.iter().collect();
    let values_si: Vec<f64> = features.iter().filter_map(|feature| feature.mean_si()).collect();
    let asked = MotionValues { confidence: CONFIDENCE, points: count, threads: 0 };
    let mut rig = MotionRig::new(&study, &features, &asked, 0).unwrap_or_else(|complaints| panic!("{complaints}"));
    let before_s = processor_s();
    let kept = rig.kept(&[count], &values_si).unwrap_or_else(|complaints| panic!("{complaints}"));
    let spent_s = processor_s() - before_s;
    println!("{count} values: {spent_s:.2} processor s, {:.3} a value; kept {kept:?}", spent_s / count as f64);
}
