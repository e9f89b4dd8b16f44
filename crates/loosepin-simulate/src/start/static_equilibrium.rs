//! The start of flexible bodies that have settled: bent and stretched as after the decay of their own oscillations.
//!
//! The shapes have no acceleration, and the rates that the motion of the mechanism gives them:
//!
//! ```text
//! q̈(q) = 0 at ż = (ż_rigid, 0),    q̇ = (q(h) - q(-h))/2h along z_rigid(t) = z + t ż + ½ t² z̈,    h = 1e-6 s
//! ```
//!
//! q are the shapes of all bodies that settle, or the coordinates of their nodes in a frame that moves with them ([`coordinates`]), z the other
//! coordinates. Without play K q is then what inertia, weight, springs and loads ask for; every contact is open. Loops of ideal joints are
//! closed by the other coordinates, along the smallest change in the sense of kinetic energy. A beam in absolute nodal coordinates may bend
//! far: it takes its load in steps in which it bends by a radian at most, each of them stable.

mod coordinates;

use crate::failure::RunFailure;
use crate::stepping::motion::Motion;
use coordinates::Coordinates;
use loosepin_math::{GramSystem, determinant_sign, factor_ldl, solve_square};
use loosepin_mechanics::dynamics::PlayState;
use loosepin_mechanics::mechanism::largest_relative_residual;

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
/// Change of nodes below which one that does not become smaller is round-off: the curvature of short elements is a small difference of places.
const ROUND_OFF_OF_NODES: f64 = 1e-9;
/// Change of nodes above which slopes are taken anew at each step.
const NEAR: f64 = 1e-3;
/// Share of the last change above which a change is that of slopes which do not fit any more.
const SLOW: f64 = 0.1;
/// Change of a shape over which slopes are taken, rad, and m for each metre of the mechanism.
const DIFFERENCE: f64 = 1e-7;
/// Largest sum of the turns of the elements in a step of the load, rad.
const MAX_TURN: f64 = 1.0;
/// Largest change of a coordinate of a node with which Newton's method continues, rad, and m for each metre of the mechanism.
const FAR: f64 = 10.0;
/// Least share of the load that is added at once.
const MIN_SHARE: f64 = 1e-4;
/// Largest residual of a loop that counts as closed, m for each metre of the mechanism, or rad.
const CLOSED: f64 = 1e-9;

/// Share of the change of a shape that a loop stays open by where the other coordinates cannot follow; they follow to some 1e-7 of it.
const FOLLOWED: f64 = 1e-3;

/// Bends and stretches the flexible bodies that are to start settled, and closes the loops: `state` is that at time zero, with
/// contacts open.
///
/// # Errors
/// There is no static shape, or none that is stable: the load is beyond what the beams bear. Or it leaves loops open that nothing else can close.
pub fn static_equilibrium(motion: &mut Motion<'_, f64>, state: &mut [f64]) -> Result<(), RunFailure> {
    let coordinates = Coordinates::new(motion.dynamics.mechanism());
    if coordinates.shapes.is_empty() {
        return Ok(());
    }
    motion.states.fill(PlayState::flight());
    let n = motion.freedoms();
    let mut at_zero = coordinates.undeformed(motion, state);
    let mut settling = Settling::new(motion, coordinates, state);
    let unloaded = at_zero.clone();
    settling.load(&mut at_zero).map_err(|failure| settling.reason(&unloaded, failure))?;
    settling.evaluate(0.0, &at_zero);
    let accelerations = settling.coordinates.accelerations(settling.motion, &at_zero);
    let [before, after] = [-HALF_SPAN_S, HALF_SPAN_S].map(|time_s| {
        let mut near = at_zero.clone();
        for &k in &settling.coordinates.others {
            near[k] += time_s * (at_zero[n + k] + 0.5 * time_s * accelerations[k]);
            near[n + k] += time_s * accelerations[k];
        }
        settling.find(time_s, &mut near).map(|()| near)
    });
    let (before, after) = (before?, after?);
    for &shape in &settling.coordinates.shapes {
        at_zero[n + shape] = (after[shape] - before[shape]) / (2.0 * HALF_SPAN_S);
    }
    settling.close_loops(0.0, &mut at_zero);
    settling.demand_closed(&at_zero)?;
    settling.coordinates.place(settling.motion, 0.0, &at_zero, state);
    Ok(())
}

/// Newton's method on the accelerations of the shapes.
struct Settling<'s, 'a> {
    motion: &'s mut Motion<'a, f64>,
    coordinates: Coordinates,
    /// Change of each shape over which slopes are taken, and the largest that counts as none: m or rad.
    differences: Vec<f64>,
    /// ∂q̈/∂q, row by row, where it is known.
    slopes: Option<Vec<f64>>,
    /// State of a run for the current coordinates.
    state: Vec<f64>,
    /// The loops over the other coordinates.
    gram: GramSystem<f64>,
    jacobian: Vec<f64>,
    defects: Vec<f64>,
}

impl<'s, 'a> Settling<'s, 'a> {
    fn new(motion: &'s mut Motion<'a, f64>, coordinates: Coordinates, state: &[f64]) -> Self {
        let mechanism = motion.dynamics.mechanism();
        let tree = &mechanism.real;
        let loops = tree.constraint_rows();
        let difference = |is_length: &bool| if *is_length { DIFFERENCE * mechanism.size_m } else { DIFFERENCE };
        Self {
            differences: coordinates.are_lengths.iter().map(difference).collect(),
            slopes: None,
            state: state.to_vec(),
            gram: GramSystem::new(tree.constraint_scales(), coordinates.others.len()),
            jacobian: vec![0.0; loops * tree.coordinates()],
            defects: vec![0.0; loops],
            coordinates,
            motion,
        }
    }

    /// Moves the shapes at time zero to where they have no acceleration, and demands that they are stable there.
    fn load(&mut self, relative: &mut [f64]) -> Result<(), RunFailure> {
        if !self.coordinates.has_nodes() {
            self.find(0.0, relative)?;
            return self.demand_stable(relative, 1.0);
        }
        let own = self.motion.dynamics.sample().clone();
        self.coordinates.bear(self.motion, &own, MIN_SHARE);
        let unloaded = self.stability(relative);
        let (mut share, mut growth) = (0.0_f64, 1.0);
        // The last change for each share added.
        let mut rates = vec![0.0; relative.len()];
        while share < 1.0 {
            let next = (share + growth).min(1.0);
            let mut tried = relative.to_vec();
            tried.iter_mut().zip(&rates).for_each(|(tried, rate)| *tried += (next - share) * rate);
            self.coordinates.bear(self.motion, &own, next);
            self.slopes = None;
            let found = self.find(0.0, &mut tried).and_then(|()| self.demand_stable(&tried, unloaded));
            let tree = &self.motion.dynamics.mechanism().real;
            if found.is_ok() && self.coordinates.turn_rad(tree, relative, &tried) <= MAX_TURN {
                for ((rate, tried), from) in rates.iter_mut().zip(&tried).zip(&*relative) {
                    *rate = (tried - from) / (next - share);
                }
                relative.copy_from_slice(&tried);
                share = next;
                growth *= 2.0;
            } else {
                growth *= 0.5;
                if growth < MIN_SHARE {
                    return Err(RunFailure::NotSettled);
                }
            }
        }
        self.motion.dynamics.sample_mut().clone_from(&own);
        self.slopes = None;
        Ok(())
    }

    /// Largest change of a shape, rad, and m for each metre of the mechanism.
    fn change(&self, from: &[f64], to: &[f64]) -> f64 {
        let shapes = self.coordinates.shapes.iter().zip(&self.differences);
        let changes = shapes.map(|(&shape, difference)| ((to[shape] - from[shape]) * DIFFERENCE / difference).abs());
        changes.fold(0.0, |largest, change| if change.is_finite() { largest.max(change) } else { f64::INFINITY })
    }

    /// Moves the shapes to where they have no acceleration at `time_s`, and closes the loops.
    fn find(&mut self, time_s: f64, relative: &mut [f64]) -> Result<(), RunFailure> {
        let count = self.coordinates.shapes.len();
        let round_off = if self.coordinates.has_nodes() { ROUND_OFF_OF_NODES } else { 0.0 };
        let mut last = f64::INFINITY;
        for _ in 0..NEWTON_STEPS {
            let found = self.accelerations(time_s, relative);
            let mut matrix = match self.slopes.take() {
                Some(slopes) => slopes,
                None => self.slopes_at(time_s, relative),
            };
            self.slopes = Some(matrix.clone());
            let mut change: Vec<f64> = found.iter().map(|acceleration| -acceleration).collect();
            if !(solve_square(&mut matrix, count, &mut change) > 0.0) {
                return Err(RunFailure::NotSettled);
            }
            let before = relative.to_vec();
            for (&shape, change) in self.coordinates.shapes.iter().zip(change) {
                relative[shape] += change;
            }
            let largest = self.change(&before, relative);
            let size = self.change(&vec![0.0; relative.len()], relative);
            if largest <= SETTLED * size.max(LEAST) || (largest < round_off && largest > SLOW * last) {
                self.close_loops(time_s, relative);
                return Ok(());
            }
            if !(largest < if round_off > 0.0 { FAR } else { f64::INFINITY }) {
                break;
            }
            if largest > SLOW * last || (round_off > 0.0 && largest > NEAR) {
                self.slopes = None;
            }
            last = largest;
        }
        Err(RunFailure::NotSettled)
    }

    /// Refuses a shape that is in balance and no more, as that of a column beyond its Euler load. `unloaded`: the sign of [`Self::stability`]
    /// without load.
    fn demand_stable(&mut self, relative: &[f64], unloaded: f64) -> Result<(), RunFailure> {
        if self.stability(relative) == unloaded { Ok(()) } else { Err(RunFailure::NotSettled) }
    }

    /// Sign of the determinant of -∂q̈/∂q.
    ///
    /// M⁻¹ K is positive definite where all is stable; the first eigenvalue below zero turns its determinant. A second one turns it
    /// back: that is not noticed (docs/theory/flexible.md says so). Accelerations of nodes are not those of their coordinates: their
    /// determinant has a sign that does not change.
    fn stability(&mut self, relative: &[f64]) -> f64 {
        let mut stiffness: Vec<f64> = self.slopes_at(0.0, relative).iter().map(|slope| -slope).collect();
        determinant_sign(&mut stiffness, self.coordinates.shapes.len())
    }

    /// Refuses a start at which the other coordinates cannot close the loops.
    fn demand_closed(&mut self, relative: &[f64]) -> Result<(), RunFailure> {
        let (path, gap) = self.opening(relative);
        if gap <= CLOSED { Ok(()) } else { Err(RunFailure::SettledOpen { path }) }
    }

    /// The loop that is furthest from being closed, and how far: m for each metre of the mechanism, or rad.
    fn opening(&mut self, relative: &[f64]) -> (String, f64) {
        self.coordinates.place(self.motion, 0.0, relative, &mut self.state);
        self.motion.set_state(0.0, &self.state);
        self.motion.dynamics.constraint_residuals(&mut self.defects);
        let mechanism = self.motion.dynamics.mechanism();
        largest_relative_residual(&mechanism.model, &mechanism.real, &self.defects, mechanism.size_m)
    }

    /// Why no static shape was found from `relative` on, where the loops are closed: a loop stays open when a shape changes a little, or the load is beyond what the beams bear.
    fn reason(&mut self, relative: &[f64], failure: RunFailure) -> RunFailure {
        for index in 0..self.coordinates.shapes.len() {
            let mut moved = relative.to_vec();
            moved[self.coordinates.shapes[index]] += self.differences[index];
            self.close_loops(0.0, &mut moved);
            let (path, gap) = self.opening(&moved);
            if gap > FOLLOWED * DIFFERENCE {
                return RunFailure::SettledOpen { path };
            }
        }
        failure
    }

    /// Evaluates the equations of motion.
    fn evaluate(&mut self, time_s: f64, relative: &[f64]) {
        self.coordinates.place(self.motion, time_s, relative, &mut self.state);
        self.motion.evaluate(time_s, &self.state);
    }

    /// q̈ of the shapes where the loops are closed.
    fn accelerations(&mut self, time_s: f64, relative: &mut [f64]) -> Vec<f64> {
        self.close_loops(time_s, relative);
        self.evaluate(time_s, relative);
        let changes = self.coordinates.accelerations(self.motion, relative);
        self.coordinates.shapes.iter().map(|&shape| changes[shape]).collect()
    }

    /// ∂q̈/∂q by central differences.
    fn slopes_at(&mut self, time_s: f64, relative: &[f64]) -> Vec<f64> {
        let count = self.coordinates.shapes.len();
        let mut slopes = vec![0.0; count * count];
        for column in 0..count {
            let difference = self.differences[column];
            let [below, above] = [-difference, difference].map(|change| {
                let mut moved = relative.to_vec();
                moved[self.coordinates.shapes[column]] += change;
                self.accelerations(time_s, &mut moved)
            });
            for (row, (above, below)) in above.iter().zip(&below).enumerate() {
                slopes[row * count + column] = (above - below) / (2.0 * difference);
            }
        }
        slopes
    }

    /// Closes the loops of ideal joints in positions and rates, with the shapes and their rates held.
    fn close_loops(&mut self, time_s: f64, relative: &mut [f64]) {
        let loops = self.defects.len();
        if loops == 0 || self.coordinates.others.is_empty() {
            return;
        }
        let n = self.motion.freedoms();
        self.evaluate(time_s, relative);
        let mass = self.motion.dynamics.factored_mass().to_vec();
        for _ in 0..LOOP_STEPS {
            self.take_directions(time_s, relative, &mass);
            self.motion.dynamics.constraint_residuals(&mut self.defects);
            self.correct(&mut relative[..n]);
        }
        self.take_directions(time_s, relative, &mass);
        let columns = self.motion.dynamics.mechanism().real.coordinates();
        self.motion.dynamics.constraint_jacobian(&mut self.jacobian[..loops * columns]);
        self.motion.dynamics.constraint_rates(&self.jacobian[..loops * columns], &mut self.defects);
        self.correct(&mut relative[n..2 * n]);
    }

    /// Sets the state, and takes in what unit rates of the other coordinates do to the coordinates of the tree: with `mass`, the factors of its
    /// mass matrix, what the loops ask of the other coordinates.
    fn take_directions(&mut self, time_s: f64, relative: &[f64], mass: &[f64]) {
        let n = self.motion.freedoms();
        let of_tree = |settling: &mut Self, rates: &dyn Fn(usize) -> f64| {
            let mut moving = relative[..2 * n].to_vec();
            (0..n).for_each(|k| moving[n + k] = rates(k));
            settling.coordinates.place(settling.motion, time_s, &moving, &mut settling.state);
            settling.state[n..2 * n].to_vec()
        };
        let others = self.coordinates.others.clone();
        let driven = of_tree(self, &|_| 0.0);
        let directions: Vec<Vec<f64>> = others
            .iter()
            .map(|&other| {
                let found = of_tree(self, &|k| if k == other { 1.0 } else { 0.0 });
                found.iter().zip(&driven).map(|(found, driven)| found - driven).collect()
            })
            .collect();
        self.coordinates.place(self.motion, time_s, relative, &mut self.state);
        self.motion.set_state(time_s, &self.state);

        let (rows, count) = (self.defects.len(), others.len());
        let columns = self.motion.dynamics.mechanism().real.coordinates();
        let mut of_tree = vec![0.0; rows * columns];
        self.motion.dynamics.constraint_jacobian(&mut of_tree);
        let mut jacobian = vec![0.0; rows * count];
        for (row, gradient) in of_tree.chunks_exact(columns).enumerate() {
            for (k, direction) in directions.iter().enumerate() {
                jacobian[row * count + k] = gradient.iter().zip(direction).map(|(slope, rate)| slope * rate).sum();
            }
        }
        // Pᵀ M P = (Lᵀ P)ᵀ D (Lᵀ P); the factors hold 1/D on their diagonal.
        let turned: Vec<Vec<f64>> = directions
            .iter()
            .map(|direction| {
                (0..n).map(|i| direction[i] + (i + 1..n).map(|j| mass[j * n + i] * direction[j]).sum::<f64>()).collect()
            })
            .collect();
        let mut own_mass = vec![0.0; count * count];
        for (k, one) in turned.iter().enumerate() {
            for (l, other) in turned.iter().enumerate() {
                own_mass[k * count + l] = (0..n).map(|i| one[i] * other[i] / mass[i * n + i]).sum();
            }
        }
        factor_ldl(&mut own_mass, count);
        self.gram.set(&jacobian, count, &own_mass, count);
    }

    /// Takes the smallest change that removes the defects of the loops off the other coordinates, or off their rates.
    fn correct(&mut self, numbers: &mut [f64]) {
        self.gram.solve(&mut self.defects);
        let others = &self.coordinates.others;
        let mut change = vec![0.0; others.len()];
        self.gram.add_correction(&self.defects, &mut change);
        for (&other, change) in others.iter().zip(change) {
            numbers[other] -= change;
        }
    }
}
