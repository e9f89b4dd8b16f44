//! `loosepin study`: exit status, files, the same bytes for any number of threads, an orderly end on Ctrl-C.

use std::fs;
use std::io::Read;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

use super::command_line::{Desk, Said, case_text};

/// A study of a tenth of a turn, so that its thousand runs take seconds.
const SHORT_STUDY: &str = r#"
name = "a tenth of a turn"
model = "model.toml"
seed = 7

[cycle]
transient_turns = 0
recorded_turns = 0.1
samples_per_turn = 40

[sampling]
outer = 9
inner = 16
replicates = 4

[random]
"parameter.crank_length" = { normal = { mean = "50 mm", standard_deviation = "0.02 mm" } }

[epistemic]
"joint.gudgeon.radial_clearance" = { interval = ["0.1 mm", "0.5 mm"] }

[[ask]]
output = "slider"
of = "total"
reduce = "maximum_absolute"
statistics = ["mean"]
"#;

/// A requirement that every run of the short study keeps.
const KEPT: &str = "\n[[require]]\noutput = \"slider\"\nof = \"total\"\nwithin = \"5 mm\"\nover = \"cycle\"\nprobability_at_least = 0.5\n";
/// One that no run keeps.
const BROKEN: &str = "\n[[require]]\noutput = \"slider\"\nof = \"total\"\nwithin = \"1e-6 mm\"\nover = \"cycle\"\nprobability_at_least = 0.5\n";

fn desk(study: &str) -> Desk {
    let desk = Desk::with_model("slider_crank_worn_pin");
    desk.write("study.toml", study);
    desk
}

#[test]
fn identity_a_study_with_a_setting_is_that_of_a_model_with_the_value() {
    let desk = Desk::new();
    desk.succeed(&["new", "slider-crank", "."]);
    let study = "name = \"rod\"\nmodel = \"model.toml\"\n[cycle]\ntransient_turns = 0\nrecorded_turns = 0.1\nsamples_per_turn = 40\n\
        [sampling]\nouter = 8\ninner = 16\n[random]\n\"parameter.rod_length\" = { tolerance = \"± 0.1 mm\" }\n\
        [epistemic]\n\"joint.gudgeon.radial_clearance\" = { interval = [\"0.3 mm\", \"0.5 mm\"] }\n\
        [[ask]]\noutput = \"slider\"\nof = \"value\"\nreduce = \"maximum\"\nstatistics = [\"mean\"]\n";
    desk.write("study.toml", study);
    let set = ["--set", "parameter.rod_length=125 mm", "--set", "parameter.crank_length=48mm"];
    desk.succeed(&[&["study", "study.toml", "--out", "set"][..], &set].concat());
    let model = desk.read("model.toml");
    let written = model
        .replace("rod_length = \"120 mm\"", "rod_length = \"125 mm\"")
        .replace("crank_length = \"50 mm\"", "crank_length = \"48 mm\"");
    let read = |folder: &str| -> serde_json::Value {
        serde_json::from_str(&desk.read(&format!("{folder}/summary.json"))).expect("JSON")
    };
    desk.write("model.toml", &written);
    desk.succeed(&["study", "study.toml", "--out", "written"]);
    desk.write("model.toml", &model);
    desk.succeed(&["study", "study.toml", "--out", "plain"]);
    let [of_set, of_written, plain] = ["set", "written", "plain"].map(read);
    assert_eq!(of_set["treatments"], of_written["treatments"]);
    assert_ne!(of_set["treatments"], plain["treatments"]);
    // The command that makes it again, and those of its witnesses, have the settings.
    let command = of_set["repeat"]["command"].as_str().expect("a command");
    assert_eq!(
        command,
        "loosepin study study.toml --set 'parameter.rod_length=125 mm' --set parameter.crank_length=48mm"
    );
    let witness = of_set["witness_commands"].to_string();
    assert!(
        witness.contains("parameter.crank_length=48mm") && !plain["witness_commands"].to_string().contains("48mm"),
        "{witness}"
    );
    // A value of what has none, and one that no model has.
    desk.fail(
        &["study", "study.toml", "--set", "joint.gudgeon.radial_clearance=0.4mm"],
        "error[E0409]: 'joint.gudgeon.radial_clearance' is set, but is an unknown (epistemic) input of the study, which has no single value\n\
         hint: change it under [epistemic], or remove it there",
    );
    let unknown = desk.run(&["study", "study.toml", "--set", "parameter.rod=1mm"]);
    assert!(unknown.status == 2 && unknown.messages.contains("error[E0405]"), "{}", unknown.messages);
}

#[test]
fn identity_one_and_two_threads_write_the_same_bytes() {
    let desk = desk(&format!("{SHORT_STUDY}{KEPT}"));
    let one = desk.succeed(&["study", "study.toml", "--threads", "1", "--out", "one"]);
    let two = desk.succeed(&["study", "study.toml", "--threads", "2", "--out", "two"]);
    assert_eq!(one.output, two.output);
    assert!(one.output.starts_with("a tenth of a turn\n"));
    let rest = "--all adds every bound and where it is attained, the three treatments, runs and assumptions\n";
    assert_eq!(one.messages, format!("{rest}report: one/report.html\n"), "no progress where there is no terminal");
    for file in ["summary.json", "bounds.csv", "runs.parquet", "report.html", "loosepin.json"] {
        let bytes = |folder: &str| fs::read(desk.path(folder).join(file)).expect("written");
        assert!(bytes("one") == bytes("two"), "{file} differs");
    }
    let timing: serde_json::Value = serde_json::from_str(&desk.read("two/timing.json")).expect("JSON");
    assert_eq!(timing["threads"], 2);
}

#[test]
fn a_requirement_that_is_not_met_is_exit_status_1() {
    let desk = desk(&format!("{SHORT_STUDY}{BROKEN}"));
    let said = desk.run(&["study", "study.toml", "--out", "bounds"]);
    assert_eq!(said.status, 1, "{}", said.messages);
    assert!(said.output.contains("Not met: the "), "{}", said.output);
    // The stored result says the same.
    let again = desk.run(&["study", "study.toml", "--out", "bounds"]);
    assert_eq!((again.status, &again.output), (1, &said.output));
    assert_eq!(
        again.messages,
        "bounds already holds this study: the report is written again (--force runs it again)\n\
         --all adds every bound and where it is attained, the three treatments, runs and assumptions\nreport: bounds/report.html\n"
    );
    let report = desk.run(&["report", "bounds"]);
    assert_eq!((report.status, &report.output), (1, &said.output));
    // A pipe that nobody reads to its end changes nothing of that.
    let piped = [Stdio::null(), Stdio::piped(), Stdio::null()];
    let [input, output, messages] = piped;
    let mut command = desk.command(&["study", "study.toml", "--out", "bounds"]);
    let mut child = command.stdin(input).stdout(output).stderr(messages).spawn().expect("the command starts");
    drop(child.stdout.take());
    assert_eq!(child.wait().expect("it ends").code(), Some(1));
    // Another study does not go into the same folder.
    desk.write("study.toml", &SHORT_STUDY.replace("seed = 7", "seed = 8"));
    let refused = desk.run(&["study", "study.toml", "--out", "bounds"]);
    assert_eq!(refused.status, 2);
    assert!(
        refused.messages.starts_with("error[E0901]: bounds contains another study, 'a tenth of a turn' (inputs "),
        "{}",
        refused.messages
    );
    assert!(refused.messages.ends_with("hint: give another folder, or replace these results with --force\n"));
}

#[cfg(unix)]
#[test]
fn ctrl_c_ends_a_study_and_keeps_its_runs() {
    let desk = Desk::with_model("slider_crank_worn_pin");
    desk.write("study.toml", &case_text("slider_crank_worn_pin", "study.toml"));
    let mut child = desk
        .command(&["study", "study.toml", "--out", "bounds"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the command starts");
    while !desk.path("bounds/loosepin.json").exists() {
        sleep(Duration::from_millis(20));
    }
    sleep(Duration::from_millis(300));
    let interrupt = Command::new("kill").args(["-INT", &child.id().to_string()]).status().expect("kill is there");
    assert!(interrupt.success());
    let mut messages = String::new();
    child.stderr.take().expect("piped").read_to_string(&mut messages).expect("UTF-8");
    assert_eq!(child.wait().expect("it ends").code(), Some(130), "{messages}");
    assert!(messages.starts_with("interrupted after ") && messages.contains(" of at most "), "{messages}");
    assert!(
        messages.ends_with("they are kept in bounds/runs.sqlite\nhint: continue with the same command and --resume\n"),
        "{messages}"
    );
    assert!(desk.path("bounds/runs.parquet").exists());
    let Said { messages, status, .. } = desk.run(&["report", "bounds"]);
    assert_eq!(status, 2);
    assert_eq!(
        messages,
        "error[E0902]: the study 'worn pin at 5000 rpm' in bounds did not finish\n\
         hint: run the same command again; it writes into the same folder\n"
    );
}

#[test]
fn check_tells_what_is_one_of_a_list() {
    let lists = "\"joint.gudgeon.radial_clearance\" = { any_of = [\"0.1 mm\", \"0.25 mm\"] }\n\
                 \"contact.steel_pin.law\" = { any_of = [\"lankarani-nikravesh\", \"flores\", \"hertz\"] }";
    let interval = "\"joint.gudgeon.radial_clearance\" = { interval = [\"0.1 mm\", \"0.5 mm\"] }";
    let desk = desk(&SHORT_STUDY.replace(interval, lists));
    let said = desk.succeed(&["check", "study.toml"]).output;
    let expected = "2 inputs from lists\n  \
                    joint.gudgeon.radial_clearance  any of 0.1 mm, 0.25 mm\n  \
                    contact.steel_pin.law           any of lankarani-nikravesh, flores, hertz\n";
    assert!(said.contains(expected), "{said}");
    // Six combinations of 16 runs; 1024 where all is random; 128 of each combination where nothing is.
    assert!(said.contains("At most 1888 runs"), "{said}");
}

#[test]
fn an_accuracy_is_reached_or_it_is_said_what_it_would_take() {
    let desk = desk(&format!("{SHORT_STUDY}{KEPT}"));
    let reached = desk.succeed(&["study", "study.toml", "--accuracy", "slider.mean=20um", "--out", "near", "--all"]);
    assert!(
        reached.output.contains("\nAccuracy of the bounds\n\n- All bounds reach the required accuracy after "),
        "{}",
        reached.output
    );
    // A line may end between any two words.
    let words: Vec<&str> = reached.output.split_whitespace().collect();
    assert!(words.join(" ").contains(", required 0.02 mm."), "{}", reached.output);
    // Not reached is said and is no error; nothing is lost.
    let ended =
        desk.succeed(&["study", "study.toml", "--accuracy", "1e-14m", "--budget", "2500 runs", "--out", "ended"]);
    assert!(
        ended.output.contains("- The required accuracy is not reached. The study ended after "),
        "{}",
        ended.output
    );
    assert!(ended.output.contains("exceed the budget of 2500 runs."), "{}", ended.output);
    assert!(ended.output.contains("- The bounds use all runs made so far."), "{}", ended.output);
    let summary: serde_json::Value = serde_json::from_str(&desk.read("ended/summary.json")).expect("JSON");
    let accuracy = &summary["accuracy"];
    assert_eq!((&accuracy["stop"], &accuracy["budget"]["runs"]), (&"budget".into(), &2500.into()));
    assert_eq!(accuracy["runs"], summary["counts"]["runs"]);
    // As many rounds as it made make the same runs.
    let rounds = format!("{} rounds", accuracy["rounds"]);
    desk.succeed(&["study", "study.toml", "--accuracy", "1e-14m", "--budget", &rounds, "--out", "again"]);
    for file in ["bounds.csv", "runs.parquet"] {
        let bytes = |folder: &str| fs::read(desk.path(folder).join(file)).expect("written");
        assert!(bytes("ended") == bytes("again"), "{file} differs");
    }
}

#[test]
fn accuracies_and_budgets_are_reported_with_the_column_in_their_text() {
    let desk = desk(SHORT_STUDY);
    for (argument, value, messages) in [
        (
            "--accuracy",
            "1kg",
            "--accuracy:1:1: error[E0304]: the accuracy is a mass; must be a length\n\
             hint: an accuracy has the unit of the bounds; for probabilities it is a number such as 0.01",
        ),
        ("--accuracy", "-1um", "--accuracy:1:1: error[E0501]: the accuracy is -0.001 mm; must be > 0"),
        (
            "--accuracy",
            "0.01",
            "--accuracy:1:1: error[E0303]: the accuracy is 0.01 without a unit; must be a length\nhint: for example 0.5 mm",
        ),
        (
            "--accuracy",
            "slidr.mean=1um",
            "--accuracy:1:1: error[E0401]: no question has an output 'slidr'\nhint: did you mean 'slider'?",
        ),
        (
            "--accuracy",
            "slider.maen=1um",
            "--accuracy:1:8: error[E0204]: 'maen' is not a statistic with an accuracy\nhint: did you mean 'mean'?",
        ),
        (
            "--accuracy",
            "slider.quantile=1um",
            "--accuracy:1:8: error[E0401]: no question has the quantile of 'slider'\n\
             hint: its statistics are mean; add others to the statistics of an [[ask]]",
        ),
        (
            "--accuracy",
            "slider.mean=1 uum",
            "--accuracy:1:15: error[E0302]: 'uum' is not a known unit\nhint: did you mean 'um'?",
        ),
        (
            "--budget",
            "soon",
            "--budget:1:1: error[E0301]: 'soon' is no budget of runs, time or rounds\n\
             hint: for example 20000 runs, 30 min or 12 rounds",
        ),
        ("--budget", "-5 min", "--budget:1:1: error[E0501]: a budget is -5 min; must be > 0"),
    ] {
        desk.fail(&["study", "study.toml", argument, value], messages);
    }
    assert!(!desk.path("results").exists(), "nothing is left behind");
}
