//! One chain of a series.

use crate::chain::joint_turn::{ChainPose, Lean};
use crate::kind::frames::MarkerShift;
use crate::mechanism::body_tree::TreeJoint;
use crate::mechanism::marker::Marker;
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use loosepin_math::Frame;

/// A joint of the chain: its bearing's marker seen from the journal's marker before, and its play.
#[derive(Debug, Clone, Copy)]
struct Link {
    before: Frame,
    lean: Lean,
    is_reversed: bool,
}

/// A chain with its dimensions and the places of its journals, which stay as they are from pose to pose.
#[derive(Debug, Clone)]
pub struct ChainSample {
    links: Vec<Link>,
    /// From the last journal's marker to the body.
    after: Frame,
}

impl ChainSample {
    /// The chain along `path`, with what play does to each joint of the mechanism, and its markers where they are not the mechanism's own.
    pub(crate) fn new(
        mechanism: &SpatialMechanism,
        path: &[TreeJoint],
        shifts: &[MarkerShift],
        markers: Option<&[[Marker; 2]]>,
    ) -> Self {
        let mut before = Frame::IDENTITY;
        let mut links = Vec::with_capacity(path.len());
        for joint in path {
            let own = &mechanism.joints()[joint.joint];
            let given = markers.and_then(|markers| markers.get(joint.joint));
            let [bearing, journal] = given.unwrap_or(&[own.bearing, own.journal]).each_ref().map(Frame::from);
            let (near, far) = if joint.is_reversed { (journal, bearing) } else { (bearing, journal) };
            let lean = Lean::new(&shifts[joint.joint]);
            links.push(Link { before: before.compose(&near), lean, is_reversed: joint.is_reversed });
            before = far.inverse();
        }
        Self { links, after: before }
    }

    /// The body's pose, exactly. About 130 multiplications and additions, a root and a division a joint.
    #[inline]
    pub fn end(&self, pose: &ChainPose) -> Frame {
        let mut at = Frame::IDENTITY;
        for (link, place) in self.links.iter().zip(&pose.places) {
            let turned = link.lean.journal(place);
            let turned = if link.is_reversed { turned.inverse() } else { turned };
            at = at.compose(&link.before).compose(&turned);
        }
        at.compose(&self.after)
    }
}
