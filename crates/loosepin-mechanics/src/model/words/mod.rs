//! Names of parts in words.
//! Sentences about a model stand in `loosepin-check`.

pub(in crate::model) mod names_of_model;
pub(in crate::model) mod part_names;
