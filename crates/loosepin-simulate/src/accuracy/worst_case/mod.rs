//! The worst case of an output over the play.
//!
//! | what | where |
//! |---|---|
//! | the sum of first-order effects, for previews | `first_order.rs` |
//! | the largest deviation that is found, with the displacements that make it | `search.rs` |
//! | an end that no deviation passes | `upper_end.rs`: bound of a quadratic function, from derivatives over all positions (`enclosure.rs`), near a dead centre in slices (`slices.rs`) |

mod bordered;
mod enclosure;
mod evaluate;
mod first_order;
mod over_cycle;
mod path_part;
mod positions;
mod search;
mod slices;
mod upper_end;
mod variables;

pub(super) use enclosure::{Encloser, Moving};
pub use first_order::{disc_standard_deviation_si, first_order_si, rim_standard_deviation_si};
pub(super) use over_cycle::{
    CycleOfPositions, CycleWorstCase, NotProven, WeightedOutput, found_in_both_assemblies, worst_over_cycle,
};
pub(super) use path_part::PathPart;
pub(super) use positions::{Positions, ends_around};
pub(super) use search::{Objective, best_across, best_of};
pub use search::{WorstCaseExtremes, WorstPosition, starts_on_borders, worst_case_extremes};
pub(super) use upper_end::Ends;
pub(super) use variables::Variables;
