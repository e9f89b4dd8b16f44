//! The picture of a mechanism: all that is drawn of it.

use super::sizes::Sizes;
use super::source::PictureSource;
use super::{bodies, drives, ground, joints};
use crate::mechanism::joint::Joint;
use loosepin_math::Pose;
use loosepin_result::spatial_picture::{
    PictureBody, PictureEnd, PictureJoint, PicturePoint, PicturePose, SpatialPicture,
};

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
