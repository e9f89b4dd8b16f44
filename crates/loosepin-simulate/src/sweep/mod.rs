//! One run for each of many values of a quantity: where the motion repeats itself, how often it strikes, where it does not
//! settle (a bifurcation diagram).
//!
//! The motion is looked at once a turn, when the drive is back where it started (Poincaré section). A motion that repeats itself
//! after p turns shows p points, one that never does a cloud.

mod plan;
pub use loosepin_result::sweep as record;
mod request;
mod tables;
mod turns;

pub use plan::{SWEEP_POINTS, SWEEP_TRANSIENT_TURNS, SWEEP_TURNS, SweepError, SweepPlan, sweep};
pub use request::{SweepRequest, SweptValues};
pub use tables::{SECTIONS_FILE, SWEEP_FILE, sections_csv, sweep_csv};
