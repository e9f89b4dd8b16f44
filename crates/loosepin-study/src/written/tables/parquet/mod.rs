//! What runs need of the Parquet format (<https://github.com/apache/parquet-format>), written and read.
//!
//! | File | Part of the specification |
//! |---|---|
//! | `metadata.rs`, `statistics.rs` | footer: `FileMetaData` of parquet.thrift |
//! | `page.rs` | `PageHeader` of parquet.thrift |
//! | `thrift.rs`, `cursor.rs` | compact protocol of Apache Thrift, in which both stand |
//! | `plain.rs`, `dictionary.rs`, `hybrid.rs`, `delta.rs`, `bits.rs` | Encodings.md |
//!
//! Written are flat columns of doubles, which may be missing, of counts and of texts, without compression: pages of the first version,
//! one for each column of a row group. Read is that, and what earlier versions of the program wrote through the crate `parquet`: several
//! pages, the first of them by a dictionary. All else is refused. Memory is asked for by what is there: lengths are compared with
//! the bytes of the file, metadata have a maximum number of values, rows one of bytes.

mod bits;
mod cursor;
mod delta;
mod dictionary;
mod error;
mod hybrid;
mod metadata;
mod page;
mod plain;
mod reader;
mod statistics;
mod thrift;
mod writer;

pub use error::ParquetError;
pub use metadata::Kind;
pub use reader::ParquetFile;
pub use writer::write;

/// Rows of a row group: fixed, because it shapes the bytes.
const ROWS_PER_GROUP: usize = 1 << 16;
