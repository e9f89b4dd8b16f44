//! Finished runs on disk: what a study of hours has computed is never lost.
//!
//! One SQLite file a study, with a row for each finished run. Rows are known by their list (0 for the runs of the study itself, one
//! more for each direct study of the inverse question) and their place in it, which the plan fixes: whoever asks again for the run
//! at a place with the same inputs is given its row back.
//!
//! # What survives
//!
//! * Runs are collected and committed together at least every [`LONGEST_UNSAVED`]: what is older is on disk.
//! * A commit is an append to the write-ahead log `runs.sqlite-wal`, followed by a flush to the device (`synchronous = FULL`); only
//!   when the log is copied into the file, which is flushed first, is the log begun anew. Whatever moment the process or the
//!   machine stops at, the log is read again when the store is opened, up to its last whole commit: SQLite keeps a checksum of
//!   every frame.
//! * Each row carries a checksum (BLAKE3, 128 bits) of its list, place, inputs and numbers, and the structure of the file is checked
//!   when it is opened. A row that was damaged is never used: the store is refused. A row that is missing is run again and has the
//!   same bits.
//! * While a store is open the file is locked: a second process is refused.
//!
//! It knows nothing of mechanisms or of statistics: numbers in, the same numbers out.

#![cfg_attr(test, allow(clippy::disallowed_methods, reason = "tests make files of their own"))]

pub mod results;

mod error;
mod file;
mod files;
mod identity;
mod join;
mod row;
mod run_store;
mod shard;
#[cfg(test)]
mod tests;
mod writer;

pub use error::StoreError;
pub use files::{PUBLISHED_FILE, STORE_COMPANIONS, STORE_FILE, remove_store};
pub use identity::StoreIdentity;
pub use row::{InputsKey, StoredRun};
pub use run_store::{ExistingRuns, RunStore};
pub use shard::{Shard, ShardError};
pub use writer::LONGEST_UNSAVED;
