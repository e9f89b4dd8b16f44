//! Pendulums in absolute nodal coordinates: a soft one against another program, a stiffer one against the floating frame.

use super::motion::at_times;
use crate::nodal::{Mesh, Nodal, NodalBeam, Rule};
use loosepin_math::{Vec2, factor_ldl, solve_ldl};

const GRAVITY: Vec2<f64> = Vec2 { x: 0.0, y: -9.81 };

/// Length, area, second moment, density, modulus.
fn beam([length_m, area_m2, second_moment_m4, density_kg_m3, modulus_pa]: [f64; 5]) -> NodalBeam<f64> {
    NodalBeam {
        length_m,
        mass_kg: density_kg_m3 * area_m2 * length_m,
        axial_stiffness_n_m: modulus_pa * area_m2 / length_m,
        bending_stiffness_n_m: modulus_pa * second_moment_m4 / length_m,
        retardation_s: 0.0,
    }
}

fn nodes_of(numbers: &[f64]) -> Vec<Nodal<f64>> {
    let node = |four: &[f64]| Nodal { position: Vec2::new(four[0], four[1]), slope: Vec2::new(four[2], four[3]) };
    numbers.chunks_exact(4).map(node).collect()
}

fn flat(nodes: &[Nodal<f64>]) -> Vec<f64> {
    nodes.iter().flat_map(|node| [node.position.x, node.position.y, node.slope.x, node.slope.y]).collect()
}

/// Nodes and their rates at `times_s`, released from rest along x with the root pinned at the origin.
fn falling(beam: &NodalBeam<f64>, mesh: &Mesh, times_s: &[f64]) -> Vec<[Vec<Nodal<f64>>; 2]> {
    // The root's position is held: it has no unknowns.
    let count = 4 * mesh.nodes() - 2;
    let whole = |free: &[f64]| nodes_of(&[&[0.0, 0.0], free].concat());
    let mut mass: Vec<f64> = Vec::with_capacity(count * count);
    for k in 0..count {
        let along: Vec<f64> = (0..count).map(|l| if k == l { 1.0 } else { 0.0 }).collect();
        mass.extend(&flat(&beam.momenta(mesh, &whole(&along)))[2..]);
    }
    factor_ldl(&mut mass, count);
    let start = &flat(&beam.straight(mesh, Vec2::zero(), Vec2::new(1.0, 0.0)))[2..];
    let slope = |_: f64, y: &[f64], slope: &mut [f64]| {
        let (places, rates) = y.split_at(count);
        let mut forces = vec![Nodal::zero(); mesh.nodes()];
        beam.add_elastic(mesh, &whole(places), &mut forces);
        beam.add_weight(mesh, GRAVITY, &mut forces);
        slope[..count].copy_from_slice(rates);
        slope[count..].copy_from_slice(&flat(&forces)[2..]);
        solve_ldl(&mass, count, &mut slope[count..]);
    };
    let start = [start, &vec![0.0; count]].concat();
    let found = at_times(slope, &start, times_s, 1e-11, &vec![1e-12; 2 * count]);
    found.into_iter().map(|state| [whole(&state[..count]), whole(&state[count..])]).collect()
}

/// Twelve elements, 1.2 s, in which the pendulum swings past the vertical and folds.
#[test]
fn peer_the_history_of_a_soft_pendulum() {
    let beam = beam([1.2, 1.8e-3, 1.215e-8, 5540.0, 0.7e6]);
    let mesh = Mesh::new(12, Rule::Full);
    let rows: Vec<Vec<f64>> = include_str!("soft_pendulum.csv")
        .lines()
        .skip(1)
        .map(|line| line.split(',').map(|number| number.parse().expect("a number")).collect())
        .collect();
    assert_eq!(rows.len(), 101);
    let times_s: Vec<f64> = rows[1..].iter().map(|row| row[0]).collect();
    let found = falling(&beam, &mesh, &times_s);
    assert_eq!(found.len(), 100);
    for (row, [nodes, rates]) in rows[1..].iter().zip(&found) {
        let (tip, middle) = (nodes[12].position, nodes[6].position);
        for (found, known) in [tip.x, tip.y, middle.x, middle.y].iter().zip(&row[1..5]) {
            assert!((found - known).abs() < 1e-9, "at {} s: {found} for {known}", row[0]);
        }
        // It starts with none: 60 J go to and fro.
        let height_j = -beam.mass_kg * GRAVITY.dot(beam.centre_of_mass_m(&mesh, nodes));
        let energy_j = beam.kinetic_j(&mesh, rates) + beam.strain_j(&mesh, nodes) + height_j;
        assert!(energy_j.abs() < 1e-9, "{energy_j} J at {} s", row[0]);
    }
    // The same numbers as they are printed, with two more digits than the file's last times.
    let last = found[99][0][12].position;
    assert!((last - Vec2::new(-0.8898405132, 0.1542474211)).length() < 1e-9, "{last:?}");
}

/// A plastic bar of 0.5 m, whose tip turns by up to a few tenths of a radian: four lateral shapes in a tangent frame leave 4e-4 of its length.
#[test]
fn peer_a_plastic_pendulum_is_that_of_the_floating_frame() {
    const TIMES_S: [f64; 5] = [0.1, 0.2, 0.3, 0.4, 0.5];
    let floating_m = [
        Vec2::new(0.494692874, -0.072664079),
        Vec2::new(0.418674061, -0.273323335),
        Vec2::new(0.157879135, -0.474424583),
        Vec2::new(-0.213009323, -0.452377409),
        Vec2::new(-0.441782981, -0.234101494),
    ];
    let (width_m, height_m): (f64, f64) = (20e-3, 10e-3);
    let bar = beam([0.5, width_m * height_m, width_m * height_m.powi(3) / 12.0, 1200.0, 2e8]);
    let tips = |elements: usize| -> Vec<Vec2<f64>> {
        let found = falling(&bar, &Mesh::new(elements, Rule::Full), &TIMES_S);
        found.iter().map(|[nodes, _]| nodes[elements].position).collect()
    };
    let [four, eight] = [4, 8].map(tips);
    let farthest = |left: &[Vec2<f64>], right: &[Vec2<f64>]| {
        let largest = |(left, right): (&Vec2<f64>, &Vec2<f64>)| (left.x - right.x).abs().max((left.y - right.y).abs());
        left.iter().zip(right).map(largest).fold(0.0, f64::max)
    };
    assert!(farthest(&eight, &floating_m) < 2e-4, "{:e} m", farthest(&eight, &floating_m));
    assert!(farthest(&four, &eight) < 6.5e-5, "{:e} m", farthest(&four, &eight));
}
