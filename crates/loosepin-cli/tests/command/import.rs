//! `loosepin import`, `loosepin export --to`, `--measured` and `--set` of a law.

use std::fs;

use super::command_line::Desk;

/// A crank of 30 mm on the ground, drawn with its pin and a tracer.
const DRAWING: &str = "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1015\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n\
    0\nLINE\n8\n0\n10\n1.5\n20\n2.5\n11\n31.5\n21\n2.5\n0\nCIRCLE\n8\nground\n10\n1.5\n20\n2.5\n40\n4.5\n\
    0\nCIRCLE\n8\n0\n10\n31.5\n20\n2.5\n40\n2.25\n0\nTEXT\n8\n0\n10\n5\n20\n5\n40\n2\n1\ncrank\n0\nENDSEC\n0\nEOF\n";

#[test]
fn a_drawing_becomes_a_model_that_asks_for_its_numbers() {
    let desk = Desk::new();
    desk.write("crank.dxf", DRAWING);
    let said = desk.succeed(&["import", "crank.dxf"]);
    assert_eq!(
        said.messages,
        "1 link, 1 joint, 1 point on links; lengths in mm\n\
         1 thing is neither line nor polyline nor circle, and ignored\n\
         wrote crank/model.toml; fill in every \"?\" in it\nnext: loosepin check crank/model.toml\n"
    );
    let refused = desk.run(&["check", "crank/model.toml"]);
    assert_eq!(refused.status, 2);
    assert_eq!(refused.messages.matches("error[E0209]").count(), 6, "{}", refused.messages);
    let text = desk.read("crank/model.toml");
    let text = text.replace("gravity = \"?\"", "gravity = \"9.81 m/s^2\"").replace("mass = \"?\"", "mass = \"0.3 kg\"");
    let text =
        text.replace("inertia = \"?\"", "inertia = \"2e-4 kg m^2\"").replace("speed = \"?\"", "speed = \"600 rpm\"");
    desk.write("crank/model.toml", &text.replace("[\"?\", \"?\"]", "[\"11 mm\", \"0 mm\"]"));
    desk.succeed(&["check", "crank/model.toml"]);
    let again = desk.run(&["import", "crank.dxf"]);
    assert_eq!(again.status, 2);
    assert_eq!(
        again.messages,
        "error[E0904]: crank/model.toml already exists; it is not overwritten\n\
         hint: give another folder, for example: loosepin import sketch.dxf my_mechanism\n"
    );
    desk.fail(
        &["import", "crnk.dxf"],
        "error[E0101]: cannot read crnk.dxf: there is no such file\nhint: did you mean 'crank.dxf'?",
    );
    desk.write("no_unit.dxf", &DRAWING.replace("$INSUNITS\n70\n4", "$INSUNITS\n70\n0"));
    assert_eq!(
        desk.run(&["import", "no_unit.dxf"]).messages,
        "error[E1102]: no_unit.dxf: the drawing does not give its unit: $INSUNITS is not set\n\
         hint: give it with --unit, for example --unit mm\n"
    );
    desk.succeed(&["import", "no_unit.dxf", "inches", "--unit", "in"]);
}

#[test]
fn a_robot_description_becomes_a_model_that_moves() {
    let desk = Desk::new();
    let arm = include_str!("../../../../docs/examples/two-axis-arm.urdf");
    // The name does not say what it is.
    desk.write("arm.txt", arm);
    let said = desk.succeed(&["import", "arm.txt"]);
    assert_eq!(
        said.messages,
        "read as a robot description: the name does not say what the file is (.dxf, .urdf, .xml or .mjcf would), and its first character is <\n\
         3 moving links, 3 joints\nthe root link 'base' is the ground\n\
         1 shape of links, with their meshes, ignored: a model has points and axes\n\
         wrote arm/model.toml\nnext: loosepin check arm/model.toml\n"
    );
    let checked = desk.succeed(&["check", "arm/model.toml"]).output;
    assert!(checked.contains("2 degrees of freedom, 2 drives: the motion is determined"), "{checked}");
    desk.succeed(&["motion", "arm/model.toml"]);
    let again = desk.run(&["import", "arm.txt"]);
    assert_eq!(again.status, 2);
    assert!(again.messages.contains("error[E0904]: arm/model.toml already exists"), "{}", again.messages);
    desk.write("arm.URDF", arm);
    desk.fail(
        &["import", "arm.URDF", "other", "--unit", "mm"],
        "error[E0905]: --unit is for drawings; robot descriptions are in metres",
    );
    desk.write("empty.urdf", "");
    desk.fail(
        &["import", "empty.urdf"],
        "empty.urdf:1:1: error[E1103]: the file is not XML that can be read: the document does not have a root node",
    );
    desk.write("wrong.urdf", &arm.replace("0 0 0.12", "0 0 0,12"));
    desk.fail(
        &["import", "wrong.urdf"],
        "wrong.urdf:29:13: error[E1103]: <origin> of joint 'swing': xyz is '0 0 0,12'; must be 3 numbers",
    );
}

#[test]
fn a_model_in_space_becomes_a_robot_description() {
    let desk = Desk::new();
    desk.write("model.toml", include_str!("../../../../docs/examples/spatial-slider-crank.toml"));
    let said = desk.succeed(&["export", "model.toml", "--to", "mjcf"]);
    assert!(said.messages.starts_with("the play of joint 'main' is not exported\n"), "{}", said.messages);
    assert!(said.messages.ends_with("wrote mjcf/spatial_slider-crank.xml\n"), "{}", said.messages);
    desk.succeed(&["import", "mjcf/spatial_slider-crank.xml", "back"]);
    desk.succeed(&["motion", "back/model.toml"]);
    desk.fail(
        &["export", "model.toml", "--to", "mjcf"],
        "error[E0904]: mjcf/spatial_slider-crank.xml already exists; it is not overwritten\nhint: give another folder, or replace it with --force",
    );
    desk.succeed(&["export", "model.toml", "--to", "mjcf", "--force"]);
    let refused = desk.run(&["export", "model.toml", "--to", "urdf"]);
    assert_eq!(refused.status, 2);
    let place = "error[E1105]: joint 'wrist' closes a loop, which URDF does not know";
    assert!(refused.messages.starts_with("model.toml:") && refused.messages.contains(place), "{}", refused.messages);
    let planar = Desk::with_model("slider_crank_5000");
    planar.fail(
        &["export", "model.toml", "--to", "urdf"],
        "error[E0905]: model.toml is not a model in space; robot descriptions are made of these alone\n\
         hint: a model in space has geometry = \"space\" at its top",
    );
}

#[test]
fn measured_curves_enter_hash_page_and_summary() {
    let desk = Desk::with_model("slider_crank_5000");
    desk.write("measured.csv", "crank [deg], slider [mm]\n0, 170.1\n18, 168.4\n");
    let run = |more: &[&str]| desk.run(&[&["simulate", "model.toml", "--turns", "0.1"], more].concat());
    let bare = run(&["--out", "bare"]);
    let with = run(&["--out", "with", "--measured", "measured.csv"]);
    assert_eq!((bare.status, with.status), (0, 0), "{}", with.messages);
    assert!(with.output.contains("residual: measured minus computed") && !bare.output.contains("residual"));
    let summary: serde_json::Value = serde_json::from_str(&desk.read("with/summary.json")).expect("JSON");
    assert_eq!(summary["measured"][0]["output"], "slider");
    assert_eq!(summary["repeat"]["command"], "loosepin simulate model.toml --turns 0.1 --measured measured.csv");
    let last = &summary["repeat"]["files"][1];
    assert_eq!((last["name"].as_str(), last["role"].as_str()), (Some("measured.csv"), Some("measured")));
    assert_eq!(last["text"], desk.read("measured.csv"));
    assert!(!desk.read("bare/summary.json").contains("measured.csv"));
    // The same folder with other measured values holds something else.
    desk.write("measured.csv", "crank [deg], slider [mm]\n0, 170.2\n");
    assert_eq!(run(&["--out", "with", "--measured", "measured.csv"]).status, 2);
    desk.write("measured.csv", "crank [deg], slidr [mm]\n0, 170.2\n");
    let refused = run(&["--out", "other", "--measured", "measured.csv"]);
    assert!(refused.messages.contains("the model has no output 'slidr'"), "{}", refused.messages);
    assert!(fs::metadata(desk.path("other")).is_err(), "no folder is left behind");
}

#[test]
fn a_law_can_be_set_for_one_run() {
    let desk = Desk::with_model("slider_crank_5000");
    let run = |law: &str, folder: &str| {
        let set = format!("contact.steel_pin.law={law}");
        desk.run(&["simulate", "model.toml", "--turns", "0.1", "--set", &set, "--out", folder])
    };
    // Delivered restitution for a nominal 0.9: χ(1 + ε) = ln((1 + χ)/(1 - χε)), docs/theory/contact.md.
    assert!(run("flores", "flores").output.contains("0.8939 (0.9)"));
    assert!(run("lankarani-nikravesh", "same").output.contains("0.9132 (0.9)"));
    let refused = run("flors", "none");
    assert_eq!(refused.status, 2);
    assert!(refused.messages.contains("error[E0204]: there is no contact law 'flors'"), "{}", refused.messages);
    assert!(refused.messages.contains("hint: did you mean 'flores'?"), "{}", refused.messages);
    let lacking = run("johnson", "none");
    assert!(lacking.messages.contains("johnson needs bearing_length of joint 'gudgeon'"), "{}", lacking.messages);
}
