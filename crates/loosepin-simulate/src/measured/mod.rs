//! Measured curves: a table with units in its header, laid over the outputs of a run, with what is left between them.
//! Features of a measured motion that `identify` uses stand in `loosepin-study`.

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
