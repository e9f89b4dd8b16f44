//! Models of mechanisms in space: a file with its numbers as quantities, and the mechanism that it makes with given values. Poses, gains and
//! worst cases are computed in the other folders, which know no file.
//!
//! | Step | File |
//! |---|---|
//! | the parts of a model; directions; where a joint is, and its errors of manufacture | `parts.rs`; `direction.rs`; `marker.rs` |
//! | points, axes and names while a file is read | `reader.rs` |
//! | tables | `read.rs` (the file), `body.rs`, `joint.rs`, `drive.rs` (with the cycle), `output/`, `assembly.rs` |
//! | from values to a mechanism; where its bodies start | `compile.rs`; `placing.rs` |
//! | its motion over a turn, with worst cases; what play does to an output | `over_turn.rs`; `course.rs` |
//! | how far play takes a number, and the path of a point | `by_play/` |
//! | what random dimensions do to it | `scatter.rs` |
//! | numbers that are round-off | `round_off.rs` |
//! | whether its parts fit | `fit.rs` |
//! | whether a file forgot to say that it is in space | `forgotten.rs` |
//! | what is drawn of it | `drawn.rs` |
//! | why it cannot be sampled | `sampled.rs` |
//! | what is hardly possible; which bodies never move; what is wrong with it | `plausible.rs`; `still.rs`; `problem.rs` |

mod assembly;
mod body;
mod by_play;
mod compile;
mod course;
pub(crate) mod direction;
mod drawn;
mod drive;
mod fit;
mod forgotten;
mod joint;
pub(crate) mod marker;
mod output;
mod over_turn;
mod parts;
mod placing;
mod plausible;
pub(crate) mod problem;
mod read;
mod reader;
mod round_off;
mod sampled;
mod scatter;
mod still;

pub use body::is_inertia;
pub use by_play::{PlayEnds, PlayQuestion};
pub use compile::CycleInput;
pub use direction::Direction;
pub use fit::ModelAssembly;
pub use forgotten::refuse_without_geometry;
pub use marker::{ModelMarker, ModelMisalignment, PointId};
pub use output::ModelOutputKind;
pub use over_turn::dead_centre_spans;
pub use parts::{
    ModelBody, ModelCycle, ModelCycleSpan, ModelDrive, ModelGuess, ModelJoint, ModelOutput, ModelPoint, SpatialModel,
};
pub use problem::{SpatialModelError, SpatialModelProblem, SpatialMotionProblem};
pub use read::{is_spatial, spatial_model_schema};
pub use scatter::{SpatialScatter, SpatialScatterPlan};
