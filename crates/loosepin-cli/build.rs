//! Gives the program its version with the commit that it was built from: `0.1.0 (cb8de60bcd)`.
//!
//! The commit is that of the environment variable LOOSEPIN_COMMIT, else that of the checkout around this file. Sources without git,
//! as from a tarball, have none, and the version stands alone. Results record the version without it (`loosepin::VERSION`).

#![allow(clippy::disallowed_methods, reason = "a program of developers")]

use std::process::Command;

fn main() {
    println!("cargo::rerun-if-env-changed=LOOSEPIN_COMMIT");
    println!("cargo::rerun-if-changed=build.rs");
    let version = env!("CARGO_PKG_VERSION");
    let given = std::env::var("LOOSEPIN_COMMIT").ok().filter(|commit| !commit.is_empty());
    let full = match given.or_else(commit_of_checkout) {
        Some(commit) => format!("{version} ({commit})"),
        None => version.to_owned(),
    };
    println!("cargo::rustc-env=LOOSEPIN_VERSION={full}");
}

/// The commit of the checkout that holds this file as its own.
fn commit_of_checkout() -> Option<String> {
    // A tarball may lie inside of another repository, whose commit says nothing.
    git(&["ls-files", "--error-unmatch", "build.rs"])?;
    // Every commit and checkout adds a line to this file.
    if let Some(log) = git(&["rev-parse", "--git-path", "logs/HEAD"]) {
        println!("cargo::rerun-if-changed={log}");
    }
    git(&["rev-parse", "--short=10", "HEAD"])
}

/// Output of git, where git exists and succeeds.
fn git(arguments: &[&str]) -> Option<String> {
    let output = Command::new("git").args(arguments).output().ok().filter(|output| output.status.success())?;
    Some(String::from_utf8(output.stdout).ok()?.trim().to_owned())
}
