//! Every command of docs/cluster.md runs: with a scheduler that is a loop, and machines that are this one.
#![cfg(unix)]

use std::ffi::OsString;
use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::process::{Command, Stdio};

use super::command_line::Desk;

/// A study with two rounds that are too large for a merge: that of the bounds and that of the contributors.
const STUDY: &str = r#"
name = "shared"
model = "model.toml"
seed = 23

[cycle]
transient_turns = 0
recorded_turns = 0.125
samples_per_turn = 40

[sampling]
outer = 6
inner = 256
replicates = 4
accuracy = "0.2 um"
budget = "1 rounds"

[random]
"parameter.crank_length" = { normal = { mean = "50 mm", standard_deviation = "0.02 mm" } }

[epistemic]
"joint.gudgeon.radial_clearance" = { interval = ["0.1 mm", "0.5 mm"] }

[[ask]]
output = "slider"
of = "total"
poses = { crank = ["30 deg"] }
statistics = ["mean", "contributors"]
"#;

/// `sbatch --wait SCRIPT`: the tasks of its array one after the other.
const SBATCH: &str = r#"#!/bin/sh
[ "$1" = --wait ] || exit 2
range=$(sed -n 's/^#SBATCH --array=//p' "$2")
for task in $(seq "${range%-*}" "${range#*-}"); do
    SLURM_ARRAY_TASK_ID=$task SLURM_CPUS_PER_TASK=1 sh "$2" || exit
done
"#;

/// `ssh HOST COMMAND`: here.
const SSH: &str = "#!/bin/sh\nshift\nexec sh -c \"$*\"\n";

/// The fenced blocks of a language, in the order of the page.
fn blocks(language: &str) -> Vec<String> {
    let page =
        fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/cluster.md")).expect("the page");
    let fence = format!("```{language}\n");
    page.split(&fence).skip(1).filter_map(|rest| rest.split("```").next()).map(str::to_owned).collect()
}

/// A desk with the study, its results from one process in `whole`, and `sbatch` and `ssh` in `bin`.
fn desk() -> Desk {
    let desk = Desk::with_model("slider_crank_worn_pin");
    desk.write("study.toml", STUDY);
    desk.succeed(&["study", "study.toml", "--out", "whole"]);
    fs::create_dir(desk.path("bin")).expect("a folder");
    for (name, text) in [("bin/sbatch", SBATCH), ("bin/ssh", SSH)] {
        desk.write(name, text);
        fs::set_permissions(desk.path(name), fs::Permissions::from_mode(0o755)).expect("it can be run");
    }
    desk
}

/// Runs a script of the shell in the folder, with `loosepin` on its path; gives its exit status.
fn shell(desk: &Desk, script: &str, variables: &[(&str, &str)]) -> i32 {
    let program = Path::new(env!("CARGO_BIN_EXE_loosepin")).parent().expect("a folder").to_owned();
    let mut path = OsString::from(desk.path("bin"));
    for folder in [program.as_os_str(), &std::env::var_os("PATH").unwrap_or_default()] {
        path.push(":");
        path.push(folder);
    }
    let mut command = Command::new("sh");
    command
        .args(["-c", script])
        .current_dir(desk.path(""))
        .env("PATH", path)
        .env("SOURCE_DATE_EPOCH", "0")
        .envs(variables.iter().copied());
    let output = command.stdin(Stdio::null()).output().expect("a shell");
    output.status.code().unwrap_or_else(|| panic!("{}", String::from_utf8_lossy(&output.stderr)))
}

fn assert_same(desk: &Desk) {
    for file in ["summary.json", "bounds.csv", "report.html"] {
        assert!(desk.read(&format!("whole/{file}")) == desk.read(&format!("bounds/{file}")), "{file} differs");
    }
}

#[test]
fn identity_the_slurm_array_ends_with_the_bytes_of_one_process() {
    let desk = desk();
    let scripts = blocks("sh");
    desk.write("shards.sh", &scripts[0]);
    assert_eq!(shell(&desk, &scripts[1], &[]), 0);
    assert_same(&desk);
}

#[test]
fn identity_the_loop_over_ssh_ends_with_the_bytes_of_one_process() {
    let desk = desk();
    assert_eq!(shell(&desk, &blocks("sh")[2], &[]), 0);
    assert_same(&desk);
}

#[test]
fn identity_the_pods_of_the_job_end_with_the_bytes_of_one_process() {
    let desk = desk();
    let job = blocks("yaml").remove(0);
    let command =
        job.lines().find_map(|line| line.trim().strip_prefix("command: [\"sh\", \"-c\", \"")).expect("a command");
    let command = command.strip_suffix("\"]").expect("its end");
    let pods: usize = job
        .lines()
        .find_map(|line| line.trim().strip_prefix("completions: "))
        .expect("a number")
        .parse()
        .expect("pods");
    for rounds in 0.. {
        assert!(rounds < 10, "it does not end");
        for pod in 0..pods {
            assert_eq!(shell(&desk, command, &[("JOB_COMPLETION_INDEX", &pod.to_string())]), 0);
        }
        let status = shell(&desk, &format!("loosepin merge bounds.shard-*-of-{pods}"), &[]);
        if status != 3 {
            assert_eq!(status, 0);
            break;
        }
    }
    assert_same(&desk);
}

#[test]
fn the_two_lines_that_stand_first_run() {
    let desk = desk();
    let page =
        fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/cluster.md")).expect("the page");
    let line = |start: &str| {
        let found = page.lines().find_map(|line| line.strip_prefix("    ").filter(|line| line.starts_with(start)));
        found.unwrap_or_else(|| panic!("no line {start}")).to_owned()
    };
    let (shard, merge) = (line("loosepin study"), line("loosepin merge"));
    for number in 1..=7 {
        let shard = shard.replace("--shard 2/7", &format!("--shard {number}/7"));
        assert_eq!(shell(&desk, &shard, &[]), 0);
    }
    assert_eq!(shell(&desk, &merge, &[]), 3, "a second round");
    let alone =
        page.split('`').find(|text| text.starts_with("loosepin study") && text.ends_with("--resume")).expect("alone");
    assert_eq!(shell(&desk, alone, &[]), 0);
    assert_same(&desk);
}
