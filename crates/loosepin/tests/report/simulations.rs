//! What is said of single runs.

use loosepin::mechanism::Mechanism;
use loosepin::model::{Cycle, Model};
use loosepin::report::{simulation_page, simulation_text};
use loosepin::simulate::record::{DriveSense, QuasiStaticShare, SimulationRecord};
use loosepin::simulate::{Plan, Settings, simulate};
use loosepin::units::SiUnit;
use std::path::Path;

fn model(file: &str) -> Model {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(file);
    Model::from_path(&path).unwrap_or_else(|diagnostics| panic!("{diagnostics}"))
}

fn simulated(model: &Model, cycle: Cycle) -> SimulationRecord {
    let values = model.quantities.nominal();
    let mechanism = Mechanism::new(model, &values).unwrap_or_else(|error| panic!("{error}"));
    let plan = Plan {
        cycle,
        settings: Settings::for_simulation(),
        with_states: false,
        lyapunov_turns: None,
        second_run: false,
        overrides: Vec::new(),
    };
    simulate(&mechanism, &values, &plan).unwrap_or_else(|failure| panic!("{failure}")).record
}

#[test]
fn an_output_whose_name_ends_as_a_deviation_is_still_told_as_itself() {
    let mut record = super::report_fixture::simulation::worn_pin();
    for extreme in record.extremes.iter_mut().filter(|extreme| extreme.name == "slider") {
        extreme.name = "slider_deviation".to_owned();
    }
    record.outputs[0].name = "slider_deviation".to_owned();
    let text = simulation_text(&record);
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(
        text.contains("the slider_deviation deviates from its ideal motion by -0.5377 mm to 0.5388 mm."),
        "the deviation, not the position of 69 to 170 mm: {text}"
    );
    assert!(text.contains("slider_deviation, deviation -0.5377 mm"), "{text}");
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
            "No output deviates more than clearances and penetrations permit. The slider has the largest share: 95.8 % of the permitted deviation."
        ),
        "{}",
        words(&record)
    );
    let check = &mut record.quasi_static_check[0];
    (check.is_exceeded, check.deviation_si) = (true, -5.5e-4);

    assert!(
        words(&record).contains(
            "This run is wrong: the slider deviates by -0.5500 mm at 4.000 ms, but clearances and penetrations permit only -0.5329 mm."
        ),
        "{}",
        words(&record)
    );
    record.quasi_static_check[0].samples_without_worst_case = 3;
    assert!(
        words(&record).contains(
            "The slider deviates by -0.5500 mm at 4.000 ms, but clearances and penetrations permit only -0.5329 mm in this assembly of the links. Either a dead point lies within the clearances, where the links can change to the other assembly, or this run is wrong: avoid the dead point to find out. 3 samples could not be checked: a dead point lies within the clearances, or a \
             slider overhangs its guide."
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
    let said = simulation_text(&record).split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(
        said.contains(
            "Control servo: load does not come to rest although its reference does. It oscillates with amplitude 0.20"
        ) && said.contains("and period 0.3918 s (a limit cycle, 14 oscillations)."),
        "{said}"
    );
    let page = simulation_page(&record);
    assert!(page.contains("does not come to rest although its reference does"));
}

#[test]
fn identity_a_run_tells_its_drawing_drives_outputs_and_forces_on_the_rim() {
    let model = model("../../cases/slider_crank_5000/model.toml");
    let mut cycle = model.cycle.clone();
    (cycle.transient_turns, cycle.recorded_turns, cycle.samples_per_turn) = (0.0, 0.2, 1000);
    let record = simulated(&model, cycle);
    let drive = &record.drawing.drives[0];
    assert_eq!(record.drawing.drives.len(), 1);
    assert_eq!((drive.name.as_str(), drive.sense), ("crank", DriveSense::Forward));
    assert_eq!(record.drawing.joints[drive.joint].name, "main");
    let output = &record.drawing.output_points[0];
    let body = &record.drawing.bodies[output.point.body];
    let names = (output.name.as_str(), body.name.as_str(), body.points[output.point.point].name.as_str());
    assert_eq!(names, ("slider", "slider", "pin"));
    assert_eq!(record.drawing.output_points.len(), 1, "velocities and forces have no place");
    let orbit = &record.orbits[0];
    assert_eq!(orbit.drive_angle_rad, record.drive_angle_rad);
    // A force acts on the rim alone: the laws are those of penetration.
    let mut touching = 0;
    for (sample, force_n) in orbit.force_n.iter().enumerate().filter(|(_, force_n)| **force_n > 0.0) {
        touching += 1;
        let radius_m = orbit.x_m[sample].hypot(orbit.y_m[sample]);
        assert!(radius_m >= orbit.radial_clearance_m, "{force_n} N at {radius_m} m");
    }
    assert!(touching > 3, "{touching} of {} samples", orbit.force_n.len());
    assert!(orbit.force_n.len() > touching, "it flies as well");
}

#[test]
fn a_motion_tells_its_drawing_what_goes_to_and_fro() {
    use loosepin::accuracy::{MotionPlan, motion};
    let model = model("../loosepin-import/templates/double-slider/model.toml");
    let values = model.quantities.nominal();
    let mechanism = Mechanism::new(&model, &values).unwrap_or_else(|error| panic!("{error}"));
    let (span, overrides) = (model.cycle.span, Vec::new());
    let plan = MotionPlan {
        span,
        positions: 12,
        scatter: Vec::new(),
        correlations: Vec::new(),
        paths: Vec::new(),
        asked: Vec::new(),
        overrides,
    };
    let record = motion(&mechanism, &values, &plan).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(record.drawing.drives[0].sense, DriveSense::ToAndFro);
    let drawn: Vec<&str> = record.drawing.output_points.iter().map(|output| output.name.as_str()).collect();
    assert_eq!(drawn, ["pen_x", "pen_y", "drawn"]);
}
