//! The checked mechanism description: in SI, immutable, with every number in a numbered slot.
//!
//! `ModelFile` (what was written) becomes [`Model`] (what it means). A model knows nothing of uncertainty and nothing
//! of coordinates; [`crate::mechanism`] compiles it.

mod quantity;
mod topology;

pub use quantity::{Quantity, QuantityError, QuantityId, QuantityTable, Rule, Values};
pub use topology::{
    Axis, Body, BodyId, Clearance, Component, Contact, ContactId, Cycle, Drive, DriveId, Friction, FrictionLaw, Guess,
    Joint, JointId, JointKind, Model, Output, OutputKind, Point, PointId, SlidingVelocity, Stiffness,
};
