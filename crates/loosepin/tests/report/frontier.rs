//! Two inputs loosened against each other: the chart, and the sentences beside it.

use loosepin::report::{figures, study_page, study_text};
use loosepin::study::result::{Loosened, LoosenedInput, Together, TogetherRecord};
use loosepin::units::SiUnit;

use crate::report_fixture;

/// What is required of the two numbers.
fn is_met(a: f64, b: f64) -> bool {
    a * b <= 1.0
}

/// The record of a search under that rule: at each a the largest multiple of a step that is met, and the next one.
fn record() -> TogetherRecord {
    const STEP: f64 = 1.0 / 32.0;
    const LARGEST: f64 = 3.0;
    let input = |path: &str, least_si: f64, up_to_si: f64| LoosenedInput {
        path: path.to_owned(),
        what: Loosened::UpperEnd,
        unit: SiUnit::NONE,
        least_si,
        up_to_si,
    };
    let mut record = TogetherRecord {
        how: Together::Frontier,
        inputs: vec![input("parameter.a", 0.25, 8.0), input("parameter.b", 0.0, LARGEST)],
        allowed_si: Vec::new(),
        beyond_si: Vec::new(),
        checks: Vec::new(),
        runs: 0,
    };
    for a in [0.25, 0.5, 0.875, 1.25, 2.0, 2.75, 4.0] {
        if is_met(a, LARGEST) {
            record.allowed_si.push(vec![a, LARGEST]);
            continue;
        }
        let b = (1.0 / a / STEP).floor() * STEP;
        record.allowed_si.push(vec![a, b]);
        record.beyond_si.push(vec![a, b + STEP]);
    }
    record
}

/// The rows of the chart: a, largest b that is drawn as met, least b that is drawn as not shown to be met where there is one.
fn rows() -> Vec<(f64, f64, Option<f64>)> {
    let mut result = report_fixture::study::worn_pin();
    result.together = Some(record());
    let figures = figures(&study_page(&result));
    let chart = figures.iter().find(|figure| figure.name == "frontier").expect("the chart");
    let csv = chart.to_csv().expect("a chart has numbers");
    let cells = |line: &str| -> Vec<Option<f64>> { line.split(',').map(|cell| cell.parse().ok()).collect() };
    let rows = csv.lines().skip(2).map(cells);
    rows.map(|row| (row[0].expect("a"), row[2].expect("b"), row[3])).collect()
}

#[test]
fn analytic_no_point_that_is_drawn_as_met_breaks_the_rule() {
    let (rows, record) = (rows(), record());
    assert_eq!(rows.len(), 2 * record.allowed_si.len());
    for pair in rows.windows(2) {
        let [(a0, met0, refused0), (a1, met1, refused1)] = [pair[0], pair[1]];
        for share in (0..=20).map(|step| f64::from(step) / 20.0) {
            let between = |from: f64, to: f64| from + share * (to - from);
            let a = between(a0, a1);
            assert!(is_met(a, between(met0, met1)), "{a} {met0} {met1}");
            if let (Some(refused0), Some(refused1)) = (refused0, refused1) {
                assert!(!is_met(a, between(refused0, refused1)), "{a} {refused0} {refused1}");
            }
        }
    }
    // Every pair of the record is a corner.
    for allowed in &record.allowed_si {
        assert!(rows.iter().any(|row| (row.0, row.1) == (allowed[0], allowed[1])), "{allowed:?}");
    }
    for beyond in &record.beyond_si {
        assert!(rows.iter().any(|row| (row.0, row.2) == (beyond[0], Some(beyond[1]))), "{beyond:?}");
    }
}

#[test]
fn the_sentences_say_which_pairs_were_run() {
    let mut result = report_fixture::study::worn_pin();
    result.together = Some(record());
    let text = study_text(&result).split_whitespace().collect::<Vec<&str>>().join(" ");
    for due in [
        "All requirements are met with each of these pairs that was run, also with other random numbers.",
        "A pair that is tighter in both values than a pair that meets the requirements also counts as meeting them. A pair that is looser in both than a rejected pair counts as not shown to meet them. Such pairs were not run.",
    ] {
        assert!(text.contains(due), "{text}");
    }
}
