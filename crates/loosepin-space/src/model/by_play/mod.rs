//! What play does over a turn beside the worst cases of outputs.
//!
//! | Step | File |
//! |---|---|
//! | paths of points, and how far it takes them along and across | `point_paths.rs` |

mod point_paths;
