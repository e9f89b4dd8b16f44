//! Changes of a text that is TOML: what people wrote beside them keeps its bytes.
//!
//! | What | File |
//! |---|---|
//! | where everything stands in a text | `scan.rs` |
//! | pieces that are put in place of others; changes as the page counts them | `pieces.rs` |
//! | lines and entries that come in | `lines.rs` |
//! | lines and entries that go out | `cut.rs` |
//! | the change from one text to another, line by line | `change.rs` |
//!
//! `toml_edit` reads with the same parser, and writes what it has read: without the carriage returns, the mark of the byte order and the
//! missing end of the last line, with dotted keys of one table together, and with all headers of a table as its first one is written.

pub(crate) mod change;
mod cut;
pub(crate) mod lines;
pub(crate) mod pieces;
pub(crate) mod scan;

pub(crate) use cut::PathPrefixes;
