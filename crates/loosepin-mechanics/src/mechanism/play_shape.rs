//! Shapes of the parts between which a joint or coupling has play, and all that the rest of the program asks of them.
//!
//! How they touch is `dynamics`: a file a shape.

use super::flanks::Flanks;
use loosepin_math::{Real, Vec2, numbers};

/// Shape of a joint with play.
#[derive(Debug, Clone)]
pub enum PlayShape<T> {
    /// A round pin in a round hole: one contact.
    Pin(PinShape<T>),
    /// A block between the two faces of a guide: a contact for each corner.
    Slider(SliderBlock<T>),
    /// A round pin in a straight slot with round ends: one contact.
    Slot(SlotShape<T>),
    /// Teeth of a coupling with backlash: a contact for each flank; or a follower on its cam: one contact.
    Flanks(Flanks<T>),
}

numbers!(
    enum PlayShape {
        Pin(pin),
        Slider(block),
        Slot(slot),
        Flanks(flanks),
    }
);

/// A round hole.
#[derive(Debug, Clone, Copy)]
pub struct PinShape<T> {
    /// Radius R_i of the bearing, m.
    pub bearing_radius_m: T,
}

numbers!(struct PinShape { bearing_radius_m });

/// A straight slot with round ends.
#[derive(Debug, Clone, Copy)]
pub struct SlotShape<T> {
    /// Half-length h from the middle of the slot to the centre of each round end, m.
    pub half_length_m: T,
    /// Radius R_i of the ends, half the width of the slot, m.
    pub end_radius_m: T,
    /// Direction of the slot's line in its body's frame.
    pub line: Vec2<T>,
    /// κ: by what share the round ends are stiffer than the faces; zero where the stiffness is given.
    pub end_stiffening: T,
}

numbers!(struct SlotShape { half_length_m, end_radius_m, line, end_stiffening });

/// A block between the two faces of a guide.
#[derive(Debug, Clone, Copy)]
pub struct SliderBlock<T> {
    /// Half-length a along its axis, m.
    pub half_length_m: T,
    /// Half-height b across its axis, m.
    pub half_height_m: T,
    /// Direction of the guide's line in the guide body's frame.
    pub line: Vec2<T>,
    /// Direction of the block's axis in the slider body's frame.
    pub axis: Vec2<T>,
    /// Where the faces begin and end along the line, m; none where they have no ends. The block may overhang an end; a run in which it
    /// leaves the faces altogether fails.
    pub ends_m: Option<[T; 2]>,
}

numbers!(struct SliderBlock { half_length_m, half_height_m, line, axis, ends_m });

/// How the parts of a joint with play may lie against each other.
#[derive(Debug, Clone, Copy)]
pub enum PlayFreedom<'p, T> {
    /// The pin anywhere in a circle.
    InCircle,
    /// The pin anywhere between two faces; where it is along them is the joint's own motion.
    BetweenFaces,
    /// The block anywhere between two faces, as far as it may tilt there.
    Tilting(&'p SliderBlock<T>),
    /// Teeth between their flanks, along the pitch line; a follower on its cam.
    AlongPitchLine,
}

impl<T> PlayShape<T> {
    /// How its parts may lie against each other.
    pub fn freedom(&self) -> PlayFreedom<'_, T> {
        match self {
            Self::Pin(_) => PlayFreedom::InCircle,
            Self::Slot(_) => PlayFreedom::BetweenFaces,
            Self::Slider(block) => PlayFreedom::Tilting(block),
            Self::Flanks(_) => PlayFreedom::AlongPitchLine,
        }
    }

    /// The hole in which a pin has an orbit; none of other parts.
    #[inline(always)]
    pub fn hole(&self) -> Option<&PinShape<T>> {
        match self {
            Self::Pin(pin) => Some(pin),
            Self::Slider(_) | Self::Slot(_) | Self::Flanks(_) => None,
        }
    }

    /// The block that may tilt in its guide.
    #[inline(always)]
    pub fn block(&self) -> Option<&SliderBlock<T>> {
        match self {
            Self::Slider(block) => Some(block),
            Self::Pin(_) | Self::Slot(_) | Self::Flanks(_) => None,
        }
    }

    /// The slot along which a pin has a place.
    #[inline(always)]
    pub fn slot(&self) -> Option<&SlotShape<T>> {
        match self {
            Self::Slot(slot) => Some(slot),
            Self::Pin(_) | Self::Slider(_) | Self::Flanks(_) => None,
        }
    }

    /// What goes by the coordinates of two joints, and not by places in the plane.
    #[inline(always)]
    pub fn flanks(&self) -> Option<&Flanks<T>> {
        match self {
            Self::Flanks(flanks) => Some(flanks),
            Self::Pin(_) | Self::Slider(_) | Self::Slot(_) => None,
        }
    }

    /// Whether the parts may part for good, as a follower from its cam: then no clearance limits how far.
    pub fn may_lift(&self) -> bool {
        self.flanks().is_some_and(|flanks| flanks.is_one_sided)
    }

    /// Whether the gap function is |e|² - c², smooth where e = 0: of what goes round a centre.
    #[inline(always)]
    pub fn is_round(&self) -> bool {
        match self {
            Self::Pin(_) | Self::Slot(_) => true,
            Self::Slider(_) | Self::Flanks(_) => false,
        }
    }
}

impl<T: Real> PlayShape<T> {
    /// Directions of the line of a guide or slot in the frame of the first body, and of a block's axis in that of the second.
    #[inline(always)]
    pub fn directions(&self) -> [Option<Vec2<T>>; 2] {
        match self {
            Self::Pin(_) | Self::Flanks(_) => [None; 2],
            Self::Slot(slot) => [Some(slot.line), None],
            Self::Slider(block) => [Some(block.line), Some(block.axis)],
        }
    }

    /// Where the faces of a guide begin and end along its line, m; none where they have no ends, or there are none.
    #[inline(always)]
    pub fn face_ends_m(&self) -> Option<[T; 2]> {
        self.block().and_then(|block| block.ends_m)
    }

    /// Whether a contact may go from one wall to another: a face and its end.
    pub fn has_walls(&self) -> bool {
        self.slot().is_some() || self.face_ends_m().is_some()
    }
}

impl PlayShape<f64> {
    /// Radius of the hole, or of the round ends, in which a pin is, m; none where there is none.
    pub fn hole_radius_m(&self) -> Option<f64> {
        self.hole().map(|hole| hole.bearing_radius_m).or_else(|| self.slot().map(|slot| slot.end_radius_m))
    }

    /// How deep the parts may go into each other before one is through the other, m, with the clearance `clearance_m`.
    pub fn thickness_m(&self, clearance_m: f64) -> f64 {
        match self {
            Self::Pin(pin) => (pin.bearing_radius_m - clearance_m).max(0.0),
            Self::Slider(block) => block.half_height_m,
            Self::Slot(slot) => (slot.end_radius_m - clearance_m).max(0.0),
            // Nothing tells how thick a tooth is, or a cam.
            Self::Flanks(_) => f64::INFINITY,
        }
    }
}
