//! The element of absolute nodal coordinates: forces, damping and tangent against derivatives of energies, its mass matrix, rigid motion,
//! and the modes of a free beam.

use crate::nodal::{Mesh, Nodal, NodalBeam, Rule};
use crate::spectrum::eigenvalues;
use loosepin_math::{Dual, Real, Vec2, legendre_rule};

/// A soft beam, so that stretch and bending are both large.
const BEAM: NodalBeam<f64> = NodalBeam {
    length_m: 1.3,
    mass_kg: 0.7,
    axial_stiffness_n_m: 310.0,
    bending_stiffness_n_m: 2.3,
    retardation_s: 0.017,
};
const ELEMENTS: usize = 3;
/// Round-off of sums of some dozens of terms, relative to the largest.
const ROUND_OFF: f64 = 1e-13;

/// Nodes of a bent and stretched beam, the same for every run.
fn bent() -> Vec<Nodal<f64>> {
    let place = |node: usize| {
        let x = node as f64;
        let position = Vec2::new(0.41 * x + 0.05 * (1.7 * x).sin(), 0.13 * x * x - 0.07 * x);
        Nodal { position, slope: Vec2::new(0.93 - 0.21 * x, 0.35 + 0.27 * x) }
    };
    (0..=ELEMENTS).map(place).collect()
}

fn moving() -> Vec<Nodal<f64>> {
    let rate = |node: usize| {
        let x = node as f64;
        Nodal { position: Vec2::new(0.7 - 0.4 * x, 1.1 + 0.3 * x), slope: Vec2::new(0.2 * x - 0.5, 0.9 - 0.6 * x * x) }
    };
    (0..=ELEMENTS).map(rate).collect()
}

fn flat(nodes: &[Nodal<f64>]) -> Vec<f64> {
    nodes.iter().flat_map(|node| [node.position.x, node.position.y, node.slope.x, node.slope.y]).collect()
}

fn nodes_of<T: Real>(numbers: &[T]) -> Vec<Nodal<T>> {
    let node = |four: &[T]| Nodal { position: Vec2::new(four[0], four[1]), slope: Vec2::new(four[2], four[3]) };
    numbers.chunks_exact(4).map(node).collect()
}

fn dual_beam() -> NodalBeam<Dual<f64>> {
    let NodalBeam { length_m, mass_kg, axial_stiffness_n_m, bending_stiffness_n_m, retardation_s } = BEAM;
    NodalBeam {
        length_m: Dual::constant(length_m),
        mass_kg: Dual::constant(mass_kg),
        axial_stiffness_n_m: Dual::constant(axial_stiffness_n_m),
        bending_stiffness_n_m: Dual::constant(bending_stiffness_n_m),
        retardation_s: Dual::constant(retardation_s),
    }
}

/// The nodes, which move along `along`.
fn dual_nodes(nodes: &[Nodal<f64>], along: &[f64]) -> Vec<Nodal<Dual<f64>>> {
    let numbers: Vec<Dual<f64>> =
        flat(nodes).iter().zip(along).map(|(&value, &derivative)| Dual { value, derivative }).collect();
    nodes_of(&numbers)
}

/// The unit vector of a coordinate.
fn unit(count: usize, index: usize) -> Vec<f64> {
    (0..count).map(|k| if k == index { 1.0 } else { 0.0 }).collect()
}

fn largest(numbers: &[f64]) -> f64 {
    numbers.iter().fold(0.0, |largest: f64, number| largest.max(number.abs()))
}

#[test]
fn identity_elastic_forces_are_the_slope_of_the_strain_energy() {
    for rule in [Rule::Full, Rule::Reduced] {
        let mesh = Mesh::new(ELEMENTS, rule);
        let mut forces = vec![Nodal::zero(); ELEMENTS + 1];
        BEAM.add_elastic(&mesh, &bent(), &mut forces);
        let forces = flat(&forces);
        for (index, force) in forces.iter().enumerate() {
            let along = unit(forces.len(), index);
            let energy = dual_beam().strain_j(&mesh, &dual_nodes(&bent(), &along));
            assert!((force + energy.derivative).abs() < ROUND_OFF * largest(&forces), "{index}: {force} N");
            // By differences of the energy itself: 6e-11 is what is left of them.
            let h = 1e-4;
            let at = |steps: f64| {
                let moved: Vec<f64> = flat(&bent()).iter().zip(&along).map(|(x, d)| x + steps * h * d).collect();
                BEAM.strain_j(&mesh, &nodes_of(&moved))
            };
            let difference = (8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))) / (12.0 * h);
            assert!((force + difference).abs() < 6e-11 * largest(&forces), "{index}: {force} N for {}", -difference);
        }
    }
}

#[test]
fn identity_the_tangent_is_the_slope_of_the_forces() {
    for rule in [Rule::Full, Rule::Reduced] {
        let mesh = Mesh::new(ELEMENTS, rule);
        let count = 4 * (ELEMENTS + 1);
        let mut tangent = vec![0.0; count * count];
        for element in 0..ELEMENTS {
            let matrix = BEAM.tangent(&mesh, &[bent()[element], bent()[element + 1]]);
            for (row, entries) in matrix.iter().enumerate() {
                for (column, entry) in entries.iter().enumerate() {
                    tangent[(4 * element + row) * count + 4 * element + column] += entry;
                }
            }
        }
        for column in 0..count {
            let mut forces = vec![Nodal::zero(); ELEMENTS + 1];
            dual_beam().add_elastic(&mesh, &dual_nodes(&bent(), &unit(count, column)), &mut forces);
            let slopes = forces.iter().flat_map(|f| [f.position.x, f.position.y, f.slope.x, f.slope.y]);
            for (row, force) in slopes.enumerate() {
                let entry = tangent[row * count + column];
                assert!((entry + force.derivative).abs() < ROUND_OFF * largest(&tangent), "{row}, {column}: {entry}");
            }
        }
    }
}

/// The damping forces are the slopes of Rayleigh's function, half of the loss, over the rates; and what the strain energy gains is the work
/// of the elastic forces.
#[test]
fn identity_damping_is_that_of_a_material_of_kelvin_and_voigt() {
    let mesh = Mesh::new(ELEMENTS, Rule::Full);
    let (nodes, rates) = (bent(), moving());
    let count = 4 * (ELEMENTS + 1);
    let [mut elastic, mut both] = [vec![Nodal::zero(); ELEMENTS + 1], vec![Nodal::zero(); ELEMENTS + 1]];
    BEAM.add_elastic(&mesh, &nodes, &mut elastic);
    let loss_w = BEAM.add_viscoelastic(&mesh, &nodes, &rates, &mut both);
    let drag: Vec<f64> = flat(&both).iter().zip(flat(&elastic)).map(|(both, elastic)| both - elastic).collect();
    assert!(loss_w > 1.0);
    for (index, drag_of) in drag.iter().enumerate() {
        let along = unit(count, index);
        let mut unused = vec![Nodal::zero(); ELEMENTS + 1];
        let constant = dual_nodes(&nodes, &vec![0.0; count]);
        let loss = dual_beam().add_viscoelastic(&mesh, &constant, &dual_nodes(&rates, &along), &mut unused);
        assert!((drag_of + 0.5 * loss.derivative).abs() < ROUND_OFF * largest(&drag), "{index}: {drag_of}");
    }
    let power_w: f64 = drag.iter().zip(flat(&rates)).map(|(drag, rate)| drag * rate).sum();
    assert!((power_w + loss_w).abs() < ROUND_OFF * loss_w);
    let gained = dual_beam().strain_j(&mesh, &dual_nodes(&nodes, &flat(&rates))).derivative;
    let work: f64 = flat(&elastic).iter().zip(flat(&rates)).map(|(force, rate)| force * rate).sum();
    assert!((gained + work).abs() < ROUND_OFF * work.abs().max(gained.abs()) * 10.0, "{gained} W and {work} W");
    // The loss is τ times that of the strains' rates: half of its second derivative along the motion, for a rate that is one.
    let doubled: Vec<Nodal<f64>> = nodes_of(&flat(&rates).iter().map(|rate| 2.0 * rate).collect::<Vec<f64>>());
    let loss_of_doubled_w = BEAM.add_viscoelastic(&mesh, &nodes, &doubled, &mut [Nodal::zero(); ELEMENTS + 1]);
    assert!((loss_of_doubled_w - 4.0 * loss_w).abs() < ROUND_OFF * loss_of_doubled_w);
}

/// A straight bar that is stretched evenly: σ = E (ε + τ ε̇).
#[test]
fn analytic_a_bar_that_is_stretched_evenly() {
    let mesh = Mesh::new(ELEMENTS, Rule::Full);
    let (axis, strain, rate_1_s) = (Vec2::new(0.6, 0.8), 0.02, 0.9);
    let mut nodes = BEAM.straight(&mesh, Vec2::new(0.3, -0.2), axis);
    let mut rates = vec![Nodal::zero(); nodes.len()];
    for (index, (node, rate)) in nodes.iter_mut().zip(&mut rates).enumerate() {
        let along_m = BEAM.length_m * index as f64 / ELEMENTS as f64;
        *node = Nodal { position: node.position.plus(axis, along_m * strain), slope: axis * (1.0 + strain) };
        *rate = Nodal { position: axis * (along_m * rate_1_s), slope: axis * rate_1_s };
    }
    let mut forces = vec![Nodal::zero(); nodes.len()];
    let loss_w = BEAM.add_viscoelastic(&mesh, &nodes, &rates, &mut forces);
    let axial_n = BEAM.axial_stiffness_n_m * BEAM.length_m;
    let pull_n = axial_n * (strain + BEAM.retardation_s * rate_1_s);
    assert!((forces[0].position - axis * pull_n).length() < ROUND_OFF * pull_n);
    assert!((forces[ELEMENTS].position + axis * pull_n).length() < ROUND_OFF * pull_n);
    let loss = axial_n * BEAM.retardation_s * rate_1_s * rate_1_s * BEAM.length_m;
    assert!((loss_w - loss).abs() < ROUND_OFF * loss);
    let strain_j = 0.5 * axial_n * strain * strain * BEAM.length_m;
    assert!((BEAM.strain_j(&mesh, &nodes) - strain_j).abs() < ROUND_OFF * strain_j);
}

#[test]
fn analytic_the_mass_matrix_is_the_integral_over_the_functions() {
    let mesh = Mesh::new(1, Rule::Full);
    let l = BEAM.length_m;
    let shapes = |xi: f64| {
        [
            1.0 - 3.0 * xi * xi + 2.0 * xi.powi(3),
            l * (xi - 2.0 * xi * xi + xi.powi(3)),
            3.0 * xi * xi - 2.0 * xi.powi(3),
            l * (xi.powi(3) - xi * xi),
        ]
    };
    let integral = |f: &dyn Fn(f64) -> f64| -> f64 {
        legendre_rule(6).iter().map(|(t, weight)| BEAM.mass_kg * weight * f(0.5 * (1.0 + t))).sum()
    };
    for i in 0..4 {
        for axis in [Vec2::new(1.0, 0.0), Vec2::new(0.0, 1.0)] {
            let mut vectors = [Vec2::zero(); 4];
            vectors[i] = axis;
            let of = |k: usize| Nodal { position: vectors[k], slope: vectors[k + 1] };
            let momenta = BEAM.momenta(&mesh, &[of(0), of(2)]);
            for (j, found) in
                [momenta[0].position, momenta[0].slope, momenta[1].position, momenta[1].slope].into_iter().enumerate()
            {
                let due = axis * integral(&|xi| shapes(xi)[i] * shapes(xi)[j]);
                assert!((found - due).length() < ROUND_OFF, "{i}, {j}: {found:?} for {due:?}");
            }
        }
    }
    // The axis and its centre of mass by the same functions.
    let ends = [bent()[0], bent()[2]];
    let vectors = [ends[0].position, ends[0].slope, ends[1].position, ends[1].slope];
    let place = |xi: f64| shapes(xi).iter().zip(vectors).fold(Vec2::zero(), |sum: Vec2<f64>, (s, v)| sum.plus(v, *s));
    for xi in [0.0, 0.31, 1.0] {
        assert!((BEAM.point_m(&mesh, &ends, xi) - place(xi)).length() < ROUND_OFF);
    }
    let centre = BEAM.centre_of_mass_m(&mesh, &ends);
    let [x, y] = [integral(&|xi| place(xi).x), integral(&|xi| place(xi).y)].map(|moment| moment / BEAM.mass_kg);
    assert!((centre - Vec2::new(x, y)).length() < ROUND_OFF);
    let gravity = Vec2::new(0.4, -9.7);
    let mut weight = vec![Nodal::zero(); 2];
    BEAM.add_weight(&mesh, gravity, &mut weight);
    for (i, found) in [weight[0].position, weight[0].slope, weight[1].position, weight[1].slope].into_iter().enumerate()
    {
        assert!((found - gravity * integral(&|xi| shapes(xi)[i])).length() < ROUND_OFF);
    }
}

#[test]
fn identity_a_rigid_motion_turns_the_forces_and_has_the_energy_of_a_rod() {
    let mesh = Mesh::new(ELEMENTS, Rule::Full);
    let (sine, cosine) = 2.3_f64.sin_cos();
    let away = Vec2::new(-1.7, 0.9);
    let turned = |node: &Nodal<f64>| Nodal {
        position: node.position.rotated(sine, cosine) + away,
        slope: node.slope.rotated(sine, cosine),
    };
    let (nodes, carried) = (bent(), bent().iter().map(turned).collect::<Vec<_>>());
    let [mut forces, mut of_carried] = [vec![Nodal::zero(); ELEMENTS + 1], vec![Nodal::zero(); ELEMENTS + 1]];
    BEAM.add_elastic(&mesh, &nodes, &mut forces);
    BEAM.add_elastic(&mesh, &carried, &mut of_carried);
    let size = largest(&flat(&forces));
    for (force, of_carried) in forces.iter().zip(&of_carried) {
        assert!((force.position.rotated(sine, cosine) - of_carried.position).length() < ROUND_OFF * size);
        assert!((force.slope.rotated(sine, cosine) - of_carried.slope).length() < ROUND_OFF * size);
    }
    // No resultant, and no couple about the origin.
    let total = forces.iter().fold(Vec2::zero(), |sum: Vec2<f64>, force| sum + force.position);
    let couple: f64 = nodes
        .iter()
        .zip(&forces)
        .map(|(node, force)| node.position.cross(force.position) + node.slope.cross(force.slope))
        .sum();
    assert!(total.length() < ROUND_OFF * size && couple.abs() < ROUND_OFF * size);

    // A straight beam that turns about its root: no forces, the centre of mass in the middle, and half m L² ω²/3.
    let axis = Vec2::new(cosine, sine);
    let (straight, spin) = (BEAM.straight(&mesh, away, axis), 3.1);
    let rate = |node: &Nodal<f64>| Nodal {
        position: (node.position - away).turned() * spin,
        slope: node.slope.turned() * spin,
    };
    let rates: Vec<Nodal<f64>> = straight.iter().map(rate).collect();
    let mut forces = vec![Nodal::zero(); ELEMENTS + 1];
    let loss_w = BEAM.add_viscoelastic(&mesh, &straight, &rates, &mut forces);
    assert!(loss_w < 1e-25 && largest(&flat(&forces)) < ROUND_OFF * BEAM.axial_stiffness_n_m);
    assert!(BEAM.strain_j(&mesh, &straight) < 1e-28);
    let energy = BEAM.mass_kg * (BEAM.length_m * spin).powi(2) / 6.0;
    assert!((BEAM.kinetic_j(&mesh, &rates) - energy).abs() < ROUND_OFF * energy);
    let middle = away.plus(axis, 0.5 * BEAM.length_m);
    assert!((BEAM.centre_of_mass_m(&mesh, &straight) - middle).length() < ROUND_OFF);
}

/// ω of a straight beam that floats, ascending; a motion without stiffness has zero.
fn frequencies_rad_s(beam: &NodalBeam<f64>, mesh: &Mesh) -> Vec<f64> {
    let count = 4 * mesh.nodes();
    let nodes = beam.straight(mesh, Vec2::zero(), Vec2::new(1.0, 0.0));
    let mut tangent = vec![0.0; count * count];
    for element in 0..mesh.elements() {
        let matrix = beam.tangent(mesh, &[nodes[element], nodes[element + 1]]);
        for (row, entries) in matrix.iter().enumerate() {
            for (column, entry) in entries.iter().enumerate() {
                tangent[(4 * element + row) * count + 4 * element + column] += entry;
            }
        }
    }
    let mass: Vec<f64> = (0..count).flat_map(|k| flat(&beam.momenta(mesh, &nodes_of(&unit(count, k))))).collect();
    eigenvalues(&mass, &tangent, count).iter().map(|square| square.max(0.0).sqrt()).collect()
}

/// A steel rod of 8 x 8 mm and 0.3 m.
fn rod() -> NodalBeam<f64> {
    NodalBeam {
        length_m: 0.3,
        mass_kg: 0.151104,
        axial_stiffness_n_m: 200e9 * 64e-6 / 0.3,
        bending_stiffness_n_m: 200e9 * (8e-3_f64).powi(4) / 12.0 / 0.3,
        retardation_s: 0.0,
    }
}

#[test]
fn analytic_frequencies_of_a_free_rod() {
    let rod = rod();
    let found = frequencies_rad_s(&rod, &Mesh::new(8, Rule::Full));
    let unit = (rod.bending_stiffness_n_m / (rod.mass_kg * rod.length_m * rod.length_m)).sqrt();
    // Beyond three rigid motions; cubic elements are exact to (l k)⁴/720 at a wave number k.
    for ((found, root), tolerance) in
        found[3..].iter().zip([4.730040745_f64, 7.853204624, 10.995607838]).zip([1e-4, 7e-4, 3e-3])
    {
        let due = root * root * unit;
        assert!((found / due - 1.0).abs() < tolerance, "{found} rad/s for {due}");
    }
    // The first axial one is π √(EA/(m L)), 8401.9 Hz.
    let axial = std::f64::consts::PI * (rod.axial_stiffness_n_m / rod.mass_kg).sqrt();
    let nearest = found.iter().map(|found| (found / axial - 1.0).abs()).fold(f64::INFINITY, f64::min);
    assert!(nearest < 1e-5, "{nearest}");
    assert_eq!(found.iter().filter(|frequency| **frequency < 1e-3 * unit).count(), 3);
}

/// Of a mesh: 9.55 c/l axial and 59.9 r c/l² lateral, c = √(E/ρ), r = √(I/A); of one element 13.04 c/l axial.
#[test]
fn analytic_largest_frequencies_of_a_mesh() {
    let rod = rod();
    let speed_m_s = (200e9_f64 / 7870.0).sqrt();
    let radius_m = 8e-3 / 12_f64.sqrt();
    let lateral = 59.9 * radius_m / (rod.length_m / 24.0);
    for (elements, due) in [(1, 13.04), (8, 9.55), (24, lateral)] {
        let l = rod.length_m / elements as f64;
        let found = frequencies_rad_s(&rod, &Mesh::new(elements, Rule::Full));
        let largest = found[found.len() - 1] * l / speed_m_s;
        assert!((largest / due - 1.0).abs() < 2e-3, "{elements} elements: {largest} for {due}");
        let told = rod.largest_frequency_rad_s(&Mesh::new(elements, Rule::Full)) * l / speed_m_s;
        assert!((told / due - 1.0).abs() < 1e-12, "{elements} elements: {told} for {due}");
    }
}

/// Two points for the stretch leave a motion of the whole mesh without stiffness: axial strain as 3η² - 1 in every element.
#[test]
fn analytic_only_two_axial_points_leave_a_motion_without_stiffness() {
    for (axial, bending, without) in [(5, 3, 3), (3, 2, 3), (2, 2, 4), (2, 3, 4)] {
        let found = frequencies_rad_s(&rod(), &Mesh::with_points(6, axial, bending));
        let loose = found.iter().filter(|frequency| **frequency < 1.0).count();
        assert_eq!(loose, without, "{axial} + {bending} points: {:?}", &found[..5]);
    }
}
