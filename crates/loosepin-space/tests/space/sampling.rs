//! Samples of a model over its turn, against closed forms and against accuracies pose by pose.

use crate::known::{COUPLER, rssr_angle};
use loosepin_space::{PartOfOutput, PlaySide, SampledPart, SpatialModel, TurnSampler};
use loosepin_text::numbers::Values;

const RSSR: &str = include_str!("../../../../docs/examples/rssr-four-bar.toml");

fn model(text: &str) -> SpatialModel {
    SpatialModel::from_text("model.toml", text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"))
}

/// The values with some numbers of the file replaced.
fn with(model: &SpatialModel, changes: &[(&str, f64)]) -> Values {
    let set: Vec<_> = changes.iter().map(|(path, value)| (model.quantities.id(path).expect(path), *value)).collect();
    model.quantities.evaluate(&set).unwrap()
}

fn turns(count: usize) -> Vec<f64> {
    (0..count).map(|k| k as f64 / count as f64).collect()
}

fn part(output: usize, part: PartOfOutput) -> SampledPart {
    SampledPart { output, part }
}

#[test]
fn analytic_a_four_bar_with_balls_is_one_with_another_coupler() {
    let model = model(RSSR);
    let nominal = model.quantities.nominal();
    let turns = turns(12);
    let sampler = TurnSampler::new(&model, &nominal, &turns, &[part(0, PartOfOutput::Number)]).unwrap();
    let exact = sampler.clone().with_play_side(PlaySide::Exact).unwrap();
    for (change, clearance) in [(0.0, 2e-4), (1e-4, 1e-4), (-3e-3, 5e-4)] {
        let length = COUPLER + change;
        let values =
            with(&model, &[("body.coupler.points.rocker.x", length), ("joint.ball.radial_clearance", clearance)]);
        let (first, found) = (sampler.sample(&values).unwrap(), exact.sample(&values).unwrap());
        for (place, turn) in turns.iter().enumerate() {
            let psi = |length: f64| rssr_angle(std::f64::consts::TAU * turn, length);
            let by_length = psi(length) - psi(COUPLER);
            assert!((found.from_nominal_si[place] - by_length).abs() < 1e-12);
            let (plus, minus) = (psi(length + clearance) - psi(length), psi(length - clearance) - psi(length));
            let (largest, smallest) = if plus > minus { (plus, minus) } else { (minus, plus) };
            assert!((found.largest_si[place] - largest).abs() < 1e-12, "{} {largest}", found.largest_si[place]);
            assert!((found.smallest_si[place] - smallest).abs() < 1e-12);
            assert!((found.largest_from_nominal_si[place] - largest - by_length).abs() < 1e-12);
            // First order: half the width, but for the third derivative.
            let slope = 0.5 * (largest - smallest);
            assert!((first.largest_si[place] - slope).abs() < 1e-4 * slope && first.smallest_si[place] < 0.0);
        }
    }
}
