//! From a model in space to a robot description, URDF or MJCF.
//!
//! | Step | File |
//! |---|---|
//! | a link with its mass | `link.rs` |
//! | elements of XML | `element.rs` |
//! | the texts | `urdf.rs`, `mjcf.rs` |
//! | what both are written from | `closed_model.rs` |
//! | all of it | `export_robot.rs` |
//! | the file | `file.rs` |
//! | what cannot be said | `problem.rs` |

mod closed_model;
mod element;
mod export_robot;
mod file;
mod link;
mod mjcf;
mod problem;
mod urdf;

pub use export_robot::{Exported, RobotFormat, export_robot};
pub use file::write_robot;
pub use problem::ExportProblem;
