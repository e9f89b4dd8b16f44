//! What a mechanism in space is: bodies, markers, joints and drives. Checked when it is made, and not changed afterwards.

pub(crate) mod body;
pub(crate) mod body_tree;
pub(crate) mod drive;
pub(crate) mod error;
pub(crate) mod joint;
pub(crate) mod marker;
pub(crate) mod spatial_mechanism;
