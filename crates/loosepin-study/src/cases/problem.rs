//! Problems of a reference case.

use loosepin_text::diagnostics::{Code, problems};
use loosepin_text::document::listed;
use loosepin_text::units::counted;

problems! {
    /// Problems of a reference case. `entry` is a path in words.
    #[derive(Debug, Clone, PartialEq, Eq)]
    pub enum CaseProblem {
        /// A folder without cases.
        NoCases { folder: String } => Code::FileNotReadable,
            says("{folder} contains no reference case: no folder with a model.toml and an expected.toml"),
            hint("the cases are in the repository; give their folder with --folder DIR");
        /// A page that cannot be written.
        NotWritten { file: String, reason: String } => Code::FolderNotUsable,
            says("cannot write {file}: {reason}");
        /// A case that is not there.
        UnknownCase { name: String, nearest: Option<String>, known: Vec<String> } => Code::UnknownReference,
            says("there is no reference case '{name}'"),
            hint_of(Some(match nearest {
                Some(nearest) => format!("did you mean '{nearest}'?"),
                None => format!("available: {}", listed(known, "and")),
            }));
        /// A name that the model or a file does not have.
        UnknownName { entry: String, what: &'static str, name: String, known: Vec<String> } => Code::UnknownReference,
            says("{entry}: there is no {what} '{name}'"),
            hint_of(Some(match known.is_empty() {
                true => format!("there is no {what}"),
                false => format!("available: {}", listed(known, "and")),
            }));
        /// A key that the quantity does not use.
        KeyWithoutEffect { entry: String, quantity: &'static str } => Code::ConflictingKeys,
            says("{entry} has no effect on the quantity \"{quantity}\"");
        /// A list of another length than that of the values.
        ListLength { entry: String, found: usize, due: usize } => Code::WrongType,
            says("{entry} has {found} entries; expected one for each of the {due} values");
        /// No expected numbers.
        NothingExpected { entry: String } => Code::AskNotPossible,
            says("{entry} expects nothing; a case needs at least one number");
        /// An angle at which the quasi-static answer is not computed.
        NoPosition { angle_deg: String } => Code::AskNotPossible,
            says("the quasi-static result has no position at {angle_deg} deg; it has one for each whole degree of \
                  a turn");
        /// A cell of a reference file that is no number.
        BadCell { cell: String } => Code::WrongType,
            says("the cell '{cell}' is not a number");
        /// A row of a reference file with too few or too many cells.
        BadRow { found: usize, due: usize } => Code::WrongType,
            says("the row has {}; the header has {due}", counted(*found, "cell"));
        /// A reference file that no run can be compared with.
        BadTimes { file: String, rows: usize, end_s: String } => Code::WrongType,
            says("{file}: {rows} rows that end at {end_s} s; expected at least two, at equal times from zero");
    }
}
