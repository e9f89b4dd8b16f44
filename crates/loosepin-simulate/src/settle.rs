//! The start of flexible bodies that have settled: bent and stretched as they are once their own ringing has died away.
//!
//! The shapes have no acceleration, and the rates that the motion of the mechanism gives them:
//!
//! ```text
//! q̈(q) = 0 at ż = (ż_rigid, 0),    q̇ = (q(h) - q(-h))/2h along z_rigid(t) = z + t ż + ½ t² z̈,    h = 1e-6 s
//! ```
//!
//! q are the shapes of all bodies that settle, z the other coordinates. Without play K q is then what inertia, weight, springs and loads ask
//! for; every contact is open. Loops of ideal joints are closed by the other coordinates, along the smallest change in the sense of
//! kinetic energy.

use super::failure::RunFailure;
use super::motion::Motion;
use loosepin_math::{GramSystem, determinant, solve_square};
use loosepin_mechanics::dynamics::PlayState;
use loosepin_mechanics::mechanism::Mechanism;

/// Half of the span over which rates of shapes are taken, s: 1e-6 of a period of 1 s, and large against round-off.
const HALF_SPAN_S: f64 = 1e-6;
/// Newton steps; a beam that holds its load needs three to six.
const NEWTON_STEPS: usize = 30;
/// Newton steps on the loops within each of them.
const LOOP_STEPS: usize = 3;
/// Change of the shapes, relative to the largest of them, that is round-off.
const SETTLED: f64 = 1e-14;
/// The least that changes are relative to, rad, and m for each metre of the mechanism: a straight column has no shape of its own.
const LEAST: f64 = 1e-2;
/// Share of the last change above which a change is that of slopes which do not fit any more.
const SLOW: f64 = 0.1;
/// Change of a shape over which slopes are taken, rad, and m for each metre of the mechanism.
const DIFFERENCE: f64 = 1e-7;

/// Bends and stretches the flexible bodies that are to start settled, and closes the loops: `state` is that at time zero, with
/// contacts open.
///
/// # Errors
/// There is no static shape, or none that is stable: the load is beyond what the beams bear.
pub fn settle(motion: &mut Motion<'_, f64>, state: &mut [f64]) -> Result<(), RunFailure> {
    let mechanism = motion.dynamics.mechanism();
    let shapes = settled_shapes(mechanism);
    if shapes.is_empty() {
        return Ok(());
    }
    motion.states.fill(PlayState::flight());
    let n = motion.freedoms();
    let mut settling = Settling::new(motion, shapes);
    let mut at_zero = state.to_vec();
    settling.find(0.0, &mut at_zero)?;
    settling.demand_stable(&at_zero)?;
    settling.motion.evaluate(0.0, &at_zero);
    let accelerations = settling.motion.dynamics.accelerations().to_vec();
    let [before, after] = [-HALF_SPAN_S, HALF_SPAN_S].map(|time_s| {
        let mut near = at_zero.clone();
        for k in 0..n {
            near[k] += time_s * (at_zero[n + k] + 0.5 * time_s * accelerations[k]);
            near[n + k] += time_s * accelerations[k];
        }
        settling.shapes.iter().for_each(|&shape| near[n + shape] = 0.0);
        settling.find(time_s, &mut near).map(|()| near)
    });
    let (before, after) = (before?, after?);
    for &shape in &settling.shapes {
        at_zero[n + shape] = (after[shape] - before[shape]) / (2.0 * HALF_SPAN_S);
    }
    settling.close_loops(0.0, &mut at_zero);
    state[..2 * n].copy_from_slice(&at_zero[..2 * n]);
    Ok(())
}

/// The coordinates of the shapes of all bodies that are to start settled.
fn settled_shapes(mechanism: &Mechanism) -> Vec<usize> {
    let beams = mechanism.real.beams.iter();
    let settles = |body: usize| mechanism.model.bodies[body].beam.as_ref().is_some_and(|beam| beam.starts_settled);
    beams.filter(|beam| settles(beam.body.0)).flat_map(|beam| beam.coordinates.clone()).collect()
}

/// Newton's method on the accelerations of the shapes.
struct Settling<'s, 'a> {
    motion: &'s mut Motion<'a, f64>,
    shapes: Vec<usize>,
    /// Change of each shape over which slopes are taken, and the largest that counts as none: m or rad.
    differences: Vec<f64>,
    /// ∂q̈/∂q, row by row, where it is known.
    slopes: Option<Vec<f64>>,
    /// The loops, then a row for each shape, which holds it.
    gram: GramSystem<f64>,
    jacobian: Vec<f64>,
    defects: Vec<f64>,
}

impl<'s, 'a> Settling<'s, 'a> {
    fn new(motion: &'s mut Motion<'a, f64>, shapes: Vec<usize>) -> Self {
        let mechanism = motion.dynamics.mechanism();
        let tree = &mechanism.real;
        let loops = tree.constraint_rows();
        let mut scales = tree.constraint_scales();
        scales.extend((loops..loops + shapes.len()).map(|row| [row, row]));
        let is_length = |shape: &usize| tree.beams.iter().any(|beam| beam.axial().contains(shape));
        let difference = |shape: &usize| if is_length(shape) { DIFFERENCE * mechanism.size_m } else { DIFFERENCE };
        Self {
            differences: shapes.iter().map(difference).collect(),
            slopes: None,
            gram: GramSystem::new(scales, tree.free),
            jacobian: vec![0.0; (loops + shapes.len()) * tree.coordinates()],
            defects: vec![0.0; loops + shapes.len()],
            shapes,
            motion,
        }
    }

    /// Moves the shapes of `state` to where they have no acceleration at `time_s`, and closes the loops.
    fn find(&mut self, time_s: f64, state: &mut [f64]) -> Result<(), RunFailure> {
        let count = self.shapes.len();
        let mut last = f64::INFINITY;
        for _ in 0..NEWTON_STEPS {
            let found = self.accelerations(time_s, state);
            let mut matrix = match &self.slopes {
                Some(slopes) => slopes.clone(),
                None => self.slopes_at(time_s, state),
            };
            self.slopes = Some(matrix.clone());
            let mut change: Vec<f64> = found.iter().map(|acceleration| -acceleration).collect();
            if !(solve_square(&mut matrix, count, &mut change) > 0.0) {
                return Err(RunFailure::NotSettled);
            }
            let mut largest = 0.0_f64;
            for ((&shape, change), difference) in self.shapes.iter().zip(change).zip(&self.differences) {
                state[shape] += change;
                // In units of what moves the whole mechanism.
                let share = (change * DIFFERENCE / difference).abs();
                largest = if share.is_finite() { largest.max(share) } else { f64::INFINITY };
            }
            let of_shape = |(&shape, difference): (&usize, &f64)| (state[shape] * DIFFERENCE / difference).abs();
            let size = self.shapes.iter().zip(&self.differences).map(of_shape).fold(0.0, f64::max);
            if largest <= SETTLED * size.max(LEAST) {
                self.close_loops(time_s, state);
                return Ok(());
            }
            if !largest.is_finite() {
                break;
            }
            if largest > SLOW * last {
                self.slopes = None;
            }
            last = largest;
        }
        Err(RunFailure::NotSettled)
    }

    /// Refuses a shape that is in balance and no more, as that of a column beyond its Euler load.
    fn demand_stable(&mut self, state: &[f64]) -> Result<(), RunFailure> {
        let count = self.shapes.len();
        // -∂q̈/∂q = M⁻¹ K is positive definite where all is stable; the first eigenvalue below zero turns its determinant. A second one turns it
        // back: that is not noticed (docs/theory/flexible.md says so).
        let mut stiffness: Vec<f64> = self.slopes_at(0.0, state).iter().map(|slope| -slope).collect();
        if determinant(&mut stiffness, count) > 0.0 { Ok(()) } else { Err(RunFailure::NotSettled) }
    }

    /// q̈ of the shapes where the loops are closed.
    fn accelerations(&mut self, time_s: f64, state: &mut [f64]) -> Vec<f64> {
        self.close_loops(time_s, state);
        self.motion.evaluate(time_s, state);
        self.shapes.iter().map(|&shape| self.motion.dynamics.accelerations()[shape]).collect()
    }

    /// ∂q̈/∂q by central differences.
    fn slopes_at(&mut self, time_s: f64, state: &[f64]) -> Vec<f64> {
        let count = self.shapes.len();
        let mut slopes = vec![0.0; count * count];
        for column in 0..count {
            let difference = self.differences[column];
            let [below, above] = [-difference, difference].map(|change| {
                let mut moved = state.to_vec();
                moved[self.shapes[column]] += change;
                self.accelerations(time_s, &mut moved)
            });
            for (row, (above, below)) in above.iter().zip(&below).enumerate() {
                slopes[row * count + column] = (above - below) / (2.0 * difference);
            }
        }
        slopes
    }

    /// Closes the loops of ideal joints in positions and rates, with the shapes and their rates held.
    fn close_loops(&mut self, time_s: f64, state: &mut [f64]) {
        let loops = self.motion.dynamics.mechanism().real.constraint_rows();
        if loops == 0 {
            return;
        }
        let n = self.motion.freedoms();
        self.motion.evaluate(time_s, state);
        let mass = self.motion.dynamics.factored_mass().to_vec();
        for _ in 0..LOOP_STEPS {
            self.motion.set_state(time_s, state);
            self.motion.dynamics.constraint_residuals(&mut self.defects[..loops]);
            self.correct(&mass, &mut state[..n]);
        }
        self.motion.set_state(time_s, state);
        let columns = self.motion.dynamics.mechanism().real.coordinates();
        self.motion.dynamics.constraint_jacobian(&mut self.jacobian[..loops * columns]);
        let jacobian = self.jacobian[..loops * columns].to_vec();
        self.motion.dynamics.constraint_rates(&jacobian, &mut self.defects[..loops]);
        self.correct(&mass, &mut state[n..2 * n]);
    }

    /// Takes the smallest change that removes the defects of the loops off `numbers`.
    fn correct(&mut self, mass: &[f64], numbers: &mut [f64]) {
        let tree = &self.motion.dynamics.mechanism().real;
        let (loops, columns, n) = (tree.constraint_rows(), tree.coordinates(), tree.free);
        let (of_loops, of_shapes) = self.jacobian.split_at_mut(loops * columns);
        self.motion.dynamics.constraint_jacobian(of_loops);
        of_shapes.fill(0.0);
        for (row, &shape) in self.shapes.iter().enumerate() {
            of_shapes[row * columns + shape] = 1.0;
        }
        self.defects[loops..].fill(0.0);
        self.gram.set(&self.jacobian, columns, mass, n);
        self.gram.solve(&mut self.defects);
        let mut change = vec![0.0; n];
        self.gram.add_answer(&self.defects, &mut change);
        self.shapes.iter().for_each(|&shape| change[shape] = 0.0);
        numbers.iter_mut().zip(change).for_each(|(number, change)| *number -= change);
    }
}
