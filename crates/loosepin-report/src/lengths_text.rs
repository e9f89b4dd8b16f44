//! Lengths of a specimen, given what was measured, in words and as a table, for the terminal and for the page.

use super::number::{NumberWriter, Rounding};
use loosepin_result::motion_identification::{
    LengthColumn, MechanismRows, MotionSpecimen, SpecimenLengths, TiedLength, TiedTogether,
};
use loosepin_text::units::SiUnit;

/// Digits of a mean, and of a standard deviation.
const DIGITS: usize = 6;
const DEVIATION_DIGITS: usize = 3;

/// Columns of [`length_rows`].
pub(super) const LENGTH_HEADS: [&str; 5] =
    ["random input", "series: mean", "standard deviation", "specimen: mean", "standard deviation"];

/// A row for each random input.
pub(super) fn length_rows(rows: &MechanismRows, writer: &NumberWriter<'_>) -> Vec<[String; 5]> {
    let row = |column: &LengthColumn| {
        let mean = |value_si: f64| writer.rounded(value_si, &column.unit, DIGITS, Rounding::Nearest);
        let deviation = |value_si: f64| writer.rounded(value_si, &column.unit, DEVIATION_DIGITS, Rounding::Nearest);
        let ([before, scatter_before], [after, scatter_after]) = (column.before_si, column.after_si);
        [column.name.clone(), mean(before), deviation(scatter_before), mean(after), deviation(scatter_after)]
    };
    rows.columns.iter().map(row).collect()
}

/// What the rows rest on, and what they do not tell; or why there are none.
pub(super) fn length_words(
    specimen: &MotionSpecimen,
    lengths: &SpecimenLengths,
    writer: &NumberWriter<'_>,
) -> Vec<String> {
    let rows = match lengths {
        SpecimenLengths::Refused(refusal) => return vec![format!("no mechanisms that agree: {refusal}")],
        SpecimenLengths::Given(rows) => rows,
    };
    let known = |share: f64| writer.percent(2.0 * (share * (1.0 - share) / rows.effective_rows).sqrt(), Rounding::Up);
    let mut words = vec![
        format!(
            "{} mechanisms were run with values of the unknowns in the consistent set and beside it, and weighed by the likelihood of what was \
             measured: they say as much as {} equally probable ones",
            rows.runs,
            rows.effective.floor()
        ),
        format!(
            "{} rows are drawn of them, which say as much as {} mechanisms: a share of 95 % is known to ± {}, one of a half to ± {} (2 standard deviations)",
            rows.rows_si.len(),
            rows.effective_rows.floor(),
            known(0.95),
            known(0.5)
        ),
    ];
    words.extend(rows.tied.iter().filter_map(|tied| tied_words(specimen, rows, tied, writer)));
    words.extend(rows.tied_together.iter().filter_map(|tied| tied_together_words(specimen, tied, writer)));
    words
}

fn tied_together_words(specimen: &MotionSpecimen, tied: &TiedTogether, writer: &NumberWriter<'_>) -> Option<String> {
    Some(format!(
        "{} goes with all random inputs together (multiple rank correlation {}), though with none of them by itself: the measurement knows one only with \
         the others, and a study draws them apart, so that its band may be too narrow. Measure lengths, or write those that matter under [epistemic]",
        specimen.unknowns.get(tied.unknown)?.name,
        writer.rounded(tied.rank_correlation, &SiUnit::NONE, 2, Rounding::Nearest),
    ))
}

fn tied_words(
    specimen: &MotionSpecimen,
    rows: &MechanismRows,
    tied: &TiedLength,
    writer: &NumberWriter<'_>,
) -> Option<String> {
    let (column, unknown) = (rows.columns.get(tied.column)?, specimen.unknowns.get(tied.unknown)?);
    Some(format!(
        "{} goes with {} (rank correlation {}): the measurement knows one only with the other, and a study draws them apart. Write '{}' under \
         [epistemic] in place of [random]: then its interval is part of the answer",
        column.name,
        unknown.name,
        writer.rounded(tied.rank_correlation, &SiUnit::NONE, 2, Rounding::Nearest),
        column.path
    ))
}
