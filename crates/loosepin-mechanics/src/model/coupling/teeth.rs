//! Teeth whose force the joints of their wheels feel.

use super::reading::CouplingReader;
use crate::model::ids::JointId;
use crate::model::joint::span_of;
use crate::model::problem::ModelProblem;
use loosepin_math::{Real, Vec2};
use loosepin_text::document::{Entry, Key, Table, optional, quantity};
use loosepin_text::numbers::QuantityId;
use loosepin_text::units::{Dimension as D, Rule};

/// The teeth of gears, or of a rack and its pinion, whose force the two joints feel.
#[derive(Debug, Clone, Copy)]
pub struct Teeth {
    /// Pressure angle α at the pitch circles, rad, in [0, 45 deg).
    pub pressure_angle_rad: QuantityId,
    /// Pitch radii on the first and on the second joint, m; `None` for a rack.
    pub radii_m: [Option<QuantityId>; 2],
    /// How they mesh.
    pub mesh: Mesh,
    /// Whether the body with the teeth is the second of its joint (journal, slider), not the first; of both joints.
    pub is_second: [bool; 2],
}

/// How teeth mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mesh {
    /// Two gears beside each other.
    External,
    /// A gear in a ring.
    Internal,
    /// A pinion on a rack.
    Rack {
        /// Whether the rack goes against the line of its guide when the pinion turns from x towards y.
        is_backward: bool,
    },
}

/// Largest relative difference of the distance of two gears from that of their pitch radii: rounded numbers of a drawing.
const MAX_MISFIT: f64 = 0.01;

impl Mesh {
    /// Whether the second one moves along a line: along it the coupling acts already.
    pub fn is_rack(self) -> bool {
        matches!(self, Self::Rack { .. })
    }

    /// How far the centres of the wheels must be apart, m; `None` if the model does not say where the teeth are.
    pub fn distance_m(self, [first_m, second_m]: [f64; 2]) -> Option<f64> {
        match self {
            Self::External => Some(first_m + second_m),
            Self::Internal => Some((first_m - second_m).abs()),
            Self::Rack { .. } => None,
        }
    }

    /// Whether the centres are as far apart as the pitch radii demand, `due_m`.
    pub fn fits(self, distance_m: f64, due_m: f64) -> bool {
        due_m > 0.0 && (distance_m - due_m).abs() <= MAX_MISFIT * due_m
    }

    /// The force on the second wheel along the common tangent of the pitch circles and across it, N, in the ground's frame, where
    /// `on_wheel` is its torque, N m, or its force along the line, N. `slope` is tan α; `line` is the direction of a rack, `centres_m`
    /// are those of two wheels.
    pub fn force_n<T: Real>(
        self,
        on_wheel: T,
        slope: T,
        radii_m: [T; 2],
        line: impl FnOnce() -> Vec2<T>,
        centres_m: impl FnOnce() -> [Vec2<T>; 2],
    ) -> [Vec2<T>; 2] {
        match self {
            Self::Rack { is_backward } => {
                // From the pinion to the pitch point: on the right of the line where the rack goes along it.
                let line = line();
                let outwards = if is_backward { line.turned() } else { -line.turned() };
                [line * on_wheel, outwards * (on_wheel.abs() * slope)]
            }
            Self::External | Self::Internal => {
                let [first_m, second_m] = centres_m();
                let gap_m = second_m - first_m;
                let direction = gap_m * (T::one() / gap_m.length());
                // The pitch point lies behind the second centre, seen from the first, where the first wheel is the ring.
                let is_external = self == Self::External;
                let is_in_first = radii_m[1].less_than(radii_m[0]);
                let tangential_n = on_wheel / radii_m[1];
                let behind_n =
                    if is_external { -tangential_n } else { T::select(is_in_first, tangential_n, -tangential_n) };
                let size_n = tangential_n.abs() * slope;
                let apart_n = if is_external { size_n } else { -size_n };
                [direction.turned() * behind_n, direction * apart_n]
            }
        }
    }
}

/// The key of the pressure angle.
pub(super) const PRESSURE_ANGLE: Key = optional(
    "pressure_angle",
    quantity(D::ANGLE, Rule::PressureAngle),
    "\"20 deg\"",
    "pressure angle at the pitch circles: both joints carry the force of the teeth; if omitted, only torques act",
);

impl Teeth {
    /// Reads the teeth whose force the joints feel from a table, with its entries for the pressure angle and the second joint; the outer
    /// option is absent after a diagnostic, the inner where torques alone act.
    pub(super) fn read(
        (table, pressure_angle, second): (&Table<'_>, &Option<Entry<'_>>, &Option<Entry<'_>>),
        joints: [JointId; 2],
        radii_m: [Option<QuantityId>; 2],
        mesh: Mesh,
        reader: &mut dyn CouplingReader,
    ) -> Option<Option<Self>> {
        let Some(entry) = pressure_angle else { return Some(None) };
        let pressure_angle_rad = reader.quantity_at(entry);
        let described = || table.path.describe();
        if radii_m == [None; 2] {
            return reader.document().refuse(&ModelProblem::ForceNeedsRadii { entry: described() }, entry.key_span);
        }
        for joint in joints {
            let problem = if reader.joint_kind(joint).play().is_some() {
                ModelProblem::ForceOnPlay { entry: described(), joint: reader.joint_name(joint) }
            } else if reader.has_friction(joint) {
                ModelProblem::ForceOnFriction { entry: described(), joint: reader.joint_name(joint) }
            } else {
                continue;
            };
            return reader.document().refuse(&problem, entry.key_span);
        }
        // A force along the line of a joint that turns as well, such as a slot, is not that of a rack; gears need joints with an angle.
        let kind = reader.joint_kind(joints[1]);
        if kind.slides() && !kind.holds_angle() {
            let problem = ModelProblem::ForceOnSlot { entry: described(), joint: reader.joint_name(joints[1]) };
            return reader.document().refuse(&problem, span_of(second, table));
        }
        let [a, b] = joints.map(|joint| reader.joint_kind(joint).bodies());
        // The common body carries both; a wheel is the other one.
        let is_second = [b.contains(&a[0]), a.contains(&b[0])];
        Some(Some(Self { pressure_angle_rad: pressure_angle_rad?, radii_m, mesh, is_second }))
    }
}
