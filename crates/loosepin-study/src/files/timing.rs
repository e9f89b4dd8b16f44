//! What does not repeat from run to run, kept apart so that everything else can be compared byte for byte.

use std::time::SystemTime;

use serde::{Deserialize, Serialize};

/// Times, machine and thread counts of one study.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Timing {
    /// When the study began, RFC 3339 in UTC.
    pub started_utc: String,
    /// From start to end, in wall time.
    pub elapsed_s: f64,
    /// Finished runs per second and thread.
    pub runs_per_second_and_thread: f64,
    /// Threads used.
    pub threads: usize,
    /// Processor, as the system names it; empty where it does not.
    pub processor: String,
    /// Operating system and architecture.
    pub platform: String,
}

impl Timing {
    /// The times of a study that began at `started`, ends now, and made `runs` runs on `threads` threads.
    pub fn since(started: SystemTime, runs: usize, threads: usize) -> Timing {
        // A clock that was set back meanwhile gives no time rather than a wrong one.
        let elapsed_s = started.elapsed().map_or(f64::NAN, |elapsed| elapsed.as_secs_f64());
        Timing {
            started_utc: humantime::format_rfc3339_seconds(started).to_string(),
            elapsed_s,
            runs_per_second_and_thread: runs as f64 / (elapsed_s * threads as f64),
            threads,
            processor: processor(),
            platform: format!("{} {}", std::env::consts::OS, std::env::consts::ARCH),
        }
    }
}

/// What Linux calls the processor; empty elsewhere.
fn processor() -> String {
    let text = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let line = text.lines().find(|line| line.starts_with("model name"));
    line.and_then(|line| line.split_once(':')).map(|(_, name)| name.trim().to_owned()).unwrap_or_default()
}
