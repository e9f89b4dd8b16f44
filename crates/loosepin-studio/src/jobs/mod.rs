//! Studies and single runs in the background.
//! They run as the command runs them.

pub(crate) mod job;
pub(crate) mod queue;
