//! Lengths of a specimen, given its measurement.

use crate::numbers::number::{NumberWriter, Rounding};
use crate::words::wording::remark;
use loosepin_result::motion_identification::{
    LengthColumn, MechanismRows, MotionSpecimen, SpecimenLengths, TiedLength, TiedToLengths,
};
use loosepin_text::article::{Column, Content, Medium, Section, Table};
use loosepin_text::units::SiUnit;

/// Digits of a mean, and of a standard deviation.
const DIGITS: usize = 6;
const DEVIATION_DIGITS: usize = 3;

/// Appends the lengths of a specimen, or why they are not known; appends nothing if they were not asked for.
pub(super) fn push_lengths(section: &mut Section, specimen: &MotionSpecimen, writer: &NumberWriter<'_>) {
    let Some(lengths) = &specimen.lengths else { return };
    section.push_on(Medium::Terminal, Content::Heading("Lengths of this specimen".into()));
    if let SpecimenLengths::Given(rows) = lengths {
        section.push(Content::Table(lengths_table(rows, writer)));
    }
    section.push(Content::points(length_words(specimen, lengths, writer).into_iter().map(remark)));
}

/// A row for each random input.
fn lengths_table(rows: &MechanismRows, writer: &NumberWriter<'_>) -> Table {
    let columns = vec![
        Column::words("random input"),
        Column::numbers_on_terminal("series: mean"),
        Column::numbers_on_terminal("standard deviation"),
        Column::numbers_on_terminal("specimen: mean"),
        Column::numbers_on_terminal("standard deviation"),
    ];
    let row = |column: &LengthColumn| {
        let mean = |value_si: f64| writer.rounded(value_si, &column.unit, DIGITS, Rounding::Nearest);
        let deviation = |value_si: f64| writer.rounded(value_si, &column.unit, DEVIATION_DIGITS, Rounding::Nearest);
        let ([before, scatter_before], [after, scatter_after]) = (column.before_si, column.after_si);
        vec![column.name.clone(), mean(before), deviation(scatter_before), mean(after), deviation(scatter_after)]
    };
    Table::new(columns, rows.columns.iter().map(row))
}

/// Assumptions and limits of the rows; or why there are none.
fn length_words(specimen: &MotionSpecimen, lengths: &SpecimenLengths, writer: &NumberWriter<'_>) -> Vec<String> {
    let rows = match lengths {
        SpecimenLengths::Refused(refusal) => return vec![format!("no agreeing mechanisms: {refusal}")],
        SpecimenLengths::Given(rows) => rows,
    };
    let known = |share: f64| writer.percent(2.0 * (share * (1.0 - share) / rows.effective_rows).sqrt(), Rounding::Up);
    let mut words = vec![
        format!(
            "{} mechanisms were run with values of the unknowns in or next to the consistent set, and weighted with the likelihood of the measurement: their information is that of {} equally probable mechanisms",
            rows.runs,
            rows.effective.floor()
        ),
        format!(
            "{} rows are drawn from them, with the information of {} mechanisms: a share of 95 % is known within ± {}, a share of 50 % within ± {} (2 standard deviations)",
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

fn tied_together_words(specimen: &MotionSpecimen, tied: &TiedToLengths, writer: &NumberWriter<'_>) -> Option<String> {
    Some(format!(
        "{} is correlated with all random inputs together (multiple rank correlation {}), but with none of them alone: the measurement determines them only together. A study samples them independently, so its band may be too narrow. Measure lengths, or write the important ones under [epistemic]",
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
        "{} is correlated with {} (rank correlation {}): the measurement determines them only together, but a study samples them independently. Write '{}' under [epistemic] instead of [random]: then its interval is part of the result",
        column.name,
        unknown.name,
        writer.rounded(tied.rank_correlation, &SiUnit::NONE, 2, Rounding::Nearest),
        column.path
    ))
}
