//! Outputs of which the quasi-static answer speaks: coordinates of points and angles of bodies.

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
/// position already. Forces belong to no position.
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
fn readings(kind: &OutputKind) -> Vec<(PositionReading, &'static str)> {
    match *kind {
        OutputKind::Position { point, along }
        | OutputKind::Velocity { point, along }
        | OutputKind::Acceleration { point, along } => vec![(PositionReading::Point(point, along), "")],
        OutputKind::Angle(body) | OutputKind::AngularVelocity(body) | OutputKind::AngularAcceleration(body) => {
            vec![(PositionReading::Angle(body), "")]
        }
        OutputKind::Path(point) => {
            vec![(PositionReading::Point(point, Axis::X), " x"), (PositionReading::Point(point, Axis::Y), " y")]
        }
        OutputKind::Force { .. } => Vec::new(),
    }
}

fn describe(mechanism: &Mechanism, reading: PositionReading) -> (String, SiUnit) {
    let bodies = &mechanism.model.bodies;
    match reading {
        PositionReading::Point(point, along) => {
            let axis = match along {
                Axis::X => "x",
                Axis::Y => "y",
            };
            let body = &bodies[point.body.0];
            (format!("{axis} of {}.{}", body.name, body.points[point.point].name), SiUnit::LENGTH)
        }
        PositionReading::Angle(body) => (format!("angle of {}", bodies[body.0].name), SiUnit::ANGLE),
    }
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
