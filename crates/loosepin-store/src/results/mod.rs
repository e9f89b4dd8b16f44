//! Folders of results: where they are, whose they are, and what must not be overwritten.
//!
//! A folder of results has a small file [`MARKER_FILE`] that says what it holds and from which inputs. `docs/files/results.md`
//! describes the files beside it.

mod claim;
mod error;
mod folder;
mod inputs;
mod kind;
mod marker;
mod shards;

use loosepin_files::LockKind;

pub use claim::{Claim, Destination, LockedFolder};
pub use error::ResultsError;
pub use folder::{FinishedResult, ResultsFolder};
pub use inputs::{InputsHash, InputsHasher};
pub use kind::{MARKER_FILE, ResultKind};
pub use marker::{MAX_MARKER_BYTES, Marker, write_whole};
pub use shards::{SHARD_FILE, ShardFolders, ShardRecord, ShardsError};

/// Name of the file that is locked while somebody writes into a folder of results. It says who that is.
pub const LOCK_FILE: &str = LockKind::Result.file_name();
/// Name of the page that people read.
pub const REPORT_FILE: &str = "report.html";
/// Name of the file with the whole result, SI.
pub const SUMMARY_FILE: &str = "summary.json";
/// Name of the file with one row a sample of a run.
pub const HISTORY_FILE: &str = "history.csv";
/// Name of the file with one impact a row.
pub const IMPACTS_FILE: &str = "impacts.csv";
/// The curves of an ideal motion over the angle of the drive.
pub const MOTION_FILE: &str = "motion.csv";
/// Name of the file with one order of the drive a row.
pub const SPECTRUM_FILE: &str = "spectrum.csv";
/// Name of the file with one sector of a worn surface a row.
pub const WEAR_FILE: &str = "wear.csv";
/// Wear over the cycles, and deviations of the outputs.
pub const WEAR_LIFE_FILE: &str = "wear_life.csv";
/// Depths of all sectors over the cycles.
pub const WEAR_PROFILES_FILE: &str = "wear_profiles.csv";
