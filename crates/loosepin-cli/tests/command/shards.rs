//! A study that several processes share ends with the bytes of one that runs in a single piece.
#![cfg(unix)]

use std::fs;
use std::process::{Child, Stdio};
use std::thread::sleep;
use std::time::Duration;

use super::command_line::{Desk, Said};

/// A study whose samples grow over rounds.
const INPUTS: &str = r#"
name = "shared"
model = "model.toml"
seed = 11

[cycle]
transient_turns = 0
recorded_turns = 0.125
samples_per_turn = 40

[sampling]
outer = 6
inner = 16
replicates = 4
accuracy = "0.2 um"
budget = "4 rounds"

[random]
"parameter.crank_length" = { normal = { mean = "50 mm", standard_deviation = "0.02 mm" } }

[epistemic]
"joint.gudgeon.radial_clearance" = { interval = ["0.1 mm", "0.5 mm"] }
"#;

/// Questions of a study with many runs: shares of the variance, and the inverse question of how far `input` may go.
pub(super) fn questions(within: &str, input: &str, up_to: &str) -> String {
    format!(
        r#"
[[ask]]
output = "slider"
of = "total"
poses = {{ crank = ["30 deg"] }}
statistics = ["mean", "contributors"]

[[require]]
output = "slider"
of = "total"
within = "{within}"
over = "cycle"
probability_at_least = 0.8

[allow]
"{input}" = {{ up_to = "{up_to}" }}
"#
    )
}

fn study() -> String {
    format!("{INPUTS}{}", questions("0.45 mm", "joint.gudgeon.radial_clearance", "0.3 mm"))
}

/// Files that do not depend on who has made the runs.
const FILES: [&str; 4] = ["summary.json", "bounds.csv", "runs.parquet", "report.html"];

/// Study with a surrogate in place of the inverse question.
fn with_surrogate() -> String {
    let study = study();
    let (without_allow, _) = study.split_once("[allow]").expect("it asks how loose the pin may be");
    without_allow
        .replace("seed = 11", "seed = 11\nsurrogate = { kind = \"chaos\", training_runs = 40, confirming_runs = 8 }")
}

fn desk() -> Desk {
    let desk = Desk::with_model("slider_crank_worn_pin");
    desk.write("study.toml", &study());
    desk
}

fn started(desk: &Desk, out: &str, index: u32, of: u32) -> Child {
    let shard = format!("{index}/{of}");
    let mut command =
        desk.command(&["study", "study.toml", "--out", out, "--resume", "--threads", "1", "--shard", &shard]);
    command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the command starts")
}

fn shard(desk: &Desk, out: &str, index: u32, of: u32) -> Said {
    started(desk, out, index, of).wait_with_output().expect("it ends").into()
}

/// Joins shards 1 to `of`. Two shards make the studies of the inverse question too, of 80 runs a round; of more the merge does.
fn merge(desk: &Desk, out: &str, of: u32) -> Said {
    merge_with(desk, out, of, if of == 2 { 50 } else { 100 })
}

/// Merge that makes rounds of at most so many runs itself.
fn merge_with(desk: &Desk, out: &str, of: u32, small_round: u32) -> Said {
    let folders: Vec<String> = (1..=of).map(|index| format!("{out}.shard-{index}-of-{of}")).collect();
    let small_round = small_round.to_string();
    let mut arguments = vec!["merge", "--small-round", &small_round];
    arguments.extend(folders.iter().map(String::as_str));
    desk.run(&arguments)
}

/// Shards and merges until the study is finished; gives the last merge and how many there were.
pub(super) fn finish(desk: &Desk, out: &str, of: u32) -> (Said, usize) {
    finish_with(desk, out, of, merge)
}

fn finish_with(desk: &Desk, out: &str, of: u32, merge: impl Fn(&Desk, &str, u32) -> Said) -> (Said, usize) {
    for merges in 1..100 {
        // Side by side, as they would be on a cluster.
        let shards: Vec<Child> = (1..=of).map(|index| started(desk, out, index, of)).collect();
        for shard in shards {
            let said: Said = shard.wait_with_output().expect("it ends").into();
            assert_eq!((said.status, said.output.as_str()), (0, ""), "{}", said.messages);
        }
        let said = merge(desk, out, of);
        if said.status != 3 {
            return (said, merges);
        }
        assert!(said.messages.contains("the next round has "), "{}", said.messages);
    }
    panic!("it does not end");
}

pub(super) fn assert_same(desk: &Desk, expected: &str, found: &str) {
    let bytes = |folder: &str, file: &str| {
        fs::read(desk.path(folder).join(file)).unwrap_or_else(|error| panic!("{folder}/{file}: {error}"))
    };
    for file in FILES {
        assert!(bytes(expected, file) == bytes(found, file), "{found}/{file} differs");
    }
    for gone in ["runs.sqlite", "merged.sqlite"] {
        assert!(!desk.path(found).join(gone).exists(), "{gone} goes when the study is finished");
    }
}

#[test]
fn identity_shards_give_the_bytes_of_the_single_run() {
    let desk = desk();
    let whole = desk.run(&["study", "study.toml", "--out", "whole"]);
    assert!(whole.status < 2, "{}", whole.messages);
    let mut merges = Vec::new();
    for of in [1, 2, 7] {
        let out = format!("shared{of}");
        let (said, number) = finish(&desk, &out, of);
        assert_eq!((said.status, &said.output), (whole.status, &whole.output), "{}", said.messages);
        assert_same(&desk, "whole", &out);
        merges.push(number);
    }
    // One shard finds all rounds by itself.
    assert_eq!(merges, [1, 4, 2]);
    let again = shard(&desk, "shared7", 3, 7);
    assert_eq!(again.status, 0);
    assert!(again.messages.starts_with("shared7 already holds this study"), "{}", again.messages);
}

#[test]
fn identity_rows_of_a_specimen_are_drawn_alike_by_threads_and_shards() {
    let desk = desk();
    let rows: Vec<String> = (0..120).map(|k| format!("{:.4}", 49.94 + 0.001 * f64::from(k * 37 % 120))).collect();
    desk.write("mechanisms.csv", &format!("parameter.crank_length [mm]\n{}\n", rows.join("\n")));
    desk.write("study.toml", &format!("{}\n[specimen]\nmechanisms = \"mechanisms.csv\"\n", study()));
    let whole = desk.run(&["study", "study.toml", "--out", "whole", "--threads", "1"]);
    assert!(whole.status < 2, "{}", whole.messages);
    let two = desk.run(&["study", "study.toml", "--out", "two", "--threads", "2"]);
    assert_eq!(two.output, whole.output);
    assert_same(&desk, "whole", "two");
    let (said, _) = finish(&desk, "shared2", 2);
    assert_eq!((said.status, &said.output), (whole.status, &whole.output), "{}", said.messages);
    assert_same(&desk, "whole", "shared2");
    // The table is an input like the study itself.
    desk.write("mechanisms.csv", &format!("parameter.crank_length [mm]\n{}\n", rows[1..].join("\n")));
    let other = desk.run(&["study", "study.toml", "--out", "whole", "--threads", "1"]);
    assert_eq!(other.status, 2, "{}", other.messages);
}

/// A probability near 1e-4 over an interval: a search for design points in rounds of a few runs, then samples around them in rounds
/// of hundreds, each of which follows from those before it.
const RARE: &str = r#"
name = "shared, a small probability"
model = "model.toml"
seed = 7

[cycle]
transient_turns = 0
recorded_turns = 0.02
samples_per_turn = 200

[sampling]
outer = 5
inner = 16
replicates = 4

[random]
"parameter.crank_length" = { normal = { mean = "50 mm", standard_deviation = "0.02 mm" } }
"parameter.rod_length" = { normal = { mean = { interval = ["119.99 mm", "120.01 mm"] }, standard_deviation = "0.03 mm" } }

[[ask]]
output = "slider"
of = "dimensional"
poses = { crank = ["5 deg"] }
statistics = [{ probability_above = "0.15 mm", method = "importance" }]
"#;

#[test]
fn identity_rare_events_by_importance_sampling_are_those_of_the_single_run() {
    let desk = desk();
    desk.write("study.toml", RARE);
    let whole = desk.run(&["study", "study.toml", "--out", "whole"]);
    assert!(whole.status < 2, "{}", whole.messages);
    assert!(desk.read("whole/summary.json").contains("\"method\": \"importance\""), "by importance sampling");
    let mut merges = Vec::new();
    for of in [1, 2, 7] {
        let out = format!("rare{of}");
        // The shards make the samples around the design points, the merge what leads to these.
        let (said, number) = finish_with(&desk, &out, of, |desk, out, of| merge_with(desk, out, of, 100));
        assert_eq!((said.status, &said.output), (whole.status, &whole.output), "{}", said.messages);
        assert_same(&desk, "whole", &out);
        merges.push(number);
    }
    assert!(merges[0] == 1 && merges[1] > 2 && merges[1] == merges[2], "{merges:?}: rounds for the shards");
}

/// Kills shard 2 of 3 of `cut` when it has begun; whether it was at work still.
fn cut_short(desk: &Desk) -> bool {
    let mut killed = started(desk, "cut", 2, 3);
    // Written when the store is open, before the first run.
    let begun = desk.path("cut.shard-2-of-3/shard.json");
    while !begun.exists() {
        assert!(killed.try_wait().expect("it can be asked").is_none(), "it ended without a beginning");
        sleep(Duration::from_millis(1));
    }
    // Too late where it has ended by itself.
    let _ = killed.kill();
    !killed.wait().expect("it ends").success()
}

#[test]
fn identity_a_killed_shard_goes_on_and_nothing_differs() {
    let desk = desk();
    desk.write("study.toml", &with_surrogate());
    let whole = desk.run(&["study", "study.toml", "--out", "whole"]);
    assert!(whole.status < 2, "{}", whole.messages);
    // It has tens of milliseconds of work: on a busy machine it may be done before it is killed.
    let was_cut = (0..10).any(|_| {
        let _ = fs::remove_dir_all(desk.path("cut.shard-2-of-3"));
        cut_short(&desk)
    });
    assert!(was_cut, "it was never killed at work");
    for index in [1, 3] {
        assert_eq!(shard(&desk, "cut", index, 3).status, 0);
    }
    let early = merge(&desk, "cut", 3);
    assert_eq!(early.status, 3);
    assert!(
        early
            .messages
            .contains("the current round of 1168 runs is not complete: runs of these shards are missing: 2/3 ("),
        "{}",
        early.messages
    );
    let (said, _) = finish(&desk, "cut", 3);
    assert_eq!((said.status, &said.output), (whole.status, &whole.output), "{}", said.messages);
    assert_same(&desk, "whole", "cut");
    assert!(desk.read("whole/surrogates.json") == desk.read("cut/surrogates.json"));
}

#[test]
fn shards_that_do_not_fit_are_refused_by_name() {
    let desk = desk();
    for index in 1..=3 {
        assert_eq!(shard(&desk, "bounds", index, 3).status, 0);
    }
    let [one, two, three] = [1, 2, 3].map(|index| format!("bounds.shard-{index}-of-3"));
    desk.fail(
        &["merge", &one, &three],
        "error[E0911]: 1 of 3 shards is missing: 2/3\n\
         hint: also give their folders; loosepin study study.toml --shard 2/3 makes the runs of shard 2",
    );
    desk.fail(
        &["merge", &one, &two, &two, &three],
        "error[E0911]: shard 2/3 is given twice: bounds.shard-2-of-3 and bounds.shard-2-of-3\nhint: give each shard once",
    );
    let again = desk.run(&["study", "study.toml", "--out", "bounds", "--shard", "2/3"]);
    assert_eq!(again.status, 2);
    assert!(
        again.messages.starts_with("error[E0910]: bounds.shard-2-of-3/runs.sqlite contains "),
        "{}",
        again.messages
    );
    // A store that was copied over that of another shard.
    fs::rename(desk.path(&two).join("runs.sqlite"), desk.path("kept.sqlite")).expect("moved");
    fs::copy(desk.path(&one).join("runs.sqlite"), desk.path(&two).join("runs.sqlite")).expect("copied");
    desk.fail(
        &["merge", &one, &two, &three],
        "error[E0909]: bounds.shard-2-of-3/runs.sqlite is damaged: run 0 of list 0 is one of shard 1/3, not of 2/3\n\
         hint: restore it from a copy; --force starts again",
    );
    fs::rename(desk.path("kept.sqlite"), desk.path(&two).join("runs.sqlite")).expect("moved back");
    // A shard of another study, and of this one in another number.
    desk.write("study.toml", &study().replace("seed = 11", "seed = 12"));
    assert_eq!(shard(&desk, "other", 3, 3).status, 0);
    let said = desk.run(&["merge", &one, &two, "other.shard-3-of-3"]);
    assert_eq!(said.status, 2);
    assert!(
        said.messages.starts_with("error[E0911]: other.shard-3-of-3 belongs to another study ("),
        "{}",
        said.messages
    );
    let said = desk.run(&["merge", &one, &two, &three]);
    assert!(said.messages.starts_with("error[E0911]: study.toml with its model (inputs "), "{}", said.messages);
    assert!(said.messages.contains("hint: give the original study with --study"), "{}", said.messages);
    desk.fail(
        &["merge", "model.toml"],
        "error[E0911]: model.toml is not the folder of a shard: cannot read model.toml/shard.json: a part of the path is a file\n\
         hint: give the folders written by loosepin study --shard i/n, RESULTS.shard-i-of-n",
    );
    desk.fail(
        &["study", "study.toml", "--budget", "3min", "--shard", "1/3"],
        "--budget:1:1: error[E0611]: a budget of time cannot be shared by shards, which run at different times\n\
         hint: state it in runs or rounds, for example 200000runs",
    );
    let said = desk.run(&["study", "study.toml", "--shard", "4/3"]);
    assert_eq!(said.status, 2);
    assert!(said.messages.contains("'4/3' is no shard: write i/n, shard i of n"), "{}", said.messages);
}

#[test]
fn a_forced_shard_begins_anew_whatever_was_published() {
    let desk = desk();
    for index in [1, 2] {
        assert_eq!(shard(&desk, "bounds", index, 2).status, 0);
    }
    let open = merge(&desk, "bounds", 2);
    assert!(open.status == 3 && desk.path("bounds/merged.sqlite").exists(), "{}", open.messages);
    // Of the study before it was changed.
    desk.write("study.toml", &study().replace("seed = 11", "seed = 12"));
    let refused = shard(&desk, "bounds", 1, 2);
    assert_eq!(refused.status, 2, "{}", refused.messages);
    let forced = desk.run(&["study", "study.toml", "--out", "bounds", "--shard", "1/2", "--force"]);
    assert_eq!(forced.status, 0, "{}", forced.messages);
    assert!(!forced.messages.contains("continuing with"), "{}", forced.messages);
}

#[test]
fn identity_rounds_of_a_surrogate_that_stands_alone_are_those_of_the_single_run() {
    let desk = desk();
    let study = with_surrogate().replace("confirming_runs = 8 }", "confirming_runs = 8, direct = \"confirming\" }");
    let study = study.replace(", \"contributors\"", "").replace("training_runs = 40", "training_runs = 16");
    desk.write("study.toml", &study);
    let whole = desk.run(&["study", "study.toml", "--out", "whole"]);
    assert!(whole.status < 2, "{}", whole.messages);
    let (said, merges) = finish_with(&desk, "shared2", 2, |desk, out, of| merge_with(desk, out, of, 0));
    assert_eq!((said.status, &said.output), (whole.status, &whole.output), "{}", said.messages);
    assert_same(&desk, "whole", "shared2");
    assert!(merges > 3, "{merges}: each step has runs to learn from and runs to hold against");
}
