//! Robot descriptions: URDF and MJCF as models in space.
//!
//! | Step | File |
//! |---|---|
//! | elements, attributes and numbers with their places | `xml.rs` |
//! | turns as descriptions write them | `turns.rs` |
//! | what a description says, the same for both formats | `description.rs` |
//! | URDF | `urdf.rs` |
//! | MJCF | `mjcf` |
//! | which joints are driven | `drives.rs`, with `mechanism.rs` where loops close |
//! | the text of the model | `model_text.rs`, `model_names.rs`, `names.rs`, `numbers.rs` |
//! | all of it | `import.rs` |
//! | what is wrong | `problem.rs` |

mod description;
mod drives;
mod import;
mod mechanism;
mod mjcf;
mod model_names;
mod model_text;
mod names;
mod numbers;
mod problem;
mod turns;
mod urdf;
mod xml;

pub use import::import_robot;
pub(crate) use names::Names;
pub(crate) use numbers::number;
pub use problem::RobotProblem;
pub(crate) use turns::of_roll_pitch_yaw;
