//! Shapes of the parts between which a joint or coupling has play, a file each, and all that the rest of the program asks of them.
//!
//! How they touch is `dynamics`: a file a shape.

mod block;
mod circular_slot;
mod form;
mod pin;
mod slot;

pub use block::SliderBlock;
pub use circular_slot::{CircularSlotShape, flank_radii_m};
pub use form::{PlayForm, PlayFreedom};
pub use pin::PinShape;
pub use slot::SlotShape;

use crate::mechanism::parts::flanks::Flanks;
use loosepin_math::{Real, Vec2, numbers};

/// Makes the enum of all shapes, and `ask_shape!(shape, parts => answer)`, which calls the current shape.
macro_rules! play_shapes {
    ($($(#[$doc:meta])* $name:ident($shape:ident)),* $(,)?) => {
        /// Shape of a joint with play.
        #[derive(Debug, Clone)]
        pub enum PlayShape<T> {
            $($(#[$doc])* $name($shape<T>),)*
        }

        numbers!(enum PlayShape { $($name(own)),* });

        $(impl<T> From<$shape<T>> for PlayShape<T> {
            fn from(own: $shape<T>) -> Self {
                Self::$name(own)
            }
        })*

        macro_rules! ask_shape {
            ($own:expr, $parts:ident => $answer:expr) => {
                match $own { $($crate::mechanism::PlayShape::$name($parts) => $answer,)* }
            };
        }
    };
}

play_shapes! {
    /// A round pin in a round hole: one contact.
    Pin(PinShape),
    /// A block between the two faces of a guide: a contact for each corner.
    Slider(SliderBlock),
    /// A round pin in a straight slot with round ends: one contact.
    Slot(SlotShape),
    /// A round pin in a slot along a circle: a contact at each flank.
    CircularSlot(CircularSlotShape),
    /// Teeth of a coupling with backlash: a contact for each flank; or a follower on its cam: one contact.
    Flanks(Flanks),
}

pub(crate) use ask_shape;

impl<T> PlayShape<T> {
    /// The hole in which a pin has an orbit; `None` for other parts.
    #[inline(always)]
    pub fn hole(&self) -> Option<&PinShape<T>> {
        if let Self::Pin(pin) = self { Some(pin) } else { None }
    }

    /// The block that may tilt in its guide.
    #[inline(always)]
    pub fn block(&self) -> Option<&SliderBlock<T>> {
        if let Self::Slider(block) = self { Some(block) } else { None }
    }

    /// The straight slot along which a pin has a place.
    #[inline(always)]
    pub fn slot(&self) -> Option<&SlotShape<T>> {
        if let Self::Slot(slot) = self { Some(slot) } else { None }
    }

    /// The flanks of a coupling, which depend on the coordinates of two joints, not on positions in the plane.
    #[inline(always)]
    pub fn flanks(&self) -> Option<&Flanks<T>> {
        if let Self::Flanks(flanks) = self { Some(flanks) } else { None }
    }
}

impl<T: Real> PlayShape<T> {
    /// See [`PlayForm::freedom`].
    pub fn freedom(&self) -> PlayFreedom<T> {
        ask_shape!(self, parts => parts.freedom())
    }

    /// See [`PlayForm::thickness_m`].
    pub fn thickness_m(&self, clearance_m: T) -> T {
        ask_shape!(self, parts => parts.thickness_m(clearance_m))
    }

    /// See [`PlayForm::hole_radius_m`].
    pub fn hole_radius_m(&self) -> Option<T> {
        ask_shape!(self, parts => parts.hole_radius_m())
    }

    /// See [`PlayForm::may_lift`].
    pub fn may_lift(&self) -> bool {
        ask_shape!(self, parts => parts.may_lift())
    }

    /// See [`PlayForm::is_round`].
    #[inline(always)]
    pub fn is_round(&self) -> bool {
        ask_shape!(self, parts => parts.is_round())
    }

    /// See [`PlayForm::directions`].
    #[inline(always)]
    pub fn directions(&self) -> [Option<Vec2<T>>; 2] {
        ask_shape!(self, parts => parts.directions())
    }

    /// See [`PlayForm::has_walls`].
    pub fn has_walls(&self) -> bool {
        ask_shape!(self, parts => parts.has_walls())
    }

    /// See [`PlayForm::wall_shares`].
    pub fn wall_shares(&self) -> Option<[(&'static str, f64); 2]> {
        ask_shape!(self, parts => parts.wall_shares())
    }

    /// Ends of the faces of a guide along its line, m; `None` if they have no ends, or there are no faces.
    #[inline(always)]
    pub fn face_ends_m(&self) -> Option<[T; 2]> {
        self.block().and_then(|block| block.ends_m)
    }
}
