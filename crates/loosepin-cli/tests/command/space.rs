//! Models in space: what `check` and `motion` say, what is written, and what the other commands refuse.

use super::command_line::{Columns, Desk};

const SLIDER_CRANK: &str = include_str!("../../../../docs/examples/spatial-slider-crank.toml");

fn desk() -> Desk {
    let desk = Desk::new();
    desk.write("model.toml", SLIDER_CRANK);
    desk
}

#[test]
fn a_motion_in_space_is_stored_as_one_in_the_plane() {
    let desk = desk();
    let said = desk.succeed(&["motion", "model.toml", "--out", "one"]);
    let start = "spatial slider-crank\n2 degrees of freedom, 1 drive: the motion is determined\n";
    assert!(said.output.starts_with(start), "{}", said.output);
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
    assert!(page.contains("±1.003"), "{}", &page[..2000]);
    let summary: serde_json::Value = serde_json::from_str(&desk.read("one/summary.json")).unwrap();
    assert_eq!(summary["drive"], "crank");
    let clearance = &summary["outputs"][0]["clearance"];
    let searched = clearance["searched"][0]["position"].as_u64().unwrap() as usize;
    let at = |effects: &serde_json::Value| effects["first_order_si"][searched].as_f64().unwrap();
    let parts: f64 = clearance["contributors"].as_array().unwrap().iter().map(at).sum();
    assert!((parts - at(clearance)).abs() < 1e-15, "{clearance}");
    // What is there is shown again, from the stored record.
    let again = desk.succeed(&["motion", "model.toml", "--out", "one"]);
    assert_eq!(again.output, said.output);
    assert!(again.messages.starts_with("one already holds this motion"), "{}", again.messages);
    assert_eq!(desk.succeed(&["report", "one"]).output, said.output);
}

#[test]
fn the_path_of_a_point_in_space_has_columns_a_row_and_a_zone() {
    let desk = desk();
    let said = desk.succeed(&["motion", "model.toml", "--path", "rod.slider", "--out", "one"]).output;
    let motion = Columns::from_csv(&desk.read("one/motion.csv"));
    let names = ["x", "y", "z"]
        .map(|axis| ["m", "velocity_m_s", "acceleration_m_s2"].map(|what| format!("rod.slider_{axis}_{what}")));
    let names = names.iter().flatten().map(String::as_str);
    let reaches = ["rod.slider_play_along_m", "rod.slider_play_across_m", "rod.slider_play_longest_m"];
    assert_eq!(motion.names()[4..], names.chain(reaches).collect::<Vec<_>>());
    // The slider moves along x: it goes as far along its path as the output does.
    let along = motion.column("rod.slider_play_along_m");
    for (along, slider) in along.iter().zip(motion.column("slider_first_order_worst_case_m")) {
        assert!((along - slider).abs() < 1e-12, "{along} {slider}");
    }
    assert!(said.contains("rod.slider"), "{said}");
    let page = desk.read("one/report.html");
    assert!(page.contains("Paths of points"));
    let command = "loosepin motion model.toml --path rod.slider";
    assert!(page.contains(command), "the command that makes it again");
    desk.succeed(&["report", "one"]);
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
        &["motion", "model.toml", "--path", "rod.slidr"],
        "--path:1:1: error[E0401]: --path: there is no point 'rod.slidr'\nhint: did you mean 'rod.slider'?",
    );
    desk.fail(
        &["motion", "model.toml", "--set", "parameter.rod_lenght=310mm"],
        "--set:1:1: error[E0405]: the model has no quantity 'parameter.rod_lenght'\nhint: did you mean 'parameter.rod_length'?",
    );
}
