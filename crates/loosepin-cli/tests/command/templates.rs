//! Every template from `loosepin new` to the report of its study, in one go.

use super::command_line::Desk;
use loosepin::templates::{SPATIAL_TEMPLATES, TEMPLATES};

/// Largest residual of the energy account over the largest energy exchanged. A run at 1e-9 m has about 1e-10; what a wrong
/// sign of a force leaves is of the order of one.
const MAX_RESIDUAL: f64 = 1e-7;

/// `new`, `check`, `motion` where drives move it, `simulate` and a small `study` of one template.
fn from_new_to_report(name: &str) {
    let desk = Desk::new();
    desk.succeed(&["new", name, "it"]);
    let checked = desk.succeed(&["check", "it/model.toml", "it/study.toml"]);
    assert!(!checked.messages.contains("warning"), "{}", checked.messages);
    let mut folders = vec!["simulation", "study"];
    if desk.read("it/model.toml").contains("\n[drive.") {
        // Play at its worst may break the requirement, or nothing be proven of it.
        let said = desk.run(&["motion", "it/study.toml", "--out", "motion"]);
        assert!(said.status <= 1, "{}", said.messages);
        folders.push("motion");
    } else {
        // Actuators move it: there is no ideal motion without its forces.
        let refused = desk.run(&["motion", "it/study.toml", "--out", "motion"]);
        assert!(refused.status == 2 && refused.messages.contains("use `loosepin simulate`"), "{}", refused.messages);
    }
    desk.succeed(&["simulate", "it/model.toml", "--out", "simulation"]);
    let summary: serde_json::Value = serde_json::from_str(&desk.read("simulation/summary.json")).expect("JSON");
    assert_eq!(summary["stop"]["kind"], "finished");
    assert!(summary["impacts"].as_array().is_some_and(|impacts| !impacts.is_empty()), "the play does something");
    let residual = summary["energy"]["relative_residual"].as_f64().expect("a number");
    println!("{name}: energy residual {residual:.1e}");
    assert!(residual < MAX_RESIDUAL, "energy residual {residual:e}");

    let study = desk.read("it/study.toml");
    desk.write("it/study.toml", &shortened(&study, if name.starts_with("flexible") { 0.02 } else { 0.1 }));
    let said = desk.run(&["study", "it/study.toml", "--out", "study"]);
    // So few runs may leave the requirement open.
    assert!(said.status <= 1, "{}", said.messages);
    let summary: serde_json::Value = serde_json::from_str(&desk.read("study/summary.json")).expect("JSON");
    assert_eq!(summary["counts"]["failed"], 0);
    for folder in folders {
        assert!(desk.read(&format!("{folder}/report.html")).trim_end().ends_with("</html>"), "{folder} has its page");
    }
}

/// The study with the least sampling there is, over a small part of a turn: whether it goes through, not what it says. Links that bend
/// take ten times as long.
fn shortened(study: &str, turns: f64) -> String {
    let recorded = format!("recorded_turns = {turns}");
    let changes: [(&str, &str); 4] = [
        ("outer = ", "outer = 5"),
        ("inner = ", "inner = 8"),
        ("transient_turns = ", "transient_turns = 0"),
        ("recorded_turns = ", &recorded),
    ];
    let line = |line: &str| {
        let change = changes.iter().find(|(key, _)| line.starts_with(key));
        change.map_or(line.to_owned(), |(_, changed)| (*changed).to_owned()) + "\n"
    };
    let short: String = study.lines().map(line).collect();
    for (_, changed) in changes {
        assert!(short.contains(changed), "{changed} in {short}");
    }
    // Poses must lie within that part.
    short.replace("\"60 deg\", \"240 deg\"", "\"40 deg\", \"60 deg\"")
}

/// One test for each template; the last one fails where a template has none.
macro_rules! templates_run {
    ($($test:ident $name:literal)*) => {
        $(#[test]
        fn $test() {
            from_new_to_report($name);
        })*

        #[test]
        fn every_template_has_its_test() {
            assert_eq!(TEMPLATES.iter().map(|template| template.name).collect::<Vec<_>>(), [$($name),*]);
        }
    };
}

templates_run! {
    identity_slider_crank_keeps_its_energy "slider-crank"
    identity_four_bar_keeps_its_energy "four-bar"
    identity_offset_slider_crank_keeps_its_energy "offset-slider-crank"
    identity_inverted_slider_crank_keeps_its_energy "inverted-slider-crank"
    identity_whitworth_quick_return_keeps_its_energy "whitworth-quick-return"
    identity_scotch_yoke_keeps_its_energy "scotch-yoke"
    identity_double_slider_keeps_its_energy "double-slider"
    identity_watt_six_bar_keeps_its_energy "watt-six-bar"
    identity_stephenson_six_bar_keeps_its_energy "stephenson-six-bar"
    identity_toggle_press_keeps_its_energy "toggle-press"
    identity_worn_press_keeps_its_energy "worn-press"
    identity_pantograph_keeps_its_energy "pantograph"
    identity_two_link_arm_keeps_its_energy "two-link-arm"
    identity_three_link_arm_keeps_its_energy "three-link-arm"
    identity_space_manipulator_keeps_its_energy "space-manipulator"
    identity_flexible_slider_crank_keeps_its_energy "flexible-slider-crank"
    identity_flexible_four_bar_keeps_its_energy "flexible-four-bar"
}

/// `new`, `check`, `motion` and a small `study` of each template in space.
#[test]
fn templates_in_space_go_from_new_to_report() {
    let desk = Desk::new();
    for template in SPATIAL_TEMPLATES {
        let name = template.name;
        desk.succeed(&["new", name, name]);
        let [model, study] = ["model", "study"].map(|file| format!("{name}/{file}.toml"));
        let checked = desk.succeed(&["check", &model, &study]);
        assert!(!checked.messages.contains("warning"), "{name}: {}", checked.messages);
        desk.succeed(&["motion", &model, "--out", &format!("{name}/motion")]);
        let line = |line: &str| match line.split(" = ").next() {
            Some("outer") => "outer = 9\n".to_owned(),
            Some("inner") => "inner = 8\n".to_owned(),
            _ => format!("{line}\n"),
        };
        let short: String = desk.read(&study).lines().map(line).collect();
        desk.write(&study, &short);
        desk.succeed(&["study", &study, "--out", &format!("{name}/study")]);
        let summary: serde_json::Value =
            serde_json::from_str(&desk.read(&format!("{name}/study/summary.json"))).expect("JSON");
        assert_eq!(summary["counts"]["failed"], 0, "{name}");
        let page = desk.read(&format!("{name}/study/report.html"));
        assert!(page.trim_end().ends_with("</html>") && page.contains("Contribution of each joint"), "{name}");
    }
}
