//! Runs that fail: a limit on their share, and a command that repeats one.
#![cfg(unix)]

use super::command_line::{Desk, case_text};

/// A crank that in some samples is longer than the rod: the ideal mechanism, with which the deviation is measured, jams at a right
/// angle.
const TOO_LONG: &str = r#"
name = "cranks that are too long"
model = "model.toml"
seed = 5

[cycle]
transient_turns = 0
recorded_turns = 0.25
samples_per_turn = 40

[sampling]
outer = 4
inner = 32
replicates = 4

[random]
"parameter.crank_length" = { normal = { mean = "50 mm", standard_deviation = "3 mm" } }

[epistemic]
"parameter.rod_length" = { interval = ["51.5 mm", "56 mm"] }

[[ask]]
output = "slider"
of = "clearance"
reduce = "maximum"
statistics = ["mean", { probability_above = "2 mm" }]
"#;

/// A pin so soft in some samples that the impacts press it out of its hole.
const TOO_SOFT: &str = r#"
name = "pins that are too soft"
model = "model.toml"
seed = 7

[cycle]
transient_turns = 0
recorded_turns = 0.5
samples_per_turn = 40

[sampling]
outer = 4
inner = 16
replicates = 4
most_failed = 1

[random]
"parameter.crank_length" = { normal = { mean = "50 mm", standard_deviation = "0.3 mm" } }

[epistemic]
"contact.steel_pin.youngs_modulus" = { interval = ["0.5 MPa", "200 MPa"] }

[[ask]]
output = "slider"
of = "total"
reduce = "maximum"
statistics = [{ probability_above = "2 mm" }]
"#;

fn desk(study: &str) -> Desk {
    let desk = Desk::new();
    // The rod is as the studies have it: one dimension has one nominal value.
    let rod = if study == TOO_LONG { "rod_length = \"54 mm\"" } else { "rod_length = \"120 mm\"" };
    desk.write("model.toml", &case_text("slider_crank_worn_pin", "model.toml").replace("rod_length = \"120 mm\"", rod));
    desk.write("study.toml", study);
    desk
}

/// The most frequent reason of a finished study.
fn commonest(desk: &Desk, folder: &str) -> serde_json::Value {
    let summary: serde_json::Value = serde_json::from_str(&desk.read(&format!("{folder}/summary.json"))).expect("JSON");
    summary["failures"][0].clone()
}

#[test]
fn a_study_ends_where_too_many_runs_fail_and_goes_on_from_there() {
    let desk = desk(TOO_LONG);
    let said = desk.run(&["study", "study.toml", "--out", "bounds"]);
    assert_eq!((said.status, said.output.as_str()), (2, ""), "{}", said.messages);
    // A standard deviation of 3 mm on 50 mm is warned of first.
    let (warning, failure) = said.messages.split_once("error[E0815]: ").expect("too many failed");
    assert!(warning.starts_with("study.toml:17:1: warning[E0823]: "), "{warning}");
    let (message, hint) = failure.split_once("\nhint: `").expect("a hint");
    assert!(message.contains(" runs failed ("), "{message}");
    assert!(message.contains("; at most 10 % may: most_failed under [sampling]; "), "{message}");
    assert!(message.contains(" of them: the links cannot close at "), "{message}");
    let (command, rest) = hint.split_once("` repeats one; ").expect("a command");
    assert_eq!(rest, "--resume --most-failed SHARE goes on with the runs that are kept\n");
    let again = desk.paste(command);
    assert_eq!(again.status, 2);
    assert!(again.messages.contains("error[E0704]: the links cannot close at "), "{}", again.messages);
    assert!(desk.path("bounds/runs.parquet").exists() && desk.path("bounds/runs.sqlite").exists());
    let resumed = desk.run(&["study", "study.toml", "--out", "bounds", "--resume", "--most-failed", "0.3"]);
    assert_eq!(resumed.status, 0, "{}", resumed.messages);
    assert!(resumed.messages.contains("continuing with "), "{}", resumed.messages);
    let summary: serde_json::Value = serde_json::from_str(&desk.read("bounds/summary.json")).expect("JSON");
    let share =
        summary["counts"]["failed"].as_f64().expect("a count") / summary["counts"]["runs"].as_f64().expect("a count");
    assert!((0.02..0.3).contains(&share), "{share}");
    // The mean of the finished runs is called that, and the answer begins with those that failed.
    let mean = &summary["bounds"][0];
    assert_eq!((&mean["statistic"]["kind"], &mean["guarantee"]["kind"]), (&"mean".into(), &"finished_runs".into()));
    assert_eq!(mean["upper"]["widened_si"], "inf");
    assert!(mean["upper"]["value_si"].as_f64().is_some_and(f64::is_finite), "{mean}");
    let output = resumed.output.split_whitespace().collect::<Vec<_>>().join(" ");
    let (first, _) = output.split_once(" has no bound, since a failed run may have had any value").expect(&output);
    assert!(first.contains(" % of the runs failed (") && first.contains("the links cannot close."), "{first}");
}

#[test]
fn identity_the_printed_command_fails_in_the_same_way_at_the_same_instant() {
    let desk = desk(TOO_SOFT);
    let said = desk.run(&["study", "study.toml", "--out", "bounds"]);
    assert_eq!(said.status, 0, "{}", said.messages);
    let reason = commonest(&desk, "bounds");
    let words = reason["words"].as_str().expect("words");
    let command = reason["example"]["command"].as_str().expect("a command");
    // The same bits: the words name the instant and the depth.
    assert!(words.contains("is pressed"), "{words}");
    assert!(said.output.contains(&format!("again: {command}\n")), "{}", said.output);
    let again = desk.paste(&format!("{command} --out again"));
    assert!(again.status == 2 && again.messages.contains(words), "{words}\n{}", again.messages);
}

/// LuGre's bristles that hardly slip: springs that contacts wind up. The command of one of the runs shows the same.
#[test]
fn runs_in_which_a_law_gains_energy_are_failed_runs_by_name() {
    let bristles = "\"contact.steel_pin.friction.bristle_stiffness\" = { interval = [\"9e4 m^-1\", \"1e5 m^-1\"] }";
    let stiffness = "\"contact.steel_pin.youngs_modulus\" = { interval = [\"0.5 MPa\", \"200 MPa\"] }";
    // Longer ones may wind themselves up until they are given up.
    let short = TOO_SOFT.replace("recorded_turns = 0.5", "recorded_turns = 0.1");
    let desk = desk(&short.replace(stiffness, bristles));
    let lugre = "friction = { law = \"lugre\", coefficient = 1e4, static_coefficient = 1.5e4, stribeck_speed = \"10 mm/s\", \
                 bristle_stiffness = \"1e5 m^-1\" }";
    let model = desk.read("model.toml");
    desk.write("model.toml", &model.replace("poisson_ratio = 0.3", &format!("poisson_ratio = 0.3\n{lugre}")));
    let said = desk.run(&["study", "study.toml", "--out", "bounds"]);
    assert_eq!(said.status, 0, "{}", said.messages);
    let reason = commonest(&desk, "bounds");
    assert_eq!(reason["code"], "law_gains_energy");
    let words = reason["words"].as_str().expect("words");
    assert!(words.starts_with("friction in joint 'gudgeon' released "), "{words}");
    let command = reason["example"]["command"].as_str().expect("a command");
    let again = desk.paste(&format!("{command} --out again"));
    assert!(again.status == 2 && again.messages.contains(words), "{words}\n{}", again.messages);
    assert!(desk.path("again/history.csv").exists(), "what was computed is kept");
}
