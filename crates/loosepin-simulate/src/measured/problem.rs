//! Errors of a table of measured values.

use loosepin_text::diagnostics::{Code, problems};
use loosepin_text::units::{Dimension, ExpressionProblem, counted};

problems! {
    /// An error in a table of measured values.
    #[derive(Debug, Clone, PartialEq)]
    pub enum MeasuredProblem | Unit(ExpressionProblem) {
        /// No header, or no row below it.
        Empty { what: &'static str } => Code::MeasuredTable,
            says("the table has no {what}"),
            hint("for example a first line: angle [deg], slider [mm]");
        /// A table as spreadsheets write it where numbers have a decimal comma.
        Semicolons { line: String, meant: String } => Code::MeasuredTable,
            says("the columns are separated by semicolons; must be commas, with a decimal point in numbers"),
            hint("write '{line}' as '{meant}'; spreadsheets do this with the region English (United States)");
        /// A cell of the header without a unit.
        NoUnit { text: String } => Code::MeasuredTable,
            says("the header '{text}' is not written name [unit]"),
            hint("{}", match text {
                text if text.starts_with('#') => TAKE_COMMENT_AWAY,
                text if text.contains(';') => "columns are separated by commas",
                _ => "for example: angle [deg], slider [mm]; a pure number has [1]",
            });
        /// A first column that is no time and no angle.
        FirstColumn { name: String, found: Dimension } => Code::MeasuredTable,
            says("the first column '{name}' is {found}; it must be a time or an angle of the drive");
        /// No column besides the first.
        NothingMeasured {
            /// Name of the first column.
            name: String,
        } => Code::MeasuredTable,
            says("the table has no column except '{name}'"),
            hint("for example a first line: angle [deg], slider [mm]");
        /// Two columns of the same name.
        ColumnTwice { name: String } => Code::MeasuredTable,
            says("the column '{name}' appears twice");
        /// A column without values.
        NoValue { name: String } => Code::MeasuredTable,
            says("the column '{name}' has no value");
        /// Several columns, and none of them named.
        WhichColumn { known: Vec<String> } => Code::MeasuredTable,
            says("the table has {} columns, but the study does not choose one of them", known.len()),
            hint(
                "choose one, for example column = \"{}\"; available: {}",
                known.first().map_or("name", String::as_str),
                known.join(", ")
            );
        /// A column that is not there.
        NoColumn { name: String, nearest: Option<String>, known: Vec<String> } => Code::MeasuredTable,
            says("the table has no column '{name}'"),
            hint_of(Some(nearest_or_all(nearest.as_ref(), known)));
        /// An empty cell where every one must be filled.
        EmptyCell { name: String } => Code::MeasuredTable,
            says("a cell of the column '{name}' is empty; each row must have all values"),
            hint("fill the cell, or remove the whole row");
        /// A row of another length.
        RowLength {
            found: usize,
            /// Cells of the header.
            due: usize,
        } => Code::MeasuredTable,
            says("the row has {}; the header has {due}", counted(*found, "cell")),
            hint_of((found > due).then(|| "a comma separates columns; decimal numbers have a point".to_owned()));
        /// A line of comment.
        Comment => Code::MeasuredTable,
            says("a table must not have comment lines"),
            hint("remove the line");
        /// A cell that is no finite number.
        NotANumber { text: String } => Code::MeasuredTable,
            says("'{text}' is not a finite number"),
            hint("{}", match text {
                text if text.starts_with('#') => TAKE_COMMENT_AWAY,
                text if text.contains('\u{2212}') => "use the hyphen of the keyboard as the minus sign",
                text if text.contains(',') => "decimal numbers have a point",
                _ => "write a number; a cell of a measured curve may be empty if nothing was measured",
            });
        /// A row that does not lie behind the one before.
        NotIncreasing {
            /// Name of the first column.
            name: String,
            /// Its value, as written.
            found: String,
            /// The value before, as written.
            before: String,
        } => Code::MeasuredTable,
            says("{name} {found} follows {before}; the first column must increase from row to row");
        /// A column that is no output of the model.
        UnknownOutput { name: String, nearest: Option<String>, known: Vec<String> } => Code::MeasuredTable,
            says("the model has no output '{name}'"),
            hint_of(Some(nearest_or_all(nearest.as_ref(), known)));
        /// A column of another dimension than its output.
        OtherDimension { name: String, found: Dimension, due: String } => Code::MeasuredTable,
            says("the column '{name}' is {found}; the output is {due}");
        /// A row outside of the record.
        OutsideRecord {
            /// Name of the first column.
            name: String,
            /// The value with its unit.
            found: String,
            /// Start of the record.
            from: String,
            /// End of the record.
            to: String,
            /// Whether it is a time before the record, which begins after the turns of start-up.
            is_early_time: bool,
        } => Code::MeasuredOutside,
            says("{name} {found} is outside the recorded range, {from} to {to}"),
            hint("{}", if *is_early_time {
                format!(
                    "times count from the start of the run, and turns of start-up are not recorded: run without them (--transient 0), or \
                     add {from} to the times of the table"
                )
            } else {
                "record more turns with --turns, or shorten the table".to_owned()
            });
        /// A file that is no table.
        NoTable { reason: String } => Code::MeasuredTable,
            says("the file cannot be read as a table: {reason}");
    }
}

const TAKE_COMMENT_AWAY: &str = "a table must not have comment lines: delete the #, or remove the line";

fn nearest_or_all(nearest: Option<&String>, known: &[String]) -> String {
    match nearest {
        Some(nearest) => format!("did you mean '{nearest}'?"),
        None => format!("available: {}", known.join(", ")),
    }
}
