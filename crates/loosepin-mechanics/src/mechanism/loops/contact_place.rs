//! Places where the two bodies of a joint with play may touch.

use crate::mechanism::parts::flanks::FLANKS;
use crate::model::{Model, PlayId};

/// A place where the two bodies of a joint with play may touch: a contact, with a state, forces and events of its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ContactPlace {
    /// Index of the joint in [`crate::mechanism::Mechanism::plays`].
    pub play: usize,
    /// Which of the joint's places, from 0.
    pub place: usize,
}

/// Whether the corner at `place` of a slider is at its front, where the guide's line points to; it is at its rear otherwise.
pub fn is_front_corner(place: usize) -> bool {
    place % 2 == 1
}

/// Whether the corner at `place` of a slider is at the upper face, to the left of the guide's line; it is at the lower face otherwise.
pub fn is_upper_corner(place: usize) -> bool {
    place < 2
}

/// The places of the joints with play, joint by joint.
pub(in crate::mechanism) fn contact_places(model: &Model, plays: &[PlayId]) -> Vec<ContactPlace> {
    let count = |id: PlayId| match id {
        PlayId::Joint(joint) => model.joints[joint.0].kind.contact_places().len().max(1),
        PlayId::Coupling(_) if model.play_clearance(id).is_none() => 1,
        PlayId::Coupling(_) => FLANKS.len(),
    };
    let places = |(play, &id): (usize, &PlayId)| (0..count(id)).map(move |place| ContactPlace { play, place });
    plays.iter().enumerate().flat_map(places).collect()
}

/// Name of a contact: that of its joint or coupling, for a slider with its corner, for teeth with the flank.
pub(in crate::mechanism) fn contact_name(model: &Model, play: PlayId, place: usize) -> String {
    let name = model.play_name(play);
    let places: &[&str] = match play {
        PlayId::Joint(joint) => model.joints[joint.0].kind.contact_places(),
        PlayId::Coupling(_) if model.play_clearance(play).is_none() => &[],
        PlayId::Coupling(_) => &FLANKS,
    };
    places.get(place).map_or_else(|| name.to_owned(), |place| format!("{name} ({place})"))
}
