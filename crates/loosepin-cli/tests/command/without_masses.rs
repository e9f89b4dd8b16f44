//! Models without masses, inertias, contacts and gravity: enough for the motion, and told what is missing where they are run.

use super::command_line::Desk;

/// Templates whose drives move them, without what only runs need.
const TEMPLATES: [&str; 10] = [
    "slider-crank",
    "four-bar",
    "offset-slider-crank",
    "inverted-slider-crank",
    "whitworth-quick-return",
    "scotch-yoke",
    "double-slider",
    "watt-six-bar",
    "stephenson-six-bar",
    "toggle-press",
];

/// The keys that only runs need.
const KEYS: [&str; 5] = ["gravity ", "mass ", "inertia ", "centre_of_mass ", "contact "];

/// Both files of a template in a folder; the model once more as `light.toml`, without what only runs need.
fn desk(template: &str) -> Desk {
    let desk = Desk::new();
    desk.succeed(&["new", template, "."]);
    let mut light = String::new();
    let mut is_of_contact = false;
    for line in desk.read("model.toml").lines() {
        if line.starts_with('[') {
            is_of_contact = line.starts_with("[contact.");
        }
        let is_of_run = is_of_contact || KEYS.iter().any(|key| line.starts_with(key));
        if !is_of_run {
            light.push_str(line);
            light.push('\n');
        }
    }
    desk.write("light.toml", &light);
    desk
}

/// The motion of a model, without what names the file.
fn motion(desk: &Desk, model: &str) -> serde_json::Value {
    desk.succeed(&["motion", model, "--out", &format!("motion-{model}")]);
    let text = desk.read(&format!("motion-{model}/summary.json"));
    let mut summary: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    summary["outputs"].take()
}

#[test]
fn identity_a_motion_needs_no_radius_of_a_bearing_without_contact() {
    let desk = desk("slider-crank");
    let text = desk.read("light.toml");
    let bare: String =
        text.lines().filter(|line| !line.starts_with("bearing_radius")).map(|line| format!("{line}\n")).collect();
    assert_ne!(bare, text);
    desk.write("bare.toml", &bare);
    assert_eq!(motion(&desk, "bare.toml"), motion(&desk, "light.toml"));
    let said = desk.succeed(&["check", "bare.toml"]).output;
    assert!(said.contains("play: radial clearance 0.5 mm\n"), "{said}");
    assert!(said.contains("joint 'gudgeon': bearing_radius is missing\n"), "{said}");
    let refused = desk.run(&["simulate", "bare.toml"]);
    assert!(
        refused.status == 2 && refused.messages.contains("joint 'gudgeon': bearing_radius is missing"),
        "{}",
        refused.messages
    );
}

#[test]
fn identity_ten_templates_move_alike_without_their_masses() {
    for template in TEMPLATES {
        let desk = desk(template);
        let (heavy, light) = (motion(&desk, "model.toml"), motion(&desk, "light.toml"));
        assert!(heavy.as_array().is_some_and(|outputs| !outputs.is_empty()), "{template}");
        assert_eq!(heavy, light, "{template}");
    }
}

#[test]
fn a_model_without_masses_is_checked_for_its_motion_and_says_what_a_run_needs() {
    let desk = desk("slider-crank");
    let said = desk.succeed(&["check", "light.toml"]).output;
    assert!(said.contains("\n  crank   no mass, no inertia\n"), "{said}");
    assert!(said.contains("\n  gravity not given\n") && said.contains("             no contact is named\n"), "{said}");
    let (_, missing) = said
        .split_once(
            "The loops close over the whole cycle.\n\nComplete for its motion (loosepin motion, the band of the studio). ",
        )
        .unwrap_or_else(|| panic!("{said}"));
    let lines: Vec<&str> = missing.lines().collect();
    assert_eq!(lines[0], "A run (simulate, study) also needs:");
    // Gravity, three entries of three bodies, and the contact of one joint.
    assert_eq!(lines.len(), 1 + 1 + 9 + 1, "{missing}");
    assert!(
        lines[1].ends_with(": gravity is missing") && lines[2].ends_with(": body 'crank': mass is missing"),
        "{missing}"
    );
}

#[test]
fn a_run_without_masses_is_refused_at_each_place() {
    let desk = desk("slider-crank");
    let said = desk.run(&["simulate", "light.toml"]);
    assert_eq!((said.status, said.output.as_str()), (2, ""), "{}", said.messages);
    assert_eq!(said.messages.matches("error[E0202]").count(), 11, "{}", said.messages);
    assert!(
        said.messages.contains(
            "body 'crank': mass is missing\nhint: for example mass = \"0.3 kg\" (mass of a rigid body; needed for runs)"
        ),
        "{}",
        said.messages
    );
    // A study that asks for statistics of runs asks for masses; one with requirements alone may be judged by its motion.
    let study: Vec<String> =
        desk.read("study.toml").lines().filter(|line| !line.contains("steel_pin")).map(str::to_owned).collect();
    desk.write("study.toml", &study.join("\n").replace("model.toml", "light.toml"));
    for command in ["check", "study"] {
        let said = desk.run(&[command, "study.toml"]);
        assert_eq!(said.status, 2, "{}", said.output);
        assert_eq!(said.messages.matches("is missing").count(), 11, "{}", said.messages);
    }
    assert!(!desk.path("results").exists(), "nothing is left behind");
}
