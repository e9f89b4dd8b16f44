//! One run: steps, events, contact states, outputs.

mod column;
mod drawing;
mod engine;
mod failure;
mod gap;
mod history;
mod motion;
mod observer;
pub mod record;
mod reference;
mod search;
mod settings;
mod tables;

pub use column::{Arms, Column, Reading, columns};
pub use drawing::{add_pose, skeleton};
pub use engine::{Counters, EnergyAccount, PlaySummary, RunReport, run};
pub use failure::RunFailure;
pub use history::{BodyStates, Plan, Simulation, simulate, turn_s};
pub use observer::{Observer, Onset, Separation, Step};
pub use reference::IdealReference;
pub use search::{Peak, maximum_within};
pub use settings::{STEP_SHARE, Settings, Window};
pub use tables::{history_csv, impacts_csv};
