//! Constraints of joints and couplings on the positions: constraint rows, coordinates of joints, gaps of joints with play. The forces in
//! them are those of `dynamics`.

pub mod constraints;
pub(in crate::mechanism) mod contact_place;
pub(in crate::mechanism) mod coupling;
pub(in crate::mechanism) mod coupling_geometry;
pub(in crate::mechanism) mod gap_measure;
pub(in crate::mechanism) mod joint_coordinate;
pub(in crate::mechanism) mod joint_geometry;
pub(in crate::mechanism) mod tooth_force;
pub(in crate::mechanism) mod tooth_geometry;
