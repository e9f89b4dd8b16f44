//! From gestures to changes of the two texts.
//!
//! | What | File |
//! |---|---|
//! | a joint that is dragged: which coordinates put it there | `reshape.rs` |
//! | a coordinate: which number of the text gives it, and what that number becomes | `behind.rs` |
//! | a number as it is written: its unit stays, its value is round on the screen | `written.rs` |
//! | a drag as a whole: from the texts and the pointer to new texts | `grip.rs` |
//! | how well a number is known, as people write it | `knowledge.rs` |
//! | the same in the texts: play, scatter, what is unknown | `know.rs` |
//! | a text with pieces that are replaced | `rewritten.rs` |
//! | links, joints and bodies that come, go, and get other names | `structure` |

mod behind;
mod grip;
mod know;
mod knowledge;
mod reshape;
mod rewritten;
mod structure;
mod written;

pub use behind::number_behind;
pub use grip::{gripped, refused_drag, shown_angle_deg};
pub use know::know;
pub use structure::{Edit, Locks, Restructured, restructured, why_not};

#[cfg(test)]
pub mod tests;
