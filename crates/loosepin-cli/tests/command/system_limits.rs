//! Limits of the system end in words and documented statuses. Before there were such words, the limit of the size of a file killed the
//! command (status 153 of a shell), and that of memory aborted it (134) or left it waiting for ever.
#![cfg(target_os = "linux")]

use std::fs::{self, File};
use std::process::{Command, Stdio};
use std::thread::available_parallelism;

use super::command_line::{Desk, Said};

/// A study of tenths of a second, whose store of runs alone is larger than 256 KiB.
const STUDY: &str = r#"
name = "many short runs"
model = "model.toml"
seed = 5

[cycle]
transient_turns = 0
recorded_turns = 0.01
samples_per_turn = 60

[sampling]
outer = 12
inner = 256

[random]
"parameter.crank_length" = { normal = { mean = "50 mm", standard_deviation = "0.02 mm" } }

[epistemic]
"joint.gudgeon.radial_clearance" = { interval = ["0.1 mm", "0.5 mm"] }

[[ask]]
output = "slider"
of = "total"
at = "cycle"
statistics = ["mean"]
"#;

const FULL: &str = "the disk is full, or the file would exceed the size limit (ulimit -f)";

/// The command under a limit that a shell sets; `limit` is as `ulimit` takes it: blocks of 512 bytes, or KiB.
fn limited(desk: &Desk, limit: &str, arguments: &[&str]) -> Command {
    let plain = desk.command(arguments);
    let mut shell = Command::new("sh");
    shell.args(["-c", &format!("ulimit {limit}; exec \"$0\" \"$@\"")]).arg(plain.get_program()).args(arguments);
    shell.current_dir(desk.path("")).stdin(Stdio::null()).env("COLUMNS", "100").env("SOURCE_DATE_EPOCH", "0");
    shell
}

fn run(desk: &Desk, limit: &str, arguments: &[&str]) -> Said {
    limited(desk, limit, arguments).output().expect("a shell").into()
}

fn bytes(desk: &Desk, folder: &str, file: &str) -> Vec<u8> {
    fs::read(desk.path(folder).join(file)).unwrap_or_else(|error| panic!("{folder}/{file}: {error}"))
}

/// Before, `ulimit -s 64` aborted every command (status 134).
#[test]
fn a_small_stack_makes_no_difference() {
    let desk = Desk::with_model("slider_crank_worn_pin");
    fs::write(desk.path("study.toml"), STUDY).expect("it can be written");
    let arguments = |folder| ["study", "study.toml", "--threads", "2", "--out", folder];
    desk.succeed(&arguments("whole"));
    let said = run(&desk, "-s 64", &arguments("limited"));
    assert_eq!(said.status, 0, "{}", said.messages);
    for file in ["summary.json", "bounds.csv"] {
        assert!(bytes(&desk, "whole", file) == bytes(&desk, "limited", file), "{file} differs");
    }
    let said = run(&desk, "-s 64", &["check", "model.toml"]);
    assert_eq!((said.status, said.messages.as_str()), (0, ""));
}

#[test]
fn a_file_that_may_not_grow_is_told_and_the_same_command_writes_it_later() {
    let desk = Desk::with_model("slider_crank_worn_pin");
    let arguments = |folder| ["simulate", "model.toml", "--turns", "0.3", "--out", folder];
    desk.succeed(&arguments("whole"));
    // The first file of all is that of the lock.
    for (blocks, file) in [(0, ""), (1, "history.csv"), (64, "summary.json")] {
        let said = run(&desk, &format!("-f {blocks}"), &arguments("limited"));
        assert_eq!(said.status, 2, "{}", said.messages);
        let begin = format!("error[E0903]: cannot write limited/{file}");
        assert!(said.messages.starts_with(&begin), "{blocks} blocks: {}", said.messages);
        assert!(said.messages.ends_with(&format!(": {FULL}\n")), "{blocks} blocks: {}", said.messages);
    }
    assert!(
        !desk.path("limited/loosepin.json").exists()
            || !desk.read("limited/loosepin.json").contains("\"is_finished\": true")
    );
    desk.succeed(&arguments("limited"));
    for file in ["summary.json", "history.csv", "report.html"] {
        assert!(bytes(&desk, "whole", file) == bytes(&desk, "limited", file), "{file} differs");
    }
}

#[test]
fn identity_a_study_whose_store_may_not_grow_goes_on_when_it_may() {
    let desk = Desk::with_model("slider_crank_worn_pin");
    desk.write("study.toml", STUDY);
    let arguments = |folder| ["study", "study.toml", "--threads", "2", "--out", folder];
    let whole = desk.succeed(&arguments("whole"));
    // 256 KiB, less than its store and more than any of its other files.
    let limit = "-f 512";
    let said = run(&desk, limit, &arguments("limited"));
    assert_eq!(said.status, 2, "{}", said.messages);
    let begin = format!("error[E0903]: cannot write to limited/runs.sqlite: {FULL}\nhint: ");
    assert!(said.messages.starts_with(&begin), "{}", said.messages);
    assert!(!desk.read("limited/loosepin.json").contains("\"is_finished\": true"));
    let resumed = desk.run(&[&arguments("limited")[..], &["--resume"]].concat());
    assert_eq!((resumed.status, &resumed.output), (0, &whole.output), "{}", resumed.messages);
    for file in ["summary.json", "bounds.csv", "runs.parquet", "report.html"] {
        assert!(bytes(&desk, "whole", file) == bytes(&desk, "limited", file), "{file} differs");
    }
}

#[test]
fn standard_output_that_may_not_grow_is_told() {
    let desk = Desk::new();
    for arguments in [&["--help"][..], &["schema", "model"]] {
        let file = File::create(desk.path("printed")).expect("a file");
        let said = Said::from(limited(&desk, "-f 1", arguments).stdout(file).output().expect("a shell"));
        assert_eq!((said.status, said.messages), (2, format!("error: cannot write to standard output: {FULL}\n")));
        assert_eq!(fs::metadata(desk.path("printed")).expect("it is there").len(), 512, "{arguments:?}");
    }
}

#[test]
fn an_allocation_that_fails_has_a_status_of_its_own() {
    let desk = Desk::with_model("slider_crank_worn_pin");
    let said = run(&desk, "-d 3000", &["simulate", "model.toml", "--turns", "6", "--out", "out"]);
    assert_eq!((said.status, said.output.as_str()), (4, ""), "{}", said.messages);
    let rest = said.messages.strip_prefix("error: out of memory: the system refused ").expect("the first words");
    let (bytes, rest) = rest.split_once(' ').expect("a number");
    assert!(bytes.parse::<u64>().is_ok_and(|bytes| bytes > 0), "{bytes}");
    assert_eq!(
        rest,
        "bytes\nhint: raise the memory limit (ulimit -v, ulimit -d, or the limit of the container), or use fewer --threads or samples; saved runs of a study are kept: --resume continues with them\n"
    );
    assert!(
        !desk.path("out/loosepin.json").exists() || !desk.read("out/loosepin.json").contains("\"is_finished\": true")
    );
}

#[test]
fn a_study_under_a_limit_of_memory_is_refused_before_it_starts() {
    let desk = Desk::with_model("slider_crank_worn_pin");
    desk.write("study.toml", STUDY);
    let threads = available_parallelism().map_or(1, usize::from);
    for (arguments, limit, threads, words) in [
        (
            vec!["study", "study.toml", "--out", "out", "--threads", "64"],
            "-v 200000",
            "64 threads".to_owned(),
            "address space; its limit (ulimit -v) leaves ",
        ),
        (
            vec!["study", "study.toml", "--out", "out", "--threads", "1"],
            "-d 8192",
            "1 thread".to_owned(),
            "memory for data; its limit (ulimit -d) leaves ",
        ),
        (
            vec!["check", "study.toml"],
            "-d 8192",
            format!("{threads} thread{}", if threads == 1 { "" } else { "s" }),
            "memory for data; its limit (ulimit -d) leaves ",
        ),
    ] {
        let said = run(&desk, limit, &arguments);
        assert_eq!(said.status, 2, "{arguments:?}: {}", said.messages);
        let lines: Vec<&str> = said.messages.lines().collect();
        assert!(lines[0].starts_with("study.toml:11:2: error[E0817]: 3072 runs of "), "{}", said.messages);
        assert!(lines[0].contains(&format!(" numbers each on {threads} need about ")), "{}", said.messages);
        assert!(lines[0].contains(words), "{}", said.messages);
        assert_eq!(
            lines[1],
            "hint: smaller outer and inner under [sampling] need fewer runs; poses need fewer numbers than curves; each of --threads \
             takes memory"
        );
        assert!(!desk.path("out").exists(), "{arguments:?}");
    }
}

/// `ulimit -u` counts the processes of a user, and holds for nobody who may do everything: a limit of addresses stands for it.
#[test]
fn a_sweep_without_room_for_its_threads_says_so() {
    let desk = Desk::with_model("slider_crank_worn_pin");
    let over = "joint.gudgeon.radial_clearance=0.1mm..0.2mm";
    let arguments = [
        "sweep",
        "model.toml",
        "--over",
        over,
        "--points",
        "3",
        "--turns",
        "2",
        "--transient",
        "0",
        "--threads",
        "200",
    ];
    let said = run(&desk, "-v 300000", &arguments);
    assert_eq!(said.status, 2, "{}", said.messages);
    assert_eq!(
        said.messages,
        "error[E0806]: the system refused to start the threads\n\
         hint: use fewer with --threads, or raise the limit of memory (ulimit -v) or of processes (ulimit -u)\n"
    );
}
