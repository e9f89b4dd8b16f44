//! What play does over a turn beside the worst cases of outputs.
//!
//! | Step | File |
//! |---|---|
//! | how far it takes a number, found and proven: what requirements are judged by | `play_ends.rs` |
//! | paths of points, and how far it takes them along and across | `point_paths.rs` |

mod play_ends;
mod point_paths;

pub use play_ends::{PlayEnds, PlayQuestion};
