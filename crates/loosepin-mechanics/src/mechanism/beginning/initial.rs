//! The conditions of the initial state of a mechanism that its drives do not move alone: loops and given values together.

use crate::mechanism::error::MechanismError;
use crate::mechanism::loops::constraints;
use crate::mechanism::parts::drive::Drives;
use crate::mechanism::tree::kinematics::Kinematics;
use crate::mechanism::tree::numbers::TreeNumbers;
use crate::mechanism::tree::spanning_tree::Tree;
use crate::model::{Axis, InitialNumber, InitialOf, InitialValue, JointId, Model, Values};
use loosepin_math::Vec2;

/// The numbers of the initial state of a sample, in the order of the model; m, rad, m/s or rad/s.
pub fn initial_numbers(model: &Model, values: &Values) -> Vec<f64> {
    let references = Drives::of_controls(model, values);
    let number = |initial: &InitialValue| match initial.number {
        InitialNumber::Given(id) => values[id],
        InitialNumber::Reference { control } => {
            references.law_at(&model.controls[control].reference, control, 0.0)[usize::from(initial.is_rate)]
        }
    };
    model.initial.iter().map(number).collect()
}

/// Conditions on the position, or on the rates, that are given.
pub fn conditions(model: &Model, is_rate: bool) -> impl Iterator<Item = (usize, &InitialValue)> {
    model.initial.iter().enumerate().filter(move |(_, initial)| initial.is_rate == is_rate)
}

/// The present value of what a condition is about, and its gradient over all coordinates, added to `row`.
pub fn value_and_gradient(
    model: &Model,
    tree: &Tree,
    geometry: &TreeNumbers<f64>,
    kinematics: &Kinematics<f64>,
    of: InitialOf,
    row: &mut [f64],
) -> f64 {
    let mut turn = |slot: usize, sign: f64| {
        for column in kinematics.columns(tree, slot) {
            row[column.coordinate] += sign * column.turning;
        }
        sign * kinematics.poses[slot].angle_rad()
    };
    match of {
        InitialOf::BodyAngle(body) => turn(tree.slot_of_body[body.0], 1.0),
        InitialOf::JointAngle(joint) => {
            let [i, j] = model.joints[joint.0].kind.bodies().map(|body| tree.slot_of_body[body.0]);
            turn(j, 1.0) + turn(i, -1.0)
        }
        InitialOf::BodyPosition(body, axis) => {
            let slot = tree.slot_of_body[body.0];
            let along = |vector: Vec2<f64>| match axis {
                Axis::X => vector.x,
                Axis::Y => vector.y,
            };
            for column in kinematics.columns(tree, slot) {
                row[column.coordinate] += along(column.linear);
            }
            along(kinematics.poses[slot].position_m)
        }
        InitialOf::JointPosition(joint) => {
            let Some((slots, arms_m, line_rad)) = guide(model, tree, geometry, joint) else { return f64::NAN };
            let poses = slots.map(|slot| kinematics.poses[slot]);
            let arms = [0, 1].map(|side| poses[side].turn(arms_m[side]));
            let gap = poses[1].position_m + arms[1] - poses[0].position_m - arms[0];
            let (sine, cosine) = loosepin_math::sin_cos(poses[0].angle_rad() + line_rad);
            let line = Vec2::new(cosine, sine);
            for (side, sign) in [(0, -1.0), (1, 1.0)] {
                for column in kinematics.columns(tree, slots[side]) {
                    row[column.coordinate] += sign * line.dot(column.at(arms[side]));
                    if side == 0 {
                        // The line turns with the guide.
                        row[column.coordinate] += column.turning * line.turned().dot(gap);
                    }
                }
            }
            line.dot(gap)
        }
    }
}

/// Slots of guide and slider of a prismatic joint, its points in their frames, and the angle of its line in the guide's.
fn guide(
    model: &Model,
    tree: &Tree,
    geometry: &TreeNumbers<f64>,
    joint: JointId,
) -> Option<([usize; 2], [Vec2<f64>; 2], f64)> {
    let slots = model.joints[joint.0].kind.bodies().map(|body| tree.slot_of_body[body.0]);
    let of_link = tree.links.iter().zip(&geometry.links).find_map(|(link, numbers)| match link.joint() {
        Some((own, true)) if own == joint => {
            Some(([numbers.parent_arm_m, numbers.own_arm_m], numbers.mount.parent_angle_rad))
        }
        Some((own, false)) if own == joint => {
            Some(([numbers.own_arm_m, numbers.parent_arm_m], numbers.mount.own_angle_rad))
        }
        _ => None,
    });
    let of_cut = || {
        let cut = tree.cuts.iter().position(|cut| cut.joint == joint)?;
        let numbers = &geometry.cuts[cut];
        Some((numbers.arms_m, numbers.markers[0]))
    };
    let (arms_m, line_rad) = of_link.or_else(of_cut)?;
    Some((slots, arms_m, line_rad))
}

/// Loop equations and conditions on the position as one system: residuals, and their Jacobian over all coordinates.
pub struct StartEquations<'a> {
    /// The model.
    pub model: &'a Model,
    /// Its ideal tree.
    pub tree: &'a Tree,
    /// The numbers of the sample.
    pub geometry: &'a TreeNumbers<f64>,
    /// Given values by index of the model's list.
    numbers: &'a [f64],
}

impl<'a> StartEquations<'a> {
    /// For a sample.
    pub fn new(model: &'a Model, tree: &'a Tree, geometry: &'a TreeNumbers<f64>, numbers: &'a [f64]) -> Self {
        Self { model, tree, geometry, numbers }
    }

    /// Rows: those of the loops, then those of the conditions.
    pub fn rows(&self) -> usize {
        self.tree.constraint_rows() + conditions(self.model, false).count()
    }

    /// Residuals at the present position.
    pub fn residuals(&self, kinematics: &Kinematics<f64>, out: &mut [f64]) {
        let loops = self.tree.constraint_rows();
        constraints::residuals(self.tree, self.geometry, kinematics, &mut out[..loops]);
        let mut unused = vec![0.0; self.tree.coordinates()];
        for ((index, initial), out) in conditions(self.model, false).zip(&mut out[loops..]) {
            let value = value_and_gradient(self.model, self.tree, self.geometry, kinematics, initial.of, &mut unused);
            *out = value - self.numbers[index];
        }
    }

    /// The given position that is furthest from being met, where it lies further off than any loop.
    pub fn contradiction(&self, residuals: &[f64]) -> Option<MechanismError> {
        let worst = (0..residuals.len()).max_by(|a, b| residuals[*a].abs().total_cmp(&residuals[*b].abs()))?;
        let place = worst.checked_sub(self.tree.constraint_rows())?;
        let (index, initial) = conditions(self.model, false).nth(place)?;
        Some(MechanismError::StartContradicts {
            path: initial.path.clone(),
            given_si: self.numbers[index],
            found_si: self.numbers[index] + residuals[worst],
            dimension: initial.dimension(),
        })
    }

    /// Jacobian of the conditions, row-major.
    pub fn jacobian(&self, kinematics: &Kinematics<f64>, out: &mut [f64]) {
        let (loops, columns) = (self.tree.constraint_rows(), self.tree.coordinates());
        constraints::jacobian(self.tree, self.geometry, kinematics, &mut out[..loops * columns]);
        self.gradients(kinematics, false, &mut out[loops * columns..]);
    }

    /// Gradients of the conditions on the position or on the rates, row-major.
    pub fn gradients(&self, kinematics: &Kinematics<f64>, is_rate: bool, out: &mut [f64]) {
        let columns = self.tree.coordinates();
        out.fill(0.0);
        for ((_, initial), row) in conditions(self.model, is_rate).zip(out.chunks_exact_mut(columns)) {
            value_and_gradient(self.model, self.tree, self.geometry, kinematics, initial.of, row);
        }
    }
}
