//! Text with units to SI numbers and back.

pub mod display;
pub mod extended;

pub use display::{DisplayUnit, DisplayUnits, SiUnit};
