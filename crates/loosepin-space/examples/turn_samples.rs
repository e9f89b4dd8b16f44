//! Samples a second of the spatial slider-crank and the four-bar with two balls, 36 places of a turn, dimensions and clearances drawn at random:
//! `cargo run --release -p loosepin-space --example turn_samples`; a word after `--` takes only measurements whose names have it, as `exact`, and
//! files after it are measured in place of both mechanisms, each output of a number: `-- exact model.toml`.

use loosepin_space::{PartOfOutput, PlaySide, SampledPart, SpatialModel, TurnSampler};
use loosepin_text::numbers::{QuantityId, Values};
use std::error::Error;
use std::path::{Path, PathBuf};
use std::time::Instant;

const PLACES: usize = 36;
/// Relative spread of all lengths that are not zero.
const SPREAD: f64 = 2e-4;
/// How long each measurement takes, s.
const DURATION_S: f64 = 1.0;

type Result<T> = std::result::Result<T, Box<dyn Error>>;

fn main() -> Result<()> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/examples");
    let turns: Vec<f64> = (0..PLACES).map(|place| place as f64 / PLACES as f64).collect();
    let files: Vec<PathBuf> = std::env::args().skip(2).map(PathBuf::from).collect();
    let own = ["spatial-slider-crank", "rssr-four-bar"].map(|name| folder.join(format!("{name}.toml")));
    for file in if files.is_empty() { own.to_vec() } else { files } {
        let model = SpatialModel::from_path(&file)?;
        let name = model.name.clone();
        let values = drawn(&model)?;
        let parts = [SampledPart { output: 0, part: PartOfOutput::Number }];
        let sampler = TurnSampler::new(&model, &model.quantities.nominal(), &turns, &parts)?;
        for side in [PlaySide::None, PlaySide::FirstOrder, PlaySide::Exact] {
            let sampler = sampler.clone().with_play_side(side)?;
            measure(&format!("{name}, {side:?}"), &values, &|values| Ok(sampler.sample(values)?.largest_si[0]))?;
        }
        let uniforms = vec![0.3; sampler.uniforms_per_sample()];
        measure(&format!("{name}, drawn places"), &values, &|values| {
            Ok(sampler.sample_with_play(values, &uniforms)?.largest_si[0])
        })?;
    }
    Ok(())
}

/// Sets of values, all numbers of the file that are not zero off by up to the spread.
fn drawn(model: &SpatialModel) -> Result<Vec<Values>> {
    let is_drawn = |id: &QuantityId| model.quantities.nominal_value(*id) != 0.0 && model.quantities[*id].is_settable();
    let ids: Vec<QuantityId> = model.quantities.iter().map(|(id, _)| id).filter(is_drawn).collect();
    let ids: Vec<QuantityId> = ids
        .into_iter()
        .filter(|id| ["body.", "joint.", "parameter."].iter().any(|own| model.quantities[*id].path.starts_with(own)))
        .collect();
    let sets = (0..64).map(|sample| {
        let value = |(k, id): (usize, &QuantityId)| {
            (*id, model.quantities.nominal_value(*id) * (1.0 + SPREAD * ((7 * k + 13 * sample) as f64).sin()))
        };
        model.quantities.evaluate(&ids.iter().enumerate().map(value).collect::<Vec<_>>())
    });
    Ok(sets.collect::<std::result::Result<_, _>>()?)
}

fn measure(name: &str, values: &[Values], sample: &dyn Fn(&Values) -> Result<f64>) -> Result<()> {
    if std::env::args().nth(1).is_some_and(|word| !name.to_lowercase().contains(&word.to_lowercase())) {
        return Ok(());
    }
    let started = Instant::now();
    let (mut count, mut sum) = (0_usize, 0.0);
    while started.elapsed().as_secs_f64() < DURATION_S {
        for values in values {
            sum += sample(values)?;
            count += 1;
        }
    }
    let seconds = started.elapsed().as_secs_f64();
    let microseconds = seconds * 1e6 / (count * PLACES) as f64;
    let mean = sum / count as f64;
    println!("{name}: {:.0} samples/s, {microseconds:.2} µs a place (mean {mean:.6e})", count as f64 / seconds);
    Ok(())
}
