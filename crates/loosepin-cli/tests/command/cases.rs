//! `loosepin cases`: the words, the exit status, and what is said about a case that is wrong.

use super::command_line::{Desk, case_text};

/// A folder `cases` with one case without reference file or study, so that nothing long is run.
fn desk_with_case(change: impl Fn(String) -> String) -> Desk {
    let desk = Desk::new();
    std::fs::create_dir_all(desk.path("cases/crank")).expect("the folder can be made");
    desk.write("cases/crank/model.toml", &case_text("slider_crank_5000", "model.toml"));
    let expected = r#"[expected.acceleration_at_start]
quantity = "ideal_output"
output = "slider_acceleration"
angle = "0 deg"
value = "-19419.3605 m/s^2"
tolerance = "5e-5 m/s^2"
origin = "analytic"
source = "-r w^2 (1 + r/l)"
reason = "half a unit of the last digit given"

[expected.stiffness]
quantity = "contact_stiffness"
joint = "gudgeon"
value = "6.610198e10 N/m^1.5"
tolerance = "5e3 N/m^1.5"
origin = "analytic"
source = "eq. (9)"
reason = "half a unit of the last digit given"
"#;
    desk.write("cases/crank/expected.toml", &change(expected.to_owned()));
    desk
}

#[test]
fn cases_are_listed_one_a_line() {
    let desk = desk_with_case(|text| text);
    let listed = "crank    2 numbers  slider-crank at 5000 rpm, play in the gudgeon\n";
    assert_eq!(desk.succeed(&["cases"]).output, listed);
    std::fs::rename(desk.path("cases"), desk.path("others")).expect("the folder can be moved");
    assert_eq!(desk.succeed(&["cases", "--folder", "others"]).output, listed);
}

#[test]
fn a_run_shows_every_number_and_writes_the_page() {
    let desk = desk_with_case(|text| text);
    let said = desk.succeed(&["cases", "run", "--write", "page.md"]);
    assert_eq!(said.output, include_str!("../expected/cases_run.txt"));
    assert_eq!(desk.succeed(&["cases", "run", "crank"]).output, said.output);
    let page = desk.read("page.md");
    assert!(page.contains("\n| stiffness | 6.6101980e10 | 6.610198"), "{page}");
    assert!(page.contains("1 case, 2 numbers: all within their tolerances.\n"), "{page}");
}

#[test]
fn a_number_outside_of_its_tolerance_gives_status_1_and_is_named() {
    let desk = desk_with_case(|text| text.replace("-19419.3605", "-19419.3615"));
    let said = desk.run(&["cases", "run"]);
    assert_eq!(said.status, 1, "{}", said.messages);
    let end = "1 case, 2 numbers: 1 outside of their tolerances.\n- crank: acceleration at start\n";
    assert!(said.output.ends_with(end), "{}", said.output);
    assert!(said.output.contains("OUTSIDE"), "{}", said.output);
}

#[test]
fn what_is_wrong_with_a_case_is_said_with_its_place() {
    for (from, to, complaint) in [
        (
            "contact_stiffness",
            "contact_stifness",
            "cases/crank/expected.toml:12:12: error[E0204]: expected 'stiffness': quantity is 'contact_stifness'; must be",
        ),
        (
            "\"gudgeon\"",
            "\"wrist\"",
            "cases/crank/expected.toml:13:9: error[E0401]: expected 'stiffness': joint: there is no joint with play 'wrist'\n\
             hint: available: gudgeon",
        ),
        (
            "angle = \"0 deg\"\n",
            "angle = \"0 deg\"\nspan = \"1 ms\"\n",
            "cases/crank/expected.toml:5:1: error[E0205]: expected 'acceleration_at_start': span has no effect on the quantity \
             \"ideal_output\"",
        ),
        (
            "angle = \"0 deg\"",
            "angle = [\"0 deg\", \"9 deg\"]",
            "cases/crank/expected.toml:4:9: error[E0203]: expected 'acceleration_at_start': angle has 2 entries; expected one \
             for each of the 1 values",
        ),
        (
            "5e3 N/m^1.5",
            "5e3 N",
            "cases/crank/expected.toml:15:13: error[E0304]: expected 'stiffness': tolerance is a force; must be",
        ),
    ] {
        let desk = desk_with_case(|text| text.replace(from, to));
        let said = desk.run(&["cases", "run"]);
        assert_eq!((said.status, said.output.as_str()), (2, ""), "{to}");
        assert!(said.messages.starts_with(complaint), "{}", said.messages);
    }
}

#[test]
fn cases_that_are_not_there() {
    let desk = desk_with_case(|text| text);
    desk.fail(
        &["cases", "run", "crnk"],
        "error[E0401]: there is no reference case 'crnk'\nhint: did you mean 'crank'?",
    );
    desk.fail(
        &["cases", "--folder", "nowhere"],
        "error[E0101]: nowhere contains no reference case: no folder with a model.toml and an expected.toml\n\
         hint: the cases are in the repository; give their folder with --folder DIR",
    );
}
