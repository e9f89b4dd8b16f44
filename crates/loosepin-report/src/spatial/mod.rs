//! Pictures of mechanisms in space: orthographic views with depth, still and turned by the reader.
//!
//! | What | File |
//! |---|---|
//! | views: from points in space to the sheet | `projection.rs` |
//! | what is drawn, cut into parts that can be sorted by depth | `parts.rs` |
//! | parts in a position and a view, the farthest first | `placed.rs` |
//! | the same as shapes of a picture | `drawing.rs`; axes and ground `signs.rs`, names of joints `names.rs` |
//! | the picture of a page with its controls, and its data for `scripts/space-scene.ts`; turned by `scripts/space.ts` | `figure.rs` |
//! | front, side and top on one sheet | `views.rs` |

mod drawing;
pub(crate) mod figure;
mod names;
mod parts;
mod placed;
mod projection;
mod signs;
pub(crate) mod views;
