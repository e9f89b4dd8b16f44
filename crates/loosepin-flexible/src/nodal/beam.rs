//! The numbers of a beam in absolute nodal coordinates: forces, inertia and energies of the whole chain.

use super::element::{Ends, Loads, Section};
use super::mesh::{Mesh, Nodal, Point};
use loosepin_math::{Real, Vec2, numbers};

/// A straight uniform beam in absolute nodal coordinates (planar cable element, thin beam without shear).
///
/// In an element of length l, ξ = x/l, with the nodes (r0, r0') and (r1, r1'):
///
/// ```text
/// r = S_0 r0 + S_1 r0' + S_2 r1 + S_3 r1'
/// S = ( 1 - 3ξ² + 2ξ³,  l(ξ - 2ξ² + ξ³),  3ξ² - 2ξ³,  l(-ξ² + ξ³) )
/// ε = |r'| - 1,    κ = (r' × r'')/|r'|²,    U = ½ ∫ EA ε² + EI κ² dx
/// ```
///
/// κ is dθ/dx of the material (the angle θ of the section over the undeformed length). Material of Kelvin and Voigt: σ = E (ε + τ ε̇), so
/// that the damping of a mode of frequency ω is ζ = τω/2. Position and slope are seen from the ground: the mass matrix is constant, and
/// there is no limit to how far the beam turns or bends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NodalBeam<T> {
    /// Length L, m, > 0.
    pub length_m: T,
    /// Mass ρAL, kg, > 0.
    pub mass_kg: T,
    /// EA/L, N/m, > 0.
    pub axial_stiffness_n_m: T,
    /// EI/L, N m/rad, > 0.
    pub bending_stiffness_n_m: T,
    /// Retardation time τ, s, >= 0.
    pub retardation_s: T,
}

numbers!(struct NodalBeam { length_m, mass_kg, axial_stiffness_n_m, bending_stiffness_n_m, retardation_s });

/// The constant mass matrix ∫ρA S Sᵀ dx of an element; each entry times the unit matrix of the plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MassEntries<T> {
    /// Position with itself, 156 m/420, kg.
    pub position: T,
    /// Position with the slope of the same node, 22 l m/420, kg m: negative at the second node.
    pub lever: T,
    /// Slope with itself, 4 l² m/420, kg m².
    pub slope: T,
    /// Position with that of the other node, 54 m/420, kg.
    pub positions: T,
    /// Position of the first node with the slope of the second, -13 l m/420, kg m: positive the other way.
    pub across: T,
    /// Slope with that of the other node, -3 l² m/420, kg m².
    pub slopes: T,
}

impl<T: Real> NodalBeam<T> {
    /// l, m.
    pub fn element_length_m(&self, mesh: &Mesh) -> T {
        self.length_m * T::from_f64(1.0 / mesh.elements() as f64)
    }

    /// Frequency that no mode of the mesh exceeds by more than a part in a hundred, rad/s: that of a free element in its stretch, or of many
    /// in their bending,
    ///
    /// ```text
    /// 13.04 c/l of one element, 9.55 c/l of more,   59.9 r c/l²,   c = √(EA L/m),  r = √(I/A)
    /// ```
    ///
    /// It limits explicit steps.
    pub fn largest_frequency_rad_s(&self, mesh: &Mesh) -> T {
        let length_m = self.element_length_m(mesh);
        let speed_m_s = (self.axial_stiffness_n_m * self.length_m * self.length_m / self.mass_kg).sqrt();
        let radius_m = (self.bending_stiffness_n_m / self.axial_stiffness_n_m).sqrt();
        let along = T::from_f64(if mesh.elements() == 1 { 13.04 } else { 9.55 });
        let across = T::from_f64(59.9) * radius_m / length_m;
        along.max(across) * speed_m_s / length_m
    }

    /// Numbers of an element's section.
    pub(super) fn section(&self, mesh: &Mesh) -> Section<T> {
        Section {
            length_m: self.element_length_m(mesh),
            axial_n: self.axial_stiffness_n_m * self.length_m,
            bending_n_m2: self.bending_stiffness_n_m * self.length_m,
            retardation_s: self.retardation_s,
        }
    }

    /// Nodes of the undeformed beam from `root_m` on in the direction of the unit vector `axis`.
    pub fn straight(&self, mesh: &Mesh, root_m: Vec2<T>, axis: Vec2<T>) -> Vec<Nodal<T>> {
        let place = |node: usize| {
            let along_m = self.length_m * T::from_f64(node as f64 / mesh.elements() as f64);
            Nodal { position: root_m.plus(axis, along_m), slope: axis }
        };
        (0..mesh.nodes()).map(place).collect()
    }

    /// Adds the elastic forces on all nodes.
    pub fn add_elastic(&self, mesh: &Mesh, nodes: &[Nodal<T>], forces: &mut [Nodal<T>]) {
        let section = self.section(mesh);
        for element in 0..mesh.elements() {
            let loads = section.elastic(mesh, &nodes[element..element + 2]);
            loads.add_to(section.length_m, &mut forces[element..element + 2]);
        }
    }

    /// Adds elastic forces and damping on all nodes. The power that the damping turns into heat, W.
    pub fn add_viscoelastic(&self, mesh: &Mesh, nodes: &[Nodal<T>], rates: &[Nodal<T>], forces: &mut [Nodal<T>]) -> T {
        let section = self.section(mesh);
        let mut loss_w = T::zero();
        for element in 0..mesh.elements() {
            let (loads, lost_w) =
                section.viscoelastic(mesh, &nodes[element..element + 2], &rates[element..element + 2]);
            loads.add_to(section.length_m, &mut forces[element..element + 2]);
            loss_w += lost_w;
        }
        loss_w
    }

    /// Strain energy U, J.
    pub fn strain_j(&self, mesh: &Mesh, nodes: &[Nodal<T>]) -> T {
        let section = self.section(mesh);
        nodes.windows(2).fold(T::zero(), |sum, ends| sum + section.strain_j(mesh, ends))
    }

    /// Mass matrix of an element.
    pub fn mass(&self, mesh: &Mesh) -> MassEntries<T> {
        let length_m = self.element_length_m(mesh);
        let share_kg = self.mass_kg * T::from_f64(1.0 / (420.0 * mesh.elements() as f64));
        let lever = share_kg * length_m;
        let turning = lever * length_m;
        MassEntries {
            position: share_kg * T::from_f64(156.0),
            lever: lever * T::from_f64(22.0),
            slope: turning * T::from_f64(4.0),
            positions: share_kg * T::from_f64(54.0),
            across: lever * T::from_f64(-13.0),
            slopes: turning * T::from_f64(-3.0),
        }
    }

    /// Mass matrix times `vectors` of all nodes: momenta of rates, inertia forces of accelerations.
    pub fn momenta(&self, mesh: &Mesh, vectors: &[Nodal<T>]) -> Vec<Nodal<T>> {
        let mass = self.mass(mesh);
        let mut momenta = vec![Nodal::zero(); vectors.len()];
        for (element, ends) in vectors.windows(2).enumerate() {
            for (own, other, sign) in [(0, 1, T::one()), (1, 0, -T::one())] {
                let (near, far) = (ends[own], ends[other]);
                let to = &mut momenta[element + own];
                to.position = to
                    .position
                    .plus(near.position, mass.position)
                    .plus(near.slope, sign * mass.lever)
                    .plus(far.position, mass.positions)
                    .plus(far.slope, sign * mass.across);
                to.slope = to
                    .slope
                    .plus(near.position, sign * mass.lever)
                    .plus(near.slope, mass.slope)
                    .plus(far.position, -(sign * mass.across))
                    .plus(far.slope, mass.slopes);
            }
        }
        momenta
    }

    /// Kinetic energy, J.
    pub fn kinetic_j(&self, mesh: &Mesh, rates: &[Nodal<T>]) -> T {
        let mass = self.mass(mesh);
        let half = T::from_f64(0.5);
        let of_element = |sum: T, ends: &[Nodal<T>]| {
            let (first, last) = (ends[0], ends[1]);
            let alone = mass.position * (first.position.length_squared() + last.position.length_squared())
                + mass.slope * (first.slope.length_squared() + last.slope.length_squared());
            let together = mass.lever * (first.position.dot(first.slope) - last.position.dot(last.slope))
                + mass.positions * first.position.dot(last.position)
                + mass.across * (first.position.dot(last.slope) - last.position.dot(first.slope))
                + mass.slopes * first.slope.dot(last.slope);
            sum + half.mul_add(alone, together)
        };
        rates.windows(2).fold(T::zero(), of_element)
    }

    /// Adds the weight ∫ρA S_i g dx for the acceleration `gravity_m_s2`. Between elements the parts on the slopes cancel.
    pub fn add_weight(&self, mesh: &Mesh, gravity_m_s2: Vec2<T>, forces: &mut [Nodal<T>]) {
        let half_kg = self.mass_kg * T::from_f64(0.5 / mesh.elements() as f64);
        let lever = half_kg * self.element_length_m(mesh) * T::from_f64(1.0 / 6.0);
        let last = mesh.elements();
        for (node, force) in forces.iter_mut().enumerate() {
            let share_kg = if node == 0 || node == last { half_kg } else { half_kg + half_kg };
            force.position = force.position.plus(gravity_m_s2, share_kg);
        }
        forces[0].slope = forces[0].slope.plus(gravity_m_s2, lever);
        forces[last].slope = forces[last].slope.plus(gravity_m_s2, -lever);
    }

    /// Centre of mass, m.
    pub fn centre_of_mass_m(&self, mesh: &Mesh, nodes: &[Nodal<T>]) -> Vec2<T> {
        let lever = self.element_length_m(mesh) * T::from_f64(1.0 / 12.0);
        let middle = |sum: Vec2<T>, ends: &[Nodal<T>]| {
            let of_positions = (ends[0].position + ends[1].position) * T::from_f64(0.5);
            sum + of_positions.plus(ends[0].slope - ends[1].slope, lever)
        };
        nodes.windows(2).fold(Vec2::zero(), middle) * T::from_f64(1.0 / mesh.elements() as f64)
    }

    /// Point of the axis at the share `s` of the length, from 0 to 1, m; of accelerations of the nodes, its acceleration.
    pub fn point_m(&self, mesh: &Mesh, nodes: &[Nodal<T>], s: f64) -> Vec2<T> {
        let (element, xi) = mesh.place(s);
        let length_m = self.element_length_m(mesh);
        let (first, last) = (nodes[element], nodes[element + 1]);
        let share = T::from_f64(xi * xi * (3.0 - 2.0 * xi));
        let of_first = length_m * T::from_f64(xi * (1.0 - xi) * (1.0 - xi));
        let of_last = length_m * T::from_f64(xi * xi * (xi - 1.0));
        first.position.plus(last.position - first.position, share).plus(first.slope, of_first).plus(last.slope, of_last)
    }

    /// Slope r' of the axis at the share `s` of the length, from 0 to 1.
    pub fn slope(&self, mesh: &Mesh, nodes: &[Nodal<T>], s: f64) -> Vec2<T> {
        let (element, xi) = mesh.place(s);
        Ends::new(self.element_length_m(mesh), &nodes[element..element + 2]).slope(&Point::at(xi, 0.0))
    }
}

impl<T: Real> Loads<T> {
    /// Adds the forces on the two nodes.
    fn add_to(&self, length_m: T, ends: &mut [Nodal<T>]) {
        let pull_n = self.chord_n_m * (T::one() / length_m);
        ends[0].position += pull_n;
        ends[1].position += -pull_n;
        ends[0].slope += -self.first_n_m;
        ends[1].slope += -self.last_n_m;
    }
}
