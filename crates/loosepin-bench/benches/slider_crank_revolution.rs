//! One revolution of the slider-crank of `cases/slider_crank_5000`, on one thread: simulations per second, right-hand
//! sides per revolution, nanoseconds each; and the work of both embedded pairs against the error of the slider's position.

use criterion::{Criterion, criterion_group, criterion_main};
use loosepin::integrate::{DOP853, DORMAND_PRINCE_5, Tableau};
use loosepin::mechanism::{Mechanism, Sample};
use loosepin::model::{Model, QuantityId, Values};
use loosepin::simulate::{Observer, Settings, Step, Window, run};
use loosepin_bench::Throughput;
use std::hint::black_box;
use std::path::Path;

/// Samples of the bench: clearance and restitution differ, so that no branch predictor learns one run by heart.
const SAMPLES: usize = 64;

/// Tolerances of the work-precision table, m.
const TOLERANCES_M: [f64; 5] = [1e-6, 1e-7, 1e-8, 1e-9, 1e-10];

/// Positions of all bodies at the end of the run.
struct End(Vec<f64>);

impl Observer for End {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        let kinematics = &step.end().kinematics;
        self.0 = kinematics.poses.iter().flat_map(|pose| [pose.position_m.x, pose.position_m.y]).collect();
    }
}

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
    let turn_s = std::f64::consts::TAU / nominal[model.drives[0].speed];
    Bench { mechanism, samples, turn_s }
}

fn id(model: &Model, path: &str) -> QuantityId {
    model.quantities.id(path).expect("the case has this quantity")
}

impl Bench {
    fn settings(&self, tolerance_m: f64, method: &'static Tableau) -> Settings {
        Settings { tolerance_m, method, ..Settings::for_simulation() }
    }

    /// Runs sample `index` for one turn without looking at it; gives the number of right-hand sides.
    fn revolution(&self, index: usize, settings: &Settings) -> u64 {
        let window = Window { start_s: self.turn_s, end_s: self.turn_s };
        let report = run(&self.mechanism, &self.samples[index % SAMPLES], &window, settings, &mut Nobody);
        report.expect("the runs of the case succeed").counters.evaluations
    }

    /// Positions after half a turn.
    fn half_turn(&self, index: usize, settings: &Settings) -> (Vec<f64>, u64) {
        let window = Window { start_s: 0.0, end_s: 0.5 * self.turn_s };
        let mut end = End(Vec::new());
        let report = run(&self.mechanism, &self.samples[index], &window, settings, &mut end);
        (end.0, report.expect("the runs of the case succeed").counters.evaluations)
    }
}

/// Evaluations over half a turn against the 90 % quantile of the position error, for both pairs.
fn work_precision(bench: &Bench) {
    let exact: Vec<Vec<f64>> =
        (0..SAMPLES).map(|k| bench.half_turn(k, &bench.settings(1e-13, &DOP853)).0).collect();
    println!("half a revolution, {SAMPLES} samples: tolerance, 90 % quantile of the position error, right-hand sides");
    for method in [&DOP853, &DORMAND_PRINCE_5] {
        for tolerance_m in TOLERANCES_M {
            let settings = bench.settings(tolerance_m, method);
            let mut evaluations = 0;
            let mut errors: Vec<f64> = (0..SAMPLES)
                .map(|k| {
                    let (found, work) = bench.half_turn(k, &settings);
                    evaluations += work;
                    found.iter().zip(&exact[k]).fold(0.0_f64, |worst, (a, b)| worst.max((a - b).abs()))
                })
                .collect();
            errors.sort_by(f64::total_cmp);
            let quantile_m = errors[SAMPLES * 9 / 10];
            let mean = evaluations as f64 / SAMPLES as f64;
            println!("{:>20} {tolerance_m:8.0e} m {quantile_m:8.1e} m {mean:8.0}", method.name);
        }
    }
}

fn benches(criterion: &mut Criterion) {
    let bench = prepare();
    for tolerance_m in [1e-8, 1e-9] {
        let settings = bench.settings(tolerance_m, &DOP853);
        let throughput = Throughput::measure(4 * SAMPLES, |index| bench.revolution(index, &settings));
        println!("slider-crank revolution, tolerance {tolerance_m:e} m: {throughput}");
    }
    work_precision(&bench);
    let settings = bench.settings(1e-8, &DOP853);
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
