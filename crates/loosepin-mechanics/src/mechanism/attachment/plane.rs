//! The attachments of the plane.

use super::form::TreeGeometry;
use super::free::Free;
use super::list::attachments;
use super::node::Node;
use super::prismatic::Prismatic;
use super::revolute::Revolute;
use super::rigid::Rigid;
use super::section::Section;
use crate::mechanism::tree::numbers::LinkNumbers;
use crate::model::PlaneRow;
use loosepin_math::{Plane, PlaneMount, Real, Vec2};

attachments! {
    /// How a body hangs on its parent in the plane.
    PlaneAttachment over Plane { Free, Revolute, Prismatic, Rigid, Section, Node }
}

impl PlaneAttachment {
    /// The section of a beam in a floating frame, where it is one.
    pub fn section(&self) -> Option<Section> {
        if let Self::Section(section) = self { Some(*section) } else { None }
    }

    /// Whether it is a section of a beam: the frame of its body is another link, which has the mass.
    pub fn is_section(&self) -> bool {
        matches!(self, Self::Section(_) | Self::Node(_))
    }

    /// Displaces the second body of its joint from where it is in `centred`, the same numbers without a displacement: of a revolute joint by an
    /// eccentricity in the ground's frame, m; of a prismatic one by an ordinate across the guide's line, m, and an angle, rad. Driven joints are
    /// where their drives put them.
    pub(in crate::mechanism) fn displace<T: Real>(
        &self,
        numbers: &mut LinkNumbers<T>,
        displacement: Vec2<T>,
        centred: &LinkNumbers<T>,
    ) {
        match self {
            Self::Revolute(Revolute { forward, turns_alone: true, .. }) => {
                numbers.eccentricity_m = if *forward { displacement } else { -displacement };
            }
            Self::Prismatic(Prismatic { forward, .. }) => {
                let Vec2 { x: ordinate_m, y: tilt_rad } = displacement;
                // A guide that hangs on its slider is displaced the other way, and turns with its line.
                let (parent_turn_rad, own_turn_rad, ordinate_m) =
                    if *forward { (T::zero(), -tilt_rad, ordinate_m) } else { (-tilt_rad, T::zero(), -ordinate_m) };
                let PlaneMount { parent_angle_rad, own_angle_rad, .. } = centred.mount;
                numbers.mount = PlaneMount::new(parent_angle_rad + parent_turn_rad, own_angle_rad + own_turn_rad);
                numbers.parent_arm_m = centred.parent_arm_m.plus(numbers.mount.parent_direction.turned(), ordinate_m);
            }
            _ => {}
        }
    }
}

impl TreeGeometry for Plane {
    type Attachment = PlaneAttachment;
    type Row = PlaneRow;
}
