//! Output and exit status of the other commands.

use std::io::Read;
use std::process::Stdio;

use super::command_line::{Desk, case_text};
use loosepin::templates::all_templates;

#[test]
fn check_says_in_words_what_a_mechanism_is() {
    let desk = Desk::with_model("six_bar");
    let said = desk.succeed(&["check", "model.toml"]);
    assert_eq!(said.output, include_str!("../expected/check_six_bar.txt"));
    assert_eq!(said.messages, "");
}

#[test]
fn check_says_what_film_of_oil_is_in_a_joint() {
    let desk = Desk::new();
    let text = case_text("slider_crank_5000", "model.toml")
        .replace("[joint.main]", "film = { viscosity = \"0.04 Pa s\", roughness = \"2 um\" }\n[joint.main]")
        .replace("bearing_radius", "bearing_length = \"20 mm\"\nbearing_radius");
    desk.write("oiled.toml", &text);
    let said = desk.succeed(&["check", "oiled.toml"]).output;
    let line = "film of oil by reynolds: viscosity 0.04 Pa s, roughness 0.002 mm, 20 mm of bearing\n";
    assert!(said.contains(line), "{said}");
}

#[test]
fn check_says_what_a_study_comes_to() {
    let desk = Desk::with_model("slider_crank_5000");
    desk.write("study.toml", include_str!("../expected/study.toml"));
    let said = desk.succeed(&["check", "study.toml"]);
    // How long it takes depends on the machine; "about" is left out where it is less than a second.
    let (words, duration) = said.output.split_once(" runs: ").expect("how many runs, and how long");
    assert_eq!(words, include_str!("../expected/check_study.txt").trim_end());
    assert!(duration.trim_end().ends_with("thread") || duration.trim_end().ends_with("threads"));
}

#[test]
fn the_guess_that_check_names_picks_the_other_assembly() {
    let desk = Desk::with_model("six_bar");
    let said = desk.succeed(&["check", "model.toml"]);
    let guess = said.output.lines().find_map(|line| line.strip_prefix("  guess = ")).expect("another assembly");
    let text = case_text("six_bar", "model.toml");
    let (before, rest) = text.split_once("[assembly]").expect("a guess in the case");
    let (_, after) = rest.split_once("\n[").expect("a table behind it");
    desk.write("other.toml", &format!("{before}[assembly]\nguess = {guess}\n\n[{after}"));
    let said = desk.succeed(&["check", "other.toml"]);
    assert!(said.output.contains("link     at -47.81 deg"), "{}", said.output);
}

#[test]
fn templates_are_listed_written_and_good() {
    let desk = Desk::new();
    let listed = desk.succeed(&["new", "--list"]).output;
    assert_eq!(listed, include_str!("../expected/new_list.txt"));
    let names: Vec<&str> = listed
        .lines()
        .filter(|line| !line.is_empty() && !line.starts_with(' '))
        .filter_map(|line| line.split_once(": ").map(|(name, _)| name))
        .collect();
    assert_eq!(names, all_templates().map(|template| template.name).collect::<Vec<_>>());
    for name in names.into_iter().take(2) {
        let said = desk.succeed(&["new", name]);
        assert_eq!(
            said.messages,
            format!(
                "wrote {name}/model.toml and {name}/study.toml\nnext: loosepin check {name}/model.toml {name}/study.toml\n"
            )
        );
        desk.succeed(&["check", &format!("{name}/model.toml"), &format!("{name}/study.toml")]);
        desk.fail(
            &["new", name],
            &format!(
                "error[E0904]: {name}/model.toml already exists; it is not overwritten\n\
                 hint: give another folder, for example: loosepin new TEMPLATE my_mechanism"
            ),
        );
    }
    let all: Vec<&str> = all_templates().map(|template| template.name).collect();
    desk.fail(
        &["new", "four-br"],
        &format!(
            "error: invalid value 'four-br' for '[TEMPLATE]'\n  [possible values: {}]\n\n  \
             tip: a similar value exists: 'four-bar'\n\nFor more information, try '--help'.",
            all.join(", ")
        ),
    );
}

#[test]
fn codes_are_explained() {
    let desk = Desk::new();
    assert_eq!(
        desk.succeed(&["explain", "e0303"]).output,
        "E0303: a unit is missing\n\
         \n\
         The value needs a unit, even if it is zero. No unit is assumed: a clearance of 0.5 could be in\n\
         millimetres or in metres. Write the value as text with its unit: \"0.5 mm\".\n"
    );
    assert!(desk.succeed(&["explain", "--list"]).output.contains("\nE0704  the links cannot close a loop\n"));
    let said = desk.run(&["explain", "E9999"]);
    assert_eq!(said.status, 2);
    assert!(
        said.messages
            .starts_with("error: invalid value 'E9999' for '[CODE]': there is no code 'E9999'; codes run from")
    );
}

#[test]
fn schemas_are_json() {
    let desk = Desk::new();
    for kind in ["model", "study"] {
        let schema: serde_json::Value = serde_json::from_str(&desk.succeed(&["schema", kind]).output).expect("JSON");
        assert_eq!(schema["title"], format!("loosepin {kind}"));
    }
}

#[test]
fn version_and_help() {
    let desk = Desk::new();
    let said = desk.succeed(&["--version"]).output;
    let commit = said.trim_end().strip_prefix(concat!("loosepin ", env!("CARGO_PKG_VERSION"))).expect("the version");
    if let Some(commit) = commit.strip_prefix(" (").map(|rest| rest.trim_end_matches(')')) {
        assert!(commit.len() >= 7 && commit.chars().all(|digit| digit.is_ascii_hexdigit()), "{said}");
    } else {
        assert_eq!(commit, "");
    }
    assert_eq!(desk.succeed(&["--help"]).output, include_str!("../expected/help.txt"));
    assert_eq!(desk.succeed(&["simulate", "--help"]).output, include_str!("../expected/help_simulate.txt"));
    for command in [
        "new",
        "check",
        "motion",
        "study",
        "sweep",
        "identify",
        "cases",
        "report",
        "schema",
        "explain",
        "completions",
        "manual",
        "serve",
    ] {
        let help = desk.succeed(&[command, "--help"]).output;
        assert!(help.contains("Example"), "{command} --help ends with examples");
    }
}

#[test]
fn completions_and_manual_pages_know_every_command() {
    let desk = Desk::new();
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let script = desk.succeed(&["completions", shell]).output;
        for word in ["lyapunov", "small-round"] {
            assert!(script.contains(word), "{shell} does not complete {word}");
        }
    }
    let page = desk.succeed(&["manual"]).output;
    assert!(page.contains(".TH loosepin 1"), "{page}");
    for command in
        ["new", "import", "check", "motion", "simulate", "study", "merge", "sweep", "identify", "cases", "report"]
    {
        assert!(page.contains(&format!("loosepin\\-{command}(1)")), "the page of loosepin names {command}");
        let page = desk.succeed(&["manual", command]).output;
        assert!(page.contains(".SH OPTIONS") && page.contains("Example"), "{page}");
    }
    let said = desk.run(&["manual", "stduy"]);
    assert_eq!(said.status, 2);
    assert!(said.messages.starts_with("error: invalid value 'stduy' for '[COMMAND]'"), "{}", said.messages);
}

#[test]
fn a_reader_that_leaves_early_is_no_error() {
    let desk = Desk::with_model("slider_crank_5000");
    for arguments in [&["simulate", "model.toml", "--turns", "0.2"][..], &["schema", "model"], &["--help"]] {
        let mut child =
            desk.command(arguments).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the command starts");
        drop(child.stdout.take());
        let mut messages = String::new();
        child.stderr.take().expect("piped").read_to_string(&mut messages).expect("UTF-8");
        let status = child.wait().expect("it ends");
        assert!(!messages.contains("panicked"), "{messages}");
        assert_eq!(status.code(), Some(0), "{arguments:?}: {messages}");
    }
}

#[test]
fn motion_of_a_model_and_of_a_study() {
    let desk = Desk::with_model("slider_crank_5000");
    desk.write("study.toml", include_str!("../expected/study.toml"));
    let said = desk.succeed(&["motion", "model.toml", "--out", "motion"]);
    assert_eq!(said.messages, "report: motion/report.html\n");
    assert_eq!(said.output, include_str!("../expected/motion_slider_crank.txt"));
    assert!(desk.read("motion/report.html").contains("<html"));
    assert_eq!(desk.succeed(&["report", "motion"]).output, said.output);
    // Play and parts at their worst break its requirement.
    let judged = desk.run(&["motion", "study.toml"]);
    assert_eq!(judged.status, 1, "{}", judged.messages);
    assert!(
        judged.output.contains("Not met in the worst case: deviation of slider within ±0.75 mm"),
        "{}",
        judged.output
    );
}

#[test]
fn check_tells_springs_loads_motions_initial_states_guides_and_slots() {
    let desk = Desk::new();
    for (name, text, expected) in [
        (
            "elements.toml",
            include_str!("../../../loosepin-simulate/tests/files/slider_crank_elements.toml"),
            include_str!("../expected/check_elements.txt"),
        ),
        (
            "motions.toml",
            include_str!("../../../loosepin-simulate/tests/files/slider_crank_table_drive.toml"),
            include_str!("../expected/check_motions.txt"),
        ),
        (
            "initial.toml",
            include_str!("../../../loosepin-simulate/tests/files/pendulum_on_a_spring.toml"),
            include_str!("../expected/check_initial.txt"),
        ),
        (
            "guide.toml",
            include_str!("../../../../cases/slider_crank_guide/model.toml"),
            include_str!("../expected/check_guide.txt"),
        ),
        (
            "slot.toml",
            include_str!("../../../loosepin-simulate/tests/files/scotch_yoke_with_play_in_its_slot.toml"),
            include_str!("../expected/check_slot.txt"),
        ),
    ] {
        desk.write(name, text);
        let said = desk.succeed(&["check", name]);
        assert_eq!(said.output, expected, "{name}");
        assert_eq!(said.messages, "");
    }
}

#[test]
fn the_ideal_motion_of_a_mechanism_that_forces_move_is_that_of_a_run_without_play() {
    let desk = Desk::new();
    desk.write("model.toml", include_str!("../../../loosepin-simulate/tests/files/pendulum_on_a_spring.toml"));
    desk.fail(
        &["motion", "model.toml"],
        "model.toml:45:2: error[E0701]: the drives alone do not determine the motion: it follows from the forces, which this command does not compute\n\
         hint: use `loosepin simulate` or a study: their ideal motion is that under the same forces without play",
    );
    let said = desk.succeed(&["simulate", "model.toml", "--out", "run", "--all"]);
    assert!(said.output.contains("energy balance"), "{}", said.output);
    let history = std::fs::read_to_string(desk.path("run/history.csv")).expect("the history is there");
    // Without drives the ideal values are those of the same run without play.
    let names = "time_s,cycle_rad,tip_x_m,tip_y_m,tip_x_ideal_m,tip_x_deviation_m,tip_y_ideal_m,tip_y_deviation_m";
    assert!(history.starts_with(&format!("{names}\n0.0,0.0,")), "{}", &history[..120]);
    assert_eq!(history.lines().count(), 502);
}
