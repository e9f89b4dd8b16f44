//! Text with units to SI numbers and back.

pub mod display;

pub use display::{DisplayUnit, DisplayUnits, SiUnit};
