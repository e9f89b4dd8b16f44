//! Many samples of one model over its turn: for random dimensions and for play that is not known.
//!
//! [`TurnSampler`] is where to begin. It closes the nominal mechanism at given places of its turn; each sample is then closed from there, not
//! from the place before.
//!
//! | Step | File |
//! |---|---|
//! | what is read off, and what play may do; its numbers | `part.rs`; `turn_sample.rs` |
//! | the nominal motion, with directions along its paths | `nominal.rs` |
//! | what is fixed for all samples; one of them, from values to numbers | `turn_sampler.rs`; `one_sample.rs` |
//! | closed loops at a place, ideal and with play | `closing.rs`, `displaced.rs` |
//! | what play reaches there: without conditions, and with those of redundant rows | `reach.rs`: `free.rs`, `conditioned.rs` |
//! | numbers at a place; the largest and the smallest length of a displacement | `reading.rs`; `goal.rs`, `longest.rs`, `shortest.rs` |
//! | places of the journals from uniform numbers | `journals.rs` |
//! | what a sample cannot do | `error.rs` |

mod closing;
mod conditioned;
mod displaced;
mod error;
mod free;
mod goal;
mod journals;
mod longest;
mod nominal;
mod one_sample;
pub(crate) mod part;
mod reach;
mod reading;
mod shortest;
mod turn_sample;
mod turn_sampler;

pub use error::SamplingError;
pub use part::{PartOfOutput, PlaySide, SampledPart};
pub use turn_sample::TurnSample;
pub use turn_sampler::TurnSampler;
