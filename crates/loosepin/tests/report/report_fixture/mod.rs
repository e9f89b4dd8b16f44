//! Synthetic but realistic results of the slider-crank with a worn gudgeon pin, for pages, tables and files.
//!
//! The kinematics are exact (crank 50 mm, rod 120 mm); the journal's path in its bearing is invented, so these numbers
//! illustrate and prove nothing about the mechanism.

#![allow(dead_code, reason = "each test and example uses a part of it")]

mod kinematics;
pub mod motion;
pub mod simulation;
pub mod study;
pub mod sweep;
