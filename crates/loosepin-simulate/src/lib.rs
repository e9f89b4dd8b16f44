#![cfg_attr(test, allow(clippy::disallowed_methods, reason = "tests make files of their own"))]
#![doc = include_str!("../README.md")]

pub mod accuracy;
pub mod measured;
pub mod sweep;

mod balance;
mod batch;
mod bending;
mod bending_estimate;
mod column;
mod contact_basis;
mod control_history;
mod controlled_drawing;
mod core;
mod depth_limit;
mod drawing;
mod engine;
mod execution;
mod failure;
mod flight;
mod follow;
mod free_motion;
mod gap;
mod history;
mod ideal_curve;
mod implicit;
mod input_files;
mod lane;
mod lane_step;
mod lyapunov;
mod memory;
mod motion;
mod observer;
mod pace;
mod pass;
mod path_error;
mod period;
mod plain;
mod programs;
mod projection;
mod reads;
mod recorded;
pub use loosepin_result::simulation as record;
mod reference;
mod report;
mod resolution;
mod resting;
mod resume;
mod search;
mod sections;
mod settings;
mod settle;
mod slot_end;
mod supports;
mod swing;
mod tables;
mod trust;
mod turns;
mod watched;
mod wear;
mod work;

pub use batch::{Queue, Run};
pub use bending::other_formulation;
pub use bending_estimate::{BendingEstimate, estimate_bending};
pub use column::{Column, columns};
pub use contact_basis::{contact_basis, long_pin_force};
pub use controlled_drawing::controlled_drawing;
pub use drawing::{add_pose, parts, skeleton};
pub use engine::{conduct, demand_dynamics, run};
pub use execution::Execution;
pub use failure::RunFailure;
pub use flight::FlightClock;
pub use follow::{
    DeviationRange, Findings, Follow, FollowedDeviation, FollowedPath, FollowedRun, GAUSS, extremes_within,
    points_within,
};
pub use free_motion::FreeMotion;
pub use history::{
    BodyStates, MOST_NUMBERS, MOST_ROWS, Plan, Simulation, input, simulate, simulate_poses, simulate_until,
};
pub use ideal_curve::{IdealCurve, IdealNodes};
pub use input_files::input_files;
pub use loosepin_mechanics::mechanism::{Arms, Mechanism};
pub use loosepin_mechanics::model::{Model, Reading, relative_words};
pub use loosepin_result::simulation::REPEAT_SHARE;
pub use lyapunov::{ExponentPlan, largest_exponent};
pub use memory::{Block, LaneLayout};
pub use observer::{Observer, Onset, Separation, Step};
pub use path_error::path_error;
pub use period::{period_turns, section, section_sizes};
pub use programs::PassPrograms;
pub use reference::IdealReference;
pub use report::{Counters, EnergyAccount, FrictionLoss, FrictionPath, PlaySummary, RunReport};
pub use resolution::{SmallestClearance, ToleranceProblem};
pub use resume::MotionState;
pub use search::{Peak, maximum_within};
pub use settings::{Integrator, LARGEST_ENERGY_RESIDUAL, STEP_SHARE, Settings, Window};
pub use tables::{HistoryColumn, history_columns, history_csv, impacts_csv, spectrum_csv};
pub use trust::{PositionHistory, SecondRun, compare_positions, measure_trust};
pub use turns::Turns;
pub use wear::{
    Cycle as WearCycle, Depths, JumpLength, Life, LifePlan, LifePoint, WearProfile, WearRecorder, WearingJoint,
    life as life_by_jumps, wear_csv, wear_life_csv, wear_profiles_csv, worn_life,
};
