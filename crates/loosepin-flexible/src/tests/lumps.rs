//! Frequencies of beams with lumped masses against closed forms.

use super::rectangular;
use crate::{Basis, Beam, Frame, HeldBeam, LumpedMass, Shapes};
use loosepin_math::Vec2;
use std::f64::consts::{PI, TAU};

fn rod() -> Beam<f64> {
    rectangular([200e9, 7870.0, 0.3, 8e-3, 8e-3])
}

/// s², s³, … of slope one at the tip: a force and a couple there bend the first two.
fn monomial(index: usize, s: f64) -> [f64; 3] {
    let n = index as f64 + 2.0;
    [s.powf(n) / n, s.powf(n - 1.0), (n - 1.0) * s.powf(n - 2.0)]
}

fn at_tip(shapes: &Shapes, mass_kg: f64, inertia_kg_m2: f64, reach_m: f64) -> LumpedMass<'_> {
    LumpedMass { station: &shapes.tip, arm_m: Vec2::new(reach_m, 0.0), mass_kg, inertia_kg_m2 }
}

/// The root of a function that changes its sign once between two places.
fn root(function: &dyn Fn(f64) -> f64, [mut low, mut high]: [f64; 2]) -> f64 {
    assert!(function(low) * function(high) < 0.0, "no root between {low} and {high}");
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if function(low) * function(middle) <= 0.0 { high = middle } else { low = middle }
    }
    0.5 * (low + high)
}

/// Rods of two known mechanisms with their sliders, by another program: κL tan κL = ρAL/m.
#[test]
fn published_axial_frequencies_of_rods_with_sliders() {
    let area = PI * 4e-3_f64.powi(2);
    let round = Beam {
        length_m: 0.12,
        mass_kg: 7800.0 * area * 0.12,
        axial_stiffness_n_m: 207e9 * area / 0.12,
        bending_stiffness_n_m: 207e9 * PI * 4e-3_f64.powi(4) / 4.0 / 0.12,
        damping_ratio: 0.0,
        foreshortening: true,
    };
    for (beam, slider_kg, known_hz) in [(round, 0.14, 3752.12), (rod(), 0.075552, 2879.99)] {
        let shapes = Shapes::new(Frame::Secant, 8, 2);
        let [axial, lateral] = HeldBeam::new(&beam, &shapes, &[at_tip(&shapes, slider_kg, 0.0, 0.0)]).frequencies_hz();
        assert_eq!([axial.len(), lateral.len()], [8, 2]);
        let ratio = beam.mass_kg / slider_kg;
        let exact =
            root(&|z: f64| z * z.tan() - ratio, [1e-6, 1.57]) / TAU * (beam.axial_stiffness_n_m / beam.mass_kg).sqrt();
        assert!((exact / known_hz - 1.0).abs() < 2e-6, "{exact} for {known_hz}");
        let error = axial[0] / exact - 1.0;
        assert!((-1e-12..2e-5).contains(&error), "{} for {exact}: {error:e}", axial[0]);
        // Its bending does not feel a mass on a pin.
        let [_, alone] = beam.frequencies_hz(&shapes);
        for (with, without) in lateral.iter().zip(&alone) {
            assert!((with / without - 1.0).abs() < 1e-12, "{with} {without}");
        }
    }
}

/// A cantilever with a body at its tip, whose centre of mass lies at a reach e beyond it:
/// EI w''' = -ω² m (w + e w'), EI w'' = ω² (J w' + m e (w + e w')) at the tip.
#[test]
fn analytic_cantilever_with_a_body_at_its_tip() {
    let beam = rod();
    let length_m = beam.length_m;
    for [mass, inertia, reach] in [[0.7, 0.0, 0.0], [1.0, 0.05, 0.0], [0.3, 0.02, 0.15], [0.0, 0.1, 0.0]] {
        // Over m, m L² and L, with w = A (cosh z s - cos z s) + B (sinh z s - sin z s).
        let determinant = |z: f64| {
            let (s, c, sh, ch) = (z.sin(), z.cos(), z.sinh(), z.cosh());
            let functions = [
                [ch - c, z * (sh + s), z * z * (ch + c), z.powi(3) * (sh - s)],
                [sh - s, z * (ch - c), z * z * (sh + s), z.powi(3) * (ch + c)],
            ];
            let conditions = functions.map(|[w, slope, curvature, third]| {
                let moved = w + reach * slope;
                let square = z.powi(4);
                [third + square * mass * moved, curvature - square * (inertia * slope + mass * reach * moved)]
            });
            (conditions[0][0] * conditions[1][1] - conditions[1][0] * conditions[0][1]) / ch.powi(2)
        };
        let lump = [mass * beam.mass_kg, inertia * beam.mass_kg * length_m.powi(2), reach * length_m];
        let frequencies = |shapes: &Shapes| {
            let lump = at_tip(shapes, lump[0], lump[1], lump[2]);
            HeldBeam::new(&beam, shapes, &[lump]).frequencies_hz()[1].clone()
        };
        let polynomials = frequencies(&Shapes::from_functions((0, &|_, _| [0.0; 2]), (8, &monomial), 24));
        // Free of moment and shear at the tip, they come to the same from above, but slowly.
        let eigenfunctions = [4, 8].map(|count| frequencies(&Shapes::new(Frame::Tangent, 0, count)));
        let unit = (beam.bending_stiffness_n_m / beam.mass_kg).sqrt() / length_m / TAU;
        // The first two roots, found from below.
        let mut low = 0.1;
        for index in 0..2 {
            let mut high = low + 0.02;
            while determinant(low) * determinant(high) > 0.0 {
                (low, high) = (high, high + 0.02);
            }
            let exact = root(&determinant, [low, high]).powi(2) * unit;
            low = high;
            let error = polynomials[index] / exact - 1.0;
            assert!(error.abs() < [1e-9, 1e-6][index], "{index}: {} for {exact}: {error:e}", polynomials[index]);
            let [few, many] = eigenfunctions.each_ref().map(|found| found[index] / exact - 1.0);
            assert!(many > -1e-9 && many < 0.6 * few, "{index}: {few:e} {many:e}");
        }
    }
}

/// A mass in the middle of a beam on two pins, μ z (tan(z/2) - tanh(z/2)) = 4; the static shape there feels it.
#[test]
fn analytic_mass_in_the_middle_of_a_beam_on_two_pins() {
    let beam = rod();
    let unit = (beam.bending_stiffness_n_m / beam.mass_kg).sqrt() / beam.length_m / TAU;
    for ratio in [0.1, 1.0, 10.0] {
        let condition = |z: f64| ratio * z * ((0.5 * z).tan() - (0.5 * z).tanh()) - 4.0;
        let exact = root(&condition, [1e-3, PI - 1e-9]).powi(2) * unit;
        let shapes = Shapes::of(&Basis::new(Frame::Secant, [1, 8], &[0.5]), &[0.5]);
        let lump = LumpedMass {
            station: &shapes.inside[0],
            arm_m: Vec2::zero(),
            mass_kg: ratio * beam.mass_kg,
            inertia_kg_m2: 0.0,
        };
        let [_, lateral] = HeldBeam::new(&beam, &shapes, &[lump]).frequencies_hz();
        let error = lateral[0] / exact - 1.0;
        // What eight modes leave of the beam alone, at most.
        assert!((-1e-11..3e-6).contains(&error), "{ratio}: {error:e}");
        // The second shape has its node there.
        let second = lateral[1] / (4.0 * PI * PI * unit) - 1.0;
        assert!((-1e-11..1e-3).contains(&second), "{ratio}: {second:e}");
    }
}

/// A heavy body on a light rod is an oscillator on two springs: beside the axis bending and stretch are coupled, and the product of both
/// squares is that of the compliances.
#[test]
fn analytic_heavy_body_beside_the_axis() {
    let beam = rod();
    let shapes = Shapes::from_functions((1, &|_, s| [s, 1.0]), (4, &monomial), 24);
    let (mass_kg, across_m) = (1e5 * beam.mass_kg, 0.04);
    let lump = LumpedMass { station: &shapes.tip, arm_m: Vec2::new(0.0, across_m), mass_kg, inertia_kg_m2: 0.0 };
    let held = HeldBeam::new(&beam, &shapes, &[lump]);
    let [mut axial, lateral] = held.frequencies_hz();
    axial.extend(lateral);
    axial.sort_by(f64::total_cmp);
    // Displacement of the body along and across under forces there: its arm turns with the tip.
    let bending = 1.0 / beam.bending_stiffness_n_m;
    let along = 1.0 / beam.axial_stiffness_n_m + across_m * across_m * bending;
    let across = beam.length_m.powi(2) * bending / 3.0;
    let both = -across_m * beam.length_m * bending / 2.0;
    let (sum, product) = (along + across, along * across - both * both);
    let spread = (sum * sum - 4.0 * product).sqrt();
    for (found, compliance) in axial.iter().zip([0.5 * (sum + spread), 0.5 * (sum - spread)]) {
        let exact = 1.0 / (compliance * mass_kg).sqrt() / TAU;
        assert!((found / exact - 1.0).abs() < 1e-5, "{found} for {exact}");
    }
    // C M⁻¹ C = (2ζ)² K: the same ratio for every shape, coupled or not.
    let damping = held.damping(0.03);
    let count = shapes.count();
    let mut oscillating = vec![0.0; count];
    for column in 0..count {
        let mut answer: Vec<f64> = (0..count).map(|row| damping[row * count + column]).collect();
        loosepin_math::solve_square(&mut held.mass().to_vec(), count, &mut answer);
        for (row, value) in oscillating.iter_mut().enumerate() {
            *value = (0..count).map(|k| damping[row * count + k] * answer[k]).sum();
            let due = 0.06_f64.powi(2) * held.stiffness()[row * count + column];
            let size = 0.06_f64.powi(2)
                * (held.stiffness()[row * count + row] * held.stiffness()[column * count + column]).sqrt();
            assert!((*value - due).abs() < 1e-6 * size, "{row}, {column}: {value} for {due}");
        }
    }
}

/// Condensed shapes have the frequency at which they are cut off, the others theirs; loads bend the beam as far as before.
#[test]
fn identity_condensed_shapes_keep_slower_ones_and_their_flexibility() {
    let beam = rod();
    let shapes = Shapes::of(&Basis::new(Frame::Secant, [3, 3], &[0.12]), &[0.12]);
    let lump =
        LumpedMass { station: &shapes.inside[0], arm_m: Vec2::new(0.0, 0.01), mass_kg: 0.05, inertia_kg_m2: 1e-5 };
    let mut held = HeldBeam::new(&beam, &shapes, &[lump]);
    let sorted = |held: &HeldBeam| {
        let mut all = held.frequencies_hz().concat();
        all.sort_by(f64::total_cmp);
        all
    };
    let (before, stiffness) = (sorted(&held), held.stiffness().to_vec());
    let above_hz = 8000.0;
    let (added, were_hz) = held.condense(above_hz);
    let kept = before.iter().filter(|hz| **hz <= above_hz).count();
    assert!((2..before.len() - 1).contains(&kept), "{before:?}");
    assert_eq!(were_hz.len(), before.len() - kept);
    for (index, (hz, was)) in sorted(&held).iter().zip(&before).enumerate() {
        let due = if index < kept { *was } else { above_hz };
        assert!((hz / due - 1.0).abs() < 1e-9, "{hz} for {due}");
    }
    for (hz, was) in were_hz.iter().zip(&before[kept..]) {
        assert!((hz / was - 1.0).abs() < 1e-12, "{hz} {was}");
    }
    assert_eq!(held.stiffness(), stiffness);
    let count = shapes.count();
    assert!((0..count).all(|k| added[k * count + k] >= 0.0));
}
