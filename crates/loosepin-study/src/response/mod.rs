//! A mechanism as a function from uncertain inputs to numbers: its columns, what is recorded of a run, runs on lanes.
//! It knows no questions and no bounds.

pub(crate) mod columns;
pub(crate) mod ends;
pub(crate) mod extras;
pub(crate) mod further_outputs;
pub(crate) mod ideal_tables;
pub(crate) mod input_limits;
pub(crate) mod input_targets;
pub(crate) mod kind;
pub(crate) mod lanes;
pub(crate) mod limits;
pub(crate) mod linear_scatter;
mod planar;
pub(crate) mod planar_response;
pub(crate) mod problem;
mod recent_ends;
pub(crate) mod recorded_output;
pub(crate) mod recorder;
pub(crate) mod sampled_feature;
mod spatial;
pub(crate) mod spatial_response;
pub(crate) mod study_response;
