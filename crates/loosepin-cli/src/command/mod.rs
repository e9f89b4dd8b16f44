//! One module for each command.

pub mod check;
pub mod explain;
mod inputs;
pub mod motion;
pub mod new;
pub mod report;
pub mod schema;
pub mod simulate;
mod stored;
pub mod study;
