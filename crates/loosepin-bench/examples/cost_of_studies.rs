//! Processor time of planning and assembling of studies, as a share of that of their runs: `cost_of_studies [TEMPLATE | worn-pin | FILE.toml ...]`.
//!
//! Without names all templates and `cases/slider_crank_worn_pin`. The runs are made by a [`RunMaker`], so that what is used while it makes
//! them is theirs. What is used before, between and after them is planning and assembling, less what it takes to compile the study, which
//! is told apart. Reports are not written. Linux tells the times.

use loosepin::bounds::Failure;
use loosepin::study::{AskedRuns, Means, Progress, RunMaker, RunRows, Study, conduct_elsewhere};
use loosepin::templates::TEMPLATES;
use loosepin_bench::{case_file, processor_time};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};

const WORN_PIN: &str = "worn-pin";

/// Makes runs in this process, and notes their number and the processor time, ns, that they take.
struct Watched {
    rows: RunRows,
    made: AtomicUsize,
    used_ns: AtomicU64,
}

impl RunMaker for Watched {
    fn make(
        &self,
        asked: &AskedRuns<'_>,
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

struct Silent;

impl Progress for Silent {
    fn runs(&self, _: usize, _: usize) {}
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
    Study::from_path(&path).unwrap_or_else(|complaints| panic!("{complaints}"))
}

fn main() {
    let named: Vec<String> = std::env::args().skip(1).collect();
    let all = || TEMPLATES.iter().map(|template| template.name.to_owned()).chain([WORN_PIN.to_owned()]).collect();
    let names: Vec<String> = if named.is_empty() { all() } else { named };
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    println!("{:24} {:>7} {:>9} {:>9} {:>9} {:>7}", "study", "runs", "runs, s", "rest, s", "compiled", "share");
    for name in names {
        let study = study(&name);
        let begin = processor_time::of_process_ns();
        let rows = RunRows::new(study.clone(), threads).unwrap_or_else(|error| panic!("{name}: {error}"));
        let compiled_ns = processor_time::of_process_ns() - begin;
        let maker = Watched { rows, made: AtomicUsize::new(0), used_ns: AtomicU64::new(0) };
        let begin = processor_time::of_process_ns();
        let means = Means { threads, progress: &Silent, stop: &AtomicBool::new(false), store: None };
        conduct_elsewhere(&study, "", &means, &maker).unwrap_or_else(|error| panic!("{name}: {error}"));
        let whole_ns = processor_time::of_process_ns() - begin;
        let [whole, compiled, runs] = [whole_ns, compiled_ns, maker.used_ns.into_inner()].map(|ns| 1e-9 * ns as f64);
        let rest = whole - runs - compiled;
        let share = 100.0 * rest / runs;
        let made = maker.made.into_inner();
        println!("{name:24} {made:7} {runs:9.3} {rest:9.3} {compiled:9.3} {share:5.1} %");
    }
}
