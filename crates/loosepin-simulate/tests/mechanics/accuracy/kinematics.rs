//! Partial velocities, accelerations and constraints against exact derivatives on dual numbers.

use super::{Built, build_case, case_names, ideal_at, spread};
use loosepin_math::{Dual, Real};
use loosepin_mechanics::mechanism::{Kinematics, Tree, TreeNumbers, constraints};

type Nested = Dual<Dual<f64>>;

/// Round-off of a chain of a dozen bodies with rates of order ten, relative to the largest entry.
const ROUND_OFF: f64 = 1e-11;

/// q + q̇ t + q̈ t²/2 as a number whose first and second derivative with respect to t it carries.
fn nested(value: f64, rate: f64, acceleration: f64) -> Nested {
    Dual { value: Dual { value, derivative: rate }, derivative: Dual { value: rate, derivative: acceleration } }
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= ROUND_OFF * (1.0 + a.abs().max(b.abs()))
}

fn trees(built: &Built) -> [&Tree; 2] {
    [&built.mechanism.ideal, &built.mechanism.real]
}

fn geometry<T: Real>(built: &Built, tree: &Tree) -> TreeNumbers<T> {
    TreeNumbers::new(&built.mechanism.model, tree, &built.values)
}

#[test]
fn identity_partial_velocities_are_derivatives_of_positions() {
    for case in case_names() {
        let built = build_case(&case);
        for tree in trees(&built) {
            let z: Vec<f64> = (0..tree.coordinates()).map(|k| 1.7 * spread(k, 0.013)).collect();
            let mut plain = Kinematics::<f64>::new(tree);
            plain.set_positions(tree, &geometry(&built, tree), &z);
            for moved in 0..z.len() {
                let coordinates: Vec<Dual<f64>> =
                    (0..z.len()).map(|k| Dual { value: z[k], derivative: f64::from(k == moved) }).collect();
                let mut kinematics = Kinematics::new(tree);
                kinematics.set_positions(tree, &geometry(&built, tree), &coordinates);
                for index in 0..tree.links.len() {
                    let pose = &kinematics.poses[index + 1];
                    let column = plain.columns(tree, index + 1).find(|column| column.coordinate == moved);
                    let (x, y, turning) =
                        column.map_or((0.0, 0.0, 0.0), |column| (column.linear.x, column.linear.y, column.turning));
                    assert!(close(pose.position_m.x.derivative, x), "{case} x of link {index} by {moved}");
                    assert!(close(pose.position_m.y.derivative, y), "{case} y of link {index} by {moved}");
                    assert_eq!(pose.angle_rad().derivative, turning, "{case} angle of link {index} by {moved}");
                }
            }
        }
    }
}

#[test]
fn identity_acceleration_biases_are_second_derivatives() {
    for case in case_names() {
        let built = build_case(&case);
        for tree in trees(&built) {
            let columns = tree.coordinates();
            let z: Vec<f64> = (0..columns).map(|k| 1.3 * spread(k, 0.021)).collect();
            let rates: Vec<f64> = (0..columns).map(|k| 9.0 * spread(k, 0.034)).collect();
            let driven: Vec<f64> = (0..tree.drives.len()).map(|k| 40.0 * spread(k, 0.055)).collect();
            let numbers = geometry(&built, tree);
            let mut plain = Kinematics::new(tree);
            plain.set_positions(tree, &numbers, &z);
            plain.set_velocities(tree, &rates);
            plain.set_biases(tree, &numbers, &rates, &driven);
            let coordinates: Vec<Nested> = (0..columns)
                .map(|k| nested(z[k], rates[k], if k < tree.free { 0.0 } else { driven[k - tree.free] }))
                .collect();
            let mut kinematics = Kinematics::<Nested>::new(tree);
            kinematics.set_positions(tree, &geometry(&built, tree), &coordinates);
            for slot in 0..=tree.links.len() {
                let (pose, twist, bias) = (&kinematics.poses[slot], &plain.twists[slot], &plain.biases[slot]);
                let entries = [
                    (pose.position_m.x, twist.linear.x, bias.linear.x),
                    (pose.position_m.y, twist.linear.y, bias.linear.y),
                    (pose.angle_rad(), twist.angular, bias.angular),
                ];
                for (entry, velocity, acceleration) in entries {
                    assert!(close(entry.value.derivative, velocity), "{case} velocity of slot {slot}");
                    assert!(close(entry.derivative.derivative, acceleration), "{case} acceleration of slot {slot}");
                }
            }
        }
    }
}

#[test]
fn identity_constraint_jacobian_and_biases_are_derivatives_of_the_residuals() {
    for case in case_names() {
        let built = build_case(&case);
        for tree in trees(&built) {
            let (rows, columns) = (tree.constraint_rows(), tree.coordinates());
            let z: Vec<f64> = (0..columns).map(|k| 1.1 * spread(k, 0.047)).collect();
            let rates: Vec<f64> = (0..columns).map(|k| 7.0 * spread(k, 0.029)).collect();
            let numbers = geometry(&built, tree);
            let mut plain = Kinematics::new(tree);
            plain.set_positions(tree, &numbers, &z);
            plain.set_velocities(tree, &rates);
            plain.set_biases(tree, &numbers, &rates, &vec![0.0; tree.drives.len()]);
            let mut jacobian = vec![0.0; rows * columns];
            constraints::jacobian(tree, &numbers, &plain, &mut jacobian);
            let mut biases = vec![0.0; rows];
            constraints::biases(tree, &numbers, &plain, &mut biases);

            let coordinates: Vec<Nested> = (0..columns).map(|k| nested(z[k], rates[k], 0.0)).collect();
            let mut kinematics = Kinematics::<Nested>::new(tree);
            let numbers = geometry(&built, tree);
            kinematics.set_positions(tree, &numbers, &coordinates);
            let mut residuals = vec![Nested::zero(); rows];
            constraints::residuals(tree, &numbers, &kinematics, &mut residuals);
            for row in 0..rows {
                let rate: f64 = (0..columns).map(|k| jacobian[row * columns + k] * rates[k]).sum();
                assert!(close(residuals[row].value.derivative, rate), "{case} row {row}");
                assert!(close(residuals[row].derivative.derivative, biases[row]), "{case} row {row}");
            }
        }
    }
}

#[test]
fn identity_ideal_accelerations_close_the_loops_to_second_order() {
    for case in case_names() {
        let built = build_case(&case);
        let sample = built.sample();
        let turn_s = built.input().turn_s();
        let motion = ideal_at(&built, &sample, 0.137 * turn_s);
        let tree = &built.mechanism.ideal;
        let free = tree.free;
        let (z, rates) = motion.real_state();
        let coordinates: Vec<Nested> = (0..tree.coordinates())
            .map(|k| nested(z[k], rates[k], if k < free { motion.accelerations()[k] } else { 0.0 }))
            .collect();
        let mut kinematics = Kinematics::<Nested>::new(tree);
        let numbers = geometry(&built, tree);
        kinematics.set_positions(tree, &numbers, &coordinates);
        let mut residuals = vec![Nested::zero(); tree.constraint_rows()];
        constraints::residuals(tree, &numbers, &kinematics, &mut residuals);
        let speed = rates.iter().fold(0.0_f64, |fastest, rate| fastest.max(rate.abs()));
        for (row, residual) in residuals.iter().enumerate() {
            assert!(residual.value.value.abs() < 1e-14, "{case} row {row} is open");
            assert!(residual.value.derivative.abs() < ROUND_OFF * speed, "{case} row {row} opens");
            assert!(residual.derivative.derivative.abs() < ROUND_OFF * speed * speed, "{case} row {row} accelerates");
        }
        for slot in 0..=tree.links.len() {
            let (pose, acceleration) = (&kinematics.poses[slot], motion.acceleration(slot));
            let scale = ROUND_OFF * speed * speed;
            assert!((pose.position_m.x.derivative.derivative - acceleration.linear.x).abs() < scale, "{case} {slot}");
            assert!((pose.position_m.y.derivative.derivative - acceleration.linear.y).abs() < scale, "{case} {slot}");
            assert!((pose.angle_rad().derivative.derivative - acceleration.angular).abs() < scale, "{case} {slot}");
        }
    }
}
