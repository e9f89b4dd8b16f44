//! How many threads a command runs on.

use loosepin::study::default_threads;

/// As many as asked for, otherwise as many as the machine has.
pub fn threads(asked: Option<u32>) -> usize {
    asked.map_or_else(default_threads, |threads| threads as usize)
}
