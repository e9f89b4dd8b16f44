//! Rows and outputs over boxes of positions and play, with their first and second derivatives, on intervals whose ends are rounded outwards.
//!
//! The bodies are a tree. Each moves against the one that its branch comes from, about a point c of the ideal position near the joint between
//! them, by
//!
//! ```text
//! P ↦ c + L ξ + E(t)(P - c),   E(t) = 1 + w [t] + [t]²/2,   w = √(1 - t·t/4): the turn of the unit quaternion (w, t/2)
//! ```
//!
//! with six numbers (ξ, t) each. So what a joint of the tree lets its bodies do depends on six numbers and its play alone, and where several bodies
//! turn together nothing is subtracted.

pub(crate) mod enclosed_output;
pub(crate) mod jet;
pub(crate) mod joint;
pub(crate) mod position_box;
mod row;
mod shift;
pub(crate) mod step;
pub(crate) mod vector;
