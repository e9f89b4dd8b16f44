//! Tables and pictures of work against error.

use crate::diagram::{Line, Panel, with_thousands_separators};
use crate::precision::{Case, Method, Point, Samples, work_at};
use loosepin::integrate::{DOP853, TSITOURAS_5};
use loosepin::simulate::{Integrator, Settings};
use std::fmt::Write;

/// The tightest tolerance measured over that of the reference.
const MARGIN: f64 = 100.0;

/// Tolerance of the runs with another method that check the reference over its own: tighter ones gain nothing against rounding.
const CHECK: f64 = 10.0;

/// Evaluations after which a run counts as failed: some thirty times the most that a median run needs.
const MAX_EVALUATIONS: u64 = 10_000_000;

/// Accuracy promised by the default setting, m.
pub const PROMISED_M: f64 = 1e-8;

/// Errors at which the methods are compared, m.
const COMPARED_M: [f64; 4] = [1e-7, PROMISED_M, 1e-9, 1e-10];

/// All methods in one case.
pub struct Measured {
    /// The case.
    pub case: &'static Case,
    /// For each method, from loose to tight.
    points: Vec<Vec<Point>>,
    /// Error of the check by another method.
    check: Point,
}

fn tolerance_m(half_decade: i32) -> f64 {
    let whole = format!("1e-{}", half_decade / 2).parse().unwrap_or(f64::NAN);
    if half_decade % 2 == 0 { whole } else { whole / 10_f64.sqrt() }
}

fn settings(tolerance_m: f64, method: &Method) -> Settings {
    let Method { pair, integrator, .. } = *method;
    Settings { tolerance_m, method: pair, integrator, largest_evaluations: MAX_EVALUATIONS }
}

impl Measured {
    /// Runs everything.
    ///
    /// # Panics
    /// If the case does not exist or a run of the reference fails: mistakes in this crate.
    pub fn new(case: &'static Case) -> Self {
        let samples = Samples::new(case);
        let explicit = |pair| Method { name: "", pair, integrator: Integrator::Explicit, half_decades: (0, 0, 1) };
        let reference = samples.run(&settings(case.reference_m, &explicit(&DOP853)));
        let tightest_m = 0.99 * MARGIN * case.reference_m;
        let of_method = |method: &Method| {
            let (first, last, apart) = method.half_decades;
            let tolerances =
                (first..=last).step_by(apart).map(tolerance_m).filter(|tolerance_m| *tolerance_m >= tightest_m);
            tolerances.map(|tolerance_m| samples.measure(&settings(tolerance_m, method), &reference)).collect()
        };
        let points = case.methods.iter().map(of_method).collect();
        let check = samples.measure(&settings(CHECK * case.reference_m, &explicit(&TSITOURAS_5)), &reference);
        Self { case, points, check }
    }

    /// The table of whole decades.
    pub fn table(&self) -> String {
        let methods = self.case.methods;
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
        for method in methods {
            let _ = write!(text, " {} | median | 90 % | worst |", method.name);
        }
        let _ = write!(text, "\n|---|{}\n", "--:|---|---|---|".repeat(methods.len()));
        let half_decades = methods.iter().map(|method| method.half_decades);
        let (first, last) = half_decades.fold((i32::MAX, 0), |(first, last), (a, b, _)| (first.min(a), last.max(b)));
        for tolerance_m in (first..=last).filter(|half_decade| half_decade % 2 == 0).map(tolerance_m) {
            let of = |points: &Vec<Point>| points.iter().copied().find(|point| point.tolerance_m == tolerance_m);
            let row: Vec<Option<Point>> = self.points.iter().map(of).collect();
            if row.iter().all(Option::is_none) {
                continue;
            }
            let _ = write!(text, "| {tolerance_m:.0e} m |");
            for found in row {
                let _ = match found {
                    Some(point) => write!(
                        text,
                        " {} | {:.1e} | {:.1e} | {:.1e} |",
                        work(point.evaluations as f64, point.factorizations as f64),
                        point.median_m,
                        point.quantile_m,
                        point.worst_m
                    ),
                    None => write!(text, " | | | |"),
                };
            }
            text.push('\n');
        }
        for (points, method) in self.points.iter().zip(methods) {
            for point in points.iter().filter(|point| point.failed > 0) {
                let (failed, tolerance_m) = (point.failed, point.tolerance_m);
                let _ = write!(
                    text,
                    "\nFailed with {} at {tolerance_m:.1e} m: {failed} of {} runs.\n",
                    method.name, self.case.samples
                );
            }
        }
        text
    }

    /// Its small diagram.
    pub fn panel(&self) -> Panel {
        let line = |(points, method): (&Vec<Point>, &Method)| {
            let drawn = || points.iter().filter(|point| point.quantile_m.is_finite() && point.quantile_m > 0.0);
            Line {
                label: method.name.trim_end_matches(" 5(4)").to_owned(),
                points: drawn().map(|point| (point.quantile_m, point.evaluations as f64)).collect(),
                highlighted: drawn().position(|point| point.tolerance_m == PROMISED_M),
            }
        };
        Panel {
            title: self.case.name.to_owned(),
            subtitle: self.case.about.to_owned(),
            lines: self.points.iter().zip(self.case.methods).map(line).collect(),
        }
    }
}

/// Evaluations, and factorizations where there are any.
fn work(evaluations: f64, factorizations: f64) -> String {
    let evaluations = with_thousands_separators(evaluations);
    if factorizations == 0.0 {
        evaluations
    } else {
        format!("{evaluations} and {}", with_thousands_separators(factorizations))
    }
}

fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}

/// Work at equal error, and the tolerance that gives it: a row for each case and error; the columns are the methods of the case that has most.
pub fn comparison(measured: &[Measured]) -> String {
    let methods = measured.iter().map(|of_case| of_case.case.methods).max_by_key(|methods| methods.len());
    let methods = methods.unwrap_or_default();
    let mut text = String::from("| case | error |");
    for method in methods {
        let _ = write!(text, " {} | at tolerance |", method.name);
    }
    let _ = write!(text, "\n|---|---|{}\n", "--:|---|".repeat(methods.len()));
    for error_m in COMPARED_M {
        for of_case in measured {
            let _ = write!(text, "| {} | {error_m:.0e} m |", of_case.case.name);
            let found: Vec<_> = of_case.points.iter().map(|points| work_at(points, error_m)).collect();
            let least = found.iter().flatten().fold(f64::INFINITY, |least, found| least.min(found.evaluations));
            for place in 0..methods.len() {
                let _ = match found.get(place).copied().flatten() {
                    Some(found) => {
                        let mark = if found.evaluations == least { "**" } else { "" };
                        let work = work(found.evaluations, found.factorizations);
                        let [most, least] = if found.is_most { ["≤ ", "≥ "] } else { [""; 2] };
                        write!(text, " {mark}{most}{work}{mark} | {least}{:.1e} m |", found.tolerance_m)
                    }
                    None => write!(text, " | |"),
                };
            }
            text.push('\n');
        }
    }
    text
}
