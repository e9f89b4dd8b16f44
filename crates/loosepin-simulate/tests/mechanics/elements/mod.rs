//! Springs, dampers, loads, motions of drives and initial states against closed forms and against the energy account.

mod backlash;
mod cams;
mod control;
mod couplings;
mod drives;
mod efforts;
mod expressions;
mod initial;
mod joint_friction;
mod lift_off;
mod load_tables;
mod loads;
mod neighbours;
mod offsets;
mod power_balance;
mod springs;
mod tooth_forces;
mod warm;

use loosepin_mechanics::mechanism::{Mechanism, Sample};
use loosepin_mechanics::model::{Model, Values};
use loosepin_simulate::{Observer, RunReport, Settings, Step, Window, run};
use std::path::Path;

/// A compiled mechanism with its values.
pub(crate) struct Built {
    pub(crate) values: Values,
    pub(crate) mechanism: Mechanism,
}

impl Built {
    pub(crate) fn sample(&self) -> Sample<f64> {
        Sample::new(&self.mechanism, &self.values).expect("the values fit the mechanism")
    }
}

pub(crate) fn build(text: &str) -> Built {
    let model = Model::from_text("model.toml", text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let values = model.quantities.nominal();
    let mechanism = Mechanism::new(&model, &values).unwrap_or_else(|error| panic!("{}: {error}", model.name));
    Built { values, mechanism }
}

/// The text of a model of `tests/files`.
pub(crate) fn file(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/files").join(name);
    std::fs::read_to_string(path).expect("the file is there")
}

struct Nobody;

impl Observer for Nobody {
    fn step(&mut self, _step: &mut Step<'_, '_>) {}
}

/// The report of a run from time zero to `end_s`.
pub(crate) fn report(built: &Built, end_s: f64) -> RunReport {
    let window = Window { start_s: 0.0, end_s };
    run(&built.mechanism, &built.sample(), &window, &Settings::for_simulation(), &mut Nobody)
        .unwrap_or_else(|failure| panic!("{failure}"))
}

/// A crank of 50 mm that is driven at `speed`, with `elements` added.
pub(crate) fn crank(speed: &str, elements: &str) -> Built {
    crank_with_drive(&format!("speed = \"{speed}\"\nstart_angle = \"20 deg\""), "drive = \"crank\"", elements)
}

/// A crank with any motion and any cycle.
pub(crate) fn crank_with_drive(motion: &str, cycle: &str, elements: &str) -> Built {
    build(&crank_text(motion, cycle, elements))
}

/// Its text.
pub(crate) fn crank_text(motion: &str, cycle: &str, elements: &str) -> String {
    format!(
        r#"
name = "crank"
gravity = "0 m/s^2"
[body.ground]
points = {{ o = ["0 mm", "0 mm"], anchor = ["70 mm", "-20 mm"] }}
[body.crank]
mass = "0.3 kg"
inertia = "1e-4 kg m^2"
centre_of_mass = ["25 mm", "0 mm"]
points = {{ main = ["0 mm", "0 mm"], pin = ["50 mm", "0 mm"] }}
[joint.main]
kind = "revolute"
bearing = "ground.o"
journal = "crank.main"
{elements}
[drive.crank]
joint = "main"
{motion}
[cycle]
{cycle}
"#
    )
}
