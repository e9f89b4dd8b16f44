//! Which runs are made, and what is made of them.
//! Rounds of the double loop, their points and their growth. Estimates stand in `estimators`, models over u in `search`.

pub(crate) mod check;
pub(crate) mod double_loop;
pub(crate) mod error;
pub(crate) mod evaluate;
mod inner_runs;
pub(crate) mod promise;
pub(crate) mod refinement;
mod results;
mod rounds;
mod scouting;
mod steering;
