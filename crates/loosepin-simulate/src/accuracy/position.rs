//! Outputs of which the quasi-static answer speaks: coordinates of points and angles of bodies.

use crate::column::{self, Reading};
use loosepin_math::{Real, Vec2};
use loosepin_mechanics::mechanism::{Kinematics, Mechanism, Tree, Twist, acceleration_at};
use loosepin_mechanics::model::{Axis, BodyId, OutputKind, PointId};
use loosepin_text::units::SiUnit;

/// A coordinate of a point or the angle of a body.
#[derive(Debug, Clone, PartialEq)]
pub struct PositionOutput {
    /// Name of the output of the model; paths add ` x` and ` y`.
    pub name: String,
    /// Its quantity in words, for example `x of slider.pin`.
    pub words: String,
    /// Unit of its values.
    pub unit: SiUnit,
    /// The quantity that is read.
    pub reading: PositionReading,
}

/// The quantity of a [`PositionOutput`], seen from the ground.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PositionReading {
    /// Coordinate of a point, m.
    Point(PointId, Axis),
    /// Angle of a body, rad.
    Angle(BodyId),
}

/// The position outputs of a model in file order, each once.
///
/// A velocity or acceleration stands for the position that it is the derivative of, unless another output names that
/// position already. Other outputs, such as forces, belong to no position.
pub fn position_outputs(mechanism: &Mechanism) -> Vec<PositionOutput> {
    let outputs = &mechanism.model.outputs;
    let is_position =
        |kind: &OutputKind| matches!(kind, OutputKind::Position { .. } | OutputKind::Angle(_) | OutputKind::Path(_));
    let mut found: Vec<(usize, PositionOutput)> = Vec::new();
    for derivatives in [false, true] {
        for (index, output) in outputs.iter().enumerate().filter(|(_, o)| is_position(&o.kind) != derivatives) {
            for (reading, suffix) in readings(&output.kind) {
                let is_known = found.iter().any(|(_, known)| known.reading == reading);
                if derivatives && is_known {
                    continue;
                }
                let (words, unit) = describe(mechanism, reading);
                let name = format!("{}{suffix}", output.name);
                found.push((index, PositionOutput { name, words, unit, reading }));
            }
        }
    }
    found.sort_by_key(|(index, _)| *index);
    found.into_iter().map(|(_, output)| output).collect()
}

/// The positions behind an output, with what is added to its name.
fn readings(kind: &OutputKind) -> impl Iterator<Item = (PositionReading, &'static str)> {
    let position = |reading: Reading| match reading {
        Reading::Position(point, along) | Reading::Velocity(point, along) | Reading::Acceleration(point, along) => {
            Some(PositionReading::Point(point, along))
        }
        Reading::Angle(body) | Reading::AngularVelocity(body) | Reading::AngularAcceleration(body) => {
            Some(PositionReading::Angle(body))
        }
        _ => None,
    };
    column::readings(kind).into_iter().filter_map(move |(reading, suffix)| Some((position(reading)?, suffix)))
}

fn describe(mechanism: &Mechanism, reading: PositionReading) -> (String, SiUnit) {
    let (reading, unit) = match reading {
        PositionReading::Point(point, along) => (Reading::Position(point, along), SiUnit::LENGTH),
        PositionReading::Angle(body) => (Reading::Angle(body), SiUnit::ANGLE),
    };
    (reading.words(&mechanism.model), unit)
}

impl PositionReading {
    /// The value, m or rad. `arm_m` gives the position of a point in its body's frame.
    pub fn value<T: Real>(self, tree: &Tree, kinematics: &Kinematics<T>, arm_m: &dyn Fn(PointId) -> Vec2<T>) -> T {
        match self {
            Self::Point(point, axis) => {
                let pose = &kinematics.poses[tree.slot_of_body[point.body.0]];
                along(pose.point_m(arm_m(point)), axis)
            }
            Self::Angle(body) => kinematics.poses[tree.slot_of_body[body.0]].angle_rad,
        }
    }

    /// Its first and second time derivative. `acceleration` gives the acceleration of the frame in a slot.
    pub fn rates(
        self,
        tree: &Tree,
        kinematics: &Kinematics<f64>,
        acceleration: impl Fn(usize) -> Twist<f64>,
        arm_m: &dyn Fn(PointId) -> Vec2<f64>,
    ) -> [f64; 2] {
        match self {
            Self::Point(point, axis) => {
                let slot = tree.slot_of_body[point.body.0];
                let arm = kinematics.poses[slot].turn(arm_m(point));
                let twist = &kinematics.twists[slot];
                [twist.at(arm), acceleration_at(&acceleration(slot), twist, arm)].map(|vector| along(vector, axis))
            }
            Self::Angle(body) => {
                let slot = tree.slot_of_body[body.0];
                [kinematics.twists[slot].angular, acceleration(slot).angular]
            }
        }
    }
}

fn along<T: Real>(vector: Vec2<T>, axis: Axis) -> T {
    match axis {
        Axis::X => vector.x,
        Axis::Y => vector.y,
    }
}
