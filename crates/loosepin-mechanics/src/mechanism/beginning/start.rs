//! The initial state of a sample: loops, drives and given values together.

use crate::mechanism::beginning::initial::{StartEquations, conditions};
use crate::mechanism::compile::Mechanism;
use crate::mechanism::error::SampleError;
use crate::mechanism::loops::constraints::LargestResidual;
use crate::mechanism::parts::drive::Drives;
use crate::mechanism::sample::Sample;
use crate::mechanism::tree::kinematics::Kinematics;
use crate::mechanism::tree::mobility::RANK_TOLERANCE;
use crate::mechanism::tree::spanning_tree::Tree;
use crate::model::Model;
use loosepin_math::{Elimination, solve_square};

/// Newton steps from the nominal start.
const NEWTON_STEPS: usize = 30;
/// Residual, relative to the size of the mechanism, from which one more Newton step reaches round-off.
const NEARLY_CLOSED: f64 = 1e-9;
/// Pivot ratio below which the start counts as singular.
const SINGULAR_PIVOT_RATIO: f64 = 1e-9;

impl Mechanism {
    /// Coordinates and rates of the real tree at time zero: ideal positions and velocities of the sample, journals centred or at their
    /// offsets. Journals that are to rest are centred.
    ///
    /// # Errors
    /// The sample cannot close, or does not fit the initial state.
    pub fn start(&self, sample: &Sample<f64>) -> Result<(Vec<f64>, Vec<f64>), SampleError> {
        if self.is_driven() {
            return self.start_at(sample, &sample.offsets);
        }
        Ok(self.real_coordinates(&initial_kinematics(self, sample)?, &sample.real))
    }
}

/// Poses and velocities of the ideal tree at time zero.
///
/// Positions: Newton's method on the loops and the given positions together, from the nominal start. Rates: the same
/// equations, differentiated; without any given rate a mechanism without drives is at rest.
///
/// # Errors
/// The loops cannot be closed with the given values.
fn initial_kinematics(mechanism: &Mechanism, sample: &Sample<f64>) -> Result<Kinematics<f64>, SampleError> {
    let (model, tree) = (&mechanism.model, &mechanism.ideal);
    let (n, columns, loops) = (tree.free, tree.coordinates(), tree.constraint_rows());
    let geometry = &mechanism.displaced(&sample.ideal, &sample.offsets);
    let equations = StartEquations::new(model, tree, geometry, &sample.initial);
    let mut kinematics = Kinematics::new(tree);
    let mut coordinates = mechanism.ideal_start.clone();
    let mut rates = vec![0.0; columns];
    set_driven(model, tree, &sample.drives, &mut coordinates[n..], &mut rates[n..]);

    let mut residuals = vec![0.0; equations.rows()];
    let mut jacobian = vec![0.0; equations.rows() * columns];
    let tolerance = NEARLY_CLOSED * mechanism.size_m;
    let (mut polished, mut steps) = (false, 0);
    loop {
        kinematics.set_positions(tree, geometry, &coordinates);
        equations.residuals(&kinematics, &mut residuals);
        equations.jacobian(&kinematics, &mut jacobian);
        let worst = residuals.iter().fold(0.0_f64, |worst, residual| worst.max(residual.abs()));
        if polished || n == 0 || steps == NEWTON_STEPS {
            if worst <= tolerance {
                break;
            }
            let open = LargestResidual::worst(model, tree, &residuals[..loops]);
            return Err(SampleError::CannotClose { open, time_s: 0.0, at: None });
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
        return Err(SampleError::Singular { time_s: 0.0, at: None });
    }
    let mut matrix: Vec<f64> = rows.iter().flat_map(|row| free[row * n..(row + 1) * n].iter().copied()).collect();
    let mut solution: Vec<f64> = rows.iter().map(|row| right(*row)).collect();
    if n > 0 && !(solve_square(&mut matrix, n, &mut solution) > SINGULAR_PIVOT_RATIO) {
        return Err(SampleError::Singular { time_s: 0.0, at: None });
    }
    Ok(solution)
}
