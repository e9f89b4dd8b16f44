//! Rows of the response and where they come from: on threads, in other processes, from the store; failed ones too.
//! Which rows are wanted is said outside.

pub(crate) mod all_runs;
pub(crate) mod design_runs;
pub(crate) mod evaluate;
pub(crate) mod external_runs;
pub(crate) mod failures;
pub(crate) mod keep;
pub(crate) mod memory_at_hand;
pub(crate) mod run_rows;
pub(crate) mod run_subset;
pub(crate) mod table;
