//! Closing the loops for the first time: from hints to a configuration.

use crate::mechanism::beginning::initial::StartEquations;
use crate::mechanism::error::MechanismError;
use crate::mechanism::loops::constraints::LargestResidual;
use crate::mechanism::parts::drive::Drives;
use crate::mechanism::parts::drive_place::drive_place;
use crate::mechanism::tree::cut_numbers::CutNumbers;
use crate::mechanism::tree::kinematics::{Kinematics, Pose};
use crate::mechanism::tree::numbers::TreeNumbers;
use crate::mechanism::tree::spanning_tree::{Cut, Tree};
use crate::model::{Model, Row, Values};
use loosepin_math::solve_sparse_symmetric;

/// Starting points tried: the hinted one, then others spread over the circle.
const STARTS: usize = 48;
/// Levenberg-Marquardt steps from each starting point.
const STEPS: usize = 200;
/// Starting points that are tried however large the mechanism is, until one closes.
const MIN_STARTS: usize = 4;
/// What all steps may cost once these are tried: each costs the square of the free coordinates. Up to 60 free coordinates it is
/// enough for every step of every starting point; of 1,000 free bodies none but the first few are tried.
const MAX_WORK: usize = STARTS * STEPS * 60 * 60;
/// Residual relative to the size of the mechanism that counts as closed.
const CLOSED: f64 = 1e-11;
/// Two assemblies are the same when no body differs by more than this angle, rad, or share of the size.
const SAME: f64 = 1e-5;

/// The ways in which the loops close at the start.
#[derive(Debug, Clone)]
pub struct Assembly {
    /// Coordinates of the chosen configuration, free ones first.
    pub coordinates: Vec<f64>,
    /// Angles of all bodies, by slot, in the other configurations that were found, rad.
    pub alternatives_rad: Vec<Vec<f64>>,
}

/// Finds the configurations that close all loops at time zero and chooses the one nearest to the hints; without hints,
/// the one that is reached from all body frames parallel to the ground's.
///
/// # Errors
/// [`MechanismError::CannotClose`] with the best that was found.
pub fn assemble(equations: &StartEquations<'_>, values: &Values, size_m: f64) -> Result<Assembly, MechanismError> {
    let StartEquations { model, tree, geometry, .. } = *equations;
    let drives = Drives::new(model, values);
    let hints: Vec<(usize, f64)> =
        model.guesses.iter().map(|guess| (tree.slot_of_body[guess.body.0], values[guess.angle_rad])).collect();
    let mut hint_of_slot = vec![None; tree.links.len() + 1];
    for &(slot, angle_rad) in hints.iter().rev() {
        hint_of_slot[slot] = Some(angle_rad);
    }
    let mut kinematics = Kinematics::new(tree);
    let mut found: Vec<Configuration> = Vec::new();
    let mut best_open: Option<(f64, Vec<f64>)> = None;
    let (mut work, mut starts) = (0, 0);
    for start in 0..STARTS {
        let is_enough = if found.is_empty() { start >= MIN_STARTS } else { start > 0 };
        if is_enough && work >= MAX_WORK {
            break;
        }
        starts += 1;
        let mut z = starting_point(equations, &drives, &hint_of_slot, size_m, start);
        let (worst, steps) = close(equations, &mut kinematics, &mut z, (size_m, STEPS));
        work += steps * tree.free * tree.free;
        let is_elsewhere =
            !all_face_the_right_way(tree, geometry, &kinematics) || !found.is_empty() && is_turns_on(model, tree, &z);
        if !(worst <= CLOSED * size_m) || is_elsewhere {
            if best_open.as_ref().is_none_or(|(gap, _)| worst < *gap) {
                best_open = Some((worst, z));
            }
            continue;
        }
        // Given angles have their turns already, and couplings tell one turn from another.
        if model.initial.is_empty() && model.couplings.is_empty() {
            unwind(tree, geometry, &mut kinematics, &hint_of_slot, &mut z);
        }
        let poses = kinematics.poses.clone();
        let is_known = found.iter().any(|known| known.is_the_same(&poses, size_m));
        if !is_known {
            // Without hints the distance is zero, so that the first configuration found stays the first.
            let distance = hints.iter().map(|&(slot, hint)| 1.0 - (poses[slot].angle_rad() - hint).cos()).sum();
            found.push(Configuration { distance, coordinates: z, poses });
        }
        if tree.constraint_rows() == 0 && model.initial.is_empty() {
            break;
        }
    }
    found.sort_by(|a, b| a.distance.total_cmp(&b.distance));
    let mut found = found.into_iter();
    match found.next() {
        Some(chosen) => {
            let angles_rad = |other: Configuration| other.poses.iter().map(|pose| pose.angle_rad()).collect();
            Ok(Assembly { coordinates: chosen.coordinates, alternatives_rad: found.map(angles_rad).collect() })
        }
        None => {
            let z = best_open.map(|(_, z)| z).unwrap_or_default();
            kinematics.set_positions(tree, geometry, &z);
            let mut residuals = vec![0.0; equations.rows()];
            equations.residuals(&kinematics, &mut residuals);
            if let Some(error) = equations.contradiction(&residuals) {
                return Err(error);
            }
            let open = LargestResidual::worst(model, tree, &residuals[..tree.constraint_rows()]);
            if !model.initial.is_empty() {
                return Err(MechanismError::CannotCloseAsGiven { open });
            }
            let is_closed = residuals.iter().all(|residual| residual.abs() <= CLOSED * size_m);
            if let Some(cut) = turned_cut(tree, geometry, &kinematics).filter(|_| is_closed) {
                let joint = &model.joints[cut.joint.0];
                let bodies = joint.kind.bodies().map(|body| model.bodies[body.0].name.clone());
                return Err(MechanismError::ClosesTurned { path: format!("joint.{}", joint.name), bodies });
            }
            let guesses =
                model.guesses.iter().map(|guess| (model.bodies[guess.body.0].name.clone(), values[guess.angle_rad]));
            Err(MechanismError::CannotClose {
                open,
                at: drive_place(model, tree, &z),
                starts,
                guesses: guesses.collect(),
            })
        }
    }
}

/// A configuration that closes all loops.
struct Configuration {
    /// Distance to the hints: Σ 1 - cos(angle - hint).
    distance: f64,
    coordinates: Vec<f64>,
    /// Poses by slot.
    poses: Vec<Pose<f64>>,
}

impl Configuration {
    fn is_the_same(&self, poses: &[Pose<f64>], size_m: f64) -> bool {
        self.poses.iter().zip(poses).all(|(a, b)| {
            (a.position_m - b.position_m).length() < SAME * size_m
                && ((a.angle_rad() - b.angle_rad()) / 2.0).sin().abs() < SAME
        })
    }
}

/// Hinted bodies start at their hint in every attempt; the others at zero first, then spread.
fn starting_point(
    equations: &StartEquations<'_>,
    drives: &Drives<f64>,
    hint_of_slot: &[Option<f64>],
    size_m: f64,
    start: usize,
) -> Vec<f64> {
    let StartEquations { model, tree, .. } = *equations;
    let mut z = vec![0.0; tree.coordinates()];
    for (k, drive) in tree.drives.iter().enumerate() {
        z[tree.free + k] = drives.at(model, *drive, 0.0)[0];
    }
    for (index, link) in tree.links.iter().enumerate() {
        // Multiples of irrational numbers fill the circle evenly, differently for each body.
        let spread = (start as f64 * (0.618_033_988_749_895 + 0.137_1 * index as f64)).fract();
        let angle = hint_of_slot[index + 1].unwrap_or(std::f64::consts::TAU * if start == 0 { 0.0 } else { spread });
        let length = if start == 0 { 0.0 } else { size_m * (2.0 * spread - 1.0) };
        if let Some(coordinate) = link.angle() {
            z[coordinate] = angle;
        } else if !link.is_driven {
            z[link.lengths()].fill(length);
        }
    }
    z
}

/// The constraint that stays furthest open where all of them are as nearly closed as they can be near `z` with the drives where they are:
/// where |Φ|² is least. Of a single loop that is its least gap.
pub fn least_open(equations: &StartEquations<'_>, mut z: Vec<f64>, size_m: f64) -> LargestResidual {
    /// From a position close by about ten are usual.
    const NEAR_STEPS: usize = 40;
    let StartEquations { model, tree, .. } = *equations;
    let mut kinematics = Kinematics::new(tree);
    close(equations, &mut kinematics, &mut z, (size_m, NEAR_STEPS));
    let mut residuals = vec![0.0; equations.rows()];
    equations.residuals(&kinematics, &mut residuals);
    LargestResidual::worst(model, tree, &residuals[..tree.constraint_rows()])
}

/// Minimises |Φ|² by Levenberg and Marquardt's method over the free coordinates, in so many steps at most; gives the largest residual left
/// and the number of steps.
fn close(
    equations: &StartEquations<'_>,
    kinematics: &mut Kinematics<f64>,
    z: &mut [f64],
    (size_m, most_steps): (f64, usize),
) -> (f64, usize) {
    let StartEquations { tree, geometry, .. } = *equations;
    let (n, rows, columns) = (tree.free, equations.rows(), tree.coordinates());
    // Lengths are counted in sizes of the mechanism, so that they weigh like angles.
    let mut scale = vec![1.0; n];
    for link in &tree.links {
        if !link.is_driven {
            scale[link.lengths()].fill(size_m);
        }
    }
    let mut residuals = vec![0.0; rows];
    let mut jacobian = vec![0.0; rows * columns];
    let mut filled = Vec::with_capacity(n);
    // Of large mechanisms these are megabytes: taken once, not in each step.
    let [mut normal, mut damped] = [(); 2].map(|()| vec![0.0; n * n]);
    let [mut step, mut delta] = [(); 2].map(|()| vec![0.0; n]);
    let mut trial = z.to_vec();
    let mut damping = 1e-3;
    let evaluate = |kinematics: &mut Kinematics<f64>, z: &[f64], residuals: &mut [f64]| {
        kinematics.set_positions(tree, geometry, z);
        equations.residuals(kinematics, residuals);
        residuals.iter().map(|r| r * r).sum::<f64>()
    };
    let mut error = evaluate(kinematics, z, &mut residuals);
    let mut steps = 0;
    for _ in 0..most_steps {
        if error.sqrt() <= 1e-15 * size_m {
            break;
        }
        steps += 1;
        equations.jacobian(kinematics, &mut jacobian);
        // The upper triangle of JᵀJ, row by row over what the row depends on.
        normal.fill(0.0);
        step.fill(0.0);
        for row in 0..rows {
            let slopes = &jacobian[row * columns..row * columns + n];
            filled.clear();
            filled.extend((0..n).filter(|i| slopes[*i] != 0.0));
            for (place, &i) in filled.iter().enumerate() {
                let left = slopes[i] * scale[i];
                step[i] -= left * residuals[row];
                for &j in &filled[..=place] {
                    normal[j * n + i] += left * slopes[j] * scale[j];
                }
            }
        }
        let largest = (0..n).fold(0.0_f64, |l, i| l.max(normal[i * n + i]));
        let mut improved = false;
        for _ in 0..12 {
            damped.copy_from_slice(&normal);
            for i in 0..n {
                damped[i * n + i] += damping * largest + f64::MIN_POSITIVE;
            }
            delta.copy_from_slice(&step);
            solve_sparse_symmetric(&mut damped, n, &mut delta);
            // A turn of more than half a radian at once would jump between branches.
            let longest = delta.iter().fold(0.0_f64, |l, d| l.max(d.abs()));
            let shorten = f64::min(1.0, 0.5 / longest);
            trial.copy_from_slice(z);
            for i in 0..n {
                trial[i] += shorten * delta[i] * scale[i];
            }
            let trial_error = evaluate(kinematics, &trial, &mut residuals);
            if trial_error < error {
                z.copy_from_slice(&trial);
                error = trial_error;
                damping = (damping * 0.1).max(1e-14);
                improved = true;
                break;
            }
            damping *= 10.0;
        }
        if !improved {
            break;
        }
    }
    evaluate(kinematics, z, &mut residuals);
    let worst = residuals.iter().fold(0.0, |worst: f64, r| if r.is_nan() { f64::INFINITY } else { worst.max(r.abs()) });
    (worst, steps)
}

/// Takes whole turns out of the angles: every absolute angle to within half a turn of its hint, or of zero, then further so
/// that bodies which a cut joint keeps from turning against each other differ by no whole turn either.
fn unwind(
    tree: &Tree,
    geometry: &TreeNumbers<f64>,
    kinematics: &mut Kinematics<f64>,
    hint_of_slot: &[Option<f64>],
    z: &mut [f64],
) {
    let turns = |angle: f64| (angle / std::f64::consts::TAU).round() * std::f64::consts::TAU;
    for (index, link) in tree.links.iter().enumerate() {
        if let Some(coordinate) = link.joint_angle() {
            z[coordinate] -= turns(z[coordinate] - hint_of_slot[index + 1].unwrap_or(0.0));
        }
    }
    // The absolute angle that a slot turns with, if any: its own, or that of the nearest parent that has one.
    let carrier = |mut slot: usize| loop {
        if slot == 0 {
            return None;
        }
        let link = &tree.links[slot - 1];
        if let Some(coordinate) = link.angle() {
            return Some(coordinate);
        }
        slot = link.parent_slot;
    };
    // Each pass settles at least one more cut joint of a chain.
    kinematics.set_positions(tree, geometry, z);
    for _ in 0..tree.cuts.len() {
        let wound = tree.cuts.iter().zip(&geometry.cuts).find_map(|(cut, numbers)| {
            let turn = turns(cut_turn_rad(cut, numbers, kinematics));
            (holds_angle(cut) && turn != 0.0).then_some((cut, turn))
        });
        let Some((cut, turn)) = wound else { return };
        match (carrier(cut.slots[1]), carrier(cut.slots[0])) {
            (Some(coordinate), _) => z[coordinate] -= turn,
            (None, Some(coordinate)) => z[coordinate] += turn,
            (None, None) => return,
        }
        kinematics.set_positions(tree, geometry, z);
    }
}

/// Whether the bodies of a cut joint do not turn against each other.
fn holds_angle(cut: &Cut) -> bool {
    cut.rows.iter().any(|row| row.is_angle())
}

/// Angle by which a cut joint's second body is turned against its first, rad: zero where the joint is closed.
fn cut_turn_rad(cut: &Cut, numbers: &CutNumbers<f64>, kinematics: &Kinematics<f64>) -> f64 {
    kinematics.poses[cut.slots[1]].angle_rad() + numbers.markers[1]
        - kinematics.poses[cut.slots[0]].angle_rad()
        - numbers.markers[0]
}

/// Whether a body stands more than half a turn from zero in a mechanism with couplings: the same position, its wheels in mesh with
/// other teeth, is no other way of assembling the links.
fn is_turns_on(model: &Model, tree: &Tree, z: &[f64]) -> bool {
    let is_far = |angle_rad: f64| angle_rad.abs() > std::f64::consts::PI;
    let wheels = model.couplings.iter().flat_map(|coupling| [coupling.first, coupling.second]);
    let wheels: Vec<_> = wheels.flat_map(|joint| model.joints[joint.0].kind.bodies()).collect();
    let mut turning = tree.links.iter().filter(|link| wheels.contains(&link.body));
    turning.any(|link| link.joint_angle().is_some_and(|coordinate| is_far(z[coordinate])))
}

/// The sine of an angle that should be zero is zero at a half turn as well: that is no assembly.
fn all_face_the_right_way(tree: &Tree, geometry: &TreeNumbers<f64>, kinematics: &Kinematics<f64>) -> bool {
    turned_cut(tree, geometry, kinematics).is_none()
}

/// The first cut whose bodies are turned by a half turn against each other.
fn turned_cut<'t>(tree: &'t Tree, geometry: &TreeNumbers<f64>, kinematics: &Kinematics<f64>) -> Option<&'t Cut> {
    let is_turned = |(cut, numbers): &(&Cut, &CutNumbers<f64>)| {
        holds_angle(cut) && !(cut_turn_rad(cut, numbers, kinematics).cos() > 0.0)
    };
    tree.cuts.iter().zip(&geometry.cuts).find(is_turned).map(|(cut, _)| cut)
}
