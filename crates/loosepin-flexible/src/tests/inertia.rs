//! Mass matrix and bias forces: against the second coding, against Lagrange's equations, and how many points they need.

use super::invariants::Invariants;
use super::rectangular;
use crate::{Basis, Beam, Frame, Inertia, Shapes};
use loosepin_math::{Vec2, sin_cos};

fn beam() -> Beam<f64> {
    rectangular([207e9, 7800.0, 0.26, 5e-3, 20e-3])
}

/// Shapes with static ones at two points inside.
fn with_points(frame: Frame, counts: [usize; 2]) -> Shapes {
    Shapes::of(&Basis::new(frame, counts, &[0.3, 0.74]), &[0.3, 0.74])
}

/// Coordinates and rates that bend the beam far: tip slopes of some tenths.
fn state(shapes: &Shapes) -> (Vec<f64>, Vec<f64>) {
    let spread = |k: usize, shift: f64| ((k as f64 + shift) * 0.618_033_988_75).fract() - 0.45;
    let scaled = |k: usize, shift: f64, size: f64| size * spread(k, shift) / (k as f64 + 1.0);
    let q = (0..shapes.count()).map(|k| scaled(k, 0.7, if k < shapes.axial() { 3e-3 } else { 0.4 })).collect();
    let rates = (0..shapes.count()).map(|k| scaled(k, 2.3, if k < shapes.axial() { 2.0 } else { 90.0 })).collect();
    (q, rates)
}

#[test]
fn identity_sums_over_points_are_the_polynomials_of_the_invariants() {
    for frame in [Frame::Secant, Frame::Tangent] {
        for foreshortening in [true, false] {
            for counts in [[2, 2], [3, 3], [0, 4], [2, 0]] {
                let beam = Beam { foreshortening, ..beam() };
                for shapes in [Shapes::new(frame, counts[0], counts[1]), with_points(frame, counts)] {
                    let (q, rates) = state(&shapes);
                    let mut inertia = Inertia::new(&shapes);
                    beam.inertia(&shapes, &q, &rates, 37.0, &mut inertia);
                    let (mass, bias) = Invariants::new(&beam, &shapes).inertia(&q, &rates, 37.0);
                    let size = |numbers: &[f64]| numbers.iter().fold(0.0_f64, |size, number| size.max(number.abs()));
                    for (found, exact, what) in [(&inertia.mass, &mass, "M"), (&inertia.bias, &bias, "h")] {
                        for (k, (found, other)) in found.iter().zip(exact).enumerate() {
                            let off = (found - other).abs() / size(exact);
                            assert!(off < 2e-15, "{what}[{k}] of {counts:?}, {frame:?}, f {foreshortening}: {off:e}");
                        }
                    }
                }
            }
        }
    }
}

#[test]
fn identity_points_are_as_many_as_the_integrals_need() {
    // Of 40 points nothing is left: relative errors of M and h by the number of shapes.
    for (counts, largest) in [([2, 2], 1e-14), ([4, 4], 1e-14), ([1, 1], 1e-9)] {
        let (beam, shapes) = (beam(), Shapes::new(Frame::Secant, counts[0], counts[1]));
        let many = Shapes::from_functions(
            (counts[0], &crate::functions::axial),
            (counts[1], &|index, s| crate::functions::lateral(Frame::Secant, index, s)),
            40,
        );
        let (q, rates) = state(&shapes);
        let [mut few, mut exact] = [Inertia::new(&shapes), Inertia::new(&many)];
        beam.inertia(&shapes, &q, &rates, 37.0, &mut few);
        beam.inertia(&many, &q, &rates, 37.0, &mut exact);
        // Entries of M against the diagonal, and h against the root of it.
        let n = few.size;
        let of_row = |row: usize| exact.mass[row * n + row].sqrt();
        let entries = (0..n * n).map(|k| (few.mass[k] - exact.mass[k]).abs() / (of_row(k / n) * of_row(k % n)));
        let largest_bias = (0..n).fold(0.0_f64, |largest, row| largest.max(exact.bias[row].abs() / of_row(row)));
        let biases = (0..n).map(|row| (few.bias[row] - exact.bias[row]).abs() / of_row(row) / largest_bias);
        let worst = entries.chain(biases).fold(0.0, f64::max);
        assert!(worst < largest, "{counts:?}: {worst:e}");
    }
}

/// Kinetic energy for absolute coordinates X, Y, θ, q and their rates.
fn kinetic_j(beam: &Beam<f64>, shapes: &Shapes, z: &[f64], rates: &[f64]) -> f64 {
    let (sine, cosine) = sin_cos(z[2]);
    let velocity = Vec2::new(rates[0], rates[1]).rotated(-sine, cosine);
    beam.kinetic_j(shapes, &z[3..], &rates[3..], velocity, rates[2])
}

#[test]
fn identity_mass_matrix_and_bias_forces_are_those_of_lagrange() {
    let bases = |frame| [(frame, Shapes::new(frame, 2, 3)), (frame, with_points(frame, [2, 2]))];
    for (frame, shapes) in [Frame::Secant, Frame::Tangent].into_iter().flat_map(bases) {
        let beam = beam();
        let (q, q_rates) = state(&shapes);
        let n = 3 + shapes.count();
        let z = [&[0.13, -0.21, 0.83][..], &q].concat();
        let rates = [&[1.7, -2.9, 37.0][..], &q_rates].concat();
        let accelerations: Vec<f64> =
            (0..n).map(|k| if k < 3 { 210.0 + 90.0 * k as f64 } else { 800.0 * (k as f64 - 4.6) }).collect();

        // p = ∂T/∂ż: T is of second degree in ż, so that differences are exact.
        let momentum = |z: &[f64], rates: &[f64], k: usize| {
            let at = |change: f64| {
                let mut rates = rates.to_vec();
                rates[k] += change;
                kinetic_j(&beam, &shapes, z, &rates)
            };
            (at(1.0) - at(-1.0)) / 2.0
        };
        // Differences of fourth order.
        let derivative = |value: &dyn Fn(f64) -> f64, h: f64| {
            (8.0 * (value(h) - value(-h)) - value(2.0 * h) + value(-2.0 * h)) / (12.0 * h)
        };
        let (sine, cosine) = sin_cos(z[2]);
        let in_frame = Vec2::new(accelerations[0], accelerations[1]).rotated(-sine, cosine);
        let speeds_change = [&[in_frame.x, in_frame.y][..], &accelerations[2..]].concat();
        let mut inertia = Inertia::new(&shapes);
        beam.inertia(&shapes, &q, &q_rates, rates[2], &mut inertia);
        let needed: Vec<f64> = (0..n)
            .map(|row| {
                let products = inertia.mass[row * n..(row + 1) * n].iter().zip(&speeds_change);
                products.map(|(m, change)| m * change).sum::<f64>() + inertia.bias[row]
            })
            .collect();
        let force = Vec2::new(needed[0], needed[1]).rotated(sine, cosine);
        let needed = [&[force.x, force.y][..], &needed[2..]].concat();
        let scale = needed.iter().fold(0.0_f64, |scale, force| scale.max(force.abs()));
        for k in 0..n {
            let along = |time_s: f64| {
                let moved: Vec<f64> =
                    (0..n).map(|i| z[i] + time_s * (rates[i] + 0.5 * time_s * accelerations[i])).collect();
                let quick: Vec<f64> = (0..n).map(|i| rates[i] + time_s * accelerations[i]).collect();
                momentum(&moved, &quick, k)
            };
            let beside = |change: f64| {
                let mut z = z.clone();
                z[k] += change;
                kinetic_j(&beam, &shapes, &z, &rates)
            };
            let lagrange = derivative(&along, 1e-4) - derivative(&beside, 1e-4);
            let off = (lagrange - needed[k]).abs() / scale;
            assert!(off < 1e-8, "{frame:?}, coordinate {k}: {lagrange} and {}: {off:e}", needed[k]);
        }
    }
}

#[test]
fn identity_kinetic_energy_is_half_the_form_of_the_mass_matrix() {
    let (beam, shapes) = (beam(), Shapes::new(Frame::Secant, 2, 3));
    let (q, rates) = state(&shapes);
    let mut inertia = Inertia::new(&shapes);
    beam.inertia(&shapes, &q, &rates, 37.0, &mut inertia);
    let speeds = [&[1.7, -2.9, 37.0][..], &rates].concat();
    let n = speeds.len();
    let form: f64 = (0..n * n).map(|k| speeds[k / n] * inertia.mass[k] * speeds[k % n]).sum();
    let energy = beam.kinetic_j(&shapes, &q, &rates, Vec2::new(1.7, -2.9), 37.0);
    assert!((0.5 * form - energy).abs() < 1e-14 * energy, "{} and {energy}", 0.5 * form);
    // ∂M/∂V along ω holds the centre of mass.
    let centre = beam.centre_of_mass_m(&shapes, &q);
    assert!((inertia.mass[2 * n] + beam.mass_kg * centre.y).abs() < 1e-16);
    assert!((inertia.mass[2 * n + 1] - beam.mass_kg * centre.x).abs() < 1e-15);
}

#[test]
fn identity_points_of_the_frames_ends_and_their_partial_velocities() {
    for frame in [Frame::Secant, Frame::Tangent] {
        let (beam, shapes) = (beam(), Shapes::new(frame, 2, 3));
        let (q, rates) = state(&shapes);
        assert_eq!(beam.point_m(&shapes.root, &q), Vec2::zero());
        let root_angle = beam.angle_rad(&shapes.root, &q);
        match frame {
            Frame::Secant => assert_eq!(beam.point_m(&shapes.tip, &q).y, 0.0),
            Frame::Tangent => assert_eq!(root_angle, 0.0),
        }
        // Slopes at the ends are 0, 1 or -1: coordinates are turns of the ends.
        for slope in shapes.root.slopes.iter().chain(&shapes.tip.slopes) {
            assert!([0.0, 1.0, -1.0].contains(slope), "{frame:?}: {slope}");
        }
        let mut partials = vec![Vec2::zero(); shapes.count()];
        beam.partials(&shapes.tip, &q, &mut partials);
        for k in 0..shapes.count() {
            let at = |change: f64| {
                let mut q = q.clone();
                q[k] += change;
                beam.point_m(&shapes.tip, &q)
            };
            let difference = (at(1e-3) - at(-1e-3)) * 500.0;
            assert!((difference - partials[k]).length() < 1e-12, "{frame:?}, coordinate {k}");
        }
        // The acceleration of the tip without those of the coordinates, by differences along a straight motion in q.
        let spin = 37.0;
        let at = |time_s: f64| {
            let moved: Vec<f64> = q.iter().zip(&rates).map(|(q, rate)| q + time_s * rate).collect();
            let (sine, cosine) = sin_cos(spin * time_s);
            beam.point_m(&shapes.tip, &moved).rotated(sine, cosine)
        };
        let h = 2e-5;
        let difference = (at(h) + at(-h) - at(0.0) * 2.0) * (1.0 / (h * h));
        let rate = partials.iter().zip(&rates).fold(Vec2::zero(), |sum: Vec2<f64>, (d, rate)| sum.plus(*d, *rate));
        let exact = beam
            .relative_acceleration_m_s2(&shapes.tip, rate, &rates, spin)
            .plus(beam.point_m(&shapes.tip, &q), -spin * spin);
        assert!((difference - exact).length() < 2e-6 * exact.length(), "{frame:?}: {difference:?} and {exact:?}");
    }
}

#[test]
fn identity_damping_is_the_ratio_of_every_shape_and_never_gives_back() {
    let beam = Beam { damping_ratio: 0.02, ..beam() };
    let shapes = Shapes::new(Frame::Secant, 2, 3);
    let (q, rates) = state(&shapes);
    let mut forces = vec![0.0; shapes.count()];
    beam.add_elastic(&shapes, &q, &rates, &mut forces);
    let power: f64 = forces.iter().zip(&rates).map(|(force, rate)| force * rate).sum();
    let mut elastic = vec![0.0; shapes.count()];
    beam.add_elastic(&shapes, &q, &vec![0.0; shapes.count()], &mut elastic);
    let stored: f64 = elastic.iter().zip(&rates).map(|(force, rate)| force * rate).sum();
    let loss = beam.damping_loss_w(&shapes, &rates);
    assert!(loss > 0.0 && (stored - power - loss).abs() < 1e-12 * loss.abs().max(stored.abs()));
    // The elastic force is the gradient of the strain energy.
    for k in 0..shapes.count() {
        let at = |change: f64| {
            let mut q = q.clone();
            q[k] += change;
            beam.strain_j(&shapes, &q)
        };
        let gradient = (at(1e-3) - at(-1e-3)) * 500.0;
        assert!((gradient + elastic[k]).abs() < 1e-11 * elastic[k].abs(), "{k}");
    }
    // Each sine is a shape of its own: C = 2 ζ √(K M).
    let mut inertia = Inertia::new(&shapes);
    beam.inertia(&shapes, &[0.0; 5], &[0.0; 5], 0.0, &mut inertia);
    for i in 0..3 {
        let mut unit = vec![0.0; 5];
        unit[2 + i] = 1.0;
        let mut drag = vec![0.0; 5];
        beam.add_elastic(&shapes, &[0.0; 5], &unit, &mut drag);
        let mass = inertia.mass[(5 + i) * 8 + 5 + i];
        let stiffness = 2.0 * beam.strain_j(&shapes, &unit);
        let due = 2.0 * 0.02 * (stiffness * mass).sqrt();
        assert!((drag[2 + i] + due).abs() < 1e-12 * due, "{i}: {} for {due}", -drag[2 + i]);
    }
}
