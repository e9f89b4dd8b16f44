//! Measured curves: a table with units in its header, compared with the outputs of a run, with the residuals. Features of a measured motion
//! that `identify` uses stand in `loosepin-study`.

mod between;
mod compare;
mod joint;
mod problem;
mod sample;
mod table;

pub use compare::compare_with_measured;
pub use joint::{JointColumn, JointSample};
pub use problem::MeasuredProblem;
pub use sample::SampleColumn;
pub use table::{MeasuredColumn, MeasuredTable};
