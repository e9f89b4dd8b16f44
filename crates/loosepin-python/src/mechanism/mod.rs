//! What is computed of a mechanism alone, for Python: one run, sweeps, motion without dynamics, checks of files. Studies are in the folder
//! above.

pub mod check;
pub mod motion;
pub mod simulation;
pub mod single_run;
pub mod stored;
pub mod sweep;
