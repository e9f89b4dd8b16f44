//! Numbers that differ from run to run, kept apart so that everything else can be compared byte for byte.

use std::path::Path;
use std::time::SystemTime;

use loosepin_files::read_named_text;
use loosepin_text::date::date;
use loosepin_text::units::extended;
use serde::{Deserialize, Serialize};

/// Times, machine and thread counts of one study.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Timing {
    /// When the study began, RFC 3339 in UTC; empty where the clock stands before 1970 or after 9999.
    pub started_utc: String,
    /// From start to end, in wall time; NaN if the clock was set back meanwhile.
    #[serde(with = "extended")]
    pub elapsed_s: f64,
    /// Finished runs per second and thread.
    #[serde(with = "extended")]
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
            started_utc: date(started).unwrap_or_default(),
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
    // Of a machine with a thousand processors.
    const MAX_BYTES: u64 = 16 << 20;
    let text = read_named_text(Path::new("/proc/cpuinfo"), MAX_BYTES).unwrap_or_default();
    let line = text.lines().find(|line| line.starts_with("model name"));
    line.and_then(|line| line.split_once(':')).map(|(_, name)| name.trim().to_owned()).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::Timing;
    use std::time::{Duration, SystemTime, UNIX_EPOCH};

    #[test]
    fn a_clock_outside_of_the_calendar_gives_no_date() {
        let day = Duration::from_secs(86_400);
        assert_eq!(Timing::since(UNIX_EPOCH - day, 3, 2).started_utc, "");
    }

    #[test]
    fn times_read_back_where_the_clock_was_set_back() {
        let timing = Timing::since(SystemTime::now() + Duration::from_secs(3600), 3, 2);
        assert!(timing.elapsed_s.is_nan());
        let text = serde_json::to_string(&timing).unwrap();
        let read: Timing = serde_json::from_str(&text).unwrap();
        assert!(read.elapsed_s.is_nan() && read.started_utc == timing.started_utc, "{text}");
    }
}
