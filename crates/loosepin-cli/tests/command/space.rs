//! Models in space: what `check` and `motion` say, what is written, and what the other commands refuse.

use super::command_line::{Columns, Desk};

const SLIDER_CRANK: &str = include_str!("../../../../docs/examples/spatial-slider-crank.toml");

fn desk() -> Desk {
    let desk = Desk::new();
    desk.write("model.toml", SLIDER_CRANK);
    desk
}

#[test]
fn a_motion_in_space_writes_its_table_once() {
    let desk = desk();
    let said = desk.succeed(&["motion", "model.toml", "--out", "one"]);
    assert!(said.output.starts_with("spatial slider-crank\n\n37 positions over a turn"), "{}", said.output);
    let motion = Columns::from_csv(&desk.read("one/motion.csv"));
    let names = ["crank_rad", "slider_m", "slider_first_order_worst_case_m", "slider_standard_deviation_m"];
    assert_eq!(motion.names(), names);
    for (angle, place) in motion.column(names[0]).iter().zip(motion.column(names[1])) {
        let (y, z) = (0.1 - 0.08 * angle.sin(), 0.12 + 0.08 * angle.cos());
        assert!((place - (0.09 - y * y - z * z).sqrt()).abs() < 1e-12, "{angle} {place}");
    }
    // Independent program, at 0 deg.
    assert!((motion.column(names[2])[0] - 0.00100158563062).abs() < 1e-14);
    let page = desk.read("one/report.html");
    assert!(page.contains("1.003\u{a0}mm is the largest worst case of play: slider"), "{}", &page[..2000]);
    assert!(desk.read("one/motion.svg").starts_with("<svg xmlns="));
    let summary: serde_json::Value = serde_json::from_str(&desk.read("one/summary.json")).unwrap();
    assert_eq!((&summary["geometry"], &summary["drive"]), (&"space".into(), &"crank".into()));
    let worst = &summary["outputs"][0]["clearance"]["worst"];
    let parts: f64 =
        worst["contributors"].as_array().unwrap().iter().map(|own| own["first_order_si"].as_f64().unwrap()).sum();
    assert!((parts - worst["first_order_si"].as_f64().unwrap()).abs() < 1e-15, "{worst}");
    // Any of the files is in the way.
    std::fs::create_dir(desk.path("two")).unwrap();
    desk.write("two/motion.svg", "mine");
    let other = desk.run(&["motion", "model.toml", "--out", "two"]);
    assert!(other.messages.starts_with("error[E0904]: two/motion.svg already exists"), "{}", other.messages);
    assert_eq!(desk.read("two/motion.svg"), "mine");
    // Before anything is computed, and in words.
    let again = desk.run(&["motion", "model.toml", "--out", "one"]);
    assert!(
        again.output.is_empty() && again.messages.starts_with("error[E0904]: one/motion.csv already exists"),
        "{}",
        again.messages
    );
}

#[test]
fn what_does_not_know_space_refuses_it() {
    let desk = desk();
    let place =
        format!("model.toml:{}:12", SLIDER_CRANK.lines().position(|line| line.starts_with("geometry")).unwrap() + 1);
    let message = format!(
        "{place}: error[E0905]: this command works on planar models; a model in space is known to check, motion and study"
    );
    desk.fail(&["simulate", "model.toml"], &message);
    desk.fail(
        &["motion", "model.toml", "--path", "rod.slider"],
        "error[E0207]: --path cannot be used with a model in space yet",
    );
    desk.fail(
        &["motion", "model.toml", "--set", "parameter.rod_lenght=310mm"],
        "--set:1:1: error[E0405]: the model has no quantity 'parameter.rod_lenght'\nhint: did you mean 'parameter.rod_length'?",
    );
}
