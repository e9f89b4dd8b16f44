//! What kinds of play have in common: blocks of variables, bearings and clearances, and what each is asked. The kinds stand beside the joints that
//! have them, in `kind/`.

pub(crate) mod bearing;
pub(crate) mod block;
pub(crate) mod clearance;
pub(crate) mod kind_of_play;
