//! The geometry of a picture: what is drawn of bodies, joints and drives, each in the frame of its body, and paths of points with where play
//! takes them. Projection, depth and colours are no part of it.
//!
//! | Drawn | File |
//! |---|---|
//! | sizes of what has none of its own | `sizes.rs` |
//! | a body between its points; the faces of a body with many | `bodies.rs`; `hull.rs` |
//! | a joint by the sign of its kind | `joints.rs`, of simple shapes in `shapes.rs` |
//! | feet on the ground; arrows of drives | `ground.rs`; `drives.rs` |
//! | paths of points, and zones of play about them | `traces.rs` |

mod bodies;
mod drives;
mod ground;
mod hull;
mod joints;
mod shapes;
mod sizes;
mod traces;

use crate::geometry::pose::Pose;
use crate::geometry::vector::Vec3;
use crate::kind::kind_of_joint::KindOfJoint;
use crate::mechanism::joint::Joint;
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use loosepin_result::spatial_picture::{
    PictureBody, PictureEnd, PictureJoint, PicturePoint, PicturePose, SpatialPicture,
};
use sizes::Sizes;

pub(crate) use traces::{TracedPoint, traces};

/// A mechanism in the positions in which it is drawn.
#[derive(Debug, Clone, Copy)]
pub struct PictureSource<'a> {
    /// The mechanism.
    pub mechanism: &'a SpatialMechanism,
    /// Pose of each body, for each position.
    pub poses: &'a [Vec<Pose>],
    /// Named points of each body, in its frame.
    pub points: &'a [Vec<(String, Vec3)>],
    /// Speed of each drive, rad/s or m/s; its sign is the direction of the arrow.
    pub speeds: &'a [f64],
}

impl PictureSource<'_> {
    /// The picture, without paths of points.
    pub fn picture(&self) -> SpatialPicture {
        let sizes = Sizes::of(self);
        let mut elements = bodies::elements(self, &sizes);
        for number in 0..self.mechanism.joints().len() {
            elements.extend(joints::elements(self, number, &sizes));
            elements.extend(ground::elements(self, number, &sizes));
        }
        elements.extend(drives::elements(self, &sizes));
        SpatialPicture {
            extent_m: sizes.extent_m,
            bodies: self.bodies(),
            joints: self.mechanism.joints().iter().map(picture_joint).collect(),
            elements,
            poses: self.poses.iter().map(|poses| poses.iter().map(picture_pose).collect()).collect(),
            traces: Vec::new(),
        }
    }

    fn bodies(&self) -> Vec<PictureBody> {
        let points = |number: usize| self.points.get(number).into_iter().flatten();
        let bodies = self.mechanism.bodies().iter().enumerate();
        bodies
            .map(|(number, body)| PictureBody {
                name: body.name.clone(),
                points: points(number)
                    .map(|(name, at)| PicturePoint { name: name.clone(), at_m: at.to_array() })
                    .collect(),
            })
            .collect()
    }
}

fn picture_joint(joint: &Joint) -> PictureJoint {
    let sign = if joint.kind.slides() { &joint.journal } else { &joint.bearing };
    PictureJoint {
        name: joint.name.clone(),
        kind: joint.kind.word().to_owned(),
        body: joint.bearing.body,
        at_m: joint.bearing.point_m.to_array(),
        axis: joint.bearing.axes.z.to_array(),
        has_play: joint.play.is_some(),
        sign_body: sign.body,
        sign_at_m: sign.point_m.to_array(),
        ends: [&joint.bearing, &joint.journal]
            .map(|marker| PictureEnd { body: marker.body, at_m: marker.point_m.to_array() }),
    }
}

fn picture_pose(pose: &Pose) -> PicturePose {
    let turn = pose.orientation;
    PicturePose { at_m: pose.position_m.to_array(), turn: [turn.w, turn.vector.x, turn.vector.y, turn.vector.z] }
}
