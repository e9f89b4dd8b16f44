//! Tables and paragraphs of a terminal: plain text, aligned, at most 100 columns.

use comfy_table::{CellAlignment, ColumnConstraint, ContentArrangement, LineStyle, Table, TableStyle, Width};

/// Columns that a terminal is taken to have.
pub const TERMINAL_COLUMNS: u16 = 100;

/// A table with a rule under its head, numbers to the right, wrapped to the width of the terminal.
pub(crate) fn table(head: &[&str], numbers: &[usize]) -> Table {
    let mut table = Table::new();
    // Only the rule under the head and the gap between columns.
    table
        .load_style(TableStyle::new().header_separator(LineStyle::none().fill('-').junction('-')))
        .set_content_arrangement(ContentArrangement::Dynamic)
        .set_width(TERMINAL_COLUMNS)
        .set_header(head.iter().copied());
    for (index, column) in table.column_iter_mut().enumerate() {
        column.set_padding((0, 1));
        if numbers.contains(&index) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    table
}

/// Lets no word of a column be cut: the other columns wrap instead.
pub(crate) fn keep_words(table: &mut Table, column: usize) {
    let cells = table.row_iter().filter_map(|row| row.cell_iter().nth(column)).map(|cell| cell.content());
    let longest = cells.flat_map(|text| text.split_whitespace().map(|word| word.chars().count()).max()).max();
    if let (Some(longest), Some(column)) = (longest, table.column_mut(column)) {
        // One column of padding.
        let width = u16::try_from(longest + 1).unwrap_or(TERMINAL_COLUMNS).min(TERMINAL_COLUMNS / 2);
        column.set_constraint(ColumnConstraint::LowerBoundary(Width::Fixed(width)));
    }
}

/// Adds a table that has rows.
pub(crate) fn push_table(text: &mut String, table: &Table) {
    if table.row_count() > 0 {
        text.push_str(&format!("\n{}\n", trimmed(table)));
    }
}

/// The lines of a table without blanks at their ends.
pub(crate) fn trimmed(table: &Table) -> String {
    let lines: Vec<String> = table.lines().map(|line| line.trim_end().to_owned()).collect();
    lines.join("\n")
}

/// A sentence on lines of `columns`, or on one line where there are none; further lines stand below the text of a bullet. No word is cut at
/// a hyphen: `1.6e-6` is a number.
pub(crate) fn wrapped(sentence: &str, bullet: &str, columns: Option<u16>) -> String {
    let Some(columns) = columns else { return format!("{bullet}{sentence}") };
    let indent = " ".repeat(bullet.len());
    let options = textwrap::Options::new(usize::from(columns))
        .initial_indent(bullet)
        .subsequent_indent(&indent)
        .word_splitter(textwrap::WordSplitter::NoHyphenation);
    textwrap::fill(sentence, options)
}

#[cfg(test)]
mod tests {
    use super::wrapped;

    #[test]
    fn numbers_with_exponents_and_their_units_stay_together() {
        let sentence = "exceeded by 1.6e-6\u{a0}mm at most, 2e-12\u{a0}m/s^2 and -3.5e-10\u{a0}N";
        let numbers = ["1.6e-6\u{a0}mm", "2e-12\u{a0}m/s^2", "-3.5e-10\u{a0}N"];
        for columns in 14..60 {
            let lines = wrapped(sentence, "- ", Some(columns));
            let is_whole = |number: &&str| lines.lines().any(|line| line.contains(*number));
            assert!(numbers.iter().all(is_whole), "{columns} columns:\n{lines}");
        }
    }
}
