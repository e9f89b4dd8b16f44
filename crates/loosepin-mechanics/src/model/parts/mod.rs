//! The parts of a model that have no kinds, or few: bodies, beams, springs, controls, friction, wear, the cycle, the initial state.
//! Parts of many kinds have a folder beside this one.

pub(in crate::model) mod beam;
pub(in crate::model) mod beam_problem;
pub(in crate::model) mod control;
pub(in crate::model) mod cycle;
pub(in crate::model) mod friction;
pub(in crate::model) mod initial;
pub(in crate::model) mod load_table;
pub(in crate::model) mod play;
pub(in crate::model) mod spring;
pub(in crate::model) mod table_curve;
pub(in crate::model) mod topology;
pub(in crate::model) mod wear;
