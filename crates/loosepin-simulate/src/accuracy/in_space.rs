//! A planar mechanism as one in space, seen along z.
//!
//! Where constraints of joints repeat each other, the plays have to meet conditions together: the bar of a third crank that is a little too long
//! must be taken up by the play of the others. The plane counts each play alone; space knows the conditions. So such a mechanism is laid into space, with
//! pins about z that do not lean, and asked there.
//!
//! So is a mechanism whose pins lean out of the plane: each body lies in its layer, as far above the plane of the drawing as its offset, a joint
//! in the layer of its first body, which has the bearing, and an output in that of its own. All frames lie in the plane of the drawing.

use super::play_reach::PlayReach;
use loosepin_math::{Pose, Quaternion, Vec2, Vec3};
use loosepin_mechanics::mechanism::{IdealMotion, Mechanism, point_m};
use loosepin_mechanics::model::{Axis, BodyId, Clearance, Model, PlayId, PointId, Position, TreeAttachment, Values};
use loosepin_space::{
    Body, Drive, DriveValue, Joint, JointCoordinate, Marker, PointOutput, Position as PositionInSpace, Prismatic,
    Revolute, RevolutePlay, Rigid, RotationOutput, SpatialMechanism, SpatialOutput, SpatialPlay, UprightPlay, assemble,
};

/// A mechanism laid into space.
pub(super) struct InSpace<'a> {
    mechanism: &'a Mechanism,
    values: &'a Values,
    joints: Vec<Joint>,
    drives: Vec<Drive>,
    /// Number of the joint of each play.
    joint_of_play: Vec<usize>,
}

impl<'a> InSpace<'a> {
    /// Of a mechanism with these plays. `leans`: whether its pins lean in their bearings.
    ///
    /// # Errors
    /// Why it cannot be laid into space, in words.
    pub fn new(
        mechanism: &'a Mechanism,
        values: &'a Values,
        reaches: &[PlayReach],
        leans: bool,
    ) -> Result<Self, String> {
        let model = &mechanism.model;
        if let Some(coupling) = model.couplings.first() {
            return Err(format!("there is none of {}", loosepin_mechanics::model::describe_path(&coupling.path)));
        }
        let mut joints = Vec::new();
        for joint in &model.joints {
            let laid = laid(mechanism, values, &joint.kind, &joint.name);
            joints.push(laid.ok_or_else(|| format!("there is none like joint '{}'", joint.name))?);
        }
        let mut joint_of_play = Vec::new();
        for (play, reach) in mechanism.plays.iter().zip(reaches) {
            let (PlayId::Joint(joint), PlayReach::Disc { radius_m }) = (*play, *reach) else {
                return Err(format!("there is no play like that of '{}'", model.play_name(*play)));
            };
            joints[joint.0].play = Some(pin_play(model.joints[joint.0].kind.pin_clearance(), values, radius_m, leans));
            joint_of_play.push(joint.0);
        }
        let drive = |own: &loosepin_mechanics::model::DriveId| {
            let joint = model.drives[own.0].joint;
            let slides = model.joints[joint.0].kind.slides();
            let coordinate = if slides { JointCoordinate::Slide } else { JointCoordinate::Angle };
            Drive { joint: joint.0, coordinate }
        };
        let drives = mechanism.ideal.drives.iter().map(drive).collect();
        Ok(Self { mechanism, values, joints, drives, joint_of_play })
    }

    /// The mechanism where it is in a state, and its closed position there.
    ///
    /// # Errors
    /// Why there is none, in words.
    pub fn at(&self, state: &IdealMotion<'_>) -> Result<(SpatialMechanism, PositionInSpace), String> {
        let (model, tree) = (&self.mechanism.model, &self.mechanism.ideal);
        let moving = model.bodies.iter().zip(&tree.slot_of_body).skip(1).map(|(body, slot)| {
            let pose = &state.kinematics().poses[*slot];
            let orientation = Quaternion::from_rotation_vector(Vec3::Z * pose.angle_rad());
            Body::new(body.name.clone(), Pose { position_m: lifted(pose.position_m), orientation })
        });
        let bodies = std::iter::once(Body::ground()).chain(moving).collect();
        let mechanism = SpatialMechanism::new(bodies, self.joints.clone(), self.drives.clone());
        let mechanism = mechanism.map_err(|error| error.to_string())?;
        let values = &state.coordinates()[tree.free..];
        let drives: Vec<DriveValue> = values.iter().map(|value| DriveValue::at_rate(*value, 0.0)).collect();
        let position = assemble(&mechanism, &drives).map_err(|error| error.to_string())?;
        match position.is_other_start {
            true => Err("the joints do not close there as in the plane".to_owned()),
            false => Ok((mechanism, position)),
        }
    }

    /// The number of the joint of each play.
    pub fn joint_of_play(&self) -> &[usize] {
        &self.joint_of_play
    }

    /// A sum of readings: a coordinate or an angle, or a displacement of one point along a direction. `None` of another one, and of one that is
    /// seen from a body.
    pub fn output(&self, readings: &[Position], weights: &[(usize, f64)]) -> Option<SpatialOutput> {
        match *weights {
            [(place, 1.0)] => match readings[place] {
                Position::Angle(angle) if angle.to.is_none() => {
                    Some(RotationOutput { body: angle.of.0, axis: Vec3::Z }.into())
                }
                Position::Point(point, axis) if point.to.is_none() => {
                    let [along_x, along_y, _] = self.displacement_of(point.of);
                    Some(if axis == Axis::X { along_x } else { along_y })
                }
                Position::Angle(_) | Position::Point(..) => None,
            },
            [(x, along_x), (y, along_y)] => {
                let direction = lifted(Vec2::new(along_x, along_y));
                let first = self.displacement(readings, [x, y])?[0].point()?;
                Some(PointOutput { direction, ..first }.into())
            }
            _ => None,
        }
    }

    /// The displacement along x, y and z of the point with its coordinates at two places of the readings. `None` of one that is seen from a body.
    pub fn displacement(&self, readings: &[Position], [x, y]: [usize; 2]) -> Option<[SpatialOutput; 3]> {
        match (readings[x], readings[y]) {
            (Position::Point(point, Axis::X), Position::Point(other, Axis::Y))
                if point == other && point.to.is_none() =>
            {
                Some(self.displacement_of(point.of))
            }
            _ => None,
        }
    }

    fn displacement_of(&self, point: PointId) -> [SpatialOutput; 3] {
        let model = &self.mechanism.model;
        let layer = Vec3::Z * layer_m(model, self.values, point.body);
        SpatialOutput::displacement(point.body.0, lifted(point_m(model, self.values, point)) + layer)
    }
}

/// Whether a mechanism is asked in space: its plays must meet conditions together, or its pins lean.
pub(super) fn is_asked_in_space(mechanism: &Mechanism) -> bool {
    !mechanism.plays.is_empty() && mechanism.ideal.is_redundant() || mechanism.has_leaning_pins()
}

/// The play of a pin of this radial clearance: in a bearing in which it leans, or upright.
fn pin_play(clearance: Option<&Clearance>, values: &Values, radial_clearance_m: f64, leans: bool) -> SpatialPlay {
    let axial_clearance_m = clearance.and_then(|own| own.axial_clearance_m).map_or(0.0, |id| values[id]);
    match clearance.and_then(|own| own.bearing_length_m).filter(|_| leans) {
        Some(length) => RevolutePlay { bearing_length_m: values[length], radial_clearance_m, axial_clearance_m }.into(),
        None => UprightPlay { radial_clearance_m, axial_clearance_m: 0.0 }.into(),
    }
}

/// How far a body lies above the plane of the drawing, m.
fn layer_m(model: &Model, values: &Values, body: BodyId) -> f64 {
    model.bodies[body.0].offset_m.map_or(0.0, |id| values[id])
}

/// A vector of the plane in space.
pub(super) fn lifted(vector: Vec2<f64>) -> Vec3 {
    Vec3::new(vector.x, vector.y, 0.0)
}

/// A joint in space: a pin about z, a guide along its line, or both bodies as one; `None` of others.
fn laid(
    mechanism: &Mechanism,
    values: &Values,
    kind: &loosepin_mechanics::model::JointKind,
    name: &str,
) -> Option<Joint> {
    let model = &mechanism.model;
    let angles_rad = kind.angles_rad().map(|angle_rad| angle_rad.map_or(0.0, |angle_rad| values[angle_rad]));
    let layer = Vec3::Z * layer_m(model, values, kind.bodies()[0]);
    let marker = |side: usize, along_line: bool| {
        let point = kind.points()[side];
        let place_m = lifted(point_m(model, values, point)) + layer;
        let (sine, cosine) = angles_rad[side].sin_cos();
        let line = Vec3::new(cosine, sine, 0.0);
        let [z_axis, x_axis] = if along_line { [line, Vec3::Z] } else { [Vec3::Z, line] };
        Marker::new(point.body.0, place_m, z_axis, x_axis)
    };
    let markers = |along_line: bool| Some((marker(0, along_line)?, marker(1, along_line)?));
    Some(match kind.tree_attachment() {
        TreeAttachment::Turning => {
            let (first, second) = markers(false)?;
            Joint::new(name, Revolute, first, second)
        }
        TreeAttachment::Sliding => {
            let (first, second) = markers(true)?;
            Joint::new(name, Prismatic, first, second)
        }
        TreeAttachment::Fixed => {
            let (first, second) = markers(false)?;
            Joint::new(name, Rigid, first, second)
        }
        TreeAttachment::Never => return None,
    })
}
