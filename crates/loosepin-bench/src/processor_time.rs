//! Processor time of this process as reported by Linux; 0 on other systems.

use std::fs::{DirEntry, read_dir, read_to_string};

/// Linux counts the time of a whole process in these.
const TICK_NS: u64 = 10_000_000;
/// Place of the ticks for the program among what follows its name in `stat`; those for the system stand behind it.
const USER_TICKS: usize = 11;

/// Processor time of the threads that are there now, ns.
pub fn of_threads_ns() -> u64 {
    let of_thread = |thread: DirEntry| {
        let text = read_to_string(thread.path().join("schedstat")).ok()?;
        text.split_whitespace().next()?.parse::<u64>().ok()
    };
    read_dir("/proc/self/task").into_iter().flatten().flatten().filter_map(of_thread).sum()
}

/// Processor time of all threads of this process, ns, to a hundredth of a second: those that have ended as well.
pub fn of_process_ns() -> u64 {
    let text = read_to_string("/proc/self/stat").unwrap_or_default();
    let behind_name = text.rsplit_once(')').map_or("", |(_, rest)| rest);
    let ticks = behind_name.split_whitespace().skip(USER_TICKS).take(2).filter_map(|ticks| ticks.parse::<u64>().ok());
    TICK_NS * ticks.sum::<u64>()
}
