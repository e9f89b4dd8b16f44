//! A study that was killed goes on where it stopped, and ends with the same bytes.
#![cfg(unix)]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, SystemTime};

use super::command_line::{Desk, Said};

/// A study of seconds, with two rounds and a direct study of the inverse question.
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

/// Bytes of a store's log beyond which it holds runs, not only the tables for them.
const LOG_WITH_RUNS_BYTES: u64 = 20_000;

/// Bytes of the log of a store; none where there is no log.
fn log_bytes(desk: &Desk, folder: &str) -> u64 {
    fs::metadata(desk.path(folder).join("runs.sqlite-wal")).map_or(0, |found| found.len())
}

/// Kills a study after it has committed runs `commits` times. It has one thread, so that it is far from its end by then on fast
/// machines too.
pub(super) fn kill_after(desk: &Desk, commits: u32) {
    let arguments = ["study", "study.toml", "--out", "killed", "--resume", "--threads", "1"];
    let mut last = log_bytes(desk, "killed");
    let mut child = start(desk, &arguments);
    let mut seen = 0;
    while seen < commits && child.try_wait().expect("it can be asked").is_none() {
        sleep(Duration::from_millis(3));
        let now = log_bytes(desk, "killed");
        if now != last {
            seen += u32::from(now > LOG_WITH_RUNS_BYTES);
            last = now;
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
    assert!(refused.messages.starts_with("error[E0910]: killed/runs.sqlite contains "), "{}", refused.messages);
    assert!(
        refused
            .messages
            .ends_with(" finished runs of this study\nhint: --resume continues with them, --force starts again\n"),
        "{}",
        refused.messages
    );
    let resumed = desk.run(&["study", "study.toml", "--out", "killed", "--resume", "--threads", "1"]);
    assert!(resumed.messages.starts_with("continuing with "), "{}", resumed.messages);
    assert_eq!((resumed.status, &resumed.output), (whole.status, &whole.output));
    for file in ["summary.json", "bounds.csv", "runs.parquet", "report.html"] {
        assert!(bytes(&desk, "whole", file) == bytes(&desk, "killed", file), "{file} differs");
    }
    assert!(!is_there(&desk.path("killed/runs.sqlite")));
}

/// A surrogate alone to an accuracy: runs to learn from, runs at its witnesses and more of either are rounds of their own.
#[test]
fn identity_rounds_of_a_surrogate_that_were_killed_end_with_the_same_bytes() {
    const TRAINING_RUNS: usize = 30;
    let desk = desk();
    let (sampled, _) = STUDY.split_once("[[require]]").expect("a requirement");
    let asked = format!(
        r#"
[surrogate]
kind = "chaos"
training_runs = {TRAINING_RUNS}
confirming_runs = 8
direct = "confirming"

[[ask]]
output = "slider"
of = "total"
poses = {{ crank = ["60 deg"] }}
statistics = ["mean"]
"#
    );
    // Runs of some milliseconds, so that rounds of a few are not over before they are seen.
    let sampled = sampled
        .replace("transient_turns = 0", "transient_turns = 1")
        .replace("inner = 64", "inner = 16\naccuracy = \"2 um\"\nbudget = \"4 rounds\"");
    desk.write("study.toml", &format!("{sampled}{asked}"));
    let whole = desk.run(&["study", "study.toml", "--out", "whole"]);
    assert!(whole.status < 2, "{}", whole.messages);
    for commits in [1, 3] {
        kill_after(&desk, commits);
    }
    assert!(is_there(&desk.path("killed/runs.sqlite")), "killed too late to show anything");
    let resumed = desk.run(&["study", "study.toml", "--out", "killed", "--resume", "--threads", "1"]);
    let kept = resumed.messages.strip_prefix("continuing with ").and_then(|rest| rest.split(' ').next()?.parse().ok());
    assert!(kept.is_some_and(|kept: usize| kept > TRAINING_RUNS), "not killed in a later round: {}", resumed.messages);
    assert_eq!((resumed.status, &resumed.output), (whole.status, &whole.output));
    for file in ["summary.json", "bounds.csv", "runs.parquet", "surrogates.json", "report.html"] {
        assert!(bytes(&desk, "whole", file) == bytes(&desk, "killed", file), "{file} differs");
    }
}

/// Every file of a folder with its bytes and when it was written.
fn files(folder: &Path) -> Vec<(PathBuf, Vec<u8>, SystemTime)> {
    let entries = fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("readable").path());
    let mut files: Vec<_> = entries
        .map(|path| {
            let written = fs::metadata(&path).and_then(|known| known.modified()).expect("it has a time");
            (path.clone(), fs::read(&path).expect("readable"), written)
        })
        .collect();
    files.sort();
    files
}

/// Starts a process, and sends it a signal as soon as it has kept runs in `folder`.
fn signalled(desk: &Desk, arguments: &[&str], folder: &str, signal: &str) -> Child {
    let mut child = start(desk, arguments);
    while log_bytes(desk, folder) < LOG_WITH_RUNS_BYTES {
        assert!(child.try_wait().expect("it can be asked").is_none(), "it ended before it had kept runs");
        sleep(Duration::from_millis(3));
    }
    let sent = Command::new("kill").args([signal, &child.id().to_string()]).status().expect("it can be sent");
    assert!(sent.success());
    child
}

/// A process that is at work in `folder`, where nothing moves any more.
fn stopped(desk: &Desk, arguments: &[&str], folder: &str) -> Child {
    let child = signalled(desk, arguments, folder, "-STOP");
    // Until all of its threads stand still.
    sleep(Duration::from_millis(100));
    child
}

#[test]
fn a_second_process_is_refused_and_leaves_every_byte_as_it_was() {
    let desk = desk();
    // With other inputs, so that whatever it writes is not the same by chance.
    desk.write("other.toml", &STUDY.replace("seed = 11", "seed = 12"));
    // Of minutes, so that who is to be at work still is.
    desk.write("study.toml", &STUDY.replace("inner = 64", "inner = 65536"));
    let of_other = desk.run(&["study", "other.toml", "--out", "bounds", "--shard", "1/1"]);
    assert_eq!(of_other.status, 0, "{}", of_other.messages);
    let shard = |study: &'static str| ["study", study, "--out", "shared", "--shard", "1/2", "--resume"];
    let mut at_work = [
        stopped(&desk, &["study", "study.toml", "--out", "bounds"], "bounds"),
        stopped(&desk, &shard("study.toml"), "shared.shard-1-of-2"),
    ];
    let folders = [desk.path("bounds"), desk.path("shared.shard-1-of-2")];
    let before = folders.each_ref().map(|folder| files(folder));
    let holders = at_work.each_ref().map(std::process::Child::id);
    let in_use = |folder: &str| {
        let holder = if folder == "bounds" { holders[0] } else { holders[1] };
        let name = "(study 'half a turn', since ";
        [format!("error[E0907]: {folder} is in use by process {holder} on "), name.to_owned()]
    };
    let seconds: [(Vec<&str>, &str); 5] = [
        (vec!["study", "study.toml", "--out", "bounds", "--resume"], "bounds"),
        (vec!["study", "other.toml", "--out", "bounds", "--force"], "bounds"),
        (vec!["merge", "bounds.shard-1-of-1", "--force"], "bounds"),
        (shard("./study.toml").to_vec(), "shared.shard-1-of-2"),
        (vec!["study", "other.toml", "--out", "shared", "--shard", "1/2", "--force"], "shared.shard-1-of-2"),
    ];
    for (arguments, folder) in &seconds {
        let second = desk.run(arguments);
        assert_eq!(second.status, 2, "{arguments:?}");
        let [start, name] = in_use(folder);
        assert!(second.messages.starts_with(&start) && second.messages.contains(&name), "{}", second.messages);
        let end = "; nothing in it is changed\nhint: wait until it ends, or give another folder with --out\n";
        assert!(second.messages.ends_with(end), "{}", second.messages);
        for (folder, before) in folders.iter().zip(&before) {
            assert!(files(folder) == *before, "{arguments:?} has changed {}", folder.display());
        }
    }
    for child in &mut at_work {
        child.kill().expect("it is at work still");
        child.wait().expect("it ends");
    }
    // Where it is refused for the runs that are kept, what was shown of them stays as well.
    let interrupted = signalled(&desk, &["study", "study.toml", "--out", "shown"], "shown", "-INT");
    interrupted.wait_with_output().expect("it ends");
    let before = ["loosepin.json", "runs.parquet"].map(|file| bytes(&desk, "shown", file));
    let refused = desk.run(&["study", "study.toml", "--out", "shown"]);
    assert!(refused.messages.starts_with("error[E0910]: shown/runs.sqlite contains "), "{}", refused.messages);
    assert!(["loosepin.json", "runs.parquet"].map(|file| bytes(&desk, "shown", file)) == before);
}

/// A file of at most 32 KiB stands for a full disk.
#[test]
fn on_a_full_disk_nobody_is_told_of_runs_that_are_not_kept() {
    let desk = Desk::with_model("slider_crank_worn_pin");
    desk.write("study.toml", STUDY);
    let script = "trap '' XFSZ; ulimit -f 64; exec \"$0\" study study.toml --out full";
    let mut shell = Command::new("sh");
    shell.args(["-c", script, env!("CARGO_BIN_EXE_loosepin")]).current_dir(desk.path("."));
    let said: Said = shell.output().expect("a shell").into();
    assert_eq!(said.status, 2, "{}", said.messages);
    assert!(said.messages.contains("error[E0903]: cannot write to full/runs.sqlite: "), "{}", said.messages);
    assert!(
        said.messages.contains("\nhint: no run could be saved: start again when there is free space"),
        "{}",
        said.messages
    );
    // And so it does, to the end: its requirement is not met.
    let again = desk.run(&["study", "study.toml", "--out", "full", "--resume"]);
    assert!(again.status < 2 && desk.path("full/summary.json").exists(), "{}", again.messages);
}

/// The process was killed when it had made the store, and the folder did not say yet what it holds.
#[test]
fn a_store_without_a_marker_is_gone_on_with() {
    let desk = desk();
    fs::create_dir(desk.path("left")).expect("writable");
    fs::write(desk.path("left/runs.sqlite"), "").expect("writable");
    let resumed = desk.run(&["study", "study.toml", "--out", "left", "--resume"]);
    assert!(resumed.status < 2, "{}", resumed.messages);
    assert!(is_there(&desk.path("left/report.html")) && !is_there(&desk.path("left/runs.sqlite")));
}
