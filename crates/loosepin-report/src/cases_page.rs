//! Reference cases compared: as text for a terminal, and as a page of the documentation.
//!
//! Numbers are rounded to what their tolerance can tell, and the largest of many differences to the power of ten above it: the
//! text is then the same on every machine.

use comfy_table::ColumnConstraint;

use crate::medium::terminal_table::{push_table, table};
use loosepin_result::cases::{CaseRecord, Comparison, NumberRecord};
use loosepin_text::units::{decimal_exponent, distinct, format_number, power_of_ten};

/// Heads of the columns.
const HEAD: [&str; 7] = ["number", "expected", "obtained", "difference", "tolerance", "verdict", "source"];
/// Columns with numbers.
const NUMBERS: [usize; 4] = [1, 2, 3, 4];

/// The cases as text for a terminal.
pub fn cases_text(records: &[CaseRecord]) -> String {
    let mut text = String::new();
    for record in records {
        text.push_str(&format!("{}: {}\n", record.name, record.title));
        let sources = sources(record);
        let mut rows = table(&HEAD, &NUMBERS);
        for (index, column) in rows.column_iter_mut().enumerate() {
            if index > 0 {
                // A number on two lines is two numbers; names give way.
                column.set_constraint(ColumnConstraint::ContentWidth);
            }
        }
        for number in &record.numbers {
            rows.add_row(cells(number, &sources));
        }
        push_table(&mut text, &rows);
        text.push('\n');
        for (index, source) in sources.iter().enumerate() {
            let line = format!("{}: {source}", index + 1);
            text.push_str(&textwrap::fill(&line, usize::from(crate::medium::terminal_table::TERMINAL_COLUMNS)));
            text.push('\n');
        }
        text.push('\n');
    }
    text.push_str(&verdict(records));
    text
}

/// The cases as `measured/validation.md`.
pub fn cases_page(records: &[CaseRecord]) -> String {
    let mut text = String::from(
        "# Validation\n\n\
         Written by `loosepin cases run --write measured/validation.md`; a test fails if this page is out of date or a number is outside\nits tolerance. `cases/NAME/expected.toml` has the numbers, their sources and the reasons for their tolerances\n([its keys](../cases/README.md)). Obtained numbers and differences are rounded to the digits that the tolerance justifies; the\nlargest of many differences is rounded up to a power of ten.\n\n",
    );
    text.push_str(&verdict(records));
    for record in records {
        text.push_str(&format!("\n## {}\n\n{}\n\n", record.name, sentence(&record.title)));
        text.push_str(&format!("| {} |\n|---|--:|--:|--:|--:|---|---|\n", HEAD.join(" | ")));
        let sources = sources(record);
        for number in &record.numbers {
            text.push_str(&format!("| {} |\n", cells(number, &sources).join(" | ")));
        }
        text.push('\n');
        for (index, source) in sources.iter().enumerate() {
            text.push_str(&format!("{}. {source}\n", index + 1));
        }
    }
    text
}

/// With a capital and a full stop.
fn sentence(title: &str) -> String {
    let mut letters = title.chars();
    letters.next().map_or(String::new(), |first| format!("{}{}.", first.to_uppercase(), letters.as_str()))
}

/// How many numbers there are, and which are outside.
fn verdict(records: &[CaseRecord]) -> String {
    let numbers: usize = records.iter().map(|record| record.numbers.len()).sum();
    let outside: Vec<String> = records
        .iter()
        .flat_map(|record| record.numbers.iter().map(move |number| (record, number)))
        .filter(|(_, number)| !number.is_within())
        .map(|(record, number)| format!("- {}: {}\n", record.name, number.name))
        .collect();
    let counted = |count: usize, what: &str| format!("{count} {what}{}", if count == 1 { "" } else { "s" });
    let [cases, numbers] = [counted(records.len(), "case"), counted(numbers, "number")];
    if outside.is_empty() {
        format!("{cases}, {numbers}: all within their tolerances.\n")
    } else {
        format!("{cases}, {numbers}: {} outside of their tolerances.\n{}", outside.len(), outside.concat())
    }
}

/// Different sources of a case, in the order of their first number.
fn sources(record: &CaseRecord) -> Vec<&str> {
    distinct(record.numbers.iter().map(|number| number.source.as_str()))
}

fn cells(number: &NumberRecord, sources: &[&str]) -> Vec<String> {
    let unit = if number.unit.is_empty() { String::new() } else { format!(" {}", number.unit) };
    let shown = |value_si: f64| value_si / number.si_per_unit;
    let tolerance = shown(number.tolerance_si);
    let step = step_exponent(tolerance);
    let [expected, obtained, difference] = match &number.comparison {
        // What should be nothing is a residual, of which the size alone matters.
        Comparison::Number { expected_si: 0.0, obtained_si } => {
            ["0".to_owned(), below(shown(obtained_si.abs())), below(shown(obtained_si.abs()))]
        }
        Comparison::Number { expected_si, obtained_si } => {
            [shown(*expected_si), shown(*obtained_si), shown(*obtained_si) - shown(*expected_si)]
                .map(|value| rounded(value, step))
        }
        Comparison::Largest { of, difference_si } => [of.clone(), String::new(), below(shown(*difference_si))],
    };
    let source = sources.iter().position(|source| *source == number.source).unwrap_or(0) + 1;
    vec![
        number.name.clone(),
        expected,
        obtained,
        difference,
        format!("{}{unit}", format_number(tolerance)),
        if number.is_within() { "within" } else { "OUTSIDE" }.to_owned(),
        format!("{} {source}", number.origin),
    ]
}

/// The exponent of the largest power of ten that is at most half the tolerance; `None` for a tolerance of zero.
fn step_exponent(tolerance: f64) -> Option<i32> {
    // Half of what was written as 2e-6 must not fall below 1e-6 by round-off.
    const ABOVE_ROUND_OFF: f64 = 1.0 + 1e-9;
    decimal_exponent(0.5 * tolerance * ABOVE_ROUND_OFF)
}

/// A value to a multiple of a power of ten.
fn rounded(value: f64, step: Option<i32>) -> String {
    /// Exponents of the leading digit outside of which a number is written with one.
    const PLAIN: std::ops::RangeInclusive<i32> = -3..=6;
    if value.is_nan() {
        return "none".to_owned();
    }
    let Some(step) = step else { return format_number(value) };
    let unit = power_of_ten(step);
    let rounded = (value / unit).round() * unit;
    let Some(leading) = decimal_exponent(rounded) else { return "0".to_owned() };
    if PLAIN.contains(&leading) {
        format!("{rounded:.*}", usize::try_from(-step).unwrap_or(0))
    } else {
        format!("{rounded:.*e}", usize::try_from(leading - step).unwrap_or(0))
    }
}

/// The power of ten above a difference.
fn below(difference: f64) -> String {
    if difference.is_nan() {
        return "none".to_owned();
    }
    decimal_exponent(difference).map_or("0".to_owned(), |exponent| format!("< 1e{}", exponent + 1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_the_digits_that_their_tolerance_can_tell() {
        for (value, tolerance, text) in [
            (4.385_826_71, 2e-6, "4.385827"),
            (2.272_849_1e-4, 5e-10, "2.272849e-4"),
            (45_871.3, 5.0, "45871"),
            (-327_341.0, 35.0, "-327340"),
            (6.610_198_02e10, 5e3, "6.6101980e10"),
            (3e-7, 2e-6, "0"),
            (6e-7, 2e-6, "1e-6"),
            (-4e-3, 5e-4, "-0.0040"),
            (26.0, 0.0, "26"),
            (f64::NAN, 1.0, "none"),
        ] {
            assert_eq!(rounded(value, step_exponent(tolerance)), text, "{value:e} within {tolerance:e}");
        }
    }

    #[test]
    fn a_largest_difference_is_told_by_the_power_of_ten_above_it() {
        assert_eq!([3.1e-10, 0.0, f64::NAN, 4.0].map(below), ["< 1e-9", "0", "none", "< 1e1"]);
    }
}
