#![cfg_attr(test, allow(clippy::disallowed_methods, reason = "tests make files of their own"))]
#![doc = include_str!("../README.md")]

pub mod accuracy;
pub mod measured;
pub mod sweep;

mod depth_limit;
mod engine;
mod failure;
mod follow;
mod ideal;
mod input_files;
mod kinematics;
mod lanes;
mod observer;
pub use loosepin_result::simulation as record;
mod recording;
mod repeats;
mod resume;
mod settings;
mod start;
mod stepping;
mod stoppable_observer;
mod wear;

pub use engine::{demand_dynamics, run, run_batch};
pub use failure::RunFailure;
pub use follow::{
    DeviationRange, Findings, Follow, FollowedDeviation, FollowedPath, FollowedRun, GAUSS, extremes_within,
    points_within,
};
pub use ideal::column::{Column, columns};
pub use ideal::curve::{IdealCurve, IdealNodes};
pub use ideal::free_motion::FreeMotion;
pub use ideal::path_error::path_error;
pub use ideal::reference::IdealReference;
pub use input_files::input_files;
pub use kinematics::{FIRST_LOOK_STEPS, bodies_that_move, loop_properties};
pub use lanes::batch::{Queue, Run};
pub use lanes::execution::Execution;
pub use lanes::memory::{Block, LaneLayout};
pub use lanes::programs::PassPrograms;
pub use loosepin_mechanics::mechanism::{Arms, Mechanism};
pub use loosepin_mechanics::model::{Model, Reading, relative_words};
pub use loosepin_result::simulation::{REPEAT_SHARE, RunCounters};
pub use observer::{Observer, Onset, Separation, Step};
pub use recording::bending::other_formulation;
pub use recording::contact_basis::{contact_basis, long_pin_force};
pub use recording::controlled_drawing::controlled_drawing;
pub use recording::drawing::{add_pose, parts, skeleton};
pub use recording::flight::FlightClock;
pub use recording::history::{
    BodyStates, MAX_NUMBERS, MAX_ROWS, Plan, Simulation, input, simulate, simulate_from, simulate_poses, simulate_until,
};
pub use recording::motion_table::{motion_columns, motion_csv};
pub use recording::report::{EnergyAccount, FrictionLoss, FrictionPath, PlaySummary, RunReport};
pub use recording::tables::{
    HistoryColumn, HistoryError, SpectrumColumn, body_states_of_csv, history_columns, history_csv, impacts_csv,
    spectrum_columns, spectrum_csv,
};
pub use repeats::lyapunov::{EXPONENT_TURNS, ExponentPlan, largest_exponent};
pub use repeats::period::{period_turns, section, section_sizes};
pub use repeats::trust::{PositionHistory, SecondRun, compare_positions, measure_trust};
pub use repeats::turns::Turns;
pub use resume::{MotionState, StartProblem};
pub use settings::{Integrator, MAX_ENERGY_RESIDUAL, STEP_SHARE, Settings, Window};
pub use start::bending_estimate::{BendingEstimate, estimate_bending};
pub use stepping::resolution::{SmallestClearance, ToleranceProblem};
pub use stepping::search::{Peak, maximum_within};
pub use wear::{
    Cycle as WearCycle, Depths, JumpLength, Life, LifePlan, LifePoint, WearProfile, WearRecorder, WearingJoint,
    life as life_by_jumps, wear_csv, wear_life_csv, wear_profiles_csv, worn_life,
};
