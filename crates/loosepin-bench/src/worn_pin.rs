//! `cases/slider_crank_worn_pin`, for the campaigns that hold its study against runs of their own.

use crate::case_file;
use loosepin::study::{RunData, RunsTable};
use loosepin::study::{Study, StudyRun};
use loosepin::uncertainty::{EpistemicVariable, Interval, ScrambledSobol};

/// Independent scramblings that the mechanisms at one value of u are drawn in.
const REPLICATES: usize = 8;

/// The study of the case.
///
/// # Panics
/// If it is not there or is no study.
pub fn study() -> Study {
    let case = case_file("slider_crank_worn_pin", "study.toml");
    Study::from_path(&case).unwrap_or_else(|diagnostics| panic!("{diagnostics}"))
}

/// Points of a low-discrepancy set inside the box of the unknown inputs, as shares of it.
///
/// # Panics
/// If too many inputs are unknown for such a set.
pub fn low_discrepancy_fractions(study: &Study, seed: u64, points: u32) -> Vec<Vec<f64>> {
    let sobol = ScrambledSobol::try_new(seed, study.epistemic.len()).expect("few dimensions");
    let point = |index| {
        let mut fractions = vec![0.0; study.epistemic.len()];
        sobol.write_point(0, index, &mut fractions);
        fractions
    };
    (0..points).map(point).collect()
}

/// The values of the unknown inputs at a point of their box.
pub fn values_at(study: &Study, fractions: &[f64]) -> Vec<f64> {
    study.epistemic.iter().zip(fractions).map(|(input, &fraction)| input.variable.at(fraction)).collect()
}

/// The study with the unknown inputs fixed at one value of u, with this number of mechanisms.
///
/// # Panics
/// If a value is not finite, or the study has no result.
pub fn run_at(study: &Study, mechanisms: usize, at: &[f64], seed: u64) -> StudyRun {
    let mut known = study.clone();
    known.seed = seed;
    known.sampling.inner = mechanisms;
    known.sampling.replicates = REPLICATES;
    for (input, &value) in known.epistemic.iter_mut().zip(at) {
        input.variable = EpistemicVariable::from(Interval::try_new(value, value).expect("a finite value"));
    }
    crate::run(&known)
}

/// The values of a column in the runs of the double loop; NaN for failed runs.
///
/// # Panics
/// If there is no such column of numbers.
pub fn double_loop(runs: &RunsTable, name: &str) -> Vec<f64> {
    let column = |name: &str| {
        let found = runs.columns.iter().find(|column| column.name == name);
        &found.unwrap_or_else(|| panic!("the runs have no column '{name}'")).data
    };
    let (RunData::Text(purposes), RunData::F64(values)) = (column("purpose"), column(name)) else {
        panic!("'{name}' is no response of the runs")
    };
    purposes.iter().zip(values).filter(|(purpose, _)| *purpose == "mixed").map(|(_, &value)| value).collect()
}
