//! Mechanisms with flexible links: against histories of another program, energy, momenta, and other trees of the same mechanism.

mod condensed;
mod estimates;
mod histories;
mod implicit;
mod laws;
mod lumps;
mod nodal;
mod nodal_settled;
mod nodal_turns;
mod points;
mod refusals;
mod settled;
mod stress;
mod trees;

use crate::elements::{Built, build};
use loosepin_result::simulation::SimulationRecord;
use loosepin_simulate::{Plan, RunFailure, Settings, simulate};

/// A run that is tighter than usual.
fn outcome(text: &str) -> Result<SimulationRecord, RunFailure> {
    let built = build(text);
    let plan = Plan {
        settings: Settings { tolerance_m: 1e-12, ..Settings::for_simulation() },
        ..Plan::of_model(&built.mechanism.model)
    };
    simulate(&built.mechanism, &built.values, &plan).map(|simulation| simulation.record)
}

fn record(text: &str) -> SimulationRecord {
    outcome(text).unwrap_or_else(|failure| panic!("{failure}"))
}

/// A run to a tolerance.
fn record_of(built: &Built, tolerance_m: f64) -> SimulationRecord {
    let plan = Plan {
        settings: Settings { tolerance_m, ..Settings::for_simulation() },
        ..Plan::of_model(&built.mechanism.model)
    };
    simulate(&built.mechanism, &built.values, &plan).unwrap_or_else(|failure| panic!("{failure}")).record
}

fn record_within(text: &str, tolerance_m: f64) -> SimulationRecord {
    record_of(&build(text), tolerance_m)
}

/// Text with the table of the joint `moved` before that of the joint `before`.
fn reordered(text: &str, moved: &str, before: &str) -> String {
    let start = text.find(&format!("[joint.{moved}]")).expect("the joint");
    let end = start + text[start..].find("\n\n").expect("its end") + 2;
    let (table, rest) = (text[start..end].to_owned(), format!("{}{}", &text[..start], &text[end..]));
    rest.replace(&format!("[joint.{before}]"), &format!("{table}[joint.{before}]"))
}

/// Values of an output of a run.
fn values<'r>(record: &'r SimulationRecord, output: &str) -> &'r [f64] {
    &record.outputs.iter().find(|history| history.name == output).expect("an output").value_si
}

/// Largest difference of two runs in an output.
fn apart(one: &SimulationRecord, other: &SimulationRecord, output: &str) -> f64 {
    let [one, other] = [one, other].map(|record| values(record, output));
    assert_eq!(one.len(), other.len());
    one.iter().zip(other).fold(0.0, |apart, (one, other)| apart.max((one - other).abs()))
}

/// The text of the case `flexible_four_bar` with a rigid coupler of the same mass.
fn four_bar_with_rigid_coupler() -> String {
    let text = case_text("flexible_four_bar");
    let start = text.find("[body.coupler]").expect("the coupler");
    let end = start + text[start..].find("[body.rocker]").expect("the rocker");
    let rigid = "[body.coupler]\nmass = \"0.2028 kg\"\ninertia = \"0.2028 kg * coupler_length^2 / 12\"\n\
                 centre_of_mass = [\"coupler_length / 2\", \"0 mm\"]\n\
                 points = { tail = [\"0 mm\", \"0 mm\"], head = [\"coupler_length\", \"0 mm\"] }\n\n";
    format!("{}{rigid}{}", &text[..start], &text[end..])
}

/// The text of the model of a folder of `cases`.
fn case_text(name: &str) -> String {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases").join(name).join("model.toml");
    std::fs::read_to_string(path).expect("the case is there")
}

/// Outputs that [`assert_power_of_the_drive`] reads.
const POWER_OUTPUTS: &str = "\n[output.pin_x]\nforce_in = \"joint.crank_pin\"\ncomponent = \"x\"\n\
                             [output.pin_y]\nforce_in = \"joint.crank_pin\"\ncomponent = \"y\"\n[output.torque]\ntorque_of = \"drive.crank\"\n";

/// The crank of 0.15 m turns evenly about its centre of mass at 150 rad/s: the power of its drive is that of the force in the crank pin.
fn assert_power_of_the_drive(record: &SimulationRecord) {
    let mut largest = 0.0_f64;
    for (row, time_s) in record.time_s.iter().enumerate() {
        let (sine, cosine) = (150.0 * time_s).sin_cos();
        let due = 0.15 * (cosine * values(record, "pin_y")[row] - sine * values(record, "pin_x")[row]);
        let torque = values(record, "torque")[row];
        largest = largest.max(torque.abs());
        assert!((torque - due).abs() < 1e-9 * largest.max(1.0), "at {time_s} s: {torque} N m for {due}");
    }
    assert!(largest > 50.0, "{largest}");
}
