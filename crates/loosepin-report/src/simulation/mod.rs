//! One run: its page and its text for a terminal.
//!
//! | Said | File |
//! |---|---|
//! | the answer: deviation, impacts, forces, controls, checks | `answer.rs`; how flexible bodies bend `bending.rs` |
//! | smallest and largest values | `extremes.rs` |
//! | oscillations | `spectra.rs` |
//! | contact and impacts in the joints | `contact.rs` |
//! | wear | `wear.rs`, in sentences `wear_words.rs`; over the cycles of a life `life.rs` |
//! | measured curves over computed ones | `measured.rs` |
//! | how it was computed | `method.rs` |
//! | on the page alone: whether the motion repeats; charts of outputs, controls, energy | `kind.rs`; `charts.rs` |
//!
//! `page.rs` and `text.rs` put these together.

mod answer;
mod bending;
mod charts;
mod contact;
mod extremes;
mod kind;
mod life;
mod measured;
mod method;
mod page;
mod spectra;
mod text;
mod wear;
mod wear_picture;
mod wear_words;

pub use page::{simulation_excerpt, simulation_frame, simulation_page};
pub use text::{short_simulation_text, simulation_text, wear_text};
