//! Work against error of the integrators in several mechanisms: right-hand sides, never seconds.
//!
//! `cargo bench --package loosepin-bench --bench work_precision` prints the tables, a word behind `--` those of the cases with that word in their names
//! alone; `-- --write` also writes `measured/work-precision.md` and its two pictures in `measured/images`, the same bytes on every run.

#![allow(clippy::disallowed_methods, reason = "a program of developers")]

use loosepin_bench::diagram::Diagram;
use loosepin_bench::precision::{Case, TIMES};
use loosepin_bench::precision_cases::{FLEXIBLE_CASES, RIGID_CASES};
use loosepin_bench::precision_page::{Measured, PROMISED_M, comparison};
use std::path::Path;
use std::process::ExitCode;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

static RIGID: [Case; RIGID_CASES.len()] = RIGID_CASES;
static FLEXIBLE: [Case; FLEXIBLE_CASES.len()] = FLEXIBLE_CASES;

fn page(rigid: &[Measured], flexible: &[Measured]) -> String {
    let mut text = format!(
        "# Work against error\n\n\
         Written by `cargo bench --package loosepin-bench --bench work_precision -- --write`; [Which integrator, and why](integrators.md) says what follows\n\
         from it.\n\n\
         64 samples of each rigid case, whose clearances differ by ±5 % and restitutions by ±2 %, over the first half turn; as many of links in the floating frame, and\n\
         3 of links in absolute nodal coordinates, over the time stated, without clearance with Young's moduli that differ by ±5 %. Work: right-hand sides of a run, the median;\n\
         repeated and rejected steps included. Implicit steps: those for Jacobians too, and behind \"and\" the factorizations, each of a real and of a complex matrix with as many\n\
         rows as the mechanism has coordinates. Error: the largest distance, at {TIMES} times,\n\
         of the watched point from its place in the reference runs, in m; median, 90 % quantile and worst of the samples.\n\n\
         ## Work at equal error\n\n\
         Right-hand sides at which the 90 % quantile of the error is what the second column says, and the tolerance that gives it;\n\
         between measured points in logarithms. ≤: with the loosest tolerance measured, which errs less already. Empty where the tightest errs more.\n\n{}\n\
         ## Work at equal error, flexible links\n\n\
         Least: by right-hand sides alone, without the factorizations.\n\n{}",
        comparison(rigid),
        comparison(flexible)
    );
    for case in rigid.iter().chain(flexible) {
        text.push('\n');
        text.push_str(&case.table());
    }
    text
}

fn diagram(measured: &[Measured], description: &str) -> String {
    Diagram {
        description: description.to_owned(),
        x_title: "error of the position, 90 % quantile, m".to_owned(),
        y_title: "right-hand sides, median".to_owned(),
        marked_x: PROMISED_M,
        note: "A point for each half decade of the tolerance, of nodal cases for each decade; ring: tolerance 1e-8 m; dashed: error 1e-8 m.".to_owned(),
        panels: measured.iter().map(Measured::panel).collect(),
    }
    .to_svg()
}

/// All of them, on as many threads as there are processors; in their order.
fn measured(cases: &[&'static Case]) -> Vec<Measured> {
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let next = AtomicUsize::new(0);
    let found = Mutex::new(Vec::new());
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                // The last ones take longest.
                while let Some(case) = cases.iter().rev().nth(next.fetch_add(1, Ordering::Relaxed)) {
                    let of_case = Measured::new(case);
                    println!("{}", of_case.table());
                    found.lock().expect("no thread has failed").push(of_case);
                }
            });
        }
    });
    let mut found = found.into_inner().expect("no thread has failed");
    found.sort_by_key(|of_case| cases.iter().position(|case| case.name == of_case.case.name));
    found
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&String> = arguments.iter().filter(|argument| !argument.starts_with("--")).collect();
    let chosen = |cases: &'static [Case]| {
        cases.iter().filter(|case| words.iter().all(|word| case.name.contains(word.as_str()))).collect::<Vec<_>>()
    };
    let (rigid, flexible) = (chosen(&RIGID), chosen(&FLEXIBLE));
    let all: Vec<&'static Case> = rigid.iter().chain(&flexible).copied().collect();
    let found = measured(&all);
    let (rigid, flexible) = found.split_at(rigid.len());
    println!("{}\n{}", comparison(rigid), comparison(flexible));
    if !arguments.iter().any(|argument| argument == "--write") {
        return ExitCode::SUCCESS;
    }
    if !words.is_empty() {
        eprintln!("error: --write with a choice of cases\nhint: the files hold all of them");
        return ExitCode::from(2);
    }
    let measured = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../measured");
    let of_rigid = "Right-hand sides of half a turn over the error of a position, for three methods in eight cases";
    let of_flexible = "Right-hand sides over the error of a position, for three explicit methods and an implicit one in six \
                       cases of flexible links";
    for (file, text) in [
        ("work-precision.md", page(rigid, flexible)),
        ("images/work_precision.svg", diagram(rigid, of_rigid)),
        ("images/work_precision_flexible.svg", diagram(flexible, of_flexible)),
    ] {
        if let Err(error) = std::fs::write(measured.join(file), text) {
            eprintln!("error: measured/{file}: {error}");
            return ExitCode::FAILURE;
        }
    }
    ExitCode::SUCCESS
}
