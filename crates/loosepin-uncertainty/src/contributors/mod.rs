//! How much each random input has to do with the scatter of a response: Sobol' indices.
//!
//! It knows a function from points of the unit cube to numbers, and nothing else; see [`IndexPlan`].

mod groups;
mod sobol_indices;

pub use groups::independent_groups;
pub use sobol_indices::{Index, IndexPlan, IndexPlanError, Indices, SHARES_CONFIDENCE};
