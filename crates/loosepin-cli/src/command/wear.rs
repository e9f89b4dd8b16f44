//! `loosepin wear`.

use loosepin::report::{simulation_page, wear_text};
use loosepin::result::json::Stored;
use loosepin::simulate::record::SimulationRecord;

use super::inputs::read_model;
use super::simulate::simulate_and_show;
use super::stored::StoredResult;
use crate::arguments::{IntegratorKind, ShownArguments, SimulateArguments, WearArguments};
use crate::ending::{Done, Ending};

/// Simulates a cycle or reads the stored simulation, and shows the wear of its joints.
pub fn run(arguments: &WearArguments) -> Ending {
    let WearArguments { model, set, turns, transient, tolerance, output } = arguments.clone();
    read_model(&model)?.demand_wear()?;
    let simulation = SimulateArguments {
        model,
        set,
        turns,
        transient,
        tolerance,
        output,
        shown: ShownArguments::default(),
        path: Vec::new(),
        states: false,
        samples: None,
        lyapunov: None,
        measured: Vec::new(),
        no_second_run: false,
        integrator: IntegratorKind::Explicit,
    };
    simulate_and_show::<ShownWear>(&simulation)
}

/// A simulation whose wear is shown.
struct ShownWear(SimulationRecord);

impl From<SimulationRecord> for ShownWear {
    fn from(record: SimulationRecord) -> Self {
        Self(record)
    }
}

impl Stored for ShownWear {
    fn to_json(&self) -> Result<String, serde_json::Error> {
        self.0.to_json()
    }

    fn from_json(text: &str) -> Result<Self, serde_json::Error> {
        SimulationRecord::from_json(text).map(Self)
    }
}

impl StoredResult for ShownWear {
    const PAGE: fn(&Self) -> String = |shown| simulation_page(&shown.0);
    const TEXT: fn(&Self) -> String = |shown| wear_text(&shown.0);

    fn done(&self) -> Done {
        self.0.done()
    }
}
