//! One module for each command.
//! Each parses its arguments, calls the library and prints. Computations and texts are in the library.

pub mod cases;
pub mod check;
pub mod completions;
pub mod explain;
pub mod export;
pub mod identify;
pub mod import;
mod inputs;
pub mod manual;
pub mod merge;
pub mod motion;
pub mod new;
pub mod report;
pub mod schema;
#[cfg(feature = "studio")]
pub mod serve;
mod shard;
mod signals;
pub mod simulate;
mod stored;
pub mod study;
pub mod sweep;
mod threads;
pub mod wear;
