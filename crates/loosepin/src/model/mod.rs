//! The checked mechanism description: in SI, immutable, with every number in a numbered slot.
//!
//! The tables of a `model.toml` (what was written) become a [`Model`] (what it means). A model knows nothing of
//! uncertainty and nothing of coordinates; [`crate::mechanism`] compiles it.

mod body;
mod contact;
mod file;
mod guide;
mod joint;
mod keys;
mod output;
mod parameter;
mod problem;
mod quantity;
mod set_values;
mod setting;
mod topology;

pub use crate::units::Rule;
pub use file::model_schema;
pub(crate) use keys::CYCLE_NUMBERS;
pub use problem::ModelProblem;
pub use quantity::{Origin, Quantity, QuantityError, QuantityId, QuantityTable, Values};
pub use set_values::{SetValues, measured_argument};
pub use setting::{PathError, Setting, SettingError, SettingRange};
pub use topology::{
    Axis, Body, BodyId, Clearance, Component, Contact, ContactId, Cycle, Drive, DriveId, Friction, Guess,
    GuideClearance, Joint, JointId, JointKind, Model, Output, OutputKind, Point, PointId, SlidingVelocity, Stiffness,
};
