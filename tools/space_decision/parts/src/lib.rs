//! What both prototypes stand on: the tree, and vectors of three components.

mod tree;
mod vector;

pub use tree::{Attachment, Counts, Link, Tree};
pub use vector::{Matrix3, Vector3};
