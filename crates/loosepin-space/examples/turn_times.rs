//! Time of what is known of models over their turn: `cargo run --release -p loosepin-space --example turn_times -- [--print] FILE...`; with
//! `--print` all numbers of the records instead of times.

use loosepin_space::SpatialModel;
use std::error::Error;
use std::path::Path;
use std::time::Instant;

/// Records of each model.
const RECORDS: usize = 15;

fn main() -> Result<(), Box<dyn Error>> {
    let (words, files): (Vec<String>, Vec<String>) = std::env::args().skip(1).partition(|word| word == "--print");
    for file in files {
        let model = SpatialModel::from_path(Path::new(&file))?;
        let values = model.quantities.nominal();
        if !words.is_empty() {
            println!("{file} {:#?}", model.motion_record(&values)?);
            continue;
        }
        let mut times_ms = Vec::with_capacity(RECORDS);
        for _ in 0..RECORDS {
            let started = Instant::now();
            model.motion_record(&values)?;
            times_ms.push(started.elapsed().as_secs_f64() * 1e3);
        }
        times_ms.sort_by(f64::total_cmp);
        println!("{file}: best {:.2} ms, median {:.2} ms", times_ms[0], times_ms[RECORDS / 2]);
    }
    Ok(())
}
