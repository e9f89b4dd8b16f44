//! TOML files walked by hand: what keys a table has, what is wrong with an entry, and where.
//!
//! A file is described once, as tables of [`Key`]s. The reader refuses what is not in them, names what is missing, and
//! the JSON Schema for editors is made from them.

mod differences;
mod entry;
mod keys;
mod path;
mod problem;
mod reader;
mod record;
mod schema;
mod suggested_file;
mod synonyms;

pub use crate::units::listed;
pub use differences::{Difference, differences};
pub use entry::{Entry, Table, Written};
pub use keys::{Key, Keys, Kind};
pub use keys::{count_of, joined, optional, quantity, required};
pub use path::EntryPath;
pub use path::describe_path;
pub use problem::DocumentProblem;
pub use reader::{Reader, not_readable, parse_toml, read_beside, read_source, source_from_bytes};
pub use record::{Choice, DefaultValue, Reads, Value, choice, count, words_of};
pub use schema::json_schema;
