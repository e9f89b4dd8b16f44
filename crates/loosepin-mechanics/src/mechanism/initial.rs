//! The initial state of a mechanism that its drives do not move alone: loops, drives and given values together.

use super::constraints::{self, Opening};
use super::drive::Drives;
use super::error::{MechanismError, SampleError};
use super::geometry::{Geometry, joint_of};
use super::kinematics::{Kinematics, moved};
use super::mobility::RANK_TOLERANCE;
use super::tree::{Tree, points_of};
use super::{Mechanism, Sample};
use crate::model::{Axis, InitialNumber, InitialOf, InitialValue, JointId, Model, Values};
use loosepin_math::{Elimination, Vec2, solve_square};

/// Newton steps from the nominal start.
const NEWTON_STEPS: usize = 30;
/// Residual, relative to the size of the mechanism, from which one more Newton step reaches round-off.
const NEARLY_CLOSED: f64 = 1e-9;
/// Pivot ratio below which the start counts as singular.
const SINGULAR_PIVOT_RATIO: f64 = 1e-9;

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
    geometry: &Geometry<f64>,
    kinematics: &Kinematics<f64>,
    of: InitialOf,
    row: &mut [f64],
) -> f64 {
    let mut turn = |slot: usize, sign: f64| {
        if slot > 0 {
            for dependence in &tree.links[slot - 1].dependences {
                row[dependence.coordinate] += sign * dependence.turning;
            }
        }
        sign * kinematics.poses[slot].angle_rad
    };
    match of {
        InitialOf::BodyAngle(body) => turn(tree.slot_of_body[body.0], 1.0),
        InitialOf::JointAngle(joint) => {
            let [i, j] = points_of(&model.joints[joint.0].kind).map(|point| tree.slot_of_body[point.body.0]);
            turn(j, 1.0) + turn(i, -1.0)
        }
        InitialOf::BodyPosition(body, axis) => {
            let slot = tree.slot_of_body[body.0];
            let along = |vector: Vec2<f64>| match axis {
                Axis::X => vector.x,
                Axis::Y => vector.y,
            };
            for (dependence, partial) in tree.links[slot - 1].dependences.iter().zip(kinematics.partials(slot)) {
                row[dependence.coordinate] += along(*partial);
            }
            along(kinematics.poses[slot].position_m)
        }
        InitialOf::JointPosition(joint) => {
            let Some((slots, arms_m, line_rad)) = guide(model, tree, geometry, joint) else { return f64::NAN };
            let poses = slots.map(|slot| kinematics.poses[slot]);
            let arms = [0, 1].map(|side| poses[side].turn(arms_m[side]));
            let gap = poses[1].position_m + arms[1] - poses[0].position_m - arms[0];
            let (sine, cosine) = loosepin_math::sin_cos(poses[0].angle_rad + line_rad);
            let line = Vec2::new(cosine, sine);
            for (side, sign) in [(0, -1.0), (1, 1.0)] {
                if slots[side] == 0 {
                    continue;
                }
                let dependences = &tree.links[slots[side] - 1].dependences;
                for (dependence, partial) in dependences.iter().zip(kinematics.partials(slots[side])) {
                    let velocity = moved(*partial, arms[side].turned(), dependence.turning);
                    row[dependence.coordinate] += sign * line.dot(velocity);
                    if side == 0 {
                        // The line turns with the guide.
                        row[dependence.coordinate] += dependence.turning * line.turned().dot(gap);
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
    geometry: &Geometry<f64>,
    joint: JointId,
) -> Option<([usize; 2], [Vec2<f64>; 2], f64)> {
    let slots = points_of(&model.joints[joint.0].kind).map(|point| tree.slot_of_body[point.body.0]);
    let of_link = tree.links.iter().zip(&geometry.links).find_map(|(link, numbers)| match joint_of(link.attachment) {
        Some((own, true)) if own == joint => {
            Some(([numbers.parent_arm_m, numbers.own_arm_m], numbers.parent_angle_rad))
        }
        Some((own, false)) if own == joint => Some(([numbers.own_arm_m, numbers.parent_arm_m], numbers.own_angle_rad)),
        _ => None,
    });
    let of_cut = || {
        let cut = tree.cuts.iter().position(|cut| cut.joint == joint)?;
        let numbers = &geometry.cuts[cut];
        Some((numbers.arms_m, numbers.angles_rad[0]))
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
    pub geometry: &'a Geometry<f64>,
    /// Given values by index of the model's list.
    numbers: &'a [f64],
}

impl<'a> StartEquations<'a> {
    /// For a sample.
    pub fn new(model: &'a Model, tree: &'a Tree, geometry: &'a Geometry<f64>, numbers: &'a [f64]) -> Self {
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

    /// Their Jacobian, row-major.
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

/// Poses and velocities of the ideal tree at time zero.
///
/// Positions: Newton's method on the loops and the given positions together, from the nominal start. Rates: the same
/// equations, differentiated; without any given rate a mechanism without drives is at rest.
///
/// # Errors
/// The loops cannot be closed with the given values.
pub fn initial_kinematics(mechanism: &Mechanism, sample: &Sample<f64>) -> Result<Kinematics<f64>, SampleError> {
    let (model, tree) = (&mechanism.model, &mechanism.ideal);
    let (n, columns, loops) = (tree.free, tree.coordinates(), tree.constraint_rows());
    let equations = StartEquations::new(model, tree, &sample.ideal, &sample.initial);
    let mut kinematics = Kinematics::new(tree);
    let mut coordinates = mechanism.ideal_start.clone();
    let mut rates = vec![0.0; columns];
    set_driven(model, tree, &sample.drives, &mut coordinates[n..], &mut rates[n..]);

    let mut residuals = vec![0.0; equations.rows()];
    let mut jacobian = vec![0.0; equations.rows() * columns];
    let tolerance = NEARLY_CLOSED * mechanism.size_m;
    let (mut polished, mut steps) = (false, 0);
    loop {
        kinematics.set_positions(tree, &sample.ideal, &coordinates);
        equations.residuals(&kinematics, &mut residuals);
        equations.jacobian(&kinematics, &mut jacobian);
        let worst = residuals.iter().fold(0.0_f64, |worst, residual| worst.max(residual.abs()));
        if polished || n == 0 || steps == NEWTON_STEPS {
            if worst <= tolerance {
                break;
            }
            let open = Opening::worst(model, tree, &residuals[..loops]);
            return Err(SampleError::CannotClose { open, time_s: 0.0 });
        }
        polished = worst <= tolerance;
        steps += 1;
        let change = solved(&jacobian, columns, n, |row| -residuals[row])?;
        coordinates[..n].iter_mut().zip(change).for_each(|(coordinate, change)| *coordinate += change);
    }

    // Without given rates, and without drives, everything rests; else they are as many as are needed.
    if conditions(model, true).next().is_some() {
        let given: Vec<f64> = conditions(model, true).map(|(index, _)| sample.initial[index]).collect();
        let mut gradients = jacobian[..loops * columns].to_vec();
        gradients.resize((loops + given.len()) * columns, 0.0);
        equations.gradients(&kinematics, true, &mut gradients[loops * columns..]);
        let driven = rates[n..].to_vec();
        let right = |row: usize| {
            let due = if row < loops { 0.0 } else { given[row - loops] };
            let gradient = &gradients[row * columns + n..(row + 1) * columns];
            due - gradient.iter().zip(&driven).map(|(slope, rate)| slope * rate).sum::<f64>()
        };
        let solution = solved(&gradients, columns, n, right)?;
        rates[..n].copy_from_slice(&solution);
        // More rates than are needed must agree with each other.
        let largest = rates.iter().fold(0.0_f64, |largest, rate| largest.max(rate.abs()));
        for (k, (_, initial)) in conditions(model, true).enumerate() {
            let row = &gradients[(loops + k) * columns..(loops + k + 1) * columns];
            let found = row.iter().zip(&rates).map(|(slope, rate)| slope * rate).sum::<f64>();
            if !((found - given[k]).abs() <= NEARLY_CLOSED * largest.max(given[k].abs())) {
                let path = initial.path.clone();
                let dimension = initial.dimension();
                return Err(SampleError::StartContradicts { path, given_si: given[k], found_si: found, dimension });
            }
        }
    }
    kinematics.set_velocities(tree, &rates);
    Ok(kinematics)
}

/// Puts the drives where they are at time zero.
fn set_driven(model: &Model, tree: &Tree, drives: &Drives<f64>, coordinates: &mut [f64], rates: &mut [f64]) {
    for (k, &drive) in tree.drives.iter().enumerate() {
        [coordinates[k], rates[k], _] = drives.at(model, drive, 0.0);
    }
}

/// Solves the `n` most independent rows of `gradients` · x = right over the free coordinates.
fn solved(gradients: &[f64], columns: usize, n: usize, right: impl Fn(usize) -> f64) -> Result<Vec<f64>, SampleError> {
    let free: Vec<f64> = gradients.chunks_exact(columns).flat_map(|row| row[..n].iter().copied()).collect();
    let count = gradients.len() / columns.max(1);
    let dependent = Elimination::new(&free, count, n, RANK_TOLERANCE).dependent_rows();
    let rows: Vec<usize> = (0..count).filter(|row| !dependent.contains(row)).collect();
    if rows.len() != n {
        return Err(SampleError::Singular { time_s: 0.0 });
    }
    let mut matrix: Vec<f64> = rows.iter().flat_map(|row| free[row * n..(row + 1) * n].iter().copied()).collect();
    let mut solution: Vec<f64> = rows.iter().map(|row| right(*row)).collect();
    if n > 0 && !(solve_square(&mut matrix, n, &mut solution) > SINGULAR_PIVOT_RATIO) {
        return Err(SampleError::Singular { time_s: 0.0 });
    }
    Ok(solution)
}
