//! How many threads a command runs on.

/// As many as asked for, otherwise as many as the machine has.
pub fn threads(asked: Option<u32>) -> usize {
    asked.map_or_else(|| std::thread::available_parallelism().map_or(1, usize::from), |threads| threads as usize)
}
