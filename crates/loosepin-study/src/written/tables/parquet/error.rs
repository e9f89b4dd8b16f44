//! What is wrong with a Parquet file.

/// Why bytes are no file of runs, or runs have no form in a file.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[allow(missing_docs, reason = "the text of an error says what it is, and names its fields")]
pub enum ParquetError {
    #[error("the file does not begin and end with PAR1")]
    NotParquet,
    #[error("{what}: {needed} bytes are needed where {left} are left")]
    CutShort { what: &'static str, needed: u64, left: usize },
    #[error("{what} is missing")]
    Missing { what: &'static str },
    #[error("{what} is {found}; must be {rule}")]
    Wrong { what: &'static str, found: i64, rule: String },
    #[error("{what}: a value of type {code} stands there; must be a list of structs")]
    OtherType { what: &'static str, code: u8 },
    #[error("its name appears twice; names must differ")]
    RepeatedColumn,
    #[error("{what}: the number has more than 64 bits")]
    Overlong { what: &'static str },
    #[error("a text is not in UTF-8")]
    NotUtf8,
    #[error("column '{column}': {source}")]
    InColumn { column: String, source: Box<ParquetError> },
}

impl ParquetError {
    /// `found` breaks `rule`; numbers beyond the range of [`i64`] are given as its end.
    pub fn wrong(what: &'static str, found: impl TryInto<i64>, rule: impl Into<String>) -> Self {
        Self::Wrong { what, found: found.try_into().unwrap_or(i64::MAX), rule: rule.into() }
    }

    /// The same, with the column in which it is.
    pub fn in_column(self, column: &str) -> Self {
        Self::InColumn { column: column.to_owned(), source: Box::new(self) }
    }
}
