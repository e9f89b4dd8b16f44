//! The ideal motion: positions, velocities and accelerations with every clearance at zero.

use std::f64::consts::GOLDEN_RATIO;

use super::compile::Mechanism;
use super::error::{DrivePlace, SampleError};
use crate::mechanism::beginning::initial::StartEquations;
use crate::mechanism::loops::constraints;
use crate::mechanism::parts::drive::{Drives, workspace_length};
use crate::mechanism::parts::drive_place::drive_place;
use crate::mechanism::tree::assembly::least_open;
use crate::mechanism::tree::kinematics::{Kinematics, Twist};
use crate::mechanism::tree::mobility::eliminate_free;
use crate::mechanism::tree::motion_branches::{MotionBranches, motion_branches};
use crate::mechanism::tree::numbers::TreeNumbers;
use crate::mechanism::tree::spanning_tree::Tree;
use crate::model::{DriveId, TimeDual};
use loosepin_math::{Dual, solve_square};

/// Newton steps before a loop is given up; from a good prediction two or three are enough.
const NEWTON_STEPS: usize = 30;
/// Residual, relative to the size of the mechanism, from which one more Newton step reaches round-off.
const NEARLY_CLOSED: f64 = 1e-9;
/// Residual, relative to the size of the mechanism, that is round-off already.
const CLOSED: f64 = 1e-14;
/// Largest turn of any body in one prediction, rad.
const MAX_STEP_RAD: f64 = 0.2;
/// Pivot ratio of the loop equations below which a position counts as singular.
const SINGULAR_PIVOT_RATIO: f64 = 1e-9;

/// Moves the ideal mechanism through time: the state of the loop equations for one sample.
#[derive(Debug, Clone)]
pub struct IdealMotion<'a> {
    mechanism: &'a Mechanism,
    geometry: TreeNumbers<f64>,
    drives: Drives<f64>,
    /// The time whose pieces of motions are used whatever the time, s.
    held_s: Option<f64>,
    /// Time of the present state, s.
    time_s: f64,
    /// Coordinates, free ones first.
    coordinates: Vec<f64>,
    rates: Vec<f64>,
    accelerations: Vec<f64>,
    /// The state before the present one.
    before: Option<Before>,
    driven_accelerations: Vec<f64>,
    kinematics: Kinematics<f64>,
    residuals: Vec<f64>,
    jacobian: Vec<f64>,
    matrix: Vec<f64>,
    right_hand_side: Vec<f64>,
    /// Room for the functions of drives.
    workspace: Vec<TimeDual<f64>>,
    pivot_ratio: f64,
    /// Constraint rows that are solved. Where joints repeat each other, which rows carry the motion changes along the way.
    rows: Vec<usize>,
}

/// Free coordinates at an earlier time, with their rates and accelerations.
#[derive(Debug, Clone)]
struct Before {
    time_s: f64,
    coordinates: Vec<f64>,
    rates: Vec<f64>,
    accelerations: Vec<f64>,
}

impl<'a> IdealMotion<'a> {
    /// Closes the loops at time zero, from the nominal start.
    ///
    /// # Errors
    /// The sample cannot close, or only in a singular position.
    pub fn new(
        mechanism: &'a Mechanism,
        geometry: &TreeNumbers<f64>,
        drives: &Drives<f64>,
    ) -> Result<Self, SampleError> {
        let tree = &mechanism.ideal;
        let (n, rows) = (tree.free, tree.constraint_rows());
        let mut motion = Self {
            mechanism,
            geometry: geometry.clone(),
            drives: drives.clone(),
            held_s: None,
            time_s: 0.0,
            coordinates: mechanism.ideal_start.clone(),
            rates: vec![0.0; tree.coordinates()],
            accelerations: vec![0.0; n],
            before: None,
            driven_accelerations: vec![0.0; tree.drives.len()],
            kinematics: Kinematics::new(tree),
            residuals: vec![0.0; rows],
            jacobian: vec![0.0; rows * tree.coordinates()],
            matrix: vec![0.0; n * n],
            right_hand_side: vec![0.0; n],
            workspace: vec![Dual::constant(Dual::constant(0.0)); workspace_length(&mechanism.model)],
            pivot_ratio: 1.0,
            rows: mechanism.ideal_rows().to_vec(),
        };
        motion.close(0.0)?;
        motion.set_rates_and_accelerations()?;
        Ok(motion)
    }

    /// Moves to `time_s`, in steps small enough to stay on the same branch.
    ///
    /// # Errors
    /// The loops cannot be closed on the way, or only in a singular position. The state is then worthless.
    pub fn move_to(&mut self, time_s: f64) -> Result<(), SampleError> {
        let fastest = self.kinematics.twists.iter().fold(0.0_f64, |f, twist| f.max(twist.angular.abs()));
        let span = time_s - self.time_s;
        let driven = self.fastest_drive_1_s(time_s);
        let steps = (span.abs() * fastest.max(driven) / MAX_STEP_RAD).ceil().clamp(1.0, 1e6) as usize;
        let start_s = self.time_s;
        for step in 1..=steps {
            let next_s = if step == steps { time_s } else { start_s + span * step as f64 / steps as f64 };
            self.predict(next_s);
            self.close(next_s)?;
            self.set_rates_and_accelerations()?;
        }
        Ok(())
    }

    /// The drive that moves furthest from here to `time_s`, and how far, in steps of a fifth of a radian or of the size of the mechanism. What is no
    /// number on the way does not count.
    pub fn longest_way(&self, time_s: f64) -> (DriveId, f64) {
        /// Instants at which a drive that does not run at constant speed is looked at.
        const LOOKS: u32 = 64;
        let model = &self.mechanism.model;
        let span_s = time_s - self.time_s;
        let mut longest = (DriveId(0), 0.0);
        for &drive in &self.mechanism.ideal.drives {
            let is_length = model.joints[model.drives[drive.0].joint.0].kind.slides();
            let scale = if is_length { self.mechanism.size_m } else { 1.0 };
            let mut drives = self.drives.clone();
            // Multiples of the golden ratio: no period of a drive repeats itself in them.
            let rates = (0..LOOKS).map(|look| {
                let at_s = self.time_s + span_s * (f64::from(look) * GOLDEN_RATIO).fract();
                drives.take_pieces_at(self.held_s.unwrap_or(at_s));
                drives.at(model, drive, at_s)[1].abs()
            });
            let mean = rates.filter(|rate| rate.is_finite()).sum::<f64>() / f64::from(LOOKS);
            let steps = span_s.abs() * mean / scale / MAX_STEP_RAD;
            if steps > longest.1 {
                longest = (drive, steps);
            }
        }
        longest
    }

    /// Guesses the free coordinates at `next_s`: by the polynomial of degree five through the present state and the one before it,
    /// or by that of degree two through the present one where the step is much longer than the last, goes back, or follows a jump of the rate.
    ///
    /// ```text
    /// q(τ) = q + q' τ + q'' τ²/2 + τ³ (c + (τ + d)(c' + (τ + d) c'')),   τ = t - present, d = present - before
    /// c, c', c'' such that q(-d), q'(-d), q''(-d) are those before
    /// ```
    fn predict(&mut self, next_s: f64) {
        /// The longest step that the last one predicts, in units of it: the error grows with its sixth power.
        const FURTHEST: f64 = 2.0;
        /// What it may add to the guess of degree two, as a share of the step.
        const MAX_CORRECTION: f64 = 0.25;
        let (free, h) = (self.mechanism.ideal.free, next_s - self.time_s);
        let mut before = self.before.take().unwrap_or_else(|| Before {
            time_s: self.time_s,
            coordinates: vec![0.0; free],
            rates: vec![0.0; free],
            accelerations: vec![0.0; free],
        });
        let d = self.time_s - before.time_s;
        let is_told = d != 0.0 && (0.0..=FURTHEST).contains(&(h / d));
        for k in 0..free {
            let (q, rate, acceleration) = (self.coordinates[k], self.rates[k], self.accelerations[k]);
            self.coordinates[k] += h * (rate + 0.5 * h * acceleration);
            if is_told {
                // What degree two leaves of the state before.
                let left = before.coordinates[k] - (q - d * (rate - 0.5 * d * acceleration));
                let left_rate = before.rates[k] - (rate - d * acceleration);
                let left_acceleration = before.accelerations[k] - acceleration;
                let cube = d * d * d;
                let c0 = -left / cube;
                let c1 = (3.0 * d * d * c0 - left_rate) / cube;
                let c2 = (6.0 * d * (d * c1 - c0) - left_acceleration) / (2.0 * cube);
                let beyond = h * h * h * (c0 + (h + d) * (c1 + (h + d) * c2));
                // Where a rate has jumped, the polynomial is far off, and might close the loops the other way round.
                if beyond.abs() <= MAX_CORRECTION * (h * rate).abs().max((0.5 * h * h * acceleration).abs()) {
                    self.coordinates[k] += beyond;
                }
            }
            (before.coordinates[k], before.rates[k], before.accelerations[k]) = (q, rate, acceleration);
        }
        before.time_s = self.time_s;
        self.before = Some(before);
    }

    /// Uses the pieces that motions have at `time_s` at all times, or those of each time: within a step that ends where two
    /// pieces meet, its end belongs to the first.
    pub fn hold_pieces(&mut self, time_s: Option<f64>) {
        self.held_s = time_s;
    }

    /// The fastest drive between the present time and `time_s`, 1/s.
    fn fastest_drive_1_s(&self, time_s: f64) -> f64 {
        /// Instants at which a drive that does not run at constant speed is looked at.
        const LOOKS: u32 = 16;
        let (model, scale) = (&self.mechanism.model, self.drive_scale());
        let mut fastest = 0.0_f64;
        for &drive in &self.mechanism.ideal.drives {
            if let Some(speed) = self.drives.constant_speed(drive) {
                fastest = fastest.max(speed.abs() / scale);
                continue;
            }
            let mut drives = self.drives.clone();
            for k in 0..=LOOKS {
                let at_s = self.time_s + (time_s - self.time_s) * f64::from(k) / f64::from(LOOKS);
                drives.take_pieces_at(self.held_s.unwrap_or(at_s));
                fastest = fastest.max(drives.at(model, drive, at_s)[1].abs() / scale);
            }
        }
        fastest
    }

    /// The present time, s.
    pub fn time_s(&self) -> f64 {
        self.time_s
    }
    /// Poses and velocities of all bodies, by slot of the ideal tree.
    pub fn kinematics(&self) -> &Kinematics<f64> {
        &self.kinematics
    }
    /// Coordinates of the ideal tree, free ones first.
    pub fn coordinates(&self) -> &[f64] {
        &self.coordinates
    }
    /// Acceleration of the frame in `slot`.
    pub fn acceleration(&self, slot: usize) -> Twist<f64> {
        self.kinematics.acceleration(&self.mechanism.ideal, slot, &self.accelerations)
    }
    /// Coordinates and rates of the ideal tree, free ones first. A mechanism without play has the same tree as its real one.
    pub fn real_state(&self) -> (&[f64], &[f64]) {
        (&self.coordinates, &self.rates)
    }
    /// Accelerations of the free coordinates.
    pub fn accelerations(&self) -> &[f64] {
        &self.accelerations
    }
    /// The two ways on from here, at a change point.
    pub fn motion_branches(&self) -> Option<MotionBranches> {
        let (tree, driven) = (&self.mechanism.ideal, &self.driven_accelerations);
        motion_branches(tree, &self.geometry, &self.coordinates, &self.rates, driven)
    }
    /// The matrix dΦ/dq of the independent loop equations at the present position, n × n, row-major.
    pub fn loop_matrix(&self) -> Vec<f64> {
        let mut matrix = vec![0.0; self.matrix.len()];
        self.copy_matrix(&mut matrix);
        matrix
    }

    /// Scale of driven coordinates: the size of the mechanism, m, or one radian, the smaller.
    fn drive_scale(&self) -> f64 {
        // Driven lengths are compared with the mechanism, driven angles with a radian; the smaller one is cautious.
        self.mechanism.size_m.min(1.0)
    }

    /// Newton's method for Φ(q, t) = 0 from the present coordinates.
    fn close(&mut self, time_s: f64) -> Result<(), SampleError> {
        let tree = &self.mechanism.ideal;
        let n = tree.free;
        self.drives.take_pieces_at(self.held_s.unwrap_or(time_s));
        for (k, &drive) in tree.drives.iter().enumerate() {
            let motion = self.drives.motion(drive, time_s, &mut self.workspace);
            if motion.iter().any(|number| !number.is_finite()) {
                let drive = self.mechanism.model.drives[drive.0].name.clone();
                return Err(SampleError::DriveWithoutValue { drive, time_s });
            }
            [self.coordinates[n + k], self.rates[n + k], self.driven_accelerations[k]] = motion;
        }
        self.time_s = time_s;
        let mut polished = false;
        for _ in 0..NEWTON_STEPS {
            self.set_positions();
            constraints::residuals(tree, &self.geometry, &self.kinematics, &mut self.residuals);
            constraints::jacobian(tree, &self.geometry, &self.kinematics, &mut self.jacobian);
            if n < tree.constraint_rows() {
                self.rows = independent_rows(tree, &self.jacobian, n, self.mechanism.size_m);
                if self.rows.len() < n {
                    return Err(SampleError::Singular { time_s, at: self.drive_place() });
                }
            }
            let worst = self.residuals.iter().fold(0.0_f64, |w, r| w.max(r.abs()));
            if polished || n == 0 || worst <= CLOSED * self.mechanism.size_m {
                return if worst <= NEARLY_CLOSED * self.mechanism.size_m { Ok(()) } else { Err(self.cannot_close()) };
            }
            polished = worst <= NEARLY_CLOSED * self.mechanism.size_m;
            for (row, &independent) in self.rows.iter().enumerate() {
                self.right_hand_side[row] = -self.residuals[independent];
            }
            self.solve()?;
            for k in 0..n {
                self.coordinates[k] += self.right_hand_side[k];
            }
        }
        Err(self.cannot_close())
    }

    /// Solves the independent loop equations for the right-hand side.
    fn solve(&mut self) -> Result<(), SampleError> {
        let tree = &self.mechanism.ideal;
        let n = tree.free;
        let mut matrix = std::mem::take(&mut self.matrix);
        self.copy_matrix(&mut matrix);
        self.pivot_ratio = solve_square(&mut matrix, n, &mut self.right_hand_side);
        self.matrix = matrix;
        // Pivots of lengths and of angles differ by the size of the mechanism too: without dimension they tell.
        let is_singular = || eliminate_free(tree, &self.jacobian, self.mechanism.size_m).rank() < n;
        if !(self.pivot_ratio > SINGULAR_PIVOT_RATIO) && is_singular() {
            return Err(SampleError::Singular { time_s: self.time_s, at: self.drive_place() });
        }
        Ok(())
    }

    #[inline(always)]
    fn set_positions(&mut self) {
        self.kinematics.set_positions(&self.mechanism.ideal, &self.geometry, &self.coordinates);
    }

    fn set_rates_and_accelerations(&mut self) -> Result<(), SampleError> {
        let tree = &self.mechanism.ideal;
        let (n, columns) = (tree.free, tree.coordinates());
        for (row, &independent) in self.rows.iter().enumerate() {
            self.right_hand_side[row] =
                -(n..columns).map(|c| self.jacobian[independent * columns + c] * self.rates[c]).sum::<f64>();
        }
        self.solve()?;
        self.rates[..n].copy_from_slice(&self.right_hand_side);

        self.kinematics.set_velocities(tree, &self.rates);
        self.kinematics.set_biases(tree, &self.geometry, &self.rates, &self.driven_accelerations);
        constraints::biases(tree, &self.geometry, &self.kinematics, &mut self.residuals);
        for (row, &independent) in self.rows.iter().enumerate() {
            self.right_hand_side[row] = -self.residuals[independent];
        }
        self.solve()?;
        self.accelerations.copy_from_slice(&self.right_hand_side);
        Ok(())
    }

    #[inline(always)]
    fn copy_matrix(&self, matrix: &mut [f64]) {
        let tree = &self.mechanism.ideal;
        let (n, columns) = (tree.free, tree.coordinates());
        for (row, &independent) in self.rows.iter().enumerate() {
            matrix[row * n..(row + 1) * n]
                .copy_from_slice(&self.jacobian[independent * columns..independent * columns + n]);
        }
    }

    /// Newton's method ends anywhere: what stays open is looked for from the last position that closed.
    fn cannot_close(&self) -> SampleError {
        let (model, tree) = (&self.mechanism.model, &self.mechanism.ideal);
        let mut coordinates = self.coordinates.clone();
        let last = self.before.as_ref().map_or(&self.mechanism.ideal_start, |before| &before.coordinates);
        coordinates[..tree.free].copy_from_slice(&last[..tree.free]);
        // A motion that drives determine has no values of its start besides.
        let equations = StartEquations::new(model, tree, &self.geometry, &[]);
        let open = least_open(&equations, coordinates, self.mechanism.size_m);
        SampleError::CannotClose { open, time_s: self.time_s, at: self.drive_place() }
    }

    fn drive_place(&self) -> Option<Box<DrivePlace>> {
        drive_place(&self.mechanism.model, &self.mechanism.ideal, &self.coordinates)
    }
}

/// The rows that full pivoting takes first: the `wanted` most independent ones, ascending.
fn independent_rows(tree: &Tree, jacobian: &[f64], wanted: usize, size_m: f64) -> Vec<usize> {
    let dependent = eliminate_free(tree, jacobian, size_m).dependent_rows();
    (0..tree.constraint_rows()).filter(|row| !dependent.contains(row)).take(wanted).collect()
}
