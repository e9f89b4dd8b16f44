//! Rows and outputs over boxes of positions and play, with their first and second derivatives, on intervals whose ends are rounded outwards.
//!
//! A body is displaced by L x and turned by E(t) from its pose r, R:
//!
//! ```text
//! E(t) = 1 + w [t] + [t]²/2,  w = √(1 - t·t/4),  the turn of the unit quaternion (w, t/2)
//! ```
//!
//! so that x and t are to first order the unknowns of the loop equations. Derivatives are those of [`jet::Jet`], by the numbers of the two bodies
//! and of the play of one joint.

pub(crate) mod enclosed_output;
pub(crate) mod jet;
pub(crate) mod joint;
mod moved_body;
pub(crate) mod position_box;
mod row;
mod shift;
pub(crate) mod vector;
