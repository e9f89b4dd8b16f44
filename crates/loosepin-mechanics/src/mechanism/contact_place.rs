//! Where the two bodies of a joint with play may touch.

use super::flanks::{FLANKS, Flanks};
use crate::model::{Model, PlayId};
use loosepin_math::{Vec2, numbers};

/// A place where the two bodies of a joint with play may touch: a contact, with a state, forces and events of its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ContactPlace {
    /// Index of the joint in [`super::Mechanism::plays`].
    pub play: usize,
    /// Which of the joint's places, from 0.
    pub place: usize,
}

/// Shape of a joint with play.
#[derive(Debug, Clone)]
pub enum PlayShape<T> {
    /// A round pin in a round hole: one contact.
    Pin {
        /// Radius R_i of the bearing, m.
        bearing_radius_m: T,
    },
    /// A block between the two faces of a guide: a contact for each corner.
    Slider(SliderBlock<T>),
    /// A round pin in a straight slot with round ends: one contact.
    Slot(SlotShape<T>),
    /// Teeth of a coupling with backlash: a contact for each flank; or a follower on its cam: one contact.
    Flanks(Flanks<T>),
}

numbers!(enum PlayShape { Pin { bearing_radius_m }, Slider(block), Slot(slot), Flanks(flanks) });

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

/// Whether the corner at `place` of a slider is at its front, where the guide's line points to; it is at its rear otherwise.
pub fn is_front_corner(place: usize) -> bool {
    place % 2 == 1
}

/// Whether the corner at `place` of a slider is at the upper face, to the left of the guide's line; it is at the lower face otherwise.
pub fn is_upper_corner(place: usize) -> bool {
    place < 2
}

/// The places of the joints with play, joint by joint.
pub(super) fn contact_places(model: &Model, plays: &[PlayId]) -> Vec<ContactPlace> {
    let count = |id: PlayId| match id {
        PlayId::Joint(joint) => model.joints[joint.0].kind.contact_places().len().max(1),
        PlayId::Coupling(_) if model.play_clearance(id).is_none() => 1,
        PlayId::Coupling(_) => FLANKS.len(),
    };
    let places = |(play, &id): (usize, &PlayId)| (0..count(id)).map(move |place| ContactPlace { play, place });
    plays.iter().enumerate().flat_map(places).collect()
}

/// Name of a contact: that of its joint or coupling, for a slider with its corner, for teeth with the flank.
pub(super) fn contact_name(model: &Model, play: PlayId, place: usize) -> String {
    let name = model.play_name(play);
    let places: &[&str] = match play {
        PlayId::Joint(joint) => model.joints[joint.0].kind.contact_places(),
        PlayId::Coupling(_) if model.play_clearance(play).is_none() => &[],
        PlayId::Coupling(_) => &FLANKS,
    };
    places.get(place).map_or_else(|| name.to_owned(), |place| format!("{name} ({place})"))
}
