//! Names of parts in words.

pub(in crate::model) mod names_of_model;
pub(in crate::model) mod part_names;
