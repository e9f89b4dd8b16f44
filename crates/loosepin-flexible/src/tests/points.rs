//! Points inside a beam: static shapes, frequencies, and the lack of them.

use crate::spectrum::eigenvalues;
use crate::{Basis, Frame, Shapes, Station};
use loosepin_math::solve_square;
use std::f64::consts::PI;

/// Displacement at a station under a unit force there, over L³/EI or L/EA.
fn compliance(stiffness: &[f64], values: &[f64]) -> f64 {
    let mut answer = values.to_vec();
    solve_square(&mut stiffness.to_vec(), values.len(), &mut answer);
    answer.iter().zip(values).map(|(turn, value)| turn * value).sum()
}

fn lateral(shapes: &Shapes, at: &Station) -> f64 {
    compliance(&shapes.bending_stiffness, &at.lateral)
}

fn with_point(frame: Frame, counts: [usize; 2], share: f64) -> Shapes {
    Shapes::of(&Basis::new(frame, counts, &[share]), &[share])
}

#[test]
fn published_sines_miss_the_deflection_of_a_load_inside() {
    for (count, share_of_it) in [(1, 0.9142), (2, 0.9931), (4, 0.9967), (8, 0.9996)] {
        let shapes = Shapes::of(&Basis::new(Frame::Secant, [0, count], &[]), &[0.3]);
        let found = lateral(&shapes, &shapes.inside[0]) / 0.0147;
        assert!((found - share_of_it).abs() < 5e-5, "{count} sines: {found}");
    }
}

/// A beam between two pins, its point at 0.3 L: frequencies of another program's reduction, too high by these shares, and a²b²/3.
#[test]
fn published_frequencies_with_a_static_shape_inside() {
    // Half of the last digit, and what its 20 cubic elements are too stiff by: (iπ/20)⁴/1440.
    let known = [
        (1, [4.31e-2, f64::NAN], [5e-5, 0.0]),
        (2, [5.5e-4, 1.48e-2], [5e-6, 5e-5]),
        (3, [3.7e-4, 9.2e-3], [5e-6, 5e-5]),
        (5, [1.8e-5, 3.9e-4], [5e-7, 5e-6]),
    ];
    for (count, high, digits) in known {
        // With no mode beside it a static shape stands alone.
        let basis = Basis::with_modes(Frame::Secant, [0, count - 1], &[0.3]);
        let shapes = Shapes::of(&basis, &[0.3]);
        assert_eq!(shapes.lateral(), count);
        let [_, squares] = shapes.squared_frequencies();
        for (index, (high, digit)) in high.into_iter().zip(digits).enumerate().take(count) {
            let angle = PI * (index as f64 + 1.0);
            let found = squares[index].sqrt() / angle.powi(2) - 1.0;
            let tolerance = digit + (angle / 20.0).powi(4) / 1440.0;
            assert!((found - high).abs() < tolerance, "{count} shapes: {found:e} for {high:e}");
        }
        let deflection = lateral(&shapes, &shapes.inside[0]);
        assert!((deflection - 0.0147).abs() < 1e-15, "{deflection}");
    }
}

#[test]
fn analytic_deflections_of_loads_inside() {
    for (a, modes) in [(0.25, 1), (0.5, 2), (0.62, 4), (0.93, 8)] {
        // x³/3 at a point of a cantilever, and the axial stretch x.
        let shapes = with_point(Frame::Tangent, [2, modes], a);
        let found = lateral(&shapes, &shapes.inside[0]);
        assert!((found / (a.powi(3) / 3.0) - 1.0).abs() < 1e-12, "{a}: {found}");
        for at in [&shapes.inside[0], &shapes.tip] {
            let found = compliance(&shapes.axial_stiffness, &at.axial);
            assert!((found / at.share - 1.0).abs() < 1e-12, "{a}: {found}");
        }
        // Two points: displacement of one under a force at the other, b x (1 - b² - x²)/6 for x < 1 - b.
        let basis = Basis::new(Frame::Secant, [1, modes], &[0.4 * a, a]);
        let shapes = Shapes::of(&basis, &[0.4 * a, a]);
        let mut answer = shapes.inside[1].lateral.clone();
        solve_square(&mut shapes.bending_stiffness.clone(), answer.len(), &mut answer);
        let found: f64 = answer.iter().zip(&shapes.inside[0].lateral).map(|(turn, value)| turn * value).sum();
        let (b, x) = (1.0 - a, 0.4 * a);
        let due = b * x * (1.0 - b * b - x * x) / 6.0;
        assert!((found / due - 1.0).abs() < 1e-11, "{a}: {found} for {due}");
    }
}

/// Frequencies come to those of the whole beam from above as modes are added, whatever the points.
#[test]
fn analytic_frequencies_with_points_inside_converge() {
    for inside in [&[0.3][..], &[0.5], &[0.2, 0.7], &[0.1, 0.45, 0.5, 0.9]] {
        let at = |modes: usize| {
            let shapes = Shapes::of(&Basis::new(Frame::Secant, [1, modes], inside), inside);
            let [_, squares] = shapes.squared_frequencies();
            [0, 1, 2].map(|index: usize| squares[index].sqrt() / (PI * (index as f64 + 1.0)).powi(2) - 1.0)
        };
        let (few, many) = (at(2), at(8));
        for (few, many) in few.into_iter().zip(many) {
            assert!(many > -1e-11 && many < 2e-3 && few >= many - 1e-12, "{inside:?}: {few:e} {many:e}");
        }
        assert!(many[0] < 3e-6, "{inside:?}: {:e}", many[0]);
        // Each shape has a frequency of its own: M and K are diagonal.
        let shapes = Shapes::of(&Basis::new(Frame::Secant, [1, 3], inside), inside);
        let n = shapes.lateral();
        let diagonal = |k: usize| shapes.bending_stiffness[k * n + k];
        let squares = eigenvalues(&mass(&shapes), &shapes.bending_stiffness, n);
        for k in 0..n * n {
            let (row, column) = (k / n, k % n);
            let size = (diagonal(row) * diagonal(column)).sqrt();
            let due = if row == column { diagonal(row) } else { 0.0 };
            assert!((shapes.bending_stiffness[k] - due).abs() < 1e-11 * size, "{inside:?}, {row}, {column}");
        }
        assert!(squares.windows(2).all(|pair| pair[0] < pair[1]));
    }
}

fn mass(shapes: &Shapes) -> Vec<f64> {
    let n = shapes.lateral();
    let entry = |k: usize| -> f64 {
        let term =
            |point: &crate::MassPoint| point.weight * point.station.lateral[k / n] * point.station.lateral[k % n];
        shapes.points.iter().map(term).sum()
    };
    (0..n * n).map(entry).collect()
}

/// Slope and curvature of the shapes by differences, and H by a rule of its own.
#[test]
fn identity_slopes_and_shortening_of_shapes_with_points_inside() {
    for (frame, inside) in [(Frame::Secant, &[0.3][..]), (Frame::Tangent, &[0.35, 0.8])] {
        let basis = Basis::new(frame, [3, 3], inside);
        let root = &basis.stations(&[0.0])[0];
        for i in 0..basis.lateral_count() {
            assert_eq!(root.lateral[i], 0.0);
            if frame == Frame::Tangent {
                assert_eq!(root.slopes[i], 0.0);
            } else {
                assert!(basis.lateral(i, 1.0)[0].abs() < 1e-15);
            }
            let largest =
                [0.0, 1.0].iter().chain(inside).fold(0.0_f64, |most, s| most.max(basis.lateral(i, *s)[1].abs()));
            assert!((largest - 1.0).abs() < 1e-9, "{largest}");
            for s in [0.11, 0.3, 0.35, 0.62, 0.8, 0.97] {
                let h = 1e-5;
                let [below, at, above] = [s - h, s, s + h].map(|s| basis.lateral(i, s));
                assert!(((above[0] - below[0]) / (2.0 * h) - at[1]).abs() < 1e-7, "slope of {i} at {s}");
                // A force at a point makes a kink in the curvature.
                if !inside.contains(&s) {
                    assert!(((above[1] - below[1]) / (2.0 * h) - at[2]).abs() < 1e-5, "curvature of {i} at {s}");
                }
            }
        }
        for s in [0.2, 0.3, 0.5, 0.8, 1.0] {
            let count = basis.lateral_count();
            let station = &basis.stations(&[s])[0];
            let steps = 4000;
            for place in 0..count * count {
                let sum: f64 = (0..steps)
                    .map(|k| {
                        let at = s * (k as f64 + 0.5) / steps as f64;
                        basis.lateral(place / count, at)[1] * basis.lateral(place % count, at)[1]
                    })
                    .sum();
                assert!((sum * s / steps as f64 - station.shortening[place]).abs() < 1e-5, "H at {s}");
            }
        }
    }
}

/// Two points close to each other have two static lateral shapes, one of which is a couple at both, and two hats, one of which is a short and fast
/// stretch between them. Deflections and slow shapes do not suffer.
#[test]
fn analytic_points_close_to_each_other() {
    for gap in [1.1e-3, 5e-3, 0.02] {
        let inside = [0.3, 0.3 + gap];
        let shapes = Shapes::of(&Basis::new(Frame::Secant, [1, 2], &inside), &inside);
        assert_eq!([shapes.axial(), shapes.lateral()], [3, 4]);
        for at in &shapes.inside {
            let (a, b) = (at.share, 1.0 - at.share);
            let found = lateral(&shapes, at);
            assert!((found / (a * a * b * b / 3.0) - 1.0).abs() < 1e-8, "{gap}: {found}");
        }
        let [axial, squares] = shapes.squared_frequencies();
        let first = squares[0].sqrt() / (PI * PI) - 1.0;
        assert!((-1e-9..6e-4).contains(&first), "{gap}: {first:e}");
        assert!(squares.iter().all(|square| *square < (6.0 * PI).powi(4)), "{gap}: {squares:?}");
        // With the second hat the slow stretches come nearer to those of the whole bar, from above.
        let [of_one, _] = with_point(Frame::Secant, [1, 2], 0.3).squared_frequencies();
        for (both, one) in axial.iter().zip(&of_one) {
            assert!(*both < (1.0 + 1e-9) * one && *both > 0.9 * one, "{gap}: {axial:?} {of_one:?}");
        }
        assert!(axial[2] > 1.0 / gap, "{gap}: {axial:?}");
    }
}
