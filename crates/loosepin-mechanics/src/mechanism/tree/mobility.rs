//! Counting degrees of freedom by the rank of the loop equations, and naming what is redundant.

use crate::mechanism::beginning::initial::{StartEquations, conditions};
use crate::mechanism::error::MechanismError;
use crate::mechanism::loops::constraints::{self, RowOwner};
use crate::mechanism::tree::kinematics::Kinematics;
use crate::mechanism::tree::numbers::TreeNumbers;
use crate::mechanism::tree::spanning_tree::{Cut, Tree};
use crate::model::{BodyId, Model};
use loosepin_math::Elimination;

/// Pivots of a dimensionless Jacobian below this share of the largest count as zero. Redundant rows leave round-off (1e-16), real ones of ordinary
/// mechanisms leave more than 1e-4.
pub(in crate::mechanism) const RANK_TOLERANCE: f64 = 1e-9;

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
    geometry: &TreeNumbers<f64>,
    coordinates: &[f64],
    size_m: f64,
) -> Result<Mobility, MechanismError> {
    let (rows, columns, drives) = (tree.constraint_rows(), tree.coordinates(), tree.drives.len());
    let scale = Scale::new(tree, size_m);
    let at_start = jacobian_at(tree, geometry, coordinates);
    let all = Elimination::new(&scale.dimensionless(&at_start), rows, columns, RANK_TOLERANCE);
    let degrees_of_freedom = columns - all.rank();
    if degrees_of_freedom < drives {
        return Err(MechanismError::TooManyDrives { mobility: degrees_of_freedom, drives });
    }
    let free = eliminate_free(tree, &at_start, size_m);
    if free.rank() < tree.free {
        let moving =
            |elimination: &Elimination| moving_bodies((model, tree, geometry), coordinates, elimination, &scale);
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
            let are_lengths = conditions(model, is_rate).map(|(_, initial)| initial.dimension().length != 0.0);
            let scale = scale.with_rows(are_lengths);
            let start = eliminate(tree, &scale.dimensionless(&with_given));
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
    let independent_rows = (0..rows).filter(|row| dependent.binary_search(row).is_err()).collect();
    Ok(Mobility { degrees_of_freedom, redundant, independent_rows })
}

/// Free coordinates that the loops of ideal joints leave open in the configuration `coordinates`.
pub fn open_freedoms(tree: &Tree, geometry: &TreeNumbers<f64>, coordinates: &[f64], size_m: f64) -> usize {
    tree.free - eliminate_free(tree, &jacobian_at(tree, geometry, coordinates), size_m).rank()
}

/// Eliminates the part of a Jacobian that belongs to the free coordinates: its rank, and which rows carry it.
pub(in crate::mechanism) fn eliminate_free(tree: &Tree, jacobian: &[f64], size_m: f64) -> Elimination {
    let loops = &jacobian[..tree.constraint_rows() * tree.coordinates()];
    eliminate(tree, &Scale::new(tree, size_m).dimensionless(loops))
}

/// As [`eliminate_free`], for any number of rows without dimension.
fn eliminate(tree: &Tree, jacobian: &[f64]) -> Elimination {
    let columns = tree.coordinates();
    let rows = jacobian.len() / columns.max(1);
    let free: Vec<f64> =
        (0..rows).flat_map(|row| jacobian[row * columns..row * columns + tree.free].iter().copied()).collect();
    Elimination::new(&free, rows, tree.free, RANK_TOLERANCE)
}

fn jacobian_at(tree: &Tree, geometry: &TreeNumbers<f64>, coordinates: &[f64]) -> Vec<f64> {
    let mut kinematics = Kinematics::new(tree);
    kinematics.set_positions(tree, geometry, coordinates);
    let mut jacobian = vec![0.0; tree.constraint_rows() * tree.coordinates()];
    constraints::jacobian(tree, geometry, &kinematics, &mut jacobian);
    jacobian
}

/// Scale that makes a Jacobian dimensionless: lengths counted in sizes of the mechanism, so that they weigh like angles however small or
/// large it is. The size is rounded to a power of two: then no entry is rounded.
pub(in crate::mechanism) struct Scale {
    size_m: f64,
    rows_are_lengths: Vec<bool>,
    columns_are_lengths: Vec<bool>,
}

impl Scale {
    /// Scale of the constraint rows and all coordinates of `tree`.
    pub(in crate::mechanism) fn new(tree: &Tree, size_m: f64) -> Self {
        let of_cut = |cut: &Cut| {
            let cut = *cut;
            (0..cut.count()).map(move |row| !cut.is_angle(row))
        };
        let of_couplings = tree.couplings.iter().map(|places| places[1].is_prismatic);
        let mut columns_are_lengths = vec![false; tree.coordinates()];
        for link in &tree.links {
            columns_are_lengths[link.lengths()].fill(true);
        }
        for lengths in tree.nodal_beams.iter().flat_map(|beam| beam.lengths()) {
            columns_are_lengths[lengths].fill(true);
        }
        for beam in &tree.beams {
            columns_are_lengths[beam.axial()].fill(true);
        }
        Self {
            size_m: size_m.log2().round().exp2(),
            rows_are_lengths: tree.cuts.iter().flat_map(of_cut).chain(of_couplings).collect(),
            columns_are_lengths,
        }
    }

    /// The same with further rows.
    fn with_rows(&self, are_lengths: impl Iterator<Item = bool>) -> Self {
        Self {
            rows_are_lengths: self.rows_are_lengths.iter().copied().chain(are_lengths).collect(),
            columns_are_lengths: self.columns_are_lengths.clone(),
            ..*self
        }
    }

    pub(in crate::mechanism) fn dimensionless(&self, jacobian: &[f64]) -> Vec<f64> {
        let rows = jacobian.chunks(self.columns_are_lengths.len().max(1)).zip(&self.rows_are_lengths);
        let of_row = |(row, &is_row_length): (&[f64], &bool)| {
            let entry = |(entry, &is_column_length): (&f64, &bool)| match (is_row_length, is_column_length) {
                (true, false) => entry / self.size_m,
                (false, true) => entry * self.size_m,
                _ => *entry,
            };
            row.iter().zip(&self.columns_are_lengths).map(entry).collect::<Vec<f64>>()
        };
        rows.flat_map(of_row).collect()
    }
}

/// Names of the bodies that move along the first direction that the constraints leave free.
fn moving_bodies(
    (model, tree, geometry): (&Model, &Tree, &TreeNumbers<f64>),
    coordinates: &[f64],
    free: &Elimination,
    scale: &Scale,
) -> Vec<String> {
    let mut kinematics = Kinematics::new(tree);
    kinematics.set_positions(tree, geometry, coordinates);
    let mut moves = vec![false; model.bodies.len()];
    for column in free.free_columns() {
        if moves[1..].iter().all(|is_moving| *is_moving) {
            break;
        }
        let mut rates = free.null_direction(column);
        rates.resize(tree.coordinates(), 0.0);
        for (rate, &is_length) in rates.iter_mut().zip(&scale.columns_are_lengths) {
            *rate *= if is_length { scale.size_m } else { 1.0 };
        }
        kinematics.set_velocities(tree, &rates);
        for (index, link) in tree.links.iter().enumerate() {
            let twist = kinematics.twists[index + 1];
            // The free coordinate moves with rate one, or one size a second; slower than 1e-6 is round-off of the elimination.
            moves[link.body.0] |= twist.linear.length() > 1e-6 * scale.size_m || twist.angular.abs() > 1e-6;
        }
    }
    (0..model.bodies.len()).map(BodyId).filter(|b| moves[b.0]).map(|b| model.bodies[b.0].name.clone()).collect()
}
