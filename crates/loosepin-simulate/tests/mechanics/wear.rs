//! Wear of joints.

use loosepin_mechanics::mechanism::Mechanism;
use loosepin_mechanics::model::Model;
use loosepin_simulate::{Plan, Settings, Simulation, simulate};

const MODEL: &str = include_str!("../../../../cases/slider_crank_5000/model.toml");

fn text(clearance: &str, more: &str) -> String {
    let worn = format!(
        "bearing_length = \"20 mm\"\nwear.bearing = {{ coefficient = \"1e-15 m^2/N\" }}\nwear.journal = {{ coefficient = \"1e-15 m^2/N\" }}\n{more}"
    );
    let text = MODEL.replace("radial_clearance = \"0.5 mm\"\n", &format!("radial_clearance = \"{clearance}\"\n{worn}"));
    assert_ne!(text, MODEL);
    text
}

fn run(text: &str, turns: f64, tolerance_m: f64) -> Simulation {
    let model = Model::from_text("model.toml", text).unwrap_or_else(|complaints| panic!("{complaints}"));
    let values = model.quantities.nominal();
    let mechanism = Mechanism::new(&model, &values).unwrap_or_else(|error| panic!("{error}"));
    let mut plan = Plan::of_model(&mechanism.model);
    plan.cycle.recorded_turns = turns;
    plan.settings = Settings { tolerance_m, ..plan.settings };
    simulate(&mechanism, &values, &plan).unwrap_or_else(|failure| panic!("{failure}"))
}

#[test]
fn explore() {
    let text = text("0.5 mm", "wear.sectors = 72\n");
    for tolerance_m in [1e-9, 1e-10, 1e-11] {
        for (ms, w) in [(2.0, 14.259886), (4.0, 18.914855), (6.0, 26.862913), (12.0, 57.1644)] {
            let simulation = run(&text, ms / 12.0, tolerance_m);
            let wear = &simulation.record.wear[0];
            println!("{tolerance_m:e} {ms} {} {:e} {:?}", wear.friction_path_j, wear.friction_path_j / w - 1.0, wear.checks);
            if ms == 12.0 {
                for surface in &wear.surfaces {
                    println!("{:?} {:?} {:e} {:e} {:?}", surface.surface, surface.deepest_sector, surface.greatest_depth_m, surface.sum_of_sectors_error, &surface.depth_m[..3]);
                }
            }
        }
    }
    let text = text_ideal();
    for speed in ["5000 rpm", "300 rpm"] {
        let simulation = run(&text.replace("5000 rpm", speed), 1.0, 1e-9);
        let wear = &simulation.record.wear[0];
        println!("{speed} {} {:?}", wear.friction_path_j, wear.checks);
    }
}

fn text_ideal() -> String {
    text("0 mm", "")
}
