//! One run: steps, events, contact states, outputs.

mod engine;
mod failure;
mod gap;
mod motion;
mod observer;
mod settings;

pub use engine::{Counters, EnergyAccount, PlaySummary, RunReport, run};
pub use failure::RunFailure;
pub use observer::{Observer, Onset, Separation, Step};
pub use settings::{STEP_SHARE, Settings, Window};
