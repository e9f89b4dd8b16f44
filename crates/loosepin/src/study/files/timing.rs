//! What does not repeat from run to run, kept apart so that everything else can be compared byte for byte.

use serde::{Deserialize, Serialize};

/// Times, machine and thread counts of one study.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Timing {
    /// When the study began, RFC 3339 in UTC.
    pub started_utc: String,
    /// From start to end, in wall time.
    pub elapsed_s: f64,
    /// Time in runs, added over threads.
    pub run_time_s: f64,
    /// Finished runs per second and thread.
    pub runs_per_second_and_thread: f64,
    /// Threads used.
    pub threads: usize,
    /// Processor, as the system names it; empty where it does not.
    pub processor: String,
    /// Operating system and architecture.
    pub platform: String,
}
