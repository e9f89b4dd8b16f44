//! What is said of single runs.

use loosepin::mechanism::Mechanism;
use loosepin::model::{Cycle, Model};
use loosepin::report::{simulation_page, simulation_text};
use loosepin::simulate::record::{QuasiStaticShare, SimulationRecord};
use loosepin::simulate::{Plan, Settings, simulate};
use loosepin::units::SiUnit;
use std::path::Path;

fn model(file: &str) -> Model {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(file);
    Model::from_path(&path).unwrap_or_else(|complaints| panic!("{complaints}"))
}

fn simulated(model: &Model, cycle: Cycle) -> SimulationRecord {
    let values = model.quantities.nominal();
    let mechanism = Mechanism::new(model, &values).unwrap_or_else(|error| panic!("{error}"));
    let plan = Plan {
        cycle,
        settings: Settings::for_simulation(),
        with_states: false,
        lyapunov_turns: None,
        overrides: Vec::new(),
    };
    simulate(&mechanism, &values, &plan).unwrap_or_else(|failure| panic!("{failure}")).record
}

#[test]
fn text_of_the_check() {
    let model = model("../../cases/slider_crank_5000/model.toml");
    let mut cycle = model.cycle.clone();
    (cycle.transient_turns, cycle.recorded_turns, cycle.samples_per_turn) = (0.0, 0.05, 100);
    let mut record = simulated(&model, cycle);
    record.quasi_static_check = vec![QuasiStaticShare {
        output: "slider".to_owned(),
        unit: SiUnit::LENGTH,
        largest_share: 0.95712,
        time_s: Some(4e-3),
        deviation_si: -5.1e-4,
        worst_case_si: -5.3286e-4,
        is_exceeded: false,
        samples_without_worst_case: 0,
    }];
    let words = |record: &SimulationRecord| simulation_text(record).split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(
        words(&record).contains(
            "No output deviates more than clearances and penetrations allow. The slider comes nearest, with 95.8 % of the allowed \
             deviation."
        ),
        "{}",
        words(&record)
    );
    let check = &mut record.quasi_static_check[0];
    (check.is_exceeded, check.deviation_si, check.samples_without_worst_case) = (true, -5.5e-4, 3);
    assert!(
        words(&record).contains(
            "This run is wrong: the slider deviates by -0.5500 mm, but clearances and penetrations allow only -0.5329 mm. 3 samples \
             could not be checked: a dead point lies within the clearances, or a slider overhangs its guide."
        ),
        "{}",
        words(&record)
    );
}

/// The swing itself is held against another program by `peer_backlash_keeps_a_servo_swinging`.
#[test]
fn text_of_a_servo_that_keeps_swinging() {
    let model = model("../loosepin-simulate/tests/files/backlash.toml");
    let record = simulated(&model, model.cycle.clone());
    let said = simulation_text(&record).replace('\n', " ");
    assert!(
        said.contains(
            "Control servo: load does not come to rest although its reference does. It oscillates with amplitude 0.20"
        ) && said.contains("and period 0.3918 s (a limit cycle, 14 oscillations)."),
        "{said}"
    );
    let page = simulation_page(&record);
    assert!(page.contains("does not come to rest although its reference does"));
}
