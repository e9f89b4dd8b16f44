//! Many runs side by side: a pass tries one step in all lanes at once, then decides lane by lane. Here are the numbers of the lanes,
//! the arithmetic of a pass and its three executions. What a run is (start, end, record) stands outside; what a step adds to readings
//! stands in `follow`.

pub(crate) mod batch;
pub(crate) mod core;
pub(crate) mod execution;
pub(crate) mod lane;
pub(crate) mod lane_step;
pub(crate) mod memory;
pub(crate) mod pass;
pub(crate) mod programs;
pub(crate) mod reads;
pub(crate) mod recorded;
pub(crate) mod single_lane;
