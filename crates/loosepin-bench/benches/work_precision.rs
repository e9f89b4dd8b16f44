//! Work against error of the integrators over the first half turn of several mechanisms: right-hand sides, never seconds.
//!
//! `cargo bench --package loosepin-bench --bench work_precision` prints the tables, a word behind `--` those of the cases with that word in their names
//! alone; `-- --write` also writes `docs/work-precision.md` and `docs/images/work_precision.svg`, the same bytes on every run.

use loosepin::integrate::{DOP853, DORMAND_PRINCE_5, TSITOURAS_5, Tableau};
use loosepin::simulate::Settings;
use loosepin_bench::diagram::{Diagram, Line, Panel, thousands};
use loosepin_bench::precision::{Case, Point, Samples, work_at};
use std::fmt::Write;
use std::path::Path;
use std::process::ExitCode;

/// What differs from one sample to the next, as a share of its nominal value: enough for other sequences of contacts.
const CLEARANCE: f64 = 0.05;
/// Likewise.
const RESTITUTION: f64 = 0.02;

const CASES: [Case; 8] = [
    Case {
        name: "slider_crank_5000",
        about: "one clearance, 5000 rpm; the slider",
        point: "slider.pin",
        varied: &[("joint.gudgeon.radial_clearance", CLEARANCE), ("contact.steel_pin.restitution", RESTITUTION)],
        reference_m: 1e-13,
    },
    Case {
        name: "slider_crank_two_clearances",
        about: "contacts in two joints at a time; the slider",
        point: "slider.pin",
        varied: &[
            ("joint.crank_pin.radial_clearance", CLEARANCE),
            ("joint.gudgeon.radial_clearance", CLEARANCE),
            ("contact.gudgeon.restitution", RESTITUTION),
        ],
        reference_m: 1e-13,
    },
    Case {
        name: "slider_crank_friction",
        about: "dry friction in the clearance; the slider",
        point: "slider.pin",
        varied: &[("joint.gudgeon.radial_clearance", CLEARANCE), ("contact.steel_pin.restitution", RESTITUTION)],
        reference_m: 1e-13,
    },
    Case {
        name: "four_bar_600",
        about: "one clearance, 600 rpm; the rocker's pin",
        point: "rocker.pin",
        varied: &[("joint.coupler_pin.radial_clearance", CLEARANCE), ("contact.steel_pin.restitution", RESTITUTION)],
        reference_m: 1e-13,
    },
    Case {
        name: "four_bar_linear_contact",
        about: "contact force linear in the penetration; the rocker's tip",
        point: "rocker.tip",
        varied: &[("joint.crank_pin.radial_clearance", CLEARANCE), ("contact.liner.restitution", RESTITUTION)],
        reference_m: 1e-13,
    },
    Case {
        name: "six_bar",
        about: "a loop of ideal joints; the end of the link",
        point: "link.head",
        varied: &[("joint.coupler_pin.radial_clearance", CLEARANCE), ("contact.bronze_bush.restitution", RESTITUTION)],
        reference_m: 1e-13,
    },
    Case {
        name: "six_bar_stephenson",
        about: "a loop of ideal joints, and friction; the end of the arm",
        point: "arm.end",
        varied: &[("joint.tip.radial_clearance", CLEARANCE), ("contact.steel.restitution", RESTITUTION)],
        reference_m: 1e-13,
    },
    Case {
        name: "four_bar_settling",
        about: "contacts that begin gently, 45 rpm; the rocker's tip",
        point: "rocker.tip",
        varied: &[("joint.tip.radial_clearance", CLEARANCE), ("contact.steel.restitution", RESTITUTION)],
        reference_m: 1e-11,
    },
];

static METHODS: [&Tableau; 3] = [&DOP853, &DORMAND_PRINCE_5, &TSITOURAS_5];

/// Samples of each case.
const SAMPLES: usize = 64;

/// Tolerances, m: half decades from 1e-5 to 1e-11.
const HALF_DECADES: std::ops::RangeInclusive<i32> = 10..=22;

/// The tightest tolerance measured over that of the reference.
const MARGIN: f64 = 100.0;

/// Tolerance of the runs with another method that check the reference over its own: tighter ones gain nothing against rounding.
const CHECK: f64 = 10.0;

/// Evaluations after which a run counts as failed: some thirty times the most that a median run needs.
const LARGEST_EVALUATIONS: u64 = 10_000_000;

/// What the default setting promises, m.
const PROMISED_M: f64 = 1e-8;

/// Errors at which the methods are compared, m.
const COMPARED_M: [f64; 4] = [1e-7, PROMISED_M, 1e-9, 1e-10];

fn tolerance_m(half_decade: i32) -> f64 {
    let whole = format!("1e-{}", half_decade / 2).parse().unwrap_or(f64::NAN);
    if half_decade % 2 == 0 { whole } else { whole / 10_f64.sqrt() }
}

fn settings(tolerance_m: f64, method: &'static Tableau) -> Settings {
    Settings { tolerance_m, method, largest_evaluations: LARGEST_EVALUATIONS, ..Settings::for_study() }
}

/// All methods in one case.
struct Measured {
    case: &'static Case,
    /// For each method, from loose to tight.
    points: Vec<Vec<Point>>,
    /// Error of the check by another method.
    check: Point,
}

impl Measured {
    fn new(case: &'static Case) -> Self {
        let samples = Samples::new(case, SAMPLES);
        let reference = samples.run(&settings(case.reference_m, &DOP853));
        let tightest_m = 0.99 * MARGIN * case.reference_m;
        let of_method = |method: &'static Tableau| {
            let tolerances = HALF_DECADES.map(tolerance_m).filter(|tolerance_m| *tolerance_m >= tightest_m);
            tolerances.map(|tolerance_m| samples.measure(&settings(tolerance_m, method), &reference)).collect()
        };
        let points = METHODS.map(of_method).into();
        Self { case, points, check: samples.measure(&settings(CHECK * case.reference_m, &TSITOURAS_5), &reference) }
    }

    /// The table of whole decades.
    fn table(&self) -> String {
        let mut text = format!(
            "## {}\n\n{}.\nReference: DOP853 at {:.0e} m, from which {} at {:.0e} m differs by {:.0e} m (90 % quantile; {:.0e} m at most).\n\n| tolerance |",
            self.case.name,
            capitalised(self.case.about),
            self.case.reference_m,
            TSITOURAS_5.name,
            self.check.tolerance_m,
            self.check.quantile_m,
            self.check.worst_m
        );
        for method in METHODS {
            let _ = write!(text, " {} | median | 90 % | worst |", method.name);
        }
        let _ = write!(text, "\n|---|{}\n", "--:|---|---|---|".repeat(METHODS.len()));
        for row in (0..self.points[0].len()).step_by(2) {
            let _ = write!(text, "| {:.0e} m |", self.points[0][row].tolerance_m);
            for points in &self.points {
                let point = &points[row];
                let _ = write!(
                    text,
                    " {} | {:.1e} | {:.1e} | {:.1e} |",
                    thousands(point.evaluations as f64),
                    point.median_m,
                    point.quantile_m,
                    point.worst_m
                );
            }
            text.push('\n');
        }
        for (points, method) in self.points.iter().zip(METHODS) {
            for point in points.iter().filter(|point| point.failed > 0) {
                let (failed, tolerance_m) = (point.failed, point.tolerance_m);
                let _ =
                    write!(text, "\nFailed with {} at {tolerance_m:.1e} m: {failed} of {SAMPLES} runs.\n", method.name);
            }
        }
        text
    }

    fn panel(&self) -> Panel {
        let line = |(points, method): (&Vec<Point>, &&Tableau)| Line {
            label: method.name.trim_end_matches(" 5(4)").to_owned(),
            points: points
                .iter()
                .filter(|point| point.quantile_m.is_finite() && point.quantile_m > 0.0)
                .map(|point| (point.quantile_m, point.evaluations as f64))
                .collect(),
            ringed: points
                .iter()
                .filter(|point| point.quantile_m.is_finite() && point.quantile_m > 0.0)
                .position(|point| point.tolerance_m == PROMISED_M),
        };
        Panel {
            title: self.case.name.to_owned(),
            subtitle: self.case.about.to_owned(),
            lines: self.points.iter().zip(&METHODS).map(line).collect(),
        }
    }
}

fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}

/// Work at equal error, and the tolerance that gives it: a row for each case and error.
fn comparison(measured: &[Measured]) -> String {
    let mut text = String::from("| case | error |");
    for method in METHODS {
        let _ = write!(text, " {} | at tolerance |", method.name);
    }
    let _ = write!(text, "\n|---|---|{}\n", "--:|---|".repeat(METHODS.len()));
    for error_m in COMPARED_M {
        for case in measured {
            let _ = write!(text, "| {} | {error_m:.0e} m |", case.case.name);
            let work: Vec<Option<(f64, f64)>> = case.points.iter().map(|points| work_at(points, error_m)).collect();
            let least = work.iter().flatten().fold(f64::INFINITY, |least, (_, work)| least.min(*work));
            for found in work {
                let _ = match found {
                    Some((tolerance_m, work)) => {
                        let mark = if work == least { "**" } else { "" };
                        write!(text, " {mark}{}{mark} | {tolerance_m:.1e} m |", thousands(work))
                    }
                    None => write!(text, " | |"),
                };
            }
            text.push('\n');
        }
    }
    text
}

fn page(measured: &[Measured]) -> String {
    let mut text = format!(
        "# Work against error\n\n\
         Written by `cargo bench --package loosepin-bench --bench work_precision -- --write`; [Which integrator, and why](integrators.md) says what follows\n\
         from it.\n\n\
         {SAMPLES} samples of each case, whose clearances differ by ±5 % and restitutions by ±2 %, over the first half turn. Work:\n\
         right-hand sides of a run, the median; repeated and rejected steps included. Error: the largest distance, at {times} times,\n\
         of the watched point from its place in the reference runs, in m; median, 90 % quantile and worst of the samples.\n\n\
         ## Work at equal error\n\n\
         Right-hand sides at which the 90 % quantile of the error is what the second column says, and the tolerance that gives it;\n\
         between measured points in logarithms. Empty where it lies outside of the tolerances measured.\n\n{comparison}",
        times = loosepin_bench::precision::TIMES,
        comparison = comparison(measured)
    );
    for case in measured {
        text.push('\n');
        text.push_str(&case.table());
    }
    text
}

fn diagram(measured: &[Measured]) -> String {
    Diagram {
        description: "Right-hand sides of half a turn over the error of a position, for three methods in eight cases"
            .to_owned(),
        x_title: "error of the position, 90 % quantile, m".to_owned(),
        y_title: "right-hand sides, median".to_owned(),
        marked_x: PROMISED_M,
        note: "A point for each half decade of the tolerance from 1e-5 m on; ring: tolerance 1e-8 m; dashed: error 1e-8 m."
            .to_owned(),
        panels: measured.iter().map(Measured::panel).collect(),
    }
    .to_svg()
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&String> = arguments.iter().filter(|argument| !argument.starts_with("--")).collect();
    let mut measured = Vec::new();
    for case in CASES.iter().filter(|case| words.iter().all(|word| case.name.contains(word.as_str()))) {
        let found = Measured::new(case);
        println!("{}", found.table());
        measured.push(found);
    }
    println!("{}", comparison(&measured));
    if !arguments.iter().any(|argument| argument == "--write") {
        return ExitCode::SUCCESS;
    }
    if !words.is_empty() {
        eprintln!("error: --write with a choice of cases\nhint: the files hold all of them");
        return ExitCode::from(2);
    }
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs");
    for (file, text) in [("work-precision.md", page(&measured)), ("images/work_precision.svg", diagram(&measured))] {
        if let Err(error) = std::fs::write(docs.join(file), text) {
            eprintln!("error: docs/{file}: {error}");
            return ExitCode::FAILURE;
        }
    }
    ExitCode::SUCCESS
}
