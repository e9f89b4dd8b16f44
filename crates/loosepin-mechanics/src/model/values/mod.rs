//! Numbers of a model: the one table of quantities, expressions, and how they are set from outside.
//! Every number of a model has its place, unit and rule here. Text with units is read in `loosepin-text`.

pub(in crate::model) mod function;
pub(in crate::model) mod law_choice;
pub(in crate::model) mod path_error;
pub(in crate::model) mod path_hint;
pub(in crate::model) mod point_argument;
pub(in crate::model) mod set_values;
pub(in crate::model) mod setting;
pub(in crate::model) mod sizes;
