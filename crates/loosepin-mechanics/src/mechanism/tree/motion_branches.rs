//! The two ways on from a change point: a position where branches of the ideal motion cross.

use crate::mechanism::loops::constraints;
use crate::mechanism::tree::kinematics::Kinematics;
use crate::mechanism::tree::numbers::TreeNumbers;
use crate::mechanism::tree::spanning_tree::Tree;
use loosepin_math::Elimination;

/// Loop equations that are further from singular than this share are not at a change point. One that was located to 1e-12 of a
/// turn leaves 1e-11; real pivots of ordinary mechanisms are above 1e-4.
const NEAREST_RATIO: f64 = 1e-6;
/// Angular velocities that differ by less than this share are one way, not two.
const SAME_SHARE: f64 = 1e-6;

/// The body that best shows which of two branches a motion takes, with its angular velocities on both.
#[derive(Debug, Clone, PartialEq)]
pub struct MotionBranches {
    /// Slot of the body in the ideal tree.
    pub slot: usize,
    /// Its angular velocity on either way, rad/s: the larger one first.
    pub angular_velocities_rad_s: [f64; 2],
}

/// The ways on at the positions and driven rates given.
///
/// At a change point the loop equations J q̇ = -J_d ṙ leave one direction ν open: q̇ = q̇₀ + α ν. Their derivative must vanish
/// too. In the direction w with wᵀ J = 0 it does not contain q̈: wᵀ Φ̈(q̇₀ + α ν) = 0 is a quadratic equation in α, whose two
/// roots are the two branches that cross.
///
/// `None` if the position is not singular, where the drives cannot go on (a dead point), or where no two ways exist.
pub fn motion_branches(
    tree: &Tree,
    geometry: &TreeNumbers<f64>,
    coordinates: &[f64],
    rates: &[f64],
    driven_accelerations: &[f64],
) -> Option<MotionBranches> {
    let (n, columns, rows) = (tree.free, tree.coordinates(), tree.constraint_rows());
    let mut kinematics = Kinematics::new(tree);
    kinematics.set_positions(tree, geometry, coordinates);
    let mut jacobian = vec![0.0; rows * columns];
    constraints::jacobian(tree, geometry, &kinematics, &mut jacobian);
    let free: Vec<f64> = jacobian.chunks_exact(columns).flat_map(|row| row[..n].iter().copied()).collect();
    let across: Vec<f64> =
        (0..n).flat_map(|column| (0..rows).map(move |row| (row, column))).map(|(r, c)| free[r * n + c]).collect();
    let elimination = Elimination::new(&free, rows, n, NEAREST_RATIO);
    let transposed = Elimination::new(&across, n, rows, NEAREST_RATIO);
    let (open, dependent) = (elimination.free_columns(), transposed.free_columns());
    let (&[open], &[dependent]) = (&open[..], &dependent[..]) else { return None };
    let (direction, weights) = (elimination.null_direction(open), transposed.null_direction(dependent));
    let driven: Vec<f64> = jacobian
        .chunks_exact(columns)
        .map(|row| -row[n..].iter().zip(&rates[n..]).map(|(slope, rate)| slope * rate).sum::<f64>())
        .collect();
    // A dead point stops the drives; in a crossing what they want along w is round-off of what they want at all.
    let largest = |values: &[f64]| values.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
    let size = largest(&driven) * largest(&weights);
    let against: f64 = driven.iter().zip(&weights).map(|(value, weight)| value * weight).sum();
    if against.abs() > NEAREST_RATIO * size {
        return None;
    }
    let start = elimination.solve(&driven);
    let mut at = |share: f64| {
        let mut all = rates.to_vec();
        for k in 0..n {
            all[k] = start[k] + share * direction[k];
        }
        kinematics.set_velocities(tree, &all);
        kinematics.set_biases(tree, geometry, &all, driven_accelerations);
        let mut biases = vec![0.0; rows];
        constraints::biases(tree, geometry, &kinematics, &mut biases);
        let bias: f64 = biases.iter().zip(&weights).map(|(bias, weight)| bias * weight).sum();
        let speeds: Vec<f64> = kinematics.twists.iter().map(|twist| twist.angular).collect();
        (bias, speeds)
    };
    // The rates of all coordinates are of the size of the driven ones.
    let unit = largest(&rates[n..]);
    let [below, middle, above] = [-unit, 0.0, unit].map(|share| at(share).0);
    let (curvature, slope) = (0.5 * (above + below) - middle, 0.5 * (above - below));
    let discriminant = slope * slope - 4.0 * curvature * middle;
    if !(discriminant > 0.0) || curvature == 0.0 {
        return None;
    }
    // The root without cancellation first, the other one from their product.
    let first = -0.5 * (slope + discriminant.sqrt().copysign(slope));
    let roots = [first / curvature, middle / first].map(|share| at(unit * share).1);
    let difference = |slot: usize| (roots[0][slot] - roots[1][slot]).abs();
    let slot = (0..roots[0].len()).max_by(|&a, &b| difference(a).total_cmp(&difference(b)))?;
    let speeds = [roots[0][slot].max(roots[1][slot]), roots[0][slot].min(roots[1][slot])];
    (speeds[0] - speeds[1] > SAME_SHARE * unit).then_some(MotionBranches { slot, angular_velocities_rad_s: speeds })
}
