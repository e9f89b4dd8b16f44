//! Identification of the unknowns of a mechanism from readings of a rig and from its motion.
//!
//! | Said | File |
//! |---|---|
//! | what readings leave of the plays | `readings.rs`, in sentences `readings_words.rs` |
//! | what a motion leaves of the unknowns, features measured and predicted | `motion.rs` |
//! | how probable the values are | `posterior.rs`; lengths of the specimen `lengths.rs` |
//! | what features would tell | `plan.rs` |
//! | what the study gains | `gain.rs` |
//! | what all of it rests on | `grounds.rs` |
//!
//! `page.rs` and `text.rs` put these together.

mod figures;
mod gain;
mod grounds;
mod lengths;
mod motion;
mod page;
mod plan;
mod posterior;
mod posterior_figure;
mod ranges;
mod readings;
mod readings_words;
mod text;

pub use gain::identification_gain;
pub use page::identification_page;
pub use text::{identification_text, motion_plan_text};
