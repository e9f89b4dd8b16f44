//! A study that was killed goes on where it stopped, and ends with the same bytes.
#![cfg(unix)]

mod command_line;

use std::fs;
use std::path::Path;
use std::process::{Child, Stdio};
use std::thread::sleep;
use std::time::Duration;

use command_line::Desk;

/// A study whose runs take seconds, with two rounds and a direct study of the inverse question.
const STUDY: &str = r#"
name = "half a turn"
model = "model.toml"
seed = 11

[cycle]
transient_turns = 0
recorded_turns = 0.5
samples_per_turn = 40

[sampling]
outer = 12
inner = 64
replicates = 4

[random]
"parameter.crank_length" = { normal = { mean = "50 mm", standard_deviation = "0.02 mm" } }

[epistemic]
"joint.gudgeon.radial_clearance" = { interval = ["0.1 mm", "0.5 mm"] }

[[require]]
output = "slider"
of = "total"
within = "0.45 mm"
over = "cycle"
probability_at_least = 0.8

[allow]
"joint.gudgeon.radial_clearance" = { up_to = "0.5 mm" }
"#;

fn desk() -> Desk {
    let desk = Desk::with_model("slider_crank_worn_pin");
    desk.write("study.toml", STUDY);
    desk
}

fn start(desk: &Desk, arguments: &[&str]) -> Child {
    let mut command = desk.command(arguments);
    command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().expect("the command starts")
}

/// Kills a study after it has committed runs `commits` times.
fn kill_after(desk: &Desk, commits: u32) {
    let mut child = start(desk, &["study", "study.toml", "--out", "killed", "--resume"]);
    let log = desk.path("killed/runs.sqlite-wal");
    let size = || fs::metadata(&log).map_or(0, |found| found.len());
    let mut seen = 0;
    let mut last = 0;
    while seen <= commits && child.try_wait().expect("it can be asked").is_none() {
        sleep(Duration::from_millis(3));
        let now = size();
        if now != last {
            (last, seen) = (now, seen + 1);
        }
    }
    // Too late where it has ended by itself.
    let _ = child.kill();
    child.wait().expect("it ends");
}

fn bytes(desk: &Desk, folder: &str, file: &str) -> Vec<u8> {
    fs::read(desk.path(folder).join(file)).unwrap_or_else(|error| panic!("{folder}/{file}: {error}"))
}

fn is_there(path: &Path) -> bool {
    path.try_exists().expect("it can be asked")
}

#[test]
fn identity_a_killed_study_ends_with_the_same_bytes() {
    let desk = desk();
    let whole = desk.run(&["study", "study.toml", "--out", "whole"]);
    assert!(whole.status < 2, "{}", whole.messages);
    assert!(!is_there(&desk.path("whole/runs.sqlite")), "the store goes when the study is finished");
    for commits in [1, 2, 3] {
        kill_after(&desk, commits);
    }
    assert!(is_there(&desk.path("killed/runs.sqlite")), "killed too late to show anything");
    let refused = desk.run(&["study", "study.toml", "--out", "killed"]);
    assert_eq!(refused.status, 2);
    assert!(refused.messages.starts_with("error[E0910]: killed/runs.sqlite holds "), "{}", refused.messages);
    assert!(
        refused
            .messages
            .ends_with(" finished runs of this study\nhint: --resume goes on with them, --force begins anew\n"),
        "{}",
        refused.messages
    );
    let resumed = desk.run(&["study", "study.toml", "--out", "killed", "--resume", "--threads", "1"]);
    assert!(resumed.messages.starts_with("going on with "), "{}", resumed.messages);
    assert_eq!((resumed.status, &resumed.output), (whole.status, &whole.output));
    for file in ["summary.json", "bounds.csv", "runs.parquet", "report.html"] {
        assert!(bytes(&desk, "whole", file) == bytes(&desk, "killed", file), "{file} differs");
    }
    assert!(!is_there(&desk.path("killed/runs.sqlite")));
}

#[test]
fn a_second_process_is_refused_while_the_first_is_at_work() {
    let desk = desk();
    let mut first = start(&desk, &["study", "study.toml", "--out", "bounds"]);
    while !is_there(&desk.path("bounds/runs.sqlite")) {
        assert!(first.try_wait().expect("it can be asked").is_none(), "it ended without a store");
        sleep(Duration::from_millis(3));
    }
    // The file is made a moment before it is locked.
    sleep(Duration::from_millis(200));
    let second = desk.run(&["study", "study.toml", "--out", "bounds", "--resume"]);
    first.kill().expect("it is at work still");
    first.wait().expect("it ends");
    assert_eq!(second.status, 2);
    assert_eq!(
        second.messages,
        "error[E0907]: bounds/runs.sqlite is in use by another loosepin\n\
         hint: wait for it to end, or give another folder by --out\n"
    );
}
