//! The reference for bounds of `cases/slider_crank_worn_pin`: its quantities, the estimates of its numbers, and its file.

use crate::worn_pin;
use loosepin::bounds::Statistic;
use loosepin::study::{Deviation, Reduction, Study, Where};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// A bounded quantity, with the name that the file has for it.
pub struct Asked {
    /// In the file.
    pub name: &'static str,
    /// Reduction of the total deviation of the slider over the turn.
    pub reduction: Reduction,
    /// Over mechanisms.
    pub statistic: Statistic,
}

/// The two numbers of a turn, in the order of the study.
pub const REDUCTIONS: [Reduction; 2] = [Reduction::MaximumAbsolute, Reduction::RootMeanSquare];

/// All of it. The study does not ask for the standard deviation of the root mean square.
pub const ASKED: [Asked; 7] = {
    const fn asked(name: &'static str, reduction: Reduction, statistic: Statistic) -> Asked {
        Asked { name, reduction, statistic }
    }
    let [largest, rms] = REDUCTIONS;
    [
        asked("maximum_absolute mean", largest, Statistic::Mean),
        asked("maximum_absolute standard_deviation", largest, Statistic::StandardDeviation),
        asked("maximum_absolute quantile 0.975", largest, Statistic::Quantile(0.975)),
        asked("maximum_absolute probability_above 0.85 mm", largest, Statistic::ProbabilityAbove(0.85e-3)),
        asked("rms mean", rms, Statistic::Mean),
        asked("rms standard_deviation", rms, Statistic::StandardDeviation),
        asked("rms quantile 0.975", rms, Statistic::Quantile(0.975)),
    ]
};

/// The ends of a bound.
pub const ENDS: [&str; 2] = ["lower", "upper"];

/// The study, asked for these two numbers of a turn alone, as its file asks for them.
///
/// # Panics
/// If the study does not ask for them.
pub fn study() -> Study {
    let mut study = worn_pin::study();
    let is_one = |location: &Where| location.reduction().is_some_and(|reduction| REDUCTIONS.contains(&reduction));
    study.asks.retain(|ask| ask.deviation == Deviation::Total && is_one(&ask.location));
    study.requirements.clear();
    let found: Vec<&Where> = study.asks.iter().map(|ask| &ask.location).collect();
    assert_eq!(found, REDUCTIONS.map(Where::reduced).iter().collect::<Vec<_>>(), "what the study asks for");
    study
}

/// A statistic of values; NaN if there are too few.
pub fn estimate(statistic: Statistic, values: &[f64]) -> f64 {
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    match statistic {
        Statistic::Mean => mean,
        Statistic::StandardDeviation => {
            (values.iter().map(|value| (value - mean) * (value - mean)).sum::<f64>() / (count - 1.0)).sqrt()
        }
        Statistic::ProbabilityAbove(limit) => values.iter().filter(|&&value| value > limit).count() as f64 / count,
        Statistic::Quantile(probability) => quantile(values, probability),
        other => panic!("{other:?} is no part of the reference"),
    }
}

/// Between order statistics, y_(k) at (k - 1/2)/N (A. Hazen 1914), as in bounds.
fn quantile(values: &[f64], probability: f64) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let Some(last) = sorted.len().checked_sub(1) else { return f64::NAN };
    let rank = (probability * sorted.len() as f64 - 0.5).clamp(0.0, last as f64);
    let below = rank.floor();
    let above = sorted[(below as usize + 1).min(last)];
    sorted[below as usize] + (rank - below) * (above - sorted[below as usize])
}

/// The standard error of an estimate from this number of independent parts of equal size, one after the other in `values`: the jackknife
/// that leaves one part out at a time (M. H. Quenouille 1956). It serves quantiles too, since a part has more than √N values.
pub fn standard_error(statistic: Statistic, values: &[f64], parts: usize) -> f64 {
    let size = values.len() / parts;
    let without: Vec<f64> = (0..parts)
        .map(|part| estimate(statistic, &[&values[..part * size], &values[(part + 1) * size..]].concat()))
        .collect();
    let mean = without.iter().sum::<f64>() / parts as f64;
    let squares: f64 = without.iter().map(|value| (value - mean) * (value - mean)).sum();
    (squares * (parts as f64 - 1.0) / parts as f64).sqrt()
}

/// One end of the reference.
#[derive(Debug, Clone, PartialEq)]
pub struct ReferenceEnd {
    /// Place in [`ASKED`].
    pub asked: usize,
    /// 0: lower, 1: upper.
    pub end: usize,
    /// The statistic at the witness.
    pub value_si: f64,
    /// Standard error of the value.
    pub standard_error_si: f64,
    /// Clearance, m, and restitution.
    pub witness: [f64; 2],
    /// Mechanisms that the value was estimated from.
    pub mechanisms: usize,
}

/// Path of the stored reference.
pub fn file() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("references/worn_pin.csv")
}

const HEAD: &str = "statistic,end,value_si,standard_error_si,radial_clearance_m,restitution,mechanisms";

/// The text of the file; `notes` say how it was made.
pub fn written(notes: &[String], ends: &[ReferenceEnd]) -> String {
    let mut text: String = notes.iter().map(|note| format!("# {note}\n")).collect();
    let _ = writeln!(text, "{HEAD}");
    for end in ends {
        let (name, side, [clearance_m, restitution]) = (ASKED[end.asked].name, ENDS[end.end], end.witness);
        let _ = writeln!(
            text,
            "{name},{side},{:.9e},{:.2e},{clearance_m:.9e},{restitution:.9},{}",
            end.value_si, end.standard_error_si, end.mechanisms
        );
    }
    text
}

/// Reads the text of such a file.
///
/// # Panics
/// If it is none.
pub fn read(text: &str) -> Vec<ReferenceEnd> {
    let mut lines = text.lines().filter(|line| !line.starts_with('#'));
    assert_eq!(lines.next(), Some(HEAD), "the head of the reference");
    lines.map(|line| read_end(line).unwrap_or_else(|| panic!("no end of the reference: {line}"))).collect()
}

fn read_end(line: &str) -> Option<ReferenceEnd> {
    let [name, side, value, error, clearance, restitution, mechanisms] =
        line.split(',').collect::<Vec<_>>().try_into().ok()?;
    Some(ReferenceEnd {
        asked: ASKED.iter().position(|asked| asked.name == name)?,
        end: ENDS.iter().position(|&end| end == side)?,
        value_si: value.parse().ok()?,
        standard_error_si: error.parse().ok()?,
        witness: [clearance.parse().ok()?, restitution.parse().ok()?],
        mechanisms: mechanisms.parse().ok()?,
    })
}
