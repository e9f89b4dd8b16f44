//! Questions, runs and answers: what all other floors speak of.
//! Plain types: a problem, its table of runs, its bounds. Nothing here estimates or searches.

pub(crate) mod bound;
pub(crate) mod defaults;
pub(crate) mod direction;
pub(crate) mod gaps;
pub(crate) mod points;
pub(crate) mod problem;
pub(crate) mod random_inputs;
mod rows;
pub(crate) mod scratch;
pub(crate) mod table;
mod type_map;
