//! What is fuzzed: each reader takes the bytes of a file, and neither panics nor takes long, whatever they are.

pub mod files;
mod log;
pub mod model;
pub mod plan;
mod rows;
pub mod runs;
pub mod store;
pub mod study;
