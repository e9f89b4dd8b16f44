//! From gestures to changes of the two texts.
//!
//! | What | File |
//! |---|---|
//! | a joint that is dragged: which coordinates put it there | `reshape.rs` |
//! | a coordinate: which number of the text gives it, and what that number becomes | `behind.rs` |
//! | a number as it is written: its unit stays, its value is round on the screen | `written.rs` |
//! | a guide that is turned by its line | `guide.rs` |
//! | a drag as a whole: from the texts and the pointer to new texts | `grip.rs` |
//! | the position of the new mechanism that a drag leaves on the screen; the closure of its loops | `nearest.rs`, `closure.rs` |
//! | how well a number is known, as people write it | `uncertainty_spec.rs` |
//! | the same in the texts: play, scatter, what is unknown | `set_uncertainty.rs` |
//! | play of a joint that has none yet | `new_play.rs` |
//! | links, joints and bodies that come, go, and get other names | `structure` |
//! | how a text is changed, all else byte for byte | `toml` |

mod behind;
mod closure;
mod grip;
mod guide;
mod nearest;
mod new_play;
mod reshape;
mod set_uncertainty;
mod structure;
pub(crate) mod toml;
mod uncertainty_spec;
mod written;

pub use behind::number_behind;
pub use closure::kept_closure;
pub use grip::{DragOutcome, gripped, refused_drag};
pub use nearest::nearest;
pub use set_uncertainty::set_uncertainty;
pub use structure::{Edit, Locks, Restructured, restructured, why_not};
pub use toml::pieces::applied;

#[cfg(test)]
mod drag_tests;
#[cfg(test)]
pub mod tests;
