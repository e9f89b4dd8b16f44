//! One revolution of the slider-crank of `cases/slider_crank_5000`, on one thread: simulations per second, right-hand
//! sides per revolution, nanoseconds each.

use criterion::{Criterion, criterion_group, criterion_main};
use loosepin::mechanism::{Mechanism, Sample};
use loosepin::model::{Model, QuantityId, Values};
use loosepin::simulate::{Observer, Settings, Step, Window, run};
use loosepin_bench::Throughput;
use std::hint::black_box;
use std::path::Path;

/// Samples of the bench: clearance and restitution differ, so that no branch predictor learns one run by heart.
const SAMPLES: usize = 64;

/// Looks at nothing.
struct Nobody;

impl Observer for Nobody {
    fn step(&mut self, _step: &mut Step<'_, '_>) {}
}

struct Bench {
    mechanism: Mechanism,
    samples: Vec<Sample<f64>>,
    turn_s: f64,
}

fn prepare() -> Bench {
    let case = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/slider_crank_5000/model.toml");
    let model = Model::from_path(&case).unwrap_or_else(|complaints| panic!("{complaints}"));
    let clearance = id(&model, "joint.gudgeon.radial_clearance");
    let nominal = model.quantities.nominal();
    let mechanism = Mechanism::new(&model, &nominal).expect("the case is a mechanism");
    let samples = (0..SAMPLES)
        .map(|k| {
            let clearance_m = 0.45e-3 + 0.1e-3 * k as f64 / SAMPLES as f64;
            let values: Values =
                model.quantities.evaluate(&[(clearance, clearance_m)]).expect("the clearance is possible");
            Sample::new(&mechanism, &values).expect("the sample fits the mechanism")
        })
        .collect();
    let turn_s = model.cycle_input(&nominal).turn_s();
    Bench { mechanism, samples, turn_s }
}

fn id(model: &Model, path: &str) -> QuantityId {
    model.quantities.id(path).expect("the case has this quantity")
}

impl Bench {
    /// Runs sample `index` for one turn without looking at it; gives the number of right-hand sides.
    fn revolution(&self, index: usize, settings: &Settings) -> u64 {
        let window = Window { start_s: self.turn_s, end_s: self.turn_s };
        let report = run(&self.mechanism, &self.samples[index % SAMPLES], &window, settings, &mut Nobody);
        report.expect("the runs of the case succeed").counters.evaluations
    }
}

fn benches(criterion: &mut Criterion) {
    let bench = prepare();
    for tolerance_m in [1e-8, 1e-9] {
        let settings = Settings { tolerance_m, ..Settings::for_simulation() };
        let throughput = Throughput::measure(4 * SAMPLES, |index| bench.revolution(index, &settings));
        println!("slider-crank revolution, tolerance {tolerance_m:e} m: {throughput}");
    }
    let settings = Settings { tolerance_m: 1e-8, ..Settings::for_simulation() };
    let mut index = 0;
    criterion.bench_function("slider-crank revolution, 1e-8 m", |bencher| {
        bencher.iter(|| {
            index += 1;
            black_box(bench.revolution(index, &settings))
        });
    });
}

criterion_group!(revolution, benches);
criterion_main!(revolution);
