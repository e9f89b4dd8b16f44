//! What keeps texts from running although they are drawn.

use crate::client::{Live, Server};
use loosepin::templates::find_template;
use serde_json::{Value, json};

const PATHS: [&str; 2] = ["m/model.toml", "m/study.toml"];

/// The four-bar with a crank of 150 mm, which is the shortest link: 150 + 300 mm is more than 260 + 180 mm, so that no link turns fully.
fn texts() -> [String; 2] {
    let template = find_template("four-bar").unwrap();
    let model = template.model.replace("crank_length = \"80 mm\"", "crank_length = \"150 mm\"");
    assert_ne!(model, template.model);
    [model, template.study.to_owned()]
}

/// What is seen of the texts, and what is found while they rest.
fn tried(live: &mut Live, seq: u64, [model, study]: [&str; 2]) -> [Value; 2] {
    let seen = live.look_for(seq, (PATHS[0], model), Some((PATHS[1], study)), json!({"is_at_rest": true}));
    [seen, live.next_of("check_answer")]
}

#[test]
fn analytic_a_drive_that_cannot_turn_fully_is_told_with_its_range_and_the_class_of_its_loop() {
    let desk = tempfile::tempdir().unwrap();
    let server = Server::of(desk.path());
    let mut live = server.live();
    let [model, study] = texts();
    let [seen, found] = tried(&mut live, 1, [&model, &study]);
    assert_eq!(seen["diagnostics"], json!([]), "the texts can be read");
    assert_eq!(found["seq"], 1);
    let found = &found["diagnostics"][0];
    assert_eq!(
        (&found["code"], &found["severity"], &found["document"]),
        (&json!("E0704"), &json!("error"), &json!("model"))
    );
    assert!(found["message"].as_str().unwrap().contains("joint 'rocker_pivot' stays 0.056"), "{found}");
    // The crank comes to where coupler and rocker lie on one line.
    let end_deg =
        ((150.0_f64.powi(2) + 300.0_f64.powi(2) - 440.0_f64.powi(2)) / (2.0 * 150.0 * 300.0)).acos().to_degrees();
    let range: Vec<f64> = serde_json::from_value(seen["view"]["drive_range_deg"].clone()).unwrap();
    assert!((range[0] + end_deg).abs() < 1e-6 && (range[1] - end_deg).abs() < 1e-6, "{range:?}, ±{end_deg}");
    let class = "ground, crank, coupler, rocker: triple rocker (not Grashof), shortest link crank";
    assert_eq!(seen["view"]["outline"]["loops"], json!([class]));
    // As it is in the template, nothing is in its way.
    let template = find_template("four-bar").unwrap();
    let [seen, found] = tried(&mut live, 2, [template.model, template.study]);
    assert_eq!((&found["seq"], &found["diagnostics"]), (&json!(2), &json!([])));
    assert_eq!(seen["view"]["drive_range_deg"], Value::Null);
    assert_eq!(
        seen["view"]["outline"]["loops"],
        json!(["ground, crank, coupler, rocker: crank-rocker, shortest link crank"])
    );
}

#[test]
fn what_is_found_while_a_drag_is_held_is_of_the_texts_that_it_gives() {
    let desk = tempfile::tempdir().unwrap();
    let server = Server::of(desk.path());
    let mut live = server.live();
    let template = find_template("four-bar").unwrap();
    // The crank of 80 mm at 30 deg is drawn out to 150 mm: the letters before the drag have nothing in their way.
    let to_mm = [150.0 * 30.0_f64.to_radians().cos(), 150.0 * 30.0_f64.to_radians().sin()];
    let held = json!({"take": "joint", "joint": "crank_pin"});
    let poses = [[0.0; 3], [0.0, 0.0, 30.0], [69.3, 40.0, 0.0], [260.0, 0.0, 60.0]];
    let grip = json!({"held": held, "to_mm": to_mm, "step_mm": 1.0, "is_free": false, "poses": poses});
    let further = json!({"is_at_rest": true, "grip": grip});
    let seen = live.look_for(1, (PATHS[0], template.model), Some((PATHS[1], template.study)), further);
    let changed = seen["reshaped"].to_string();
    assert!(changed.contains("150 mm"), "{changed}");
    let found = live.next_of("check_answer");
    assert_eq!((&found["seq"], &found["diagnostics"][0]["code"]), (&json!(1), &json!("E0704")), "{found}");
}

#[test]
fn a_study_that_cannot_be_planned_is_told_before_it_runs() {
    let desk = tempfile::tempdir().unwrap();
    let server = Server::of(desk.path());
    let mut live = server.live();
    let template = find_template("four-bar").unwrap();
    let study = template.study.replace("recorded_turns = 1", "recorded_turns = 100001");
    assert_ne!(study, template.study);
    let [seen, found] = tried(&mut live, 1, [template.model, &study]);
    assert_eq!(seen["diagnostics"], json!([]));
    let found = &found["diagnostics"][0];
    assert_eq!(found["document"], "study", "{found}");
    assert!(found["message"].as_str().unwrap().contains("100001 turns are recorded; must be at most"), "{found}");
}

#[test]
fn a_run_that_fails_says_why_and_blames_what_is_at_fault() {
    let desk = tempfile::tempdir().unwrap();
    std::fs::create_dir(desk.path().join("m")).unwrap();
    for (path, text) in PATHS.iter().zip(texts()) {
        std::fs::write(desk.path().join(path), text).unwrap();
    }
    let server = Server::of(desk.path());
    let mut live = server.live();
    live.send(&json!({"kind": "run", "study": PATHS[1]}));
    let job = loop {
        let job = live.next_of("job")["job"].clone();
        if job["state"] == "failed" {
            break job;
        }
        assert_ne!(job["state"], "done", "{job}");
    };
    let reason = job["reason"].as_str().unwrap();
    assert!(reason.starts_with("the links cannot close at ") && reason.contains("stays 0.056"), "{reason}");
    let lines = job["diagnostics"].to_string();
    assert!(lines.contains("m/model.toml:62:8") && !lines.contains("radial_clearance"), "{lines}");
}
