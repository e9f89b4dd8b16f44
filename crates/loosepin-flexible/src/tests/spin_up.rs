//! A beam whose hub is brought to speed: the question of Kane, Ryan and Banerjee, with the plane data used since.

use super::motion::at_times;
use crate::{Beam, Frame, Inertia, Shapes};
use loosepin_math::solve_square;
use std::f64::consts::TAU;

const LENGTH_M: f64 = 8.0;
const SPEED_RAD_S: f64 = 6.0;
const RISE_S: f64 = 15.0;

fn beam() -> Beam<f64> {
    let (density_kg_m3, modulus_pa, area_m2, second_moment_m4) = (2766.7, 6.8952e10, 7.2968e-5, 8.2189e-9);
    Beam {
        length_m: LENGTH_M,
        mass_kg: density_kg_m3 * area_m2 * LENGTH_M,
        axial_stiffness_n_m: modulus_pa * area_m2 / LENGTH_M,
        bending_stiffness_n_m: modulus_pa * second_moment_m4 / LENGTH_M,
        damping_ratio: 0.0,
        foreshortening: true,
    }
}

/// Tip along and across the axis of the hub, from its place at rest, m.
fn tips_m(beam: &Beam<f64>, count: usize, times_s: &[f64]) -> Vec<[f64; 2]> {
    let shapes = Shapes::new(Frame::Tangent, 0, count);
    let mut inertia = Inertia::new(&shapes);
    let slope = |time_s: f64, y: &[f64], slope: &mut [f64]| {
        let turn = TAU * time_s / RISE_S;
        let [spin, change] = if time_s < RISE_S {
            [SPEED_RAD_S / RISE_S * (time_s - RISE_S / TAU * turn.sin()), SPEED_RAD_S / RISE_S * (1.0 - turn.cos())]
        } else {
            [SPEED_RAD_S, 0.0]
        };
        let (q, rates) = y.split_at(count);
        beam.inertia(&shapes, q, rates, spin, &mut inertia);
        let size = inertia.size;
        let mut forces: Vec<f64> =
            (3..size).map(|row| -inertia.bias[row] - inertia.mass[row * size + 2] * change).collect();
        beam.add_elastic(&shapes, q, rates, &mut forces);
        let mut mass: Vec<f64> =
            (3..size).flat_map(|row| inertia.mass[row * size + 3..(row + 1) * size].to_vec()).collect();
        solve_square(&mut mass, count, &mut forces);
        slope[..count].copy_from_slice(rates);
        slope[count..].copy_from_slice(&forces);
    };
    let found = at_times(slope, &vec![0.0; 2 * count], times_s, 1e-11, &vec![1e-12; 2 * count]);
    let tip = |state: Vec<f64>| {
        let tip = beam.point_m(&shapes.tip, &state[..count]);
        [tip.x - LENGTH_M, tip.y]
    };
    found.into_iter().map(tip).collect()
}

#[test]
fn peer_tips_of_two_three_and_six_shapes() {
    const TIMES_S: [f64; 6] = [5.0, 6.5, 7.5, 10.0, 15.0, 20.0];
    let known_m: [(usize, [f64; 6]); 3] = [
        (2, [-0.626537344, -0.756562975, -0.711299407, -0.430672779, 0.001723107, 0.001532515]),
        (3, [-0.626938614, -0.758250125, -0.714703831, -0.437575293, 0.003109689, 0.004151750]),
        (6, [-0.626892374, -0.758132750, -0.714618494, -0.437938743, 0.003473305, 0.004836295]),
    ];
    for (count, known_m) in known_m {
        for ((found, known), time_s) in tips_m(&beam(), count, &TIMES_S).iter().zip(known_m).zip(TIMES_S) {
            assert!((found[1] - known).abs() < 1e-8, "{count} shapes at {time_s} s: {} for {known}", found[1]);
        }
    }
    // Without foreshortening the deflection is 19 % too large at 5 s, and grows without limit.
    let linear = Beam { foreshortening: false, ..beam() };
    let found = tips_m(&linear, 2, &[5.0, 7.5]);
    assert!((found[0][1] + 0.743181555).abs() < 1e-8, "{}", found[0][1]);
    assert!((found[1][1] + 3.985).abs() < 5e-4, "{}", found[1][1]);
}

#[test]
fn peer_the_history_of_three_shapes() {
    let rows: Vec<Vec<f64>> = include_str!("spin_up.csv")
        .lines()
        .skip(1)
        .map(|line| line.split(',').map(|number| number.parse().expect("a number")).collect())
        .collect();
    assert_eq!(rows.len(), 161);
    let times_s: Vec<f64> = rows[1..].iter().map(|row| row[0]).collect();
    for (row, found) in rows[1..].iter().zip(tips_m(&beam(), 3, &times_s)) {
        for (found, known) in found.iter().zip(&row[1..]) {
            assert!((found - known).abs() < 1e-9, "at {} s: {found} for {known}", row[0]);
        }
    }
}
