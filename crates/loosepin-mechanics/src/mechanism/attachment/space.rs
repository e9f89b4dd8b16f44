//! The attachments of space. Other joints close loops between bodies that hang by these.

use super::ball::Ball;
use super::form::TreeGeometry;
use super::free::Free;
use super::list::attachments;
use super::prismatic::Prismatic;
use super::revolute::Revolute;
use super::rigid::Rigid;
use crate::model::SpaceRow;
use loosepin_math::Space;

attachments! {
    /// How a body hangs on its parent in space.
    SpaceAttachment over Space { Free, Revolute, Prismatic, Rigid, Ball }
}

impl TreeGeometry for Space {
    type Attachment = SpaceAttachment;
    type Row = SpaceRow;
}
