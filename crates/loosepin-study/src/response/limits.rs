//! Limits of what a study may ask of a run.

/// Turns of a run of a study, at most: the ideal motion is followed through all of them before the first run, and again for each.
pub const MAX_TURNS: f64 = 10_000.0;
/// Recorded ones, at most: each has a table of the ideal motion.
pub const MAX_RECORDED_TURNS: f64 = 1000.0;
/// Numbers of a run that are asked for, at most: each has bounds of its own, with hundreds of numbers in the files and on the page.
pub const MAX_COLUMNS: usize = 20_000;
/// Combinations of contact laws, at most: each is a mechanism of its own.
pub const MAX_LAWS: usize = 64;
