//! One run: steps, events, contact states, outputs.

mod batch;
mod column;
mod core;
mod drawing;
mod engine;
mod equations;
mod failure;
mod free_motion;
mod gap;
mod history;
mod lane;
mod machine;
mod motion;
mod observer;
mod pace;
mod projection;
mod reads;
pub mod record;
mod reference;
mod report;
mod search;
mod settings;
mod tables;
mod work;

pub use batch::{Queue, Run};
pub use column::{Arms, Column, Reading, columns};
pub use drawing::{add_pose, skeleton};
pub use engine::{conduct, run};
pub use failure::RunFailure;
pub use history::{BodyStates, Plan, Simulation, input, simulate};
pub use observer::{Observer, Onset, Separation, Step};
pub use reference::IdealReference;
pub use report::{Counters, EnergyAccount, PlaySummary, RunReport};
pub use search::{Peak, maximum_within};
pub use settings::{STEP_SHARE, Settings, Window};
pub use tables::{history_csv, impacts_csv};
