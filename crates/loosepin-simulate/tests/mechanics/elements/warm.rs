//! Parts that are warmer than their drawings, against closed forms.

use super::{build, crank, crank_text};
use loosepin_mechanics::model::{JointKind, Model, Prismatic, Revolute, Slot};
use loosepin_simulate::{Plan, simulate};

/// Round-off of lengths of about 0.1 m, and of angles.
const ROUND_OFF: f64 = 1e-15;

#[test]
fn analytic_a_warm_crank_is_longer() {
    let warm = "thermal_expansion = \"23e-6 1/K\"\ntemperature_rise = \"80 K\"\n";
    let outputs = "[output]\nx = { position_of = \"crank.pin\", along = \"x\" }\n";
    let text = crank_text("speed = \"130 rad/s\"\nstart_angle = \"20 deg\"", "drive = \"crank\"", outputs);
    let built = build(&text.replace("inertia = \"1e-4", &format!("{warm}inertia = \"1e-4")));
    let record =
        simulate(&built.mechanism, &built.values, &Plan::of_model(&built.mechanism.model)).expect("it turns").record;
    let growth: f64 = 1.0 + 23e-6 * 80.0;
    for (&time_s, &x_m) in record.time_s.iter().zip(&record.outputs[0].value_si) {
        let exact_m = 0.05 * growth * (20_f64.to_radians() + 130.0 * time_s).cos();
        assert!((x_m - exact_m).abs() < 1e-12 * 0.05, "{x_m} {exact_m}");
    }
    let body = &built.mechanism.model.bodies[1];
    let value = |id: loosepin_mechanics::model::QuantityId| built.values[id];
    let [mass, inertia] = [body.mass_kg, body.inertia_kg_m2].map(|id| value(id.expect("a moving body")));
    let centre_m = value(body.centre_of_mass_m.expect("a moving body")[0]);
    // Mass stays, and is spread over a body that is larger in all directions.
    assert_eq!(mass, 0.3);
    assert!((inertia / (1e-4 * growth * growth) - 1.0).abs() < ROUND_OFF);
    assert!((centre_m / (0.025 * growth) - 1.0).abs() < ROUND_OFF);
}

/// A four-bar that grows alike in all its parts, the frame too, keeps its angles.
#[test]
fn identity_what_grows_alike_keeps_its_angles() {
    const FOUR_BAR: &str = r#"
name = "four-bar"
gravity = "0 m/s^2"
RISE
[body.ground]
points = { o = ["0 mm", "0 mm"], pivot = ["300 mm", "10 mm"] }
EXPANSION
[body.crank]
mass = "0.2 kg"
inertia = "1e-4 kg m^2"
centre_of_mass = ["40 mm", "0 mm"]
points = { main = ["0 mm", "0 mm"], pin = ["80 mm", "0 mm"] }
EXPANSION
[body.coupler]
mass = "0.5 kg"
inertia = "2.5e-3 kg m^2"
centre_of_mass = ["130 mm", "0 mm"]
points = { tail = ["0 mm", "0 mm"], head = ["260 mm", "0 mm"], tool = ["130 mm", "90 mm"] }
EXPANSION
[body.rocker]
mass = "0.3 kg"
inertia = "1e-3 kg m^2"
centre_of_mass = ["90 mm", "0 mm"]
points = { pivot = ["0 mm", "0 mm"], pin = ["180 mm", "0 mm"] }
EXPANSION
[joint]
main = { kind = "revolute", bearing = "ground.o", journal = "crank.main" }
crank_pin = { kind = "revolute", bearing = "crank.pin", journal = "coupler.tail" }
rocker_pin = { kind = "revolute", bearing = "coupler.head", journal = "rocker.pin" }
pivot = { kind = "revolute", bearing = "ground.pivot", journal = "rocker.pivot" }
[drive.crank]
joint = "main"
speed = "60 rpm"
start_angle = "0 deg"
[assembly]
guess = { rocker = "110 deg" }
[cycle]
drive = "crank"
samples_per_turn = 36
[output]
rocker = { angle_of = "rocker" }
tool = { path_of = "coupler.tool" }
"#;
    let histories = |rise: &str, expansion: &str| {
        let built = build(&FOUR_BAR.replace("RISE", rise).replace("EXPANSION", expansion));
        let plan = Plan::of_model(&built.mechanism.model);
        let record = simulate(&built.mechanism, &built.values, &plan).expect("it turns").record;
        record.outputs.into_iter().map(|output| output.value_si).collect::<Vec<_>>()
    };
    let cold = histories("", "");
    let warm = histories("temperature_rise = \"200 K\"", "thermal_expansion = \"12e-6 1/K\"");
    let growth = 1.0 + 200.0 * 12e-6;
    for (cold, warm) in cold.iter().zip(&warm) {
        assert_eq!(cold.len(), warm.len());
    }
    let apart = |index: usize, factor: f64| {
        let both = cold[index].iter().zip(&warm[index]);
        both.map(|(cold, warm)| (cold * factor - warm).abs()).fold(0.0, f64::max)
    };
    assert!(apart(0, 1.0) < 1e-12, "the angle of the rocker: {}", apart(0, 1.0));
    assert!(apart(1, growth) < 1e-12 && apart(2, growth) < 1e-12, "the tool");
    // A part of its own warmth turns the rocker.
    let crank_alone = build(
        &FOUR_BAR
            .replace("RISE", "")
            .replacen("EXPANSION", "", 1)
            .replacen("EXPANSION", "thermal_expansion = \"12e-6 1/K\"\ntemperature_rise = \"200 K\"", 1)
            .replace("EXPANSION", ""),
    );
    let plan = Plan::of_model(&crank_alone.mechanism.model);
    let turned = simulate(&crank_alone.mechanism, &crank_alone.values, &plan).expect("it turns").record;
    let apart = cold[0].iter().zip(&turned.outputs[0].value_si).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(apart > 1e-4, "192 um of 80 mm turn the rocker by about a milliradian, not by {apart}");
}

/// A bronze bush on a steel pin, both warm: the hole grows more than the pin. And the other way round, and in guides and slots.
#[test]
fn analytic_play_of_parts_that_grow_differently() {
    const OUTER: f64 = 18e-6 * 50.0;
    const INNER: f64 = 12e-6 * 90.0;
    let model = |joint: &str| {
        let text = format!(
            r#"
name = "warm play"
gravity = "9.81 m/s^2"
temperature_rise = "50 K"
[body.ground]
points = {{ o = ["0 mm", "0 mm"] }}
thermal_expansion = "18e-6 1/K"
[body.part]
mass = "0.3 kg"
inertia = "1e-4 kg m^2"
centre_of_mass = ["25 mm", "0 mm"]
points = {{ p = ["0 mm", "0 mm"] }}
thermal_expansion = "12e-6 1/K"
temperature_rise = "90 K"
[contact.steel]
restitution = 0.9
stiffness = "1e10 N/m^1.5"
exponent = 1.5
[joint.play]
{joint}
contact = "steel"
[cycle]
duration = "0.1 s"
"#
        );
        Model::from_text("model.toml", &text).map_err(|diagnostics| diagnostics.to_string())
    };
    let read = |joint: &str| model(joint).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let close = |value: f64, exact: f64| assert!((value - exact).abs() < ROUND_OFF * 0.02, "{value} {exact}");
    let revolute = |clearance: &str| {
        format!(
            "kind = \"revolute\"\nbearing = \"ground.o\"\njournal = \"part.p\"\nbearing_radius = \"20 mm\"\n{clearance}"
        )
    };
    for clearance in ["radial_clearance = \"0.05 mm\"", "diametral_clearance = \"0.1 mm\""] {
        let model = read(&revolute(clearance));
        let JointKind::Revolute(Revolute { clearance: Some(play), .. }) = &model.joints[0].kind else {
            panic!("it has play")
        };
        let values = model.quantities.nominal();
        close(values[play.bearing_radius_m], 0.02 * (1.0 + OUTER));
        close(values[play.radial_clearance_m], 0.02 * (1.0 + OUTER) - 0.01995 * (1.0 + INNER));
    }
    // 20 mm times (18e-6 · 50 - 12e-6 · 90) are 3.6 um less: a pin with less play than that seizes.
    let said = model(&revolute("radial_clearance = \"3 um\"")).expect_err("the pin is too thick");
    assert!(said.contains("joint 'play': radial clearance when warm -0.0005967"), "{said}");
    assert!(said.contains("the joint seizes"), "{said}");

    // Nothing stated stays nothing, though the hole grows less than the pin.
    let model_without = read(&revolute("radial_clearance = \"0 mm\""));
    let JointKind::Revolute(Revolute { clearance: Some(play), .. }) = &model_without.joints[0].kind else {
        panic!("it may be set")
    };
    assert_eq!(model_without.quantities.nominal()[play.radial_clearance_m], 0.0);
    // Deviations count from the drawing: the same numbers without any growth.
    let quantities = &model_without.quantities;
    assert_eq!(quantities.at_drawing(&quantities.nominal())[play.bearing_radius_m], 0.02);

    let model = read(
        "kind = \"prismatic\"\nguide = { point = \"ground.o\", angle = \"0 deg\", start = \"-80 mm\", end = \"80 mm\" }\n\
         slider = \"part.p\"\nhalf_length = \"30 mm\"\nhalf_height = \"10 mm\"\nclearance = \"0.05 mm\"",
    );
    let JointKind::Prismatic(Prismatic { clearance: Some(play), .. }) = &model.joints[0].kind else {
        panic!("it has play")
    };
    let values = model.quantities.nominal();
    close(values[play.clearance_m], 0.01005 * (1.0 + OUTER) - 0.01 * (1.0 + INNER));
    close(values[play.half_height_m], 0.01 * (1.0 + INNER));
    close(values[play.half_length_m], 0.03 * (1.0 + INNER));
    close(values[play.ends_m.expect("it has ends")[1]], 0.08 * (1.0 + OUTER));

    let model = read(
        "kind = \"slot\"\nslot = { point = \"ground.o\", angle = \"0 deg\" }\npin = \"part.p\"\nhalf_length = \"30 mm\"\n\
         end_radius = \"5 mm\"\nclearance = \"0.05 mm\"",
    );
    let JointKind::Slot(Slot { clearance: Some(play), .. }) = &model.joints[0].kind else { panic!("it has play") };
    let values = model.quantities.nominal();
    close(values[play.clearance_m], 0.005 * (1.0 + OUTER) - 0.00495 * (1.0 + INNER));
    close(values[play.end_radius_m], 0.005 * (1.0 + OUTER));
    close(values[play.half_length_m], 0.03 * (1.0 + OUTER));
}

/// Without warmth there is nothing to compute: the same numbers in the same places.
#[test]
fn identity_parts_as_cold_as_their_drawing_are_as_drawn() {
    let built = crank("130 rad/s", "");
    let path = |id: loosepin_mechanics::model::QuantityId| built.mechanism.model.quantities[id].path.clone();
    assert_eq!(path(built.mechanism.model.bodies[1].points[1].position_m[0]), "body.crank.points.pin.x");
}
