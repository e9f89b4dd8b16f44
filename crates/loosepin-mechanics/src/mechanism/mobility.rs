//! Counting degrees of freedom by the rank of the loop equations, and naming what is redundant.

use super::constraints::{self, RowOwner};
use super::error::MechanismError;
use super::geometry::Geometry;
use super::initial::{StartEquations, conditions};
use super::kinematics::Kinematics;
use super::tree::Tree;
use crate::model::{BodyId, Model};
use loosepin_math::Elimination;

/// Pivots below this share of the largest count as zero. Redundant rows leave round-off (1e-16), real ones of ordinary
/// mechanisms leave more than 1e-4.
pub(super) const RANK_TOLERANCE: f64 = 1e-9;

/// Mobility of a mechanism with all clearances at zero, from its loop equations.
#[derive(Debug, Clone)]
pub struct Mobility {
    /// Degrees of freedom, drives not counted as constraints.
    pub degrees_of_freedom: usize,
    /// Joints and couplings that repeat what others impose already, and how many of their constraints do.
    pub redundant: Vec<(RowOwner, usize)>,
    /// Independent constraint rows.
    pub independent_rows: Vec<usize>,
}

/// Counts the degrees of freedom in the configuration `coordinates` and compares them with the drives.
///
/// # Errors
/// Too few or too many drives, or a singular start.
pub fn count(
    model: &Model,
    tree: &Tree,
    geometry: &Geometry<f64>,
    coordinates: &[f64],
) -> Result<Mobility, MechanismError> {
    let (rows, columns, drives) = (tree.constraint_rows(), tree.coordinates(), tree.drives.len());
    let at_start = jacobian_at(tree, geometry, coordinates);
    let all = Elimination::new(&at_start, rows, columns, RANK_TOLERANCE);
    let degrees_of_freedom = columns - all.rank();
    if degrees_of_freedom < drives {
        return Err(MechanismError::TooManyDrives { mobility: degrees_of_freedom, drives });
    }
    let free = eliminate_free(tree, &at_start);
    if free.rank() < tree.free {
        let moving = |elimination: &Elimination| moving_bodies(model, tree, geometry, coordinates, elimination);
        if degrees_of_freedom <= drives {
            return Err(MechanismError::SingularStart { bodies: moving(&free) });
        }
        if model.initial.is_empty() {
            let undetermined = moving(&free);
            return Err(MechanismError::TooFewDrives { mobility: degrees_of_freedom, drives, undetermined });
        }
        for is_rate in [false, true] {
            let mut kinematics = Kinematics::new(tree);
            kinematics.set_positions(tree, geometry, coordinates);
            let given = conditions(model, is_rate).count();
            // What no drive moves and no rate is given for is at rest.
            if is_rate && given == 0 && drives == 0 {
                continue;
            }
            let mut with_given = at_start.clone();
            with_given.resize((rows + given) * columns, 0.0);
            let equations = StartEquations::new(model, tree, geometry, &[]);
            equations.gradients(&kinematics, is_rate, &mut with_given[rows * columns..]);
            let start = eliminate(tree, &with_given);
            if start.rank() < tree.free {
                return Err(MechanismError::StartNotDetermined { is_rate, bodies: moving(&start) });
            }
        }
    } else if let Some(control) = model.controls.first() {
        return Err(MechanismError::NothingToControl { control: control.name.clone() });
    } else if !model.initial.is_empty() {
        return Err(MechanismError::StartNotNeeded);
    }
    let dependent = free.dependent_rows();
    let mut redundant: Vec<(RowOwner, usize)> = Vec::new();
    for &row in &dependent {
        let owner = RowOwner::of(tree, row);
        match redundant.iter_mut().find(|(known, _)| *known == owner) {
            Some((_, count)) => *count += 1,
            None => redundant.push((owner, 1)),
        }
    }
    let independent_rows = (0..rows).filter(|row| !dependent.contains(row)).collect();
    Ok(Mobility { degrees_of_freedom, redundant, independent_rows })
}

/// Free coordinates that the loops of ideal joints leave open in the configuration `coordinates`.
pub fn open_freedoms(tree: &Tree, geometry: &Geometry<f64>, coordinates: &[f64]) -> usize {
    tree.free - eliminate_free(tree, &jacobian_at(tree, geometry, coordinates)).rank()
}

/// Eliminates the part of a Jacobian that belongs to the free coordinates: its rank, and which rows carry it.
pub(super) fn eliminate_free(tree: &Tree, jacobian: &[f64]) -> Elimination {
    eliminate(tree, &jacobian[..tree.constraint_rows() * tree.coordinates()])
}

/// As [`eliminate_free`], for any number of rows.
fn eliminate(tree: &Tree, jacobian: &[f64]) -> Elimination {
    let columns = tree.coordinates();
    let rows = jacobian.len() / columns.max(1);
    let free: Vec<f64> =
        (0..rows).flat_map(|row| jacobian[row * columns..row * columns + tree.free].iter().copied()).collect();
    Elimination::new(&free, rows, tree.free, RANK_TOLERANCE)
}

fn jacobian_at(tree: &Tree, geometry: &Geometry<f64>, coordinates: &[f64]) -> Vec<f64> {
    let mut kinematics = Kinematics::new(tree);
    kinematics.set_positions(tree, geometry, coordinates);
    let mut jacobian = vec![0.0; tree.constraint_rows() * tree.coordinates()];
    constraints::jacobian(tree, geometry, &kinematics, &mut jacobian);
    jacobian
}

/// Names of the bodies that move along the first direction that the constraints leave free.
fn moving_bodies(
    model: &Model,
    tree: &Tree,
    geometry: &Geometry<f64>,
    coordinates: &[f64],
    free: &Elimination,
) -> Vec<String> {
    let mut kinematics = Kinematics::new(tree);
    kinematics.set_positions(tree, geometry, coordinates);
    let mut moves = vec![false; model.bodies.len()];
    for column in free.free_columns() {
        let mut rates = free.null_direction(column);
        rates.resize(tree.coordinates(), 0.0);
        kinematics.set_velocities(tree, &rates);
        for (index, link) in tree.links.iter().enumerate() {
            let twist = kinematics.twists[index + 1];
            // The free coordinate moves with rate one; slower than 1e-6 is round-off of the elimination.
            moves[link.body.0] |= twist.linear.length() > 1e-6 || twist.angular.abs() > 1e-6;
        }
    }
    (0..model.bodies.len()).map(BodyId).filter(|b| moves[b.0]).map(|b| model.bodies[b.0].name.clone()).collect()
}
