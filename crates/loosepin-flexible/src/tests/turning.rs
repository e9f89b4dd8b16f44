//! A beam that turns steadily about its root: stiffening, stretch.

use super::rectangular;
use crate::spectrum::eigenvalues;
use crate::{Beam, Frame, Inertia, Shapes};
use loosepin_math::{Dual, Numbers};

/// Squares of the frequencies at the straight position, in units of EI/(m L³), for the spin γ in the root of it.
fn squares(beam: &Beam<f64>, shapes: &Shapes, gamma: f64) -> Vec<f64> {
    let n = shapes.count();
    let unit_1_s2 = beam.bending_stiffness_n_m / (beam.mass_kg * beam.length_m.powi(2));
    let spin = gamma * unit_1_s2.sqrt();
    let mut inertia = Inertia::new(shapes);
    beam.inertia(shapes, &vec![0.0; n], &vec![0.0; n], spin, &mut inertia);
    let mass: Vec<f64> = (0..n * n).map(|k| inertia.mass[(3 + k / n) * (3 + n) + 3 + k % n]).collect();
    let mut stiffness = vec![0.0; n * n];
    let (dual, still) = (Beam::<Dual<f64>>::broadcast(beam), vec![Dual::constant(0.0); n]);
    let mut inertia = Inertia::new(shapes);
    for column in 0..n {
        let mut q = still.clone();
        q[column].derivative = 1.0;
        dual.inertia(shapes, &q, &still, Dual::constant(spin), &mut inertia);
        let mut forces: Vec<Dual<f64>> = inertia.bias[3..].iter().map(|bias| -*bias).collect();
        dual.add_elastic(shapes, &q, &still, &mut forces);
        for row in 0..n {
            stiffness[row * n + column] = -forces[row].derivative;
        }
    }
    for row in 0..n {
        for column in 0..row {
            let mean = 0.5 * (stiffness[row * n + column] + stiffness[column * n + row]);
            (stiffness[row * n + column], stiffness[column * n + row]) = (mean, mean);
        }
    }
    eigenvalues(&mass, &stiffness, n).iter().map(|square| square / unit_1_s2).collect()
}

#[test]
fn published_a_turning_cantilever_stiffens() {
    // Shooting on the exact differential equation; ten shapes come to it within the relative errors given, from above.
    let beam = rectangular([2e11, 7870.0, 0.3, 8e-3, 8e-3]);
    let shapes = Shapes::new(Frame::Tangent, 0, 10);
    let known = [
        (1.0, 3.5432362697, 22.1584578810, 1e-8),
        (2.0, 3.6217969641, 22.5263111738, 7e-8),
        (4.0, 3.8977225236, 23.9415014321, 1.15e-6),
        (10.0, 5.0489748754, 32.1196857831, 6e-5),
    ];
    for (gamma, first, second, largest) in known {
        let found = squares(&beam, &shapes, gamma);
        let off = found[0].sqrt() / first - 1.0;
        assert!((-1e-10..largest).contains(&off), "γ = {gamma}: {off:e}");
        assert!((found[1].sqrt() - second).abs() < 1e-4 * second, "γ = {gamma}: {}", found[1].sqrt());
    }
    // Without foreshortening it softens instead, and buckles.
    let linear = Beam { foreshortening: false, ..beam };
    for gamma in [1.0, 4.0] {
        let found = squares(&linear, &shapes, gamma)[0];
        assert!((found - (12.362363 - gamma * gamma)).abs() < 1e-6, "{found}");
    }
}

#[test]
fn published_stretch_of_a_rod_that_turns_about_its_end() {
    // tan(κL)/κ - L, κ = ω √(ρ/E); with 1, 2, 4 and 8 shapes by another program.
    let beam = rectangular([2e11, 7870.0, 0.3, 8e-3, 8e-3]);
    let kappa = 1000.0 * (7870.0_f64 / 2e11).sqrt();
    let exact_m = (kappa * 0.3).tan() / kappa - 0.3;
    assert!((exact_m - 3.546524091e-4).abs() < 1e-13);
    for (count, known_m) in [(1, 3.545685682e-4), (2, 3.546460337e-4), (4, 3.546518300e-4), (8, 3.546523484e-4)] {
        let shapes = Shapes::new(Frame::Secant, count, 0);
        // Forces are of first degree in a: the answer to unit changes solves them.
        let forces = |a: &[f64]| {
            let mut inertia = Inertia::new(&shapes);
            beam.inertia(&shapes, a, &vec![0.0; count], 1000.0, &mut inertia);
            let mut forces: Vec<f64> = inertia.bias[3..].iter().map(|bias| -bias).collect();
            beam.add_elastic(&shapes, a, &vec![0.0; count], &mut forces);
            forces
        };
        let mut answer = forces(&vec![0.0; count]);
        let still = answer.clone();
        let mut matrix = vec![0.0; count * count];
        for column in 0..count {
            let mut a = vec![0.0; count];
            a[column] = 1e-3;
            for (row, force) in forces(&a).iter().enumerate() {
                matrix[row * count + column] = (still[row] - force) / 1e-3;
            }
        }
        loosepin_math::solve_square(&mut matrix, count, &mut answer);
        let tip_m = beam.point_m(&shapes.tip, &answer).x - 0.3;
        assert!((tip_m - known_m).abs() < 6e-14, "{count} shapes: {tip_m}");
        assert!(tip_m < exact_m);
    }
}
