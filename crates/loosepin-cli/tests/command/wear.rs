//! `loosepin wear`.

use super::command_line::{Columns, Desk, case_text};

/// The slider-crank whose gudgeon wears, over its first turn.
fn desk() -> Desk {
    let desk = Desk::new();
    let wear = "bearing_length = \"20 mm\"\nwear.bearing.coefficient = \"1e-15 m^2/N\"\n\
                wear.journal = { archard = 1e-6, hardness = \"2 GPa\" }\nwear.sectors = 72\nradial_clearance";
    let text = case_text("slider_crank_5000", "model.toml")
        .replace("recorded_turns = 2", "recorded_turns = 1")
        .replacen("radial_clearance", wear, 1);
    desk.write("model.toml", &text);
    desk
}

#[test]
fn wear_of_the_first_turn_is_shown_and_written() {
    let desk = desk();
    let said = desk.succeed(&["wear", "model.toml", "--set", "wear.cycles=4000", "--out", "run"]);
    assert_eq!(said.output, include_str!("../expected/wear.txt"));
    let text = desk.read("run/wear.csv");
    let rows: Vec<Vec<&str>> = text.lines().skip(1).map(|line| line.split(',').collect()).collect();
    assert_eq!(rows.len(), 2 * 72);
    // k_i = 1e-15 m²/N, 4000 cycles: sector 71 has 2.2330e-10 m a cycle by another program, sector 0 2.2077e-10 m.
    for (row, sector, depth_m) in [(71, "71", 2.2330e-10), (0, "0", 2.2077e-10)] {
        assert_eq!(rows[row][..3], ["gudgeon", "bearing", sector]);
        let found_m: f64 = rows[row][5].parse().expect("a depth");
        assert!((found_m / (4000.0 * depth_m) - 1.0).abs() < 3e-4, "{found_m}");
    }
    assert_eq!(rows[72][..3], ["gudgeon", "journal", "0"]);
    // `simulate` finds the same run.
    let said = desk.succeed(&["simulate", "model.toml", "--set", "wear.cycles=4000", "--out", "run", "--all"]);
    assert!(said.messages.starts_with("run already holds this simulation"), "{}", said.messages);
    assert!(said.output.contains("Wear after 4000 cycles of 1 turn"), "{}", said.output);
    assert!(desk.read("run/report.html").contains("data-figure=\"wear.gudgeon\""));
}

#[test]
fn histories_have_no_column_of_wear() {
    let desk = desk();
    let text =
        desk.read("model.toml") + "\n[output.hole]\nwear_of = \"joint.gudgeon\"\ncomponent = \"bearing_volume\"\n";
    desk.write("model.toml", &text);
    desk.succeed(&["wear", "model.toml", "--turns", "0.1", "--out", "run"]);
    let history = Columns::from_csv(&desk.read("run/history.csv"));
    assert!(history.names().iter().all(|name| !name.contains("hole")), "{:?}", history.names());
}

#[test]
fn a_model_without_wear_is_refused() {
    let desk = Desk::with_model("slider_crank_5000");
    let said = desk.run(&["wear", "model.toml", "--out", "run"]);
    assert_eq!(said.status, 2);
    let expected = "no joint of the model wears\n";
    assert!(said.messages.contains(expected), "{}", said.messages);
    assert!(!desk.path("run").exists());
}

#[test]
fn check_says_what_wears() {
    let said = desk().succeed(&["check", "model.toml"]).output;
    let line = "wear: bearing 1e-15 m^2/N, journal 5e-16 m^2/N, in 72 sectors; shown after 1 cycle\n";
    assert!(said.contains(line), "{said}");
}
