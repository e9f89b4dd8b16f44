//! Processor time of planning and assembling of studies, as a share of that of their runs: `cost_of_studies [TEMPLATE | worn-pin | FILE.toml ...]`.
//!
//! Without names all templates and `cases/slider_crank_worn_pin`. The runs are made by a [`RunProvider`], so that what is used while it makes
//! them is theirs. All else is told apart by the [`Stage`] in which it is used:
//!
//! * compile: what comes before the first round, most of it the machine code of the equations;
//! * planning: which runs come next, and the bounds from them;
//! * rows: finished runs put into the table;
//! * assembling: bands, curves, tables and all else that the result holds beside its bounds;
//! * pictures: runs of the nominal mechanism, which draw it and the paths of its journals.
//!
//! The first share is that of planning, rows and assembling, the second one that of pictures too. Reports are not written. Linux tells the times.

use loosepin::bounds::Failure;
use loosepin::study::{Progress, RequestedRuns, RunOptions, RunProvider, RunRows, Stage, Study, run_study};
use loosepin::templates::TEMPLATES;
use loosepin_bench::{case_file, processor_time};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

const WORN_PIN: &str = "worn-pin";

/// Makes runs in this process, and notes their number and the processor time, ns, that they take.
struct Watched {
    rows: RunRows,
    made: AtomicUsize,
    used_ns: AtomicU64,
}

impl RunProvider for Watched {
    fn make(
        &self,
        asked: &RequestedRuns<'_>,
        _: &dyn Fn() -> bool,
        finished: &mut dyn FnMut(usize, Result<Vec<f64>, Failure>),
    ) -> Result<(), String> {
        let begin = processor_time::of_threads_ns();
        let inputs = asked.runs.iter().map(|run| [run.random.clone(), run.epistemic.clone()]);
        let rows = self.rows.make(asked.loosened, inputs).map_err(|error| error.to_string())?;
        self.used_ns.fetch_add(processor_time::of_threads_ns() - begin, Ordering::Relaxed);
        self.made.fetch_add(rows.len(), Ordering::Relaxed);
        rows.into_iter().enumerate().for_each(|(place, row)| finished(place, row));
        Ok(())
    }
}

/// Notes the processor time, ns, of every stage.
struct Stages(Mutex<OfStages>);

struct OfStages {
    /// The stage that has begun, and when; before the first one the study is compiled.
    current: Option<Stage>,
    begin_ns: u64,
    compile_ns: u64,
    planning_ns: u64,
    runs_ns: u64,
    pictures_ns: u64,
    assembling_ns: u64,
}

impl Stages {
    /// None has begun.
    fn new() -> Self {
        let [compile_ns, planning_ns, runs_ns, pictures_ns, assembling_ns] = [0; 5];
        let begin_ns = processor_time::of_threads_ns();
        Self(Mutex::new(OfStages {
            current: None,
            begin_ns,
            compile_ns,
            planning_ns,
            runs_ns,
            pictures_ns,
            assembling_ns,
        }))
    }
}

impl Progress for Stages {
    fn runs(&self, _: usize, _: usize) {}

    fn stage(&self, stage: Stage) {
        let mut own = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let now_ns = processor_time::of_threads_ns();
        // Threads that have ended since, of the study before, are counted no more.
        let used_ns = now_ns.saturating_sub(own.begin_ns);
        let of_stage = match own.current {
            None => &mut own.compile_ns,
            Some(Stage::Planning) => &mut own.planning_ns,
            Some(Stage::Runs) => &mut own.runs_ns,
            Some(Stage::Pictures) => &mut own.pictures_ns,
            Some(Stage::Assembling | Stage::Finished) => &mut own.assembling_ns,
        };
        *of_stage += used_ns;
        (own.current, own.begin_ns) = (Some(stage), now_ns);
    }
}

fn study(name: &str) -> Study {
    let templates = Path::new(env!("CARGO_MANIFEST_DIR")).join("../loosepin-import/templates");
    let path = if name == WORN_PIN {
        case_file("slider_crank_worn_pin", "study.toml")
    } else if name.ends_with(".toml") {
        PathBuf::from(name)
    } else {
        templates.join(name).join("study.toml")
    };
    Study::from_path(&path).unwrap_or_else(|diagnostics| panic!("{diagnostics}"))
}

fn main() {
    let named: Vec<String> = std::env::args().skip(1).collect();
    let all = || TEMPLATES.iter().map(|template| template.name.to_owned()).chain([WORN_PIN.to_owned()]).collect();
    let names: Vec<String> = if named.is_empty() { all() } else { named };
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    println!(
        "{:24} {:>7} {:>7} {:>9} {:>9} {:>8} {:>7} {:>11} {:>9} {:>7} {:>8}",
        "study",
        "made",
        "rounds",
        "runs, s",
        "compile",
        "planning",
        "rows",
        "assembling",
        "pictures",
        "share",
        "with all"
    );
    for name in names {
        let study = study(&name);
        let rows = RunRows::new(study.clone(), threads).unwrap_or_else(|error| panic!("{name}: {error}"));
        let provider = Watched { rows, made: AtomicUsize::new(0), used_ns: AtomicU64::new(0) };
        let stages = Stages::new();
        let stop = AtomicBool::new(false);
        let options = RunOptions { provider: Some(&provider), ..RunOptions::new(threads, &stages, &stop) };
        let completed = run_study(&study, "", &options).unwrap_or_else(|error| panic!("{name}: {error}"));
        let runs_ns = provider.used_ns.into_inner();
        let own = stages.0.into_inner().unwrap_or_else(PoisonError::into_inner);
        let rows_ns = own.runs_ns.saturating_sub(runs_ns);
        let [runs, compile, planning, rows, assembling, pictures] =
            [runs_ns, own.compile_ns, own.planning_ns, rows_ns, own.assembling_ns, own.pictures_ns]
                .map(|ns| 1e-9 * ns as f64);
        let share = 100.0 * (planning + rows + assembling) / runs;
        let with_all = share + 100.0 * pictures / runs;
        let (made, rounds) = (provider.made.into_inner(), completed.result.counts.rounds);
        println!(
            "{name:24} {made:7} {rounds:7} {runs:9.3} {compile:9.3} {planning:8.3} {rows:7.3} {assembling:11.3} {pictures:9.3} {share:5.1} % {with_all:6.1} %"
        );
    }
}
