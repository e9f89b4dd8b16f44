//! Partial velocities, accelerations and equations of motion in space against exact derivatives on dual numbers.

use super::{Body, Loop, broadcast, link, tree_of, vector};
use crate::accuracy::spread;
use loosepin_math::{Dual, Geometry, Real, Rotation, Space, SpaceInertia, SpaceMount, Vec3};
use loosepin_mechanics::mechanism::{
    Ball, CutNumbers, Free, KindOfAttachment, Kinematics, Prismatic, Revolute, Rigid, SpaceAttachment, Tree,
    TreeNumbers, cut_biases, cut_jacobian, cut_residuals,
};
use loosepin_mechanics::model::MarkerAxis::{X, Y, Z};
use loosepin_mechanics::model::{JointId, SpaceRow};

type Nested = Dual<Dual<f64>>;

/// Of a chain of seven bodies with rates of order one, relative to the largest entry.
const ROUND_OFF: f64 = 1e-12;

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= ROUND_OFF * (1.0 + a.abs().max(b.abs()))
}

/// Every condition, with axes of every kind.
const ALL_ROWS: &[SpaceRow] = &[
    SpaceRow::Coincident,
    SpaceRow::Perpendicular(X, Z),
    SpaceRow::Across(Y),
    SpaceRow::Perpendicular(Y, X),
    SpaceRow::Across(Z),
];

/// A body that floats freely and carries a chain of one joint of every kind, hung either way, with a second branch.
fn tree() -> (Tree<Space>, TreeNumbers<f64, Space>) {
    let joint = JointId;
    let kinds: [(usize, SpaceAttachment, bool); 7] = [
        (0, Free.into(), false),
        (1, Revolute { joint: joint(0), forward: true, turns_alone: false }.into(), false),
        (2, Revolute { joint: joint(1), forward: false, turns_alone: false }.into(), true),
        (3, Prismatic { joint: joint(2), forward: true }.into(), false),
        (4, Ball { joint: joint(3), forward: true }.into(), false),
        (5, Rigid { joint: joint(4), forward: true }.into(), false),
        (3, Prismatic { joint: joint(5), forward: false }.into(), true),
    ];
    let bodies = kinds.into_iter().enumerate().map(|(index, (parent_slot, attachment, is_driven))| {
        let three = |salt: f64| [0, 1, 2].map(|k| spread(3 * index + k, salt));
        let marker = |salt: f64| {
            let [x, y, z] = three(salt);
            let length = (1.0 + x * x + y * y + z * z).sqrt();
            Space::oriented(&[1.0, x, y, z].map(|entry| entry / length), None)
        };
        let mut numbers = link([three(0.1), three(0.2)], marker(0.3), 1.0 + index as f64, [2.0, 3.0, 4.0]);
        numbers.mount = SpaceMount::new(marker(0.3), marker(0.4));
        numbers.centre_of_mass_m = vector(three(0.5));
        numbers.inertia_kg_m2 =
            SpaceInertia { diagonal_kg_m2: [2.0, 3.0, 4.0], beside_kg_m2: three(0.6).map(|p| 0.3 * p) };
        Body { parent_slot, attachment, is_driven, numbers }
    });
    let loops = [(7, 5), (0, 6)].into_iter().enumerate().map(|(index, (first, second))| {
        let three = |salt: f64| vector([0, 1, 2].map(|k| spread(3 * index + k, salt)));
        let marker = |salt: f64| {
            let Vec3 { x, y, z } = three(salt);
            let length = (1.0 + x * x + y * y + z * z).sqrt();
            Space::oriented(&[1.0, x, y, z].map(|entry| entry / length), None)
        };
        let numbers = CutNumbers {
            arms_m: [three(0.7), three(0.8)],
            markers: [marker(0.15), marker(0.25)],
            eccentricity_m: three(0.35) * 0.1,
            radius_m: 0.0,
        };
        Loop { slots: [first, second], rows: ALL_ROWS, numbers }
    });
    tree_of(&bodies.collect::<Vec<_>>(), &loops.collect::<Vec<_>>(), vector([0.3, -1.0, 9.0]))
}

/// Coordinates that do not repeat, quaternions of unit length.
fn coordinates(tree: &Tree<Space>) -> Vec<f64> {
    let mut all: Vec<f64> = (0..tree.free + tree.drives.len()).map(|k| 0.8 * spread(k, 0.013)).collect();
    for link in &tree.links {
        let own = link.coordinates.clone();
        if own.len() >= 4 {
            let quaternion = &mut all[own.end - 4..own.end];
            let length = quaternion.iter().map(|entry| entry * entry).sum::<f64>().sqrt();
            quaternion.iter_mut().for_each(|entry| *entry /= length);
        }
    }
    all
}

/// Rates of all coordinates for the speeds.
fn coordinate_rates<T: Real>(tree: &Tree<Space>, coordinates: &[T], speeds: &[T]) -> Vec<T> {
    let mut rates = vec![T::zero(); coordinates.len()];
    for link in &tree.links {
        let own = link.coordinates.clone();
        link.attachment.coordinate_rates(&coordinates[own.clone()], &speeds[link.speeds.clone()], &mut rates[own]);
    }
    rates
}

/// The vector of the skew part of S Rᵀ: ω of S = Ṙ, where nothing else is left, and α of S = R̈, for R̈ Rᵀ = α× + ω× ω×.
fn skew_part(rotation: &Rotation, rate: &Rotation) -> Vec3 {
    let axes = [(rate.x, rotation.x), (rate.y, rotation.y), (rate.z, rotation.z)];
    let sum = axes.iter().fold(vector([0.0; 3]), |sum, (rate, axis)| sum + axis.cross(*rate));
    sum * 0.5
}

fn value(v: Vec3<Dual<f64>>) -> Vec3 {
    Vec3::new(v.x.value, v.y.value, v.z.value)
}

fn derivative(v: Vec3<Dual<f64>>) -> Vec3 {
    Vec3::new(v.x.derivative, v.y.derivative, v.z.derivative)
}

fn parts(rotation: &Rotation<Dual<f64>>) -> [Rotation; 2] {
    let of =
        |part: fn(Vec3<Dual<f64>>) -> Vec3| Rotation { x: part(rotation.x), y: part(rotation.y), z: part(rotation.z) };
    [of(value), of(derivative)]
}

#[test]
fn identity_partial_velocities_in_space_are_derivatives_of_positions() {
    let (tree, numbers) = tree();
    let z = coordinates(&tree);
    let mut plain = Kinematics::<f64, Space>::new(&tree);
    plain.set_positions(&tree, &numbers, &z);
    for moved in 0..tree.speeds() {
        let unit: Vec<f64> = (0..tree.speeds()).map(|k| f64::from(k == moved)).collect();
        let rates = coordinate_rates(&tree, &z, &unit);
        let along: Vec<Dual<f64>> =
            z.iter().zip(rates).map(|(&value, derivative)| Dual { value, derivative }).collect();
        let mut kinematics = Kinematics::new(&tree);
        kinematics.set_positions(&tree, &broadcast(&numbers), &along);
        for slot in 1..=tree.links.len() {
            let column = plain.columns(&tree, slot).find(|column| column.coordinate == moved);
            let zero = Vec3::new(0.0, 0.0, 0.0);
            let (linear, turning) = column.map_or((zero, zero), |column| (column.linear, column.turning));
            let pose = &kinematics.poses[slot];
            let [rotation, rate] = parts(&pose.rotation);
            let found = [derivative(pose.position_m).to_array(), skew_part(&rotation, &rate).to_array()].concat();
            for (found, stated) in found.iter().zip([linear.to_array(), turning.to_array()].concat()) {
                assert!(close(*found, stated), "slot {slot} by speed {moved}: {found} {stated}");
            }
        }
    }
}

#[test]
fn identity_jacobian_of_loops_in_space_is_the_derivative_of_residuals() {
    let (tree, numbers) = tree();
    let z = coordinates(&tree);
    let (rows, columns) = (tree.cut_rows(), tree.speeds());
    assert_eq!(rows, 14);
    let mut plain = Kinematics::<f64, Space>::new(&tree);
    plain.set_positions(&tree, &numbers, &z);
    let mut jacobian = vec![0.0; rows * columns];
    cut_jacobian(&tree, &numbers, &plain, &mut jacobian);
    for moved in 0..columns {
        let unit: Vec<f64> = (0..columns).map(|k| f64::from(k == moved)).collect();
        let rates = coordinate_rates(&tree, &z, &unit);
        let along: Vec<Dual<f64>> =
            z.iter().zip(rates).map(|(&value, derivative)| Dual { value, derivative }).collect();
        let (mut kinematics, dual) = (Kinematics::new(&tree), broadcast(&numbers));
        kinematics.set_positions(&tree, &dual, &along);
        let mut residuals = vec![Dual::constant(0.0); rows];
        cut_residuals(&tree, &dual, &kinematics, &mut residuals);
        for (row, residual) in residuals.iter().enumerate() {
            let stated = jacobian[row * columns + moved];
            assert!(close(residual.derivative, stated), "row {row} by speed {moved}: {} {stated}", residual.derivative);
        }
    }
}

/// d/dt of velocities along the motion in which free speeds do not change, and driven ones as their drives say.
#[test]
fn identity_acceleration_biases_in_space_are_second_derivatives() {
    let (tree, numbers) = tree();
    let z = coordinates(&tree);
    let speeds: Vec<f64> = (0..tree.speeds()).map(|k| 1.9 * spread(k, 0.034)).collect();
    let driven: Vec<f64> = (0..tree.drives.len()).map(|k| 4.0 * spread(k, 0.055)).collect();
    let mut plain = Kinematics::<f64, Space>::new(&tree);
    plain.set_positions(&tree, &numbers, &z);
    plain.set_velocities(&tree, &speeds);
    plain.set_biases(&tree, &numbers, &speeds, &driven);

    // z(t) to second order: its rates are functions of coordinates and speeds, which dual numbers carry.
    let rates = coordinate_rates(&tree, &z, &speeds);
    let along: Vec<Dual<f64>> = z.iter().zip(&rates).map(|(&value, &derivative)| Dual { value, derivative }).collect();
    let changing: Vec<Dual<f64>> = speeds
        .iter()
        .enumerate()
        .map(|(k, &value)| Dual {
            value,
            derivative: if k < tree.free_speeds { 0.0 } else { driven[k - tree.free_speeds] },
        })
        .collect();
    let rate_and_change = coordinate_rates(&tree, &along, &changing);
    let nested: Vec<Nested> =
        along.iter().zip(rate_and_change).map(|(&value, derivative)| Dual { value, derivative }).collect();
    let mut kinematics = Kinematics::new(&tree);
    kinematics.set_positions(&tree, &broadcast::<Nested>(&numbers), &nested);
    let rows = tree.cut_rows();
    let (mut residuals, mut biases) = (vec![Nested::constant(Dual::constant(0.0)); rows], vec![0.0; rows]);
    cut_residuals(&tree, &broadcast::<Nested>(&numbers), &kinematics, &mut residuals);
    cut_biases(&tree, &numbers, &plain, &mut biases);
    for (row, (residual, bias)) in residuals.iter().zip(&biases).enumerate() {
        assert!(close(residual.derivative.derivative, *bias), "row {row}: {} {bias}", residual.derivative.derivative);
    }
    for slot in 1..=tree.links.len() {
        let pose = &kinematics.poses[slot];
        let position = [pose.position_m.x, pose.position_m.y, pose.position_m.z];
        let (twist, bias) = (&plain.twists[slot], &plain.biases[slot]);
        for (k, entry) in position.iter().enumerate() {
            let (velocity, acceleration) = (twist.linear.to_array()[k], bias.linear.to_array()[k]);
            assert!(close(entry.derivative.value, velocity), "velocity of slot {slot}");
            assert!(close(entry.derivative.derivative, acceleration), "acceleration of slot {slot}");
        }
        let of = |part: fn(Nested) -> Dual<f64>| {
            let vector = |v: Vec3<Nested>| Vec3::new(part(v.x), part(v.y), part(v.z));
            Rotation { x: vector(pose.rotation.x), y: vector(pose.rotation.y), z: vector(pose.rotation.z) }
        };
        let [[rotation, rate], [_, change]] = [parts(&of(|n| n.value)), parts(&of(|n| n.derivative))];
        let spin = skew_part(&rotation, &rate);
        let change_of_spin = skew_part(&rotation, &change);
        for k in 0..3 {
            assert!(close(spin.to_array()[k], twist.angular.to_array()[k]), "spin of slot {slot}");
            assert!(close(change_of_spin.to_array()[k], bias.angular.to_array()[k]), "change of spin of slot {slot}");
        }
    }
}
