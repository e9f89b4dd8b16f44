//! Reads every number of stored studies back and says which contradict each other: `cargo run --example coherence -- FOLDER...`, each the results of
//! a study. Page and terminal are written anew from its record; `summary.json` and `bounds.csv` are the stored ones. Status 1 where anything is
//! wrong. `just campaign coherence` runs it over the studies of all templates and cases.

#![allow(clippy::disallowed_methods, reason = "a program of developers")]

#[path = "../tests/report/coherence/held.rs"]
#[expect(dead_code, reason = "stored files are read as they are")]
mod held;
#[path = "../tests/report/coherence/shown.rs"]
mod shown;
#[path = "../tests/report/coherence/stored.rs"]
mod stored;

use held::{Reader, Writer, faults};
use loosepin::result::json::Stored;
use loosepin::study::result::StudyResult;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::{env, fs};

fn main() -> ExitCode {
    let folders: Vec<PathBuf> = env::args_os().skip(1).map(PathBuf::from).collect();
    if folders.is_empty() {
        eprintln!("coherence: no folder given\nhint: cargo run --example coherence -- results/study");
        return ExitCode::from(2);
    }
    let mut wrong = 0;
    for folder in folders {
        match faults_of(&folder) {
            Ok((numbers, faults)) => {
                println!("{}: {numbers} numbers, {} faults", folder.display(), faults.len());
                faults.iter().for_each(|fault| println!("  {fault}"));
                wrong += faults.len();
            }
            Err(words) => {
                println!("{}: {words}", folder.display());
                wrong += 1;
            }
        }
    }
    ExitCode::from(u8::from(wrong > 0))
}

/// How many tagged numbers the results of a study show, and what is wrong with them.
fn faults_of(folder: &Path) -> Result<(usize, Vec<String>), String> {
    let read =
        |name: &str| fs::read_to_string(folder.join(name)).map_err(|error| format!("cannot read {name}: {error}"));
    let (summary, table) = (read("summary.json")?, read("bounds.csv")?);
    let result = StudyResult::from_json(&summary).map_err(|error| format!("summary.json: {error}"))?;
    let reader = Reader::of(&summary);
    let read = [
        reader.written(Writer::Page, &result),
        reader.written(Writer::Terminal, &result),
        reader.summary(&summary),
        reader.table(&table),
    ];
    let numbers = read.iter().map(|(shown, _)| shown.len()).sum();
    Ok((numbers, faults(&read)))
}
