//! `loosepin import`, `--measured` and `--set` of a law.

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
