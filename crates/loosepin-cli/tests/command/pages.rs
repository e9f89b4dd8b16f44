//! Every command of the README and of the pages of docs and of measured runs, in the order of its page, in a folder of its own.
//!
//! A command is a line of a fenced block of the shell, or an indented line that begins with `loosepin` or `cargo run`. A block whose
//! first line begins with `# not run by the tests:` is not run; NOT_RUN lists these. A command that ends with
//! `# the tests run it with FLAGS` has these flags in place of its own. What stands in a block of `text` behind commands is quoted:
//! its lines were printed. The study of the README is run with fewer samples.
#![cfg(unix)]

use std::fs;
use std::os::unix::fs::{PermissionsExt, symlink};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use super::command_line::Desk;

/// Pages with tests of their own.
const ELSEWHERE: [&str; 1] = ["docs/cluster.md"]; // cluster_page.rs
/// Every block that is not run: its page, and what it says of itself.
const NOT_RUN: [(&str, &str); 5] = [
    ("docs/first-minute.md", "minutes of compiling"),
    ("docs/release.md", "minutes of compiling"),
    ("docs/release.md", "two release builds"),
    ("docs/studio.md", "it ends with Ctrl-C only"),
    ("docs/tutorial.md", "half an hour"),
];
/// Pages whose studies take some seconds each; the others are run together.
const LONG: [&str; 3] = ["README.md", "docs/first-minute.md", "docs/tutorial.md"];
const NOT_RUN_MARK: &str = "# not run by the tests: ";
const FLAGS_MARK: &str = "# the tests run it with ";
/// The case that the README runs, and the samples that it has here instead.
const CASE: &str = "slider_crank_worn_pin";
const FEWER: [(&str, &str); 2] = [("outer = 64 ", "outer = 6 "), ("inner = 256 ", "inner = 16 ")];

/// Part of a page that these tests run or compare.
#[derive(Debug, PartialEq)]
enum Piece {
    Script(String),
    NotRun(String),
    Quoted(String),
}

fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().expect("the repository")
}

/// The README and the pages of the documentation, by their paths in the repository.
fn pages() -> Vec<String> {
    let mut found = vec!["README.md".to_owned(), "cases/README.md".to_owned()];
    for folder in ["docs", "docs/files", "docs/theory", "measured"] {
        let entries = fs::read_dir(repository().join(folder)).expect("the pages");
        let names = entries.map(|entry| entry.expect("a page").file_name().into_string().expect("a name"));
        found.extend(names.filter(|name| name.ends_with(".md")).map(|name| format!("{folder}/{name}")));
    }
    found.sort();
    found
}

fn pieces(page: &str) -> Vec<Piece> {
    let text = fs::read_to_string(repository().join(page)).unwrap_or_else(|error| panic!("{page}: {error}"));
    let mut found = Vec::new();
    let mut lines = text.lines();
    while let Some(line) = lines.next() {
        if let Some(language) = line.trim_start().strip_prefix("```") {
            let block: Vec<&str> = lines.by_ref().take_while(|line| !line.trim_start().starts_with("```")).collect();
            let block = block.join("\n");
            match language {
                "sh" | "bash" | "console" => found.push(match block.strip_prefix(NOT_RUN_MARK) {
                    Some(rest) => Piece::NotRun(rest.lines().next().unwrap_or_default().to_owned()),
                    None => Piece::Script(block.lines().map(with_flags).collect::<Vec<_>>().join("\n")),
                }),
                "text" => found.push(Piece::Quoted(block)),
                _ => {}
            }
        } else if let Some(command) = line.strip_prefix("    ")
            && (command.starts_with("loosepin ") || command.starts_with("cargo run "))
        {
            found.push(Piece::Script(with_flags(command)));
        }
    }
    found
}

/// The command with the flags that its comment gives it for the tests.
fn with_flags(command: &str) -> String {
    let Some((command, flags)) = command.split_once(FLAGS_MARK) else { return command.to_owned() };
    let mut words: Vec<&str> = command.split_whitespace().collect();
    let mut flags = flags.split_whitespace();
    while let Some(flag) = flags.next() {
        let value = flags.next().expect("a value behind the flag");
        match words.iter().position(|word| *word == flag) {
            Some(position) => words[position + 1] = value,
            None => words.extend([flag, value]),
        }
    }
    words.join(" ")
}

/// A desk with the cases, with `loosepin` that notes what it is asked and says, and `cargo run` that is the same.
fn desk() -> Desk {
    let desk = Desk::new();
    fs::create_dir_all(desk.path("docs")).expect("a folder");
    symlink(repository().join("docs/examples"), desk.path("docs/examples")).expect("a link");
    fs::create_dir_all(desk.path("cases").join(CASE)).expect("a folder");
    for entry in fs::read_dir(repository().join("cases")).expect("the cases") {
        let entry = entry.expect("a case");
        if entry.file_name() != CASE {
            symlink(entry.path(), desk.path("cases").join(entry.file_name())).expect("a link");
        }
    }
    for entry in fs::read_dir(repository().join("cases").join(CASE)).expect("the case") {
        let path = entry.expect("a file").path();
        let mut text = fs::read_to_string(&path).expect("a text");
        if path.ends_with("study.toml") {
            for (stated, fewer) in FEWER {
                assert!(text.contains(stated), "the study has {stated}");
                text = text.replace(stated, fewer);
            }
        }
        fs::write(desk.path("cases").join(CASE).join(path.file_name().expect("a name")), text).expect("a copy");
    }
    fs::create_dir(desk.path("bin")).expect("a folder");
    let folder = desk.path("");
    let folder = folder.display();
    let program = env!("CARGO_BIN_EXE_loosepin");
    // A requirement that is not met is an answer.
    let loosepin = format!(
        "#!/bin/sh\necho \"$*\" >> '{folder}/commands'\nsaid=$(mktemp)\n'{program}' \"$@\" > \"$said\"; status=$?\n\
         cat \"$said\" >> '{folder}/said'; cat \"$said\"; rm \"$said\"\n\
         case \"$1 $status\" in 'study 1' | 'motion 1' | 'report 1') exit 0 ;; esac\nexit $status\n"
    );
    let cargo = "#!/bin/sh\n[ \"$1 $2 $3\" = 'run --release --' ] || exit 2\nshift 3\nexec loosepin \"$@\"\n";
    for (name, text) in [("bin/loosepin", loosepin.as_str()), ("bin/cargo", cargo)] {
        desk.write(name, text);
        fs::set_permissions(desk.path(name), fs::Permissions::from_mode(0o755)).expect("it can be run");
    }
    desk
}

/// Runs the commands of a page and looks for what it quotes; gives the number of commands.
fn run(page: &str) -> usize {
    let desk = desk();
    let path = format!("{}:{}", desk.path("bin").display(), std::env::var("PATH").unwrap_or_default());
    let (mut scripts, mut quoted) = (0, Vec::new());
    for piece in pieces(page) {
        match piece {
            Piece::Script(script) => {
                let mut command = Command::new("sh");
                command.args(["-euc", &script]).current_dir(desk.path("")).env("PATH", &path).env("COLUMNS", "100");
                let output = command.stdin(Stdio::null()).output().expect("a shell");
                let messages = String::from_utf8_lossy(&output.stderr);
                assert!(output.status.success(), "{page}: {script}\n{messages}");
                scripts += 1;
            }
            Piece::Quoted(text) if scripts > 0 => quoted.push(text),
            _ => {}
        }
    }
    if scripts == 0 {
        return 0;
    }
    let said = desk.read("said");
    for line in quoted.iter().flat_map(|text| text.lines()).filter(|line| !line.trim().is_empty()) {
        assert!(said.contains(line.trim_end()), "{page} quotes what was not printed: {line}");
    }
    desk.read("commands").lines().count()
}

#[test]
fn the_commands_of_the_readme_run() {
    assert_eq!(run("README.md"), 6);
}

#[test]
fn a_motion_and_a_run_fit_a_screen_and_all_adds_the_rest() {
    const LINES: usize = 40;
    let desk = desk();
    let [study, model] = ["study.toml", "model.toml"].map(|file| format!("cases/{CASE}/{file}"));
    // The study has too few samples here: quantiles without an end say why in further lines. Its first screen is measured in `report_pages.rs`.
    for (command, file, most) in [("study", &study, 2 * LINES), ("motion", &study, LINES), ("simulate", &model, LINES)]
    {
        let said = desk.run(&[command, file, "--out", command]);
        // With what --all adds, and the place of the report; warnings about the file stand above.
        let lines = said.output.lines().count() + 2;
        assert!(lines <= most, "{command}: {lines} lines\n{}{}", said.output, said.messages);
        let all = desk.run(&["report", command, "--all"]);
        assert_eq!(all.status, said.status, "{}", all.messages);
        assert_eq!(desk.run(&[command, file, "--out", command, "--all"]).output, all.output);
        let is_shorter = said.output != all.output;
        assert_eq!(said.messages.contains("--all adds "), is_shorter, "{}", said.messages);
        assert!(!all.messages.contains("--all"), "{}", all.messages);
        let all = all.output.split_whitespace().collect::<Vec<_>>().join(" ");
        for line in said.output.lines().filter(|line| !line.starts_with("---")) {
            let words = line.split_whitespace().collect::<Vec<_>>().join(" ");
            assert!(all.contains(&words), "{command}: only without --all: {line}");
        }
    }
}

#[test]
fn the_commands_of_the_first_minute_run() {
    assert_eq!(run("docs/first-minute.md"), 2);
}

#[test]
fn the_commands_of_the_tutorial_run() {
    assert_eq!(run("docs/tutorial.md"), 8);
}

#[test]
fn the_commands_of_all_other_pages_run() {
    let commands: usize = pages()
        .iter()
        .filter(|page| !LONG.contains(&page.as_str()) && !ELSEWHERE.contains(&page.as_str()))
        .map(|page| run(page))
        .sum();
    assert!(commands >= 4, "{commands} commands");
}

#[test]
fn what_is_not_run_says_so_and_is_listed_here() {
    let mut found = Vec::new();
    for page in pages() {
        for piece in pieces(&page) {
            if let Piece::NotRun(reason) = piece {
                found.push((page.clone(), reason));
            }
        }
    }
    found.sort();
    let listed: Vec<(String, String)> = NOT_RUN.map(|(page, reason)| (page.to_owned(), reason.to_owned())).into();
    assert_eq!(found, listed);
}
