//! How many threads a command runs on.

use loosepin::study::default_threads;

/// The requested number of threads, otherwise one per hardware thread.
pub fn threads(asked: Option<u32>) -> usize {
    asked.map_or_else(default_threads, |threads| threads as usize)
}
