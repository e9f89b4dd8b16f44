//! The interface of a shape of parts with play.

use loosepin_math::{Real, Vec2};

/// How the parts of a joint with play may lie against each other.
#[derive(Debug, Clone, Copy)]
pub enum PlayFreedom<T> {
    /// The pin anywhere in a circle.
    InCircle,
    /// The pin anywhere between two faces; where it is along them is the joint's own motion.
    BetweenFaces,
    /// The block anywhere between two faces, as far as it may tilt there.
    Tilting {
        /// Half-length a of the block, m.
        half_length_m: T,
        /// Half-height b of the block, m.
        half_height_m: T,
    },
    /// Teeth between their flanks, along the pitch line; a follower on its cam.
    AlongPitchLine,
}

/// A shape. Plain answers are those of parts that meet at one smooth wall each, and have no line.
pub trait PlayForm<T: Real> {
    /// How the parts may lie against each other.
    fn freedom(&self) -> PlayFreedom<T>;

    /// How deep the parts may go into each other before one is through the other, m, with the clearance `clearance_m`.
    fn thickness_m(&self, clearance_m: T) -> T;

    /// Radius of the hole, or half the width of the slot, in which a pin is, m; `None` if there is none.
    fn hole_radius_m(&self) -> Option<T> {
        None
    }

    /// Whether the parts may part for good, as a follower from its cam: then no clearance limits how far.
    fn may_lift(&self) -> bool {
        false
    }

    /// Whether the gap function is |e|² - c², smooth where e = 0, as for shapes round a centre.
    #[inline(always)]
    fn is_round(&self) -> bool {
        false
    }

    /// Directions of the line of a guide or slot in the frame of the first body, and of a block's axis in that of the second.
    #[inline(always)]
    fn directions(&self) -> [Option<Vec2<T>>; 2] {
        [None; 2]
    }

    /// Places of its walls in words, with the stiffness there over that of the contact's law; `None` if it is the same everywhere.
    fn wall_shares(&self) -> Option<[(&'static str, f64); 2]> {
        None
    }

    /// Whether a contact may go from one wall to another: a face and its end.
    fn has_walls(&self) -> bool {
        false
    }
}
