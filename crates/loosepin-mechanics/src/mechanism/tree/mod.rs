//! The spanning tree: which joint carries which body, loops that ideal joints close, mobility, poses and velocities of all bodies.
//! Contacts and loads do not belong here.

pub(in crate::mechanism) mod assembly;
pub(in crate::mechanism) mod beam;
pub(in crate::mechanism) mod beam_points;
pub(in crate::mechanism) mod blocking;
mod build;
pub(in crate::mechanism) mod cut_numbers;
pub(in crate::mechanism) mod kinematics;
pub(in crate::mechanism) mod mobility;
mod motion;
pub(in crate::mechanism) mod motion_branches;
pub(in crate::mechanism) mod nodal_beam;
pub(in crate::mechanism) mod numbers;
pub(in crate::mechanism) mod points;
pub(in crate::mechanism) mod spanning_tree;
