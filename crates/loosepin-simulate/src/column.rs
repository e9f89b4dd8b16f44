//! Outputs as columns of numbers, read off the state of a mechanism.

use loosepin_math::{Numbers, Real, Vec2};
use loosepin_mechanics::dynamics::Dynamics;
use loosepin_mechanics::mechanism::{Kinematics, Mechanism, Twist};
use loosepin_mechanics::model::{
    Actuator, Axis, BodyId, Component, Derivative, Effort, JointId, Model, OutputKind, PointId, Position, Relative,
};
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

/// The quantity of a column.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Reading {
    /// A position, m, or angle, rad.
    Position(Position),
    /// Its velocity, m/s or rad/s.
    Velocity(Position),
    /// Its acceleration, m/s² or rad/s².
    Acceleration(Position),
    /// Force of a joint on its second body, N.
    Force(JointId, Component),
    /// Largest stress along a flexible body, Pa.
    Stress(BodyId),
    /// Torque, N m, force, N, or power, W, of a drive or control.
    Effort(Actuator, Effort),
}

/// All columns of a model, in file order.
pub fn columns(model: &Model) -> Vec<Column> {
    let mut columns = Vec::new();
    for (output, written) in model.outputs.iter().enumerate() {
        for (reading, suffix) in readings(&written.kind) {
            let (name, words) = (format!("{}{suffix}", written.name), reading.words(model));
            columns.push(Column { output, name, words, unit: SiUnit::of_dimension(written.kind.dimension()), reading });
        }
    }
    columns
}

/// The quantities of an output, each with what is added to its name.
pub(crate) fn readings(kind: &OutputKind) -> Vec<(Reading, &'static str)> {
    let single = match *kind {
        OutputKind::Motion { of, derivative: Derivative::Position } => Reading::Position(of),
        OutputKind::Motion { of, derivative: Derivative::Velocity } => Reading::Velocity(of),
        OutputKind::Motion { of, derivative: Derivative::Acceleration } => Reading::Acceleration(of),
        OutputKind::Force { joint, component } => Reading::Force(joint, component),
        OutputKind::Stress(body) => Reading::Stress(body),
        OutputKind::Effort { actuator, effort } => Reading::Effort(actuator, effort),
        // No number of an instant.
        OutputKind::Wear { .. } => return Vec::new(),
        OutputKind::Path(point) => {
            let coordinate = |axis| Reading::Position(Position::Point(point, axis));
            return vec![(coordinate(Axis::X), " x"), (coordinate(Axis::Y), " y")];
        }
    };
    vec![(single, "")]
}

impl Reading {
    /// The quantity in words.
    pub fn words(&self, model: &Model) -> String {
        match *self {
            Self::Position(of) => motion_words(model, of, ["", "angle"]),
            Self::Velocity(of) => motion_words(model, of, [" velocity", "angular velocity"]),
            Self::Acceleration(of) => motion_words(model, of, [" acceleration", "angular acceleration"]),
            Self::Force(joint, component) => {
                let part = match component {
                    Component::X => "x force",
                    Component::Y => "y force",
                    Component::Magnitude => "force",
                };
                format!("{part} in {}", model.joints[joint.0].name)
            }
            Self::Stress(body) => format!("largest stress in {}", model.bodies[body.0].name),
            Self::Effort(actuator, effort) => {
                let part = match effort {
                    Effort::Torque => "torque",
                    Effort::Force => "force",
                    Effort::Power => "power",
                };
                match actuator {
                    Actuator::Drive(id) => format!("{part} of drive {}", model.drives[id.0].name),
                    Actuator::Control(id) => format!("{part} of control {}", model.controls[id.0].name),
                }
            }
        }
    }

    /// Whether accelerations or forces are needed, not only positions and velocities.
    pub fn needs_forces(&self) -> bool {
        matches!(self, Self::Acceleration(_) | Self::Force(..) | Self::Stress(_) | Self::Effort(..))
    }

    /// Whether it is a position or an angle, so that its first two time derivatives are velocities and accelerations.
    pub fn is_position(&self) -> bool {
        matches!(self, Self::Position(_))
    }

    /// The value at the last state of `dynamics`, SI.
    #[inline(always)]
    pub fn value<T: Real>(&self, arms: &Arms<T>, dynamics: &Dynamics<'_, T>) -> T {
        let mechanism = dynamics.mechanism();
        let (tree, kinematics) = (&mechanism.real, &dynamics.kinematics);
        match *self {
            Self::Position(of) => of.value(tree, kinematics, |point| arms.of(point)),
            Self::Velocity(of) => of.velocity(tree, kinematics, |point| arms.of(point)),
            Self::Acceleration(of) => {
                of.acceleration(tree, kinematics, |slot| dynamics.acceleration(slot), |point| arms.of(point))
            }
            Self::Force(joint, component) => {
                let force_n = dynamics.joint_force_n(joint);
                match component {
                    Component::X => force_n.x,
                    Component::Y => force_n.y,
                    Component::Magnitude => force_n.length(),
                }
            }
            Self::Stress(body) => dynamics.largest_stress_pa(body),
            Self::Effort(actuator, effort) => {
                let [along, rate] = dynamics.effort_and_rate(actuator);
                match effort {
                    Effort::Torque | Effort::Force => along,
                    Effort::Power => along * rate,
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
            Self::Position(of) => of.jet(&mechanism.real, kinematics, acceleration, |point| arms.of(point)),
            _ => [T::zero(); 3],
        }
    }
}

/// A position or angle in words, with what stands before ` of`, for coordinates and for angles.
fn motion_words(model: &Model, of: Position, [of_point, of_angle]: [&str; 2]) -> String {
    match of {
        Position::Point(point, Axis::X) => format!("x{of_point} of {}", relative_words(model, point)),
        Position::Point(point, Axis::Y) => format!("y{of_point} of {}", relative_words(model, point)),
        Position::Angle(body) => {
            let name = |body: BodyId| &model.bodies[body.0].name;
            let own = format!("{of_angle} of {}", name(body.of));
            body.to.map_or(own.clone(), |to| format!("{own} relative to {}", name(to)))
        }
    }
}

/// A point in words: `slider.pin`, or `rod.tip relative to crank.pin`.
pub fn relative_words(model: &Model, point: Relative<PointId>) -> String {
    let words = |point: PointId| {
        let body = &model.bodies[point.body.0];
        format!("{}.{}", body.name, body.points[point.point].name)
    };
    let own = words(point.of);
    point.to.map_or(own.clone(), |to| format!("{own} relative to {}", words(to)))
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
