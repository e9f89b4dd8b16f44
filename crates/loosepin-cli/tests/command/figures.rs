//! Figures that are saved by command.

use super::command_line::Desk;

#[test]
fn figures_are_listed_and_saved_by_name() {
    let desk = Desk::with_model("slider_crank_5000");
    desk.succeed(&["motion", "model.toml", "--out", "motion"]);
    let listed = desk.succeed(&["report", "motion", "--list"]).output;
    let names: Vec<&str> = listed.lines().filter_map(|line| line.split_whitespace().next()).collect();
    assert!(names.contains(&"mechanism") && names.contains(&"clearance.slider"), "{listed}");
    for name in &names {
        desk.succeed(&["report", "motion", "--figure", name, "--svg", "figure.svg"]);
        assert!(desk.read("figure.svg").starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\""), "{name}");
    }
    let arguments = ["--figure", "clearance.slider", "--svg", "play.svg", "--csv", "play.csv", "--width", "8.4 cm"];
    let said = desk.succeed(&[&["report", "motion"][..], &arguments].concat());
    assert_eq!(said.messages, "wrote play.svg\nwrote play.csv\n");
    assert!(desk.read("play.svg").contains("width=\"84.0mm\""));
    let rows = desk.read("play.csv");
    // A line on the origin, a header, and a row for each degree and for the end of the turn.
    assert_eq!(rows.lines().count(), 2 + 361, "{rows}");
    assert!(desk.read("motion/report.html").contains("loosepin motion model.toml"), "the command is in the page");
}

#[test]
fn figures_of_a_motion_in_space_are_listed_and_saved() {
    let desk = Desk::new();
    desk.write("model.toml", include_str!("../../../../docs/examples/spatial-slider-crank.toml"));
    desk.succeed(&["motion", "model.toml", "--out", "motion"]);
    let listed = desk.succeed(&["report", "motion", "--list"]).output;
    let names: Vec<&str> = listed.lines().filter_map(|line| line.split_whitespace().next()).collect();
    assert!(!names.is_empty(), "{listed}");
    for name in &names {
        desk.succeed(&["report", "motion", "--figure", name, "--svg", "figure.svg"]);
        assert!(desk.read("figure.svg").starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\""), "{name}");
    }
    std::fs::create_dir(desk.path("other")).expect("a folder");
    let nothing = "error[E0902]: other contains no results: it has no loosepin.json\n\
        hint: results are in results/NAME/HASH, or in the folder given with --out";
    desk.fail(&["report", "other", "--list"], nothing);
}

#[test]
fn a_figure_that_is_not_there_is_told() {
    let desk = Desk::with_model("slider_crank_5000");
    desk.succeed(&["motion", "model.toml", "--out", "motion"]);
    let near = "error[E0401]: the page has no figure 'clearance.slidr'\nhint: did you mean 'clearance.slider'?";
    desk.fail(&["report", "motion", "--figure", "clearance.slidr", "--svg", "a.svg"], near);
    let without = "error[E0401]: figure 'mechanism' has no table of numbers\nhint: save it as a picture, with --svg";
    desk.fail(&["report", "motion", "--figure", "mechanism", "--csv", "a.csv"], without);
    for wrong in [&["--figure", "mechanism"][..], &["--svg", "a.svg"], &["--list", "--figure", "mechanism"]] {
        assert_eq!(desk.run(&[&["report", "motion"], wrong].concat()).status, 2, "{wrong:?}");
    }
    let width = ["report", "motion", "--figure", "mechanism", "--svg", "a.svg", "--width", "84 kg"];
    assert!(desk.run(&width).messages.contains("E0304"));
}
