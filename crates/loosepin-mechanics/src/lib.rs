//! Planar mechanisms with play in their joints: contact laws ([`contact`]), the checked model ([`model`]), the compiled
//! mechanism ([`mechanism`]) and its equations of motion ([`dynamics`]).

pub mod contact;
pub mod dynamics;
pub mod mechanism;
pub mod model;
