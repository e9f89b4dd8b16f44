//! Bounds of single statistics of two studies, with their differences.

use serde::Serialize;

use super::outputs::SharedOutputs;
use crate::numbers::number::{NumberWriter, Rounding, significant};
use crate::words::bound::found_value;
use crate::words::wording::{output_unit, reading_words, response_words, statistic_words};
use loosepin_result::study::{BoundEnd, BoundRecord, ResponsePoint, StudyResult};

/// Digits of a difference of shares, percentage points.
const POINT_DIGITS: usize = 2;
/// Bounds that are named one by one where they are not compared, and rows of the table.
const MAX_NAMED: usize = 8;
const MAX_ROWS: usize = 200;

/// A statistic that both studies bound.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ComparedStatistic {
    /// The response: `slider (x of slider.pin): deviation, largest absolute value in the cycle`.
    pub response: String,
    /// Which one, and by which treatment where it is not the mixed one.
    pub statistic: String,
    /// The smallest and the largest value that it may have.
    pub ends: [ComparedEnd; 2],
}

/// One end of a bound in both studies.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ComparedEnd {
    /// The value found with its numerical error, in A and in B: bounds hold their errors, so a difference of them is none of the statistics.
    pub values: [String; 2],
    /// B minus A of the values found, with sign and unit.
    pub difference: String,
    /// The same in SI.
    pub difference_si: f64,
    /// Whether it means anything.
    pub weight: Weight,
}

/// A difference against the numerical errors of what is compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Weight {
    /// There is none.
    None,
    /// The difference is not larger than both errors together: it may be numerical alone.
    WithinErrors,
    /// The difference is larger.
    BeyondErrors,
}

impl Weight {
    /// The weight of a difference.
    pub fn of(difference_si: f64, errors_si: f64) -> Self {
        if difference_si == 0.0 {
            Self::None
        } else if difference_si.abs() > errors_si {
            Self::BeyondErrors
        } else {
            Self::WithinErrors
        }
    }
}

/// Rows in the order of A; and what is not compared, in sentences.
pub fn compared(
    pair: [&StudyResult; 2],
    outputs: &SharedOutputs,
    writer: &NumberWriter,
) -> (Vec<ComparedStatistic>, Vec<String>) {
    let [before, after] = pair;
    let single = |result: &'_ StudyResult| -> Vec<usize> {
        let is_shown =
            |bound: &BoundRecord| !matches!(bound.at, ResponsePoint::Curve { .. }) && outputs.has(&bound.output);
        let bounds = result.bounds.iter().enumerate();
        bounds.filter(|(_, bound)| is_shown(bound)).map(|(place, _)| place).collect()
    };
    let mut left = single(after);
    let (mut rows, mut alone) = (Vec::new(), Vec::new());
    for place in single(before) {
        let bound = &before.bounds[place];
        match left.iter().position(|other| is_same(bound, &after.bounds[*other])) {
            Some(found) => rows.push(row(before, bound, &after.bounds[left.remove(found)], writer)),
            None => {
                let other = left.iter().map(|other| &after.bounds[*other]).find(|other| is_same_but_read(bound, other));
                alone.push(match other {
                    Some(other) => format!(
                        "{} is not compared: intervals are {} in A, {} in B.",
                        words(before, bound, writer),
                        reading_words(bound.reading),
                        reading_words(other.reading)
                    ),
                    None => format!("{} is in A alone.", words(before, bound, writer)),
                });
            }
        }
    }
    let is_read_otherwise =
        |bound: &BoundRecord| before.bounds.iter().any(|own| is_same_but_read(own, bound) && !is_same(own, bound));
    let only_after = left.iter().map(|place| &after.bounds[*place]).filter(|bound| !is_read_otherwise(bound));
    alone.extend(only_after.map(|bound| format!("{} is in B alone.", words(after, bound, writer))));
    let more = alone.len().saturating_sub(MAX_NAMED);
    alone.truncate(MAX_NAMED);
    if more > 0 {
        alone.push(format!("{more} more statistics are in only one of the studies."));
    }
    let unshown = rows.len().saturating_sub(MAX_ROWS);
    rows.truncate(MAX_ROWS);
    if unshown > 0 {
        alone.push(format!("{unshown} more statistics are in both studies: see bounds.csv of each."));
    }
    (rows, alone)
}

fn is_same_but_read(a: &BoundRecord, b: &BoundRecord) -> bool {
    a.output == b.output && a.of == b.of && a.at == b.at && a.statistic == b.statistic && a.treatment == b.treatment
}

/// Whether two bounds are of the same number, read in the same way.
pub(super) fn is_same(a: &BoundRecord, b: &BoundRecord) -> bool {
    is_same_but_read(a, b) && a.reading == b.reading && a.unit == b.unit
}

fn words(result: &StudyResult, bound: &BoundRecord, writer: &NumberWriter) -> String {
    let response = response_words(result, (&bound.output, bound.of, bound.at), writer);
    format!("{response}, {}", statistic(result, bound, writer))
}

fn statistic(result: &StudyResult, bound: &BoundRecord, writer: &NumberWriter) -> String {
    // A limit has the unit of the output, not that of the probability.
    let words = statistic_words(bound.statistic, &output_unit(result, &bound.output), writer);
    match bound.treatment.is_mixed() {
        true => words,
        false => format!("{words} ({})", bound.treatment.name().to_lowercase()),
    }
}

fn row(result: &StudyResult, before: &BoundRecord, after: &BoundRecord, writer: &NumberWriter) -> ComparedStatistic {
    let end = |ends: [&BoundEnd; 2]| {
        let difference_si = ends[1].value_si - ends[0].value_si;
        let errors_si = ends[0].error.total_si() + ends[1].error.total_si();
        ComparedEnd {
            values: [found_value(ends[0], before, writer), found_value(ends[1], after, writer)],
            difference: difference_words(difference_si, errors_si, before, writer),
            difference_si,
            weight: Weight::of(difference_si, errors_si),
        }
    };
    ComparedStatistic {
        response: response_words(result, (&before.output, before.of, before.at), writer),
        statistic: statistic(result, before, writer),
        ends: [end([&before.lower, &after.lower]), end([&before.upper, &after.upper])],
    }
}

fn difference_words(difference_si: f64, errors_si: f64, bound: &BoundRecord, writer: &NumberWriter) -> String {
    let sign = if difference_si > 0.0 { "+" } else { "" };
    if bound.statistic.is_probability() {
        let points = significant(100.0 * difference_si, POINT_DIGITS, Rounding::Nearest).replace('-', "−");
        return format!("{sign}{points} percentage points");
    }
    let value = writer.down_to_error(difference_si, errors_si, &bound.unit, Rounding::Nearest);
    format!("{sign}{value}")
}
