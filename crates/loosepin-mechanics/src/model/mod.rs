//! The checked mechanism description: in SI, immutable, with every number in a numbered slot.
//!
//! The tables of a `model.toml` (what was written) become a [`Model`] (what it means). A model knows nothing of
//! uncertainty and nothing of coordinates; [`crate::mechanism`] compiles it.

mod body;
mod contact;
mod control;
mod control_keys;
mod coupling;
mod coupling_keys;
mod cycle;
mod drive;
mod drive_keys;
mod file;
mod function;
mod guide;
mod initial;
mod joint;
mod keys;
mod law_choice;
mod load;
mod load_keys;
mod output;
mod parameter;
mod problem;
mod quantity;
mod set_values;
mod setting;
mod slot;
mod spring;
mod spring_keys;
mod table_points;
mod topology;

pub use control::{Control, FeedForward};
pub use coupling::{Coupling, CouplingLaw, Ratio};
pub use cycle::{Cycle, CycleInput, CycleSpan};
pub use drive::{Drive, DriveLaw};
pub use file::model_schema;
pub use function::Function;
pub use initial::{InitialNumber, InitialOf, InitialValue};
pub use keys::CYCLE_NUMBERS;
pub use law_choice::LawError;
pub use load::{Course, Load, LoadKind};
pub use loosepin_text::document::describe_path;
pub use loosepin_text::units::Rule;
pub use problem::ModelProblem;
pub use quantity::{Origin, Quantity, QuantityError, QuantityId, QuantityTable, Values};
pub use set_values::{SetValues, measured_argument};
pub use setting::{PathError, Setting, SettingError, SettingRange};
pub use spring::{Elasticity, Spring, SpringCurve, SpringKind};
pub use topology::{
    Axis, Body, BodyId, Clearance, Component, Contact, ContactId, DriveId, Friction, Guess, GuideClearance, Joint,
    JointId, JointKind, Model, Output, OutputKind, Point, PointId, SlidingVelocity, SlotClearance, Stiffness,
};
