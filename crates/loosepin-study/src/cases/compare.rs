//! Cases compared.

use rayon::prelude::*;

use super::case::{Case, Check, CheckSubject};
use super::history::largest_difference;
use super::obtain::Runs;
use loosepin_result::cases::{CaseRecord, Comparison, NumberRecord};
use loosepin_text::diagnostics::Diagnostics;
use loosepin_text::units::ReadableUnit;

/// Runs each case and compares its numbers, side by side; the records are in the order of the cases.
///
/// # Errors
/// The first case whose numbers cannot be obtained.
pub fn compare_all(cases: &[Case]) -> Result<Vec<CaseRecord>, Diagnostics> {
    let outcomes: Vec<Result<CaseRecord, Diagnostics>> = cases.par_iter().map(compare).collect();
    outcomes.into_iter().collect()
}

/// Runs a case and compares its numbers.
///
/// # Errors
/// A run or the ideal motion fails.
pub fn compare(case: &Case) -> Result<CaseRecord, Diagnostics> {
    let mut runs = Runs::new(case);
    // Histories first: their runs serve the numbers as well.
    for check in &case.checks {
        if let CheckSubject::History(history) = &check.what {
            runs.beside(history)?;
        }
    }
    let mut numbers = Vec::new();
    for check in &case.checks {
        compare_check(&mut runs, check, &mut numbers)?;
    }
    Ok(CaseRecord { name: case.name.clone(), title: case.model.name.clone(), numbers })
}

fn compare_check(runs: &mut Runs<'_>, check: &Check, records: &mut Vec<NumberRecord>) -> Result<(), Diagnostics> {
    let record = |name: String, comparison: Comparison, tolerance_si: f64, unit: &ReadableUnit| NumberRecord {
        name,
        origin: check.origin,
        source: check.source.clone(),
        comparison,
        tolerance_si,
        unit: unit.text.clone(),
        si_per_unit: unit.si_per_unit,
    };
    match &check.what {
        CheckSubject::Numbers(numbers) => {
            for (index, number) in numbers.numbers.iter().enumerate() {
                let obtained_si = runs.obtain(&numbers.quantity, number, index, &check.place)?;
                let name = match &number.words {
                    _ if numbers.numbers.len() == 1 => check.name.clone(),
                    Some(words) => format!("{} {words}", check.name),
                    None => format!("{} {}", check.name, index + 1),
                };
                let comparison = Comparison::Number { expected_si: number.value_si, obtained_si };
                records.push(record(name, comparison, numbers.tolerance_si, &numbers.unit));
            }
        }
        CheckSubject::Impacts(impacts) => {
            let simulation = runs.over(impacts.span_s)?;
            let ours = runs.impacts(&simulation, impacts.play, impacts.of);
            let difference_si =
                impacts.expected_si.iter().enumerate().fold(0.0_f64, |largest, (index, expected_si)| {
                    let difference = ours.get(index).map_or(f64::NAN, |obtained_si| (obtained_si - expected_si).abs());
                    if difference.is_nan() || largest.is_nan() { f64::NAN } else { largest.max(difference) }
                });
            let of = match impacts.expected_si.len() {
                1 => "1 impact".to_owned(),
                count => format!("{count} impacts"),
            };
            let comparison = Comparison::Largest { of, difference_si };
            records.push(record(check.name.clone(), comparison, impacts.tolerance_si, &impacts.unit));
        }
        CheckSubject::History(history) => {
            let simulation = runs.beside(history)?;
            let of = format!("{} rows", history.reference.rows.len());
            let difference_si = largest_difference(history, &simulation);
            let comparison = Comparison::Largest { of, difference_si };
            records.push(record(check.name.clone(), comparison, history.tolerance_si, &history.unit));
        }
    }
    Ok(())
}
