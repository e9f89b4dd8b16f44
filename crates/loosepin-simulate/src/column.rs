//! Outputs as columns of numbers, read off the state of a mechanism.

use loosepin_math::{Real, Vec2};
use loosepin_mechanics::dynamics::Dynamics;
use loosepin_mechanics::mechanism::{Kinematics, Mechanism, Twist, acceleration_at};
use loosepin_mechanics::model::{Axis, BodyId, Component, JointId, OutputKind, PointId};
use loosepin_text::units::SiUnit;

/// One number that a model file asks for; a path is two of them.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// Index in [`loosepin_mechanics::model::Model::outputs`].
    pub output: usize,
    /// Name of the output; paths add ` x` and ` y`.
    pub name: String,
    /// Its quantity in words, for example `x of slider.pin`.
    pub words: String,
    /// Its unit.
    pub unit: SiUnit,
    /// The quantity that is read.
    pub reading: Reading,
}

/// The quantity of a column, seen from the ground.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Reading {
    /// Coordinate of a point, m.
    Position(PointId, Axis),
    /// Its velocity, m/s.
    Velocity(PointId, Axis),
    /// Its acceleration, m/s².
    Acceleration(PointId, Axis),
    /// Angle of a body, rad.
    Angle(BodyId),
    /// Its angular velocity, rad/s.
    AngularVelocity(BodyId),
    /// Its angular acceleration, rad/s².
    AngularAcceleration(BodyId),
    /// Force of a joint on its second body, N.
    Force(JointId, Component),
}

/// All columns of a model, in file order.
pub fn columns(mechanism: &Mechanism) -> Vec<Column> {
    let model = &mechanism.model;
    let point_name = |point: PointId| {
        let body = &model.bodies[point.body.0];
        format!("{}.{}", body.name, body.points[point.point].name)
    };
    let axis_name = |axis| match axis {
        Axis::X => "x",
        Axis::Y => "y",
    };
    let mut columns = Vec::new();
    for (output, written) in model.outputs.iter().enumerate() {
        let name = written.name.clone();
        let mut push = |name: String, words: String, unit: SiUnit, reading: Reading| {
            columns.push(Column { output, name, words, unit, reading });
        };
        match written.kind {
            OutputKind::Position { point, along } => {
                let words = format!("{} of {}", axis_name(along), point_name(point));
                push(name, words, SiUnit::LENGTH, Reading::Position(point, along));
            }
            OutputKind::Velocity { point, along } => {
                let words = format!("{} velocity of {}", axis_name(along), point_name(point));
                push(name, words, SiUnit::VELOCITY, Reading::Velocity(point, along));
            }
            OutputKind::Acceleration { point, along } => {
                let words = format!("{} acceleration of {}", axis_name(along), point_name(point));
                push(name, words, SiUnit::ACCELERATION, Reading::Acceleration(point, along));
            }
            OutputKind::Angle(body) => {
                let words = format!("angle of {}", model.bodies[body.0].name);
                push(name, words, SiUnit::ANGLE, Reading::Angle(body));
            }
            OutputKind::AngularVelocity(body) => {
                let words = format!("angular velocity of {}", model.bodies[body.0].name);
                push(name, words, SiUnit::ANGULAR_VELOCITY, Reading::AngularVelocity(body));
            }
            OutputKind::AngularAcceleration(body) => {
                let words = format!("angular acceleration of {}", model.bodies[body.0].name);
                push(name, words, SiUnit::ANGULAR_ACCELERATION, Reading::AngularAcceleration(body));
            }
            OutputKind::Force { joint, component } => {
                let part = match component {
                    Component::X => "x force",
                    Component::Y => "y force",
                    Component::Magnitude => "force",
                };
                let words = format!("{part} in {}", model.joints[joint.0].name);
                push(name, words, SiUnit::FORCE, Reading::Force(joint, component));
            }
            OutputKind::Path(point) => {
                for axis in [Axis::X, Axis::Y] {
                    let words = format!("{} of {}", axis_name(axis), point_name(point));
                    let name = format!("{name} {}", axis_name(axis));
                    push(name, words, SiUnit::LENGTH, Reading::Position(point, axis));
                }
            }
        }
    }
    columns
}

impl Reading {
    /// Whether accelerations or forces are needed, not only positions and velocities.
    pub fn needs_forces(&self) -> bool {
        matches!(self, Self::Acceleration(..) | Self::AngularAcceleration(_) | Self::Force(..))
    }

    /// Whether it is a position or an angle, so that its first two time derivatives are velocities and accelerations.
    pub fn is_position(&self) -> bool {
        matches!(self, Self::Position(..) | Self::Angle(_))
    }

    /// The value at the last state of `dynamics`, SI.
    #[inline(always)]
    pub fn value<T: Real>(&self, arms: &Arms<T>, dynamics: &Dynamics<'_, T>) -> T {
        let mechanism = dynamics.mechanism();
        let slot = |body: BodyId| mechanism.real.slot_of_body[body.0];
        match *self {
            Self::Position(point, axis) => {
                let pose = &dynamics.kinematics.poses[slot(point.body)];
                along(pose.point_m(arms.of(point)), axis)
            }
            Self::Velocity(point, axis) => {
                let slot = slot(point.body);
                let arm = dynamics.kinematics.poses[slot].turn(arms.of(point));
                along(dynamics.kinematics.twists[slot].at(arm), axis)
            }
            Self::Acceleration(point, axis) => {
                let slot = slot(point.body);
                let arm = dynamics.kinematics.poses[slot].turn(arms.of(point));
                let change = dynamics.acceleration(slot);
                along(acceleration_at(&change, &dynamics.kinematics.twists[slot], arm), axis)
            }
            Self::Angle(body) => dynamics.kinematics.poses[slot(body)].angle_rad,
            Self::AngularVelocity(body) => dynamics.kinematics.twists[slot(body)].angular,
            Self::AngularAcceleration(body) => dynamics.acceleration(slot(body)).angular,
            Self::Force(joint, component) => {
                let force_n = dynamics.joint_force_n(joint);
                match component {
                    Component::X => force_n.x,
                    Component::Y => force_n.y,
                    Component::Magnitude => force_n.length(),
                }
            }
        }
    }

    /// Value and first two time derivatives of a position or angle at the last state of `dynamics`.
    #[inline(always)]
    pub fn jet<T: Real>(&self, arms: &Arms<T>, dynamics: &Dynamics<'_, T>) -> [T; 3] {
        self.position_jet(arms, dynamics.mechanism(), &dynamics.kinematics, |slot| dynamics.acceleration(slot))
    }

    /// The value from poses and velocities by slot of the real tree, and the acceleration of each slot. Zeros for what is
    /// neither a position nor an angle.
    #[inline(always)]
    pub fn position_jet<T: Real>(
        &self,
        arms: &Arms<T>,
        mechanism: &Mechanism,
        kinematics: &Kinematics<T>,
        acceleration: impl Fn(usize) -> Twist<T>,
    ) -> [T; 3] {
        match *self {
            Self::Position(point, axis) => {
                let slot = mechanism.real.slot_of_body[point.body.0];
                let (pose, twist) = (&kinematics.poses[slot], &kinematics.twists[slot]);
                let arm = pose.turn(arms.of(point));
                let change = acceleration_at(&acceleration(slot), twist, arm);
                [along(pose.position_m + arm, axis), along(twist.at(arm), axis), along(change, axis)]
            }
            Self::Angle(body) => {
                let slot = mechanism.real.slot_of_body[body.0];
                [kinematics.poses[slot].angle_rad, kinematics.twists[slot].angular, acceleration(slot).angular]
            }
            _ => [T::zero(); 3],
        }
    }
}

#[inline(always)]
fn along<T>(vector: Vec2<T>, axis: Axis) -> T {
    match axis {
        Axis::X => vector.x,
        Axis::Y => vector.y,
    }
}

/// Positions of all points of a model in their body frames, for one sample or one a lane.
#[derive(Debug, Clone)]
pub struct Arms<T = f64>(Vec<Vec<Vec2<T>>>);

impl Arms {
    /// Reads the points of `mechanism` from `values`.
    pub fn new(mechanism: &Mechanism, values: &loosepin_mechanics::model::Values) -> Self {
        let model = &mechanism.model;
        let of_body = |body: &loosepin_mechanics::model::Body| {
            body.points.iter().map(|p| Vec2::new(values[p.position_m[0]], values[p.position_m[1]])).collect()
        };
        Self(model.bodies.iter().map(of_body).collect())
    }
}

impl Arms {
    /// Every coordinate, in the order of [`Arms::visit`].
    pub fn numbers(&self) -> Vec<f64> {
        self.0.iter().flatten().flat_map(|point| [point.x, point.y]).collect()
    }

    /// No points: for runs whose outputs are not followed.
    pub fn none() -> Self {
        Self(Vec::new())
    }
}

impl<T: Real> Arms<T> {
    /// Position of `point` in its body's frame, m.
    #[inline(always)]
    pub fn of(&self, point: PointId) -> Vec2<T> {
        self.0[point.body.0][point.point]
    }

    /// Shows every coordinate, in the order of the model.
    pub fn visit(&mut self, visit: &mut impl FnMut(&mut T)) {
        self.0.iter_mut().flatten().for_each(|point| point.visit(visit));
    }

    /// The points of `from` as constants of `T`.
    pub fn broadcast(arms: &Arms) -> Self {
        Self(arms.0.iter().map(|body| body.iter().map(|point| Vec2::from_f64(*point)).collect()).collect())
    }
}
