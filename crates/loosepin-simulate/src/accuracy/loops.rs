//! The loops of the ideal mechanism at one instant, with the bodies of joints with play displaced against each other.

use super::error::AccuracyError;
use super::play_reach::PlayReach;
use loosepin_math::{Dual, Vec2, determinant, solve_square};
use loosepin_mechanics::mechanism::constraints::{self, LargestResidual};
use loosepin_mechanics::mechanism::{Kinematics, Mechanism, TreeNumbers, point_m};
use loosepin_mechanics::model::{PointId, Position, Values};

/// Newton steps from one displacement to the next; from nearby two or three are enough.
const NEWTON_STEPS: usize = 12;
/// Residual, relative to the size of the mechanism, from which one more Newton step reaches round-off.
const NEARLY_CLOSED: f64 = 1e-9;
/// Pivot ratio of the loop equations below which a position counts as singular.
const SINGULAR_PIVOT_RATIO: f64 = 1e-9;
/// Newton step, rad or m, that is round-off: far below what a residual of [`NEARLY_CLOSED`] asks for.
const AT_REST: f64 = 1e-14;
/// The furthest that a body turns by one displacement, rad.
const FURTHEST_RAD: f64 = 1.0;
/// A displacement that does not close at once is approached in at most this many halvings.
const HALVINGS: u32 = 10;

/// Ideal mechanism, every joint closed but for a chosen displacement e_k of each joint with play: Φ(q, e) = 0 at a fixed
/// position of the drives. e_k = r_journal - r_bearing (ground's frame) of a journal, ordinate and angle of a slider in its
/// guide ([`super::PlayReach`]).
///
/// The coordinates q of the ideal tree are m and rad, free ones first. The assembly branch is the one of the position it
/// was set to: a displacement that would leave it through a singular position is refused.
#[derive(Debug, Clone)]
pub struct DisplacedLoops<'a> {
    mechanism: &'a Mechanism,
    values: &'a Values,
    geometry: TreeNumbers<f64>,
    /// The numbers as constants, for derivatives.
    dual_geometry: TreeNumbers<Dual<f64>>,
    /// The numbers with all joints in the middle of their play.
    centred_geometry: TreeNumbers<f64>,
    dual_centred_geometry: TreeNumbers<Dual<f64>>,
    /// Displacements, in the order of [`Mechanism::plays`].
    displacements: Vec<Vec2<f64>>,
    coordinates: Vec<f64>,
    /// Coordinates with all journals centred.
    centred: Vec<f64>,
    /// Whether the determinant of the loop matrix is positive on the present branch.
    is_positive: bool,
    /// The same with all journals centred.
    is_centre_positive: bool,
    kinematics: Kinematics<f64>,
    dual_kinematics: Kinematics<Dual<f64>>,
    residuals: Vec<f64>,
    dual_residuals: Vec<Dual<f64>>,
    jacobian: Vec<f64>,
    newton_steps: usize,
}

/// Where displaced joints and their loops are.
#[derive(Debug, Clone)]
pub(super) struct LoopsPlace {
    pub displacements: Vec<Vec2<f64>>,
    pub coordinates: Vec<f64>,
    /// Which assembly it is.
    pub is_positive: bool,
}

impl<'a> DisplacedLoops<'a> {
    /// The loops of `mechanism` with the dimensions of `values`; to be set to a position first.
    pub fn new(mechanism: &'a Mechanism, values: &'a Values) -> Self {
        let tree = &mechanism.ideal;
        let (rows, columns) = (tree.constraint_rows(), tree.coordinates());
        Self {
            mechanism,
            values,
            geometry: TreeNumbers::new(&mechanism.model, tree, values),
            dual_geometry: TreeNumbers::new(&mechanism.model, tree, values),
            centred_geometry: TreeNumbers::new(&mechanism.model, tree, values),
            dual_centred_geometry: TreeNumbers::new(&mechanism.model, tree, values),
            displacements: vec![Vec2::zero(); mechanism.plays.len()],
            coordinates: vec![0.0; columns],
            centred: vec![0.0; columns],
            is_positive: true,
            is_centre_positive: true,
            kinematics: Kinematics::new(tree),
            dual_kinematics: Kinematics::new(tree),
            residuals: vec![0.0; rows],
            dual_residuals: vec![Dual::constant(0.0); rows],
            jacobian: vec![0.0; rows * columns],
            newton_steps: 0,
        }
    }

    /// Takes the position `coordinates`, in which the loops are closed with all journals centred.
    pub fn set_position(&mut self, coordinates: &[f64]) {
        self.centred.copy_from_slice(coordinates);
        self.centre();
        let mut matrix = self.loop_matrix();
        self.is_centre_positive = determinant(&mut matrix, self.mechanism.ideal.free) > 0.0;
        self.is_positive = self.is_centre_positive;
    }

    /// Takes the position nearest to `coordinates` in which the loops are closed with all journals centred.
    ///
    /// # Errors
    /// They cannot be closed from there.
    pub(super) fn close_near(&mut self, coordinates: &[f64]) -> Result<(), AccuracyError> {
        self.set_position(coordinates);
        self.close()?;
        let closed = self.coordinates.clone();
        self.set_position(&closed);
        Ok(())
    }

    /// Puts all joints back into the middle of their play, in the assembly of the position.
    pub fn centre(&mut self) {
        self.is_positive = self.is_centre_positive;
        let centred = vec![Vec2::zero(); self.mechanism.plays.len()];
        self.set_displacements(&centred);
        self.coordinates.copy_from_slice(&self.centred);
        self.set_kinematics();
    }

    /// Moves the joints to `displacements` (in the order of [`Mechanism::plays`]) and closes the loops again, from the
    /// present position on.
    ///
    /// # Errors
    /// The loops cannot be closed, or a singular position lies on the way. The joints are then where they were.
    pub fn displace(&mut self, displacements: &[Vec2<f64>]) -> Result<(), AccuracyError> {
        let start = self.place();
        let moved = self.advance(displacements, 0.5_f64.powi(HALVINGS as i32), usize::MAX);
        if moved.is_err() {
            self.put(&start);
        }
        moved
    }

    /// As [`Self::displace`], but where the loops cannot be closed on a part `smallest` of the way, or are not at its end after `most` parts, the
    /// joints stay where they could be last.
    ///
    /// # Errors
    /// As for [`Self::displace`].
    pub(super) fn advance(
        &mut self,
        displacements: &[Vec2<f64>],
        smallest: f64,
        most: usize,
    ) -> Result<(), AccuracyError> {
        let start = self.displacements.clone();
        let (mut reached, mut stride, mut parts) = (0.0, 1.0, 0);
        let mut last = self.place();
        let mut angles_rad = Vec::new();
        self.keep_angles(&mut angles_rad);
        while reached < 1.0 {
            if parts == most {
                self.put(&last);
                return Err(AccuracyError::SingularWithPlay);
            }
            parts += 1;
            let share = f64::min(reached + stride, 1.0);
            let between: Vec<Vec2<f64>> = if share == 1.0 {
                displacements.to_vec()
            } else {
                start.iter().zip(displacements).map(|(a, b)| *a * (1.0 - share) + *b * share).collect()
            };
            self.set_displacements(&between);
            match self.close_beside(&angles_rad) {
                Ok(()) => {
                    self.keep_angles(&mut angles_rad);
                    reached = share;
                    last.displacements = between;
                    last.coordinates.copy_from_slice(&self.coordinates);
                }
                Err(error) => {
                    stride *= 0.5;
                    self.coordinates.copy_from_slice(&last.coordinates);
                    if stride < smallest {
                        self.put(&last);
                        return Err(error);
                    }
                }
            }
        }
        Ok(())
    }

    /// Where the joints and the loops are, and in which assembly.
    pub(super) fn place(&self) -> LoopsPlace {
        LoopsPlace {
            displacements: self.displacements.clone(),
            coordinates: self.coordinates.clone(),
            is_positive: self.is_positive,
        }
    }

    /// Goes where it was.
    pub(super) fn put(&mut self, place: &LoopsPlace) {
        self.set_displacements(&place.displacements);
        self.coordinates.copy_from_slice(&place.coordinates);
        self.is_positive = place.is_positive;
        self.set_kinematics();
    }

    /// The determinant of the loop equations, positive in the present assembly and zero in a dead centre.
    pub(super) fn determinant(&mut self) -> f64 {
        let n = self.mechanism.ideal.free;
        let determinant = determinant(&mut self.loop_matrix(), n);
        if self.is_positive { determinant } else { -determinant }
    }

    /// From close to a dead centre to the other assembly, with the joints where they are: along the direction w in which the loops give way the
    /// determinant d is zero at -d/d′, and as far again lies the other assembly.
    ///
    /// # Errors
    /// It was not found.
    pub(super) fn cross(&mut self) -> Result<(), AccuracyError> {
        /// Steps of an inverse iteration: near a dead centre one direction stands out by far.
        const ITERATIONS: usize = 4;
        /// Half of the way along w, rad or m, over which d′ is a difference.
        const DIFFERENCE: f64 = 1e-6;
        /// Longer steps that are tried where the first one leads back.
        const DOUBLINGS: i32 = 8;
        let n = self.mechanism.ideal.free;
        let start = self.place();
        let mut angles_rad = Vec::new();
        self.keep_angles(&mut angles_rad);
        let matrix = self.loop_matrix();
        let transposed: Vec<f64> = (0..n * n).map(|at| matrix[at % n * n + at / n]).collect();
        let mut motion = vec![1.0; n];
        for matrix in [&transposed, &matrix].into_iter().cycle().take(2 * ITERATIONS) {
            solve_square(&mut matrix.clone(), n, &mut motion);
            let length = motion.iter().map(|entry| entry * entry).sum::<f64>().sqrt();
            motion.iter_mut().for_each(|entry| *entry /= length);
        }
        let mut along = |way: f64| {
            self.put(&start);
            self.coordinates.iter_mut().zip(&motion).for_each(|(coordinate, entry)| *coordinate += way * entry);
            self.set_kinematics();
            self.determinant()
        };
        let slope = (along(DIFFERENCE) - along(-DIFFERENCE)) / (2.0 * DIFFERENCE);
        let way = -2.0 * along(0.0) / slope;
        let mut last = Err(AccuracyError::SingularWithPlay);
        for doubling in 0..DOUBLINGS {
            self.put(&start);
            let way = way * f64::from(1 << doubling);
            self.coordinates.iter_mut().zip(&motion).for_each(|(coordinate, entry)| *coordinate += way * entry);
            self.is_positive = !start.is_positive;
            last = self.close_beside(&angles_rad);
            if last.is_ok() {
                return last;
            }
        }
        self.put(&start);
        last
    }

    /// The present displacements, in the order of [`Mechanism::plays`].
    pub fn displacements(&self) -> &[Vec2<f64>] {
        &self.displacements
    }

    /// Steps of Newton's method so far: the work that was done.
    pub fn newton_steps(&self) -> usize {
        self.newton_steps
    }

    /// Coordinates of the ideal tree in the present position.
    pub fn coordinates(&self) -> &[f64] {
        &self.coordinates
    }

    /// The value of an output in the present position, m or rad.
    pub fn value(&self, reading: Position) -> f64 {
        let (model, values) = (&self.mechanism.model, self.values);
        reading.value(&self.mechanism.ideal, &self.kinematics, |point| point_m(model, values, point))
    }

    /// Derivatives of `readings` when the joint with play `play` is displaced along `direction`.
    ///
    /// # Errors
    /// The position is singular.
    pub fn derivatives_along_play(
        &mut self,
        play: usize,
        direction: Vec2<f64>,
        readings: &[Position],
    ) -> Result<Vec<f64>, AccuracyError> {
        let id = self.mechanism.plays[play];
        let at = self.displacements[play];
        let moving =
            Vec2::new(Dual { value: at.x, derivative: direction.x }, Dual { value: at.y, derivative: direction.y });
        let tree = &self.mechanism.ideal;
        let mut geometry = self.dual_geometry.clone();
        geometry.set_displacement(tree, id, moving, &self.dual_centred_geometry);
        let (model, values) = (&self.mechanism.model, self.values);
        let driven = vec![0.0; tree.drives.len()];
        self.derivatives(&geometry, &driven, readings, &|point| point_m(model, values, point))
    }

    /// d/d(e_k) of the sum of `readings` that `weights` gives (place and factor), for each joint with play whose reach is not a point.
    ///
    /// By the adjoint of the loop equations: with w = (dΦ/dq)⁻ᵀ dy/dq, the derivative along e is dy - w·dΦ at fixed q.
    ///
    /// # Errors
    /// The position is singular.
    pub(super) fn play_gradient(
        &mut self,
        readings: &[Position],
        weights: &[(usize, f64)],
        reaches: &[PlayReach],
    ) -> Result<Vec<Vec2<f64>>, AccuracyError> {
        let tree = &self.mechanism.ideal;
        let n = tree.free;
        let (model, values) = (&self.mechanism.model, self.values);
        let output = |kinematics: &Kinematics<Dual<f64>>| -> f64 {
            let value = |(place, weight): &(usize, f64)| {
                weight * readings[*place].value(tree, kinematics, |point| point_m(model, values, point)).derivative
            };
            weights.iter().map(value).sum()
        };
        let mut coordinates: Vec<Dual<f64>> = self.coordinates.iter().map(|q| Dual::constant(*q)).collect();
        let mut adjoint = Vec::with_capacity(n);
        for k in 0..n {
            coordinates[k].derivative = 1.0;
            self.dual_kinematics.set_positions(tree, &self.dual_geometry, &coordinates);
            coordinates[k].derivative = 0.0;
            adjoint.push(output(&self.dual_kinematics));
        }
        if n > 0 {
            let matrix = self.loop_matrix();
            let mut transposed: Vec<f64> = (0..n * n).map(|at| matrix[at % n * n + at / n]).collect();
            let is_regular = solve_square(&mut transposed, n, &mut adjoint) > SINGULAR_PIVOT_RATIO;
            if !is_regular {
                return Err(AccuracyError::SingularWithPlay);
            }
        }
        let rows = self.mechanism.ideal_rows();
        let mut gradients = vec![Vec2::zero(); reaches.len()];
        for (play, reach) in reaches.iter().enumerate() {
            let (id, at) = (self.mechanism.plays[play], self.displacements[play]);
            let mut along = |x: f64, y: f64| {
                let moving = Vec2::new(Dual { value: at.x, derivative: x }, Dual { value: at.y, derivative: y });
                self.dual_geometry.set_displacement(tree, id, moving, &self.dual_centred_geometry);
                self.dual_kinematics.set_positions(tree, &self.dual_geometry, &coordinates);
                constraints::residuals(tree, &self.dual_geometry, &self.dual_kinematics, &mut self.dual_residuals);
                let parts = adjoint.iter().zip(rows).map(|(weight, row)| weight * self.dual_residuals[*row].derivative);
                output(&self.dual_kinematics) - parts.sum::<f64>()
            };
            gradients[play] = match *reach {
                PlayReach::Slot { clearance_m: 0.0 } => continue,
                PlayReach::Slot { .. } => Vec2::new(along(1.0, 0.0), 0.0),
                PlayReach::Disc { .. } | PlayReach::Guide { .. } => Vec2::new(along(1.0, 0.0), along(0.0, 1.0)),
            };
            self.dual_geometry.set_displacement(tree, id, Vec2::from_f64(at), &self.dual_centred_geometry);
        }
        Ok(gradients)
    }

    /// Derivatives of `readings` when the numbers of the mechanism move along `geometry`, its driven coordinates along
    /// `driven` and its points along `arm_m`: dq = -(dΦ/dq)⁻¹ dΦ, and the output's own derivative with it.
    ///
    /// # Errors
    /// The position is singular.
    pub fn derivatives(
        &mut self,
        geometry: &TreeNumbers<Dual<f64>>,
        driven: &[f64],
        readings: &[Position],
        arm_m: &dyn Fn(PointId) -> Vec2<Dual<f64>>,
    ) -> Result<Vec<f64>, AccuracyError> {
        let tree = &self.mechanism.ideal;
        let n = tree.free;
        let mut coordinates: Vec<Dual<f64>> = self.coordinates.iter().map(|q| Dual::constant(*q)).collect();
        for (coordinate, derivative) in coordinates[n..].iter_mut().zip(driven) {
            coordinate.derivative = *derivative;
        }
        self.dual_kinematics.set_positions(tree, geometry, &coordinates);
        constraints::residuals(tree, geometry, &self.dual_kinematics, &mut self.dual_residuals);
        let mut change: Vec<f64> =
            self.mechanism.ideal_rows().iter().map(|&row| -self.dual_residuals[row].derivative).collect();
        let mut matrix = self.loop_matrix();
        // Also false where an entry is not a number.
        let is_regular = n == 0 || solve_square(&mut matrix, n, &mut change) > SINGULAR_PIVOT_RATIO;
        if !is_regular {
            return Err(AccuracyError::SingularWithPlay);
        }
        for (coordinate, derivative) in coordinates[..n].iter_mut().zip(change) {
            coordinate.derivative = derivative;
        }
        self.dual_kinematics.set_positions(tree, geometry, &coordinates);
        let kinematics = &self.dual_kinematics;
        Ok(readings.iter().map(|reading| reading.value(tree, kinematics, arm_m).derivative).collect())
    }

    /// The matrix dΦ/dq over independent rows and free coordinates, n × n, row-major. Needs the present kinematics.
    fn loop_matrix(&mut self) -> Vec<f64> {
        let tree = &self.mechanism.ideal;
        let (n, columns) = (tree.free, tree.coordinates());
        constraints::jacobian(tree, &self.geometry, &self.kinematics, &mut self.jacobian);
        let rows = self.mechanism.ideal_rows();
        rows.iter().flat_map(|&row| self.jacobian[row * columns..row * columns + n].iter().copied()).collect()
    }

    fn set_kinematics(&mut self) {
        self.kinematics.set_positions(&self.mechanism.ideal, &self.geometry, &self.coordinates);
    }

    fn set_displacements(&mut self, displacements: &[Vec2<f64>]) {
        self.displacements.copy_from_slice(displacements);
        let tree = &self.mechanism.ideal;
        for (&id, &displacement) in self.mechanism.plays.iter().zip(displacements) {
            self.geometry.set_displacement(tree, id, displacement, &self.centred_geometry);
            self.dual_geometry.set_displacement(tree, id, Vec2::from_f64(displacement), &self.dual_centred_geometry);
        }
    }

    /// Closes the loops where no body turns far from `angles_rad`: close to a dead centre Newton's method may go anywhere.
    fn close_beside(&mut self, angles_rad: &[f64]) -> Result<(), AccuracyError> {
        self.close()?;
        let turned =
            self.kinematics.poses.iter().zip(angles_rad).map(|(pose, before)| (pose.angle_rad() - before).abs());
        if turned.fold(0.0, f64::max) > FURTHEST_RAD { Err(AccuracyError::SingularWithPlay) } else { Ok(()) }
    }

    fn keep_angles(&self, angles_rad: &mut Vec<f64>) {
        angles_rad.clear();
        angles_rad.extend(self.kinematics.poses.iter().map(|pose| pose.angle_rad()));
    }

    /// Newton's method for Φ(q, e) = 0 over the free coordinates.
    fn close(&mut self) -> Result<(), AccuracyError> {
        let n = self.mechanism.ideal.free;
        let size_m = self.mechanism.size_m;
        // Without a free coordinate there is no loop that could be open.
        if n == 0 {
            self.set_kinematics();
            return Ok(());
        }
        let mut polished = false;
        for _ in 0..NEWTON_STEPS {
            self.newton_steps += 1;
            self.set_kinematics();
            let tree = &self.mechanism.ideal;
            constraints::residuals(tree, &self.geometry, &self.kinematics, &mut self.residuals);
            let worst = self.residuals.iter().fold(0.0_f64, |w, r| w.max(r.abs()));
            let is_closed = worst <= NEARLY_CLOSED * size_m;
            let mut matrix = self.loop_matrix();
            if polished {
                let is_positive = determinant(&mut matrix, n) > 0.0;
                return match (is_closed, is_positive == self.is_positive) {
                    (true, true) => Ok(()),
                    (true, false) => Err(AccuracyError::SingularWithPlay),
                    (false, _) => Err(self.cannot_close()),
                };
            }
            polished = is_closed;
            let mut step: Vec<f64> = self.mechanism.ideal_rows().iter().map(|&row| -self.residuals[row]).collect();
            let is_regular = solve_square(&mut matrix, n, &mut step) > SINGULAR_PIVOT_RATIO;
            if !is_regular {
                return Err(AccuracyError::SingularWithPlay);
            }
            // Rows beside those that are solved may stay open: where nothing moves any more, nothing closes them.
            let is_at_rest =
                step.iter().zip(&self.coordinates).all(|(step, at)| step.abs() <= AT_REST * (1.0 + at.abs()));
            if is_at_rest && !is_closed {
                break;
            }
            self.coordinates.iter_mut().zip(step).for_each(|(coordinate, step)| *coordinate += step);
        }
        Err(self.cannot_close())
    }

    fn cannot_close(&self) -> AccuracyError {
        let tree = &self.mechanism.ideal;
        let open = LargestResidual::worst(&self.mechanism.model, tree, &self.residuals);
        AccuracyError::CannotCloseWithPlay { open }
    }
}
