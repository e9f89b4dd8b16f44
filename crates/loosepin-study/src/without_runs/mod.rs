//! Answers without dynamics: the ideal motion, worst cases, requirements judged by them. `loosepin motion` and the studio's band show it.

pub(crate) mod asked_poses;
pub(crate) mod ideal_motion;
pub(crate) mod judge;
mod judge_by_play;
mod judged;
pub(crate) mod proven_ends;
pub(crate) mod widest_play;
