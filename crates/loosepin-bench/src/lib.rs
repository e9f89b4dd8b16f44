//! Functions shared by the benches and campaigns.

#![allow(clippy::disallowed_methods, reason = "a program of developers")]

pub mod batch;
pub mod diagram;
pub mod equations;
pub mod fresh_runs;
pub mod further_cases;
pub mod hard_bounds;
pub mod known_bounds;
pub mod known_case;
pub mod known_pairings;
pub mod precision;
pub mod precision_cases;
pub mod precision_page;
pub mod processor_time;
pub mod worn_pin;
pub mod worn_pin_reference;

use loosepin::mechanism::Mechanism;
use loosepin::model::{Model, Values};
use loosepin::study::{Progress, RunOptions, Study, StudyRun, run_study};
use loosepin::surrogate::{Choice, Kind};
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;
use std::time::Instant;

/// `cases/NAME/FILE`.
pub fn case_file(name: &str, file: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases").join(name).join(file)
}

/// `cases/NAME/model.toml` compiled at its nominal values, which stand beside it, and the duration of a turn, s.
///
/// # Panics
/// If the case is not there or is no mechanism.
pub fn compiled(name: &str) -> (Mechanism, Values, f64) {
    compiled_with(&format!("cases/{name}/model.toml"), &[])
}

/// A file of the repository with parts of its text replaced, as [`compiled`].
///
/// # Panics
/// If it is not there, does not have one of the parts or is no mechanism.
pub fn compiled_with(file: &str, changes: &[(&str, &str)]) -> (Mechanism, Values, f64) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(file);
    let model = if changes.is_empty() {
        Model::from_path(&path)
    } else {
        let mut text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{file}: {error}"));
        for (part, other) in changes {
            assert!(text.contains(part), "{file} does not have {part:?}");
            text = text.replace(part, other);
        }
        Model::from_text(file, &text)
    };
    let model = model.unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let nominal = model.quantities.nominal();
    let mechanism = Mechanism::new(&model, &nominal).unwrap_or_else(|error| panic!("{file}: {error}"));
    let turn_s = model.cycle_input(&nominal).turn_s();
    (mechanism, nominal, turn_s)
}

/// The arguments that name cases; these where there are none.
pub fn named_cases(otherwise: &[&str]) -> Vec<String> {
    let named: Vec<String> = std::env::args().skip(1).filter(|argument| !argument.starts_with('-')).collect();
    if named.is_empty() { otherwise.iter().map(|&name| name.to_owned()).collect() } else { named }
}

/// The kinds of surrogates that a word asks for.
pub fn surrogate_choice(word: &str) -> Option<Choice> {
    match word {
        "auto" => Some(Choice::Auto),
        "chaos" => Some(Choice::Only(Kind::Chaos)),
        "kriging" => Some(Choice::Only(Kind::Kriging)),
        "network" => Some(Choice::Only(Kind::Network)),
        _ => None,
    }
}

/// Ignores all progress.
struct Silent;

impl Progress for Silent {
    fn runs(&self, _: usize, _: usize) {}
}

/// Conducts a study on all processors.
///
/// # Panics
/// If it has no result.
pub fn run(study: &Study) -> StudyRun {
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    run_study(study, "", &RunOptions::new(threads, &Silent, &AtomicBool::new(false)))
        .unwrap_or_else(|error| panic!("{error}"))
}

/// The middle one; 0 where there are none.
pub fn median(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted.get(sorted.len() / 2).copied().unwrap_or(0.0)
}

/// The greatest one.
pub fn largest(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::NEG_INFINITY, f64::max)
}

/// Time since it was started.
pub struct Watch(Instant, Option<f64>);

impl Watch {
    /// Starts it.
    pub fn start() -> Self {
        Self(Instant::now(), processor_time_s())
    }

    /// By the clock, s.
    pub fn clock_s(&self) -> f64 {
        self.0.elapsed().as_secs_f64()
    }

    /// Processor time of all threads of this process, s; wall-clock time if the system does not report it.
    pub fn processor_s(&self) -> f64 {
        self.1.zip(processor_time_s()).map_or_else(|| self.clock_s(), |(start_s, end_s)| end_s - start_s)
    }
}

/// Processor time of all threads of this process so far, s; `None` if the system does not report it.
fn processor_time_s() -> Option<f64> {
    Some(processor_time::of_threads_ns()).filter(|ns| *ns > 0).map(|ns| ns as f64 * 1e-9)
}
