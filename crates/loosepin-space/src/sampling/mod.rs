//! Many samples of one model over its turn: for random dimensions and for play that is not known.
//!
//! [`TurnSampler`] is where to begin. It closes the nominal mechanism at given places of its turn; each sample is then closed from there, not
//! from the place before.
//!
//! | Step | File |
//! |---|---|
//! | what is read off, and what play may do | `part.rs` |
//! | the nominal motion, with directions along its paths | `nominal.rs` |
//! | one sample: from values to numbers | `turn_sampler.rs` |
//! | numbers at one place | `reading.rs` |
//! | the largest length of a displacement | `longest.rs` |
//! | places of the journals from uniform numbers | `journals.rs` |
//! | what a sample cannot do | `error.rs` |

mod error;
mod journals;
mod longest;
mod nominal;
mod part;
mod reading;
mod turn_sample;
mod turn_sampler;

pub use error::SamplingError;
pub use part::{PartOfOutput, PlaySide, SampledPart};
pub use turn_sample::TurnSample;
pub use turn_sampler::TurnSampler;
