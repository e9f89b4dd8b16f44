//! Flexible bodies in absolute nodal coordinates in the equations of motion.
//!
//! The vectors e of all nodes (positions and slopes) move with the coordinates z of the tree as ė = E ż, ë = E z̈ + γ; E is one but for root
//! and tip, whose slope is s (cos θ, sin θ). With the constant mass matrix M of the elements the body adds Eᵀ M E to the mass matrix and
//! Eᵀ (Q - M γ) to the forces, Q those of elasticity, damping and weight.

use crate::dynamics::elements::nodal_workspace::{Column, NodalWorkspace};
use crate::dynamics::equations::Dynamics;
use crate::mechanism::{Pose, Twist, acceleration_at};
use loosepin_flexible::{MassEntries, Nodal, even_shares};
use loosepin_math::{Geometry, Plane, PlaneRotation, Real, Vec2, arctangent};

impl<T: Real> Dynamics<'_, T> {
    /// Nodes and their rates at the state that is set. Out of line: few mechanisms have them.
    #[inline(never)]
    pub(in crate::dynamics) fn set_nodes(&mut self) {
        for index in 0..self.nodal_workspaces.len() {
            let (place, numbers) = (&self.mechanism.real.nodal_beams[index], &self.sample.real.nodal_beams[index]);
            let (coordinates, rates) = (&self.coordinates, &self.rates);
            let end = |slot: usize, arm_m: Vec2<T>, stretch: usize| {
                let (pose, twist) = (&self.kinematics.poses[slot], &self.kinematics.twists[slot]);
                let (arm, axis) = (pose.turn(arm_m), pose.turn(numbers.axis));
                let (s, growth) = (coordinates[stretch], rates[stretch]);
                let turning = (axis.turned() * (s * twist.angular)).plus(axis, growth);
                let node = Nodal { position: pose.position_m + arm, slope: axis * s };
                (node, Nodal { position: twist.at(arm), slope: turning })
            };
            let workspace = &mut self.nodal_workspaces[index];
            let last = place.mesh.elements();
            (workspace.nodes[0], workspace.rates[0]) = end(place.slot, numbers.root_m, place.root_stretch());
            (workspace.nodes[last], workspace.rates[last]) = end(place.tip_slot, numbers.tip_m, place.tip_stretch());
            for node in 1..last {
                let first = place.node(node);
                workspace.nodes[node] = nodal(&coordinates[first..first + 4]);
                workspace.rates[node] = nodal(&rates[first..first + 4]);
            }
        }
    }

    /// Adds mass matrix and forces of the body `index`.
    pub(in crate::dynamics) fn add_nodal_beam(&mut self, index: usize) {
        let tree = &self.mechanism.real;
        let n = tree.free;
        let (place, numbers) = (&tree.nodal_beams[index], &self.sample.real.nodal_beams[index]);
        let mesh = &*place.mesh;
        let last = mesh.elements();
        let NodalWorkspace { nodes, rates, forces, ends } = &mut self.nodal_workspaces[index];
        let mass = numbers.beam.mass(mesh);

        forces.fill(Nodal::zero());
        if place.is_damped {
            self.beam_loss_w += numbers.beam.add_viscoelastic(mesh, nodes, rates, forces);
        } else {
            numbers.beam.add_elastic(mesh, nodes, forces);
        }
        numbers.beam.add_weight(mesh, self.sample.real.gravity_m_s2, forces);

        // Columns of E for the ends, and the accelerations of the ends without those of the free coordinates.
        let sides = [
            (place.slot, numbers.root_m, place.root_stretch(), 0, 1, T::one()),
            (place.tip_slot, numbers.tip_m, place.tip_stretch(), last, last - 1, -T::one()),
        ];
        for (side, (slot, arm_m, stretch, near, far, sign)) in sides.into_iter().enumerate() {
            let (pose, twist) = (&self.kinematics.poses[slot], &self.kinematics.twists[slot]);
            let bias = &self.kinematics.biases[slot];
            let (arm, axis) = (pose.turn(arm_m), pose.turn(numbers.axis));
            let along = axis * self.coordinates[stretch];
            let columns = &mut ends[side];
            for (to, column) in columns.iter_mut().zip(self.kinematics.columns(tree, slot)) {
                *to = Column {
                    coordinate: column.coordinate,
                    position: column.at(arm),
                    slope: Plane::moved(Vec2::zero(), column.turning, along),
                };
            }
            columns[tree.dependences(slot).len()] = Column { coordinate: stretch, position: Vec2::zero(), slope: axis };

            let of_position = acceleration_at(bias, twist, arm);
            let growth = self.rates[stretch];
            let of_slope = slope_acceleration(bias, twist, axis, self.coordinates[stretch], growth);
            let (lever, crossing) = (sign * mass.lever, sign * mass.across);
            let to = &mut forces[near];
            to.position = to.position.plus(of_position, -mass.position).plus(of_slope, -lever);
            to.slope = to.slope.plus(of_position, -lever).plus(of_slope, -mass.slope);
            let to = &mut forces[far];
            to.position = to.position.plus(of_position, -mass.positions).plus(of_slope, crossing);
            to.slope = to.slope.plus(of_position, -crossing).plus(of_slope, -mass.slopes);
        }

        for (columns, force) in ends.iter().zip([forces[0], forces[last]]) {
            for column in columns {
                let of_slope = column.slope.dot(force.slope);
                self.equations.forces[column.coordinate] += column.position.dot(force.position) + of_slope;
            }
        }
        let mut matrix = Matrix { free: n, mass: &mut self.equations.mass, driven: &mut self.equations.driven_mass };
        for (columns, sign) in ends.iter().zip([T::one(), -T::one()]) {
            matrix.add_end(columns, &mass, sign);
        }
        if last == 1 {
            matrix.add_across(&ends[0], &ends[1], &mass);
            return;
        }
        for node in 1..last {
            let first = place.node(node);
            let force = forces[node];
            for (coordinate, force) in
                [force.position.x, force.position.y, force.slope.x, force.slope.y].into_iter().enumerate()
            {
                self.equations.forces[first + coordinate] += force;
            }
            matrix.add_node(first, &mass);
            if node > 1 {
                matrix.add_neighbours(place.node(node - 1), first, &mass);
            }
        }
        for (columns, node, sign) in [(&ends[0], 1, T::one()), (&ends[1], last - 1, -T::one())] {
            matrix.add_beside_end(columns, place.node(node), &mass, sign);
        }
    }

    /// Force that the body `index` needs at the last evaluation, Σ m (a - g), N.
    pub(in crate::dynamics) fn nodal_force_n(&self, index: usize) -> Vec2<T> {
        let (place, numbers) = (&self.mechanism.real.nodal_beams[index], &self.sample.real.nodal_beams[index]);
        let of_centre = numbers.beam.centre_of_mass_m(&place.mesh, &self.nodal_accelerations(index));
        (of_centre - self.sample.real.gravity_m_s2) * numbers.beam.mass_kg
    }

    /// Accelerations of the nodes of the body `index` at the last evaluation.
    pub(in crate::dynamics) fn nodal_accelerations(&self, index: usize) -> Vec<Nodal<T>> {
        let (place, numbers) = (&self.mechanism.real.nodal_beams[index], &self.sample.real.nodal_beams[index]);
        let end = |slot: usize, arm_m: Vec2<T>, stretch: usize| {
            let (pose, twist) = (&self.kinematics.poses[slot], &self.kinematics.twists[slot]);
            let change = self.acceleration(slot);
            let (arm, axis) = (pose.turn(arm_m), pose.turn(numbers.axis));
            let (s, growth) = (self.coordinates[stretch], self.rates[stretch]);
            let of_slope =
                slope_acceleration(&change, twist, axis, s, growth).plus(axis, self.equations.accelerations[stretch]);
            Nodal { position: acceleration_at(&change, twist, arm), slope: of_slope }
        };
        let last = place.mesh.elements();
        let mut accelerations = vec![Nodal::zero(); last + 1];
        accelerations[0] = end(place.slot, numbers.root_m, place.root_stretch());
        accelerations[last] = end(place.tip_slot, numbers.tip_m, place.tip_stretch());
        for (node, acceleration) in accelerations.iter_mut().enumerate().take(last).skip(1) {
            *acceleration = nodal(&self.equations.accelerations[place.node(node)..place.node(node) + 4]);
        }
        accelerations
    }

    /// Kinetic, potential and strain energy of the body `index` at the last state that was set, J.
    pub(in crate::dynamics) fn nodal_energy_j(&self, index: usize) -> [T; 3] {
        let (place, numbers) = (&self.mechanism.real.nodal_beams[index], &self.sample.real.nodal_beams[index]);
        let (beam, workspace) = (&numbers.beam, &self.nodal_workspaces[index]);
        let centre = beam.centre_of_mass_m(&place.mesh, &workspace.nodes);
        let height = self.sample.real.gravity_m_s2.dot(centre);
        [
            beam.kinetic_j(&place.mesh, &workspace.rates),
            -(beam.mass_kg * height),
            beam.strain_j(&place.mesh, &workspace.nodes),
        ]
    }
}

impl Dynamics<'_, f64> {
    /// Momentum, kg m/s, and angular momentum about the ground's origin, kg m²/s, of the flexible body `index` in absolute nodal coordinates at
    /// the last state that was set: Σ (M ė)_r, and Σ r × (M ė)_r + r' × (M ė)_r' over the nodes.
    pub fn nodal_momentum(&self, index: usize) -> (Vec2<f64>, f64) {
        let (place, numbers) = (&self.mechanism.real.nodal_beams[index], &self.sample.real.nodal_beams[index]);
        let NodalWorkspace { nodes, rates, .. } = &self.nodal_workspaces[index];
        let momenta = numbers.beam.momenta(&place.mesh, rates);
        let add = |(sum, turn): (Vec2<f64>, f64), (node, momentum): (&Nodal<f64>, &Nodal<f64>)| {
            let angular = node.position.cross(momentum.position) + node.slope.cross(momentum.slope);
            (sum + momentum.position, turn + angular)
        };
        nodes.iter().zip(&momenta).fold((Vec2::zero(), 0.0), add)
    }

    /// Largest angle of the sections at the nodes of the flexible body `index` in absolute nodal coordinates from the way from root to tip, up
    /// to π, rad, at the last state that was set.
    pub fn nodal_turn_rad(&self, index: usize) -> f64 {
        let nodes = &self.nodal_workspaces[index].nodes;
        let way_m = nodes[nodes.len() - 1].position - nodes[0].position;
        let turn_rad = |node: &Nodal<f64>| {
            let sizes = way_m.length() * node.slope.length();
            2.0 * arctangent(way_m.cross(node.slope).abs() / (sizes + way_m.dot(node.slope)))
        };
        nodes.iter().map(turn_rad).fold(0.0, f64::max)
    }

    /// The frame of the flexible body `index` in absolute nodal coordinates through its root, whose x axis goes to the tip as that of the
    /// undeformed body does, at the last state that was set. Its angle is within π of that of the section at the root.
    pub fn nodal_secant(&self, index: usize) -> Pose<f64> {
        let (place, numbers) = (&self.mechanism.real.nodal_beams[index], &self.sample.real.nodal_beams[index]);
        let (pose, nodes) = (&self.kinematics.poses[place.slot], &self.nodal_workspaces[index].nodes);
        let way_m = nodes[nodes.len() - 1].position - nodes[0].position;
        let axis = pose.turn(numbers.axis);
        let turn_rad = 2.0 * arctangent(axis.cross(way_m) / (way_m.length() + axis.dot(way_m)));
        let angle_rad = pose.angle_rad() + turn_rad;
        let (sine, cosine) = Real::sin_cos(angle_rad);
        let position_m = nodes[0].position - numbers.root_m.rotated(sine, cosine);
        Pose { position_m, rotation: PlaneRotation { angle_rad, sine, cosine } }
    }

    /// `count` >= 2 points of the axis of the flexible body `index` in absolute nodal coordinates at the last state that was set, evenly from
    /// root to tip, in the ground's frame, m.
    pub fn nodal_axis_m(&self, index: usize, count: usize) -> Vec<Vec2<f64>> {
        let (place, numbers) = (&self.mechanism.real.nodal_beams[index], &self.sample.real.nodal_beams[index]);
        let nodes = &self.nodal_workspaces[index].nodes;
        even_shares(count).into_iter().map(|share| numbers.beam.point_m(&place.mesh, nodes, share)).collect()
    }
}

fn nodal<T: Real>(four: &[T]) -> Nodal<T> {
    Nodal { position: Vec2::new(four[0], four[1]), slope: Vec2::new(four[2], four[3]) }
}

/// Acceleration of the slope s (cos θ, sin θ) where s has none: 2 ṡ ω t + s (ω̇ t - ω² e), 1/s².
fn slope_acceleration<T: Real>(change: &Twist<T>, twist: &Twist<T>, axis: Vec2<T>, s: T, growth: T) -> Vec2<T> {
    let spin = twist.angular;
    let turning = (growth + growth).mul_add(spin, s * change.angular);
    (axis.turned() * turning).plus(axis, -(s * spin.squared()))
}

/// The mass matrix: the lower triangle of the free coordinates, and rows of the driven ones.
struct Matrix<'m, T> {
    free: usize,
    mass: &'m mut [T],
    driven: &'m mut [T],
}

impl<T: Real> Matrix<'_, T> {
    /// Adds an entry of two coordinates; what couples two driven ones is not used.
    fn add(&mut self, one: usize, other: usize, value: T) {
        let (high, low, n) = (one.max(other), one.min(other), self.free);
        if low >= n {
            return;
        }
        let place = if high < n { &mut self.mass[high * n + low] } else { &mut self.driven[(high - n) * n + low] };
        *place += value;
    }

    /// Adds an end with itself; `sign` is one at the root, minus one at the tip.
    fn add_end(&mut self, columns: &[Column<T>], mass: &MassEntries<T>, sign: T) {
        for (k, row) in columns.iter().enumerate() {
            for column in &columns[..=k] {
                let mixed = row.position.dot(column.slope) + row.slope.dot(column.position);
                let own =
                    mass.position.mul_add(row.position.dot(column.position), mass.slope * row.slope.dot(column.slope));
                self.add(row.coordinate, column.coordinate, (sign * mass.lever).mul_add(mixed, own));
            }
        }
    }

    /// Adds root with tip, of one element alone.
    fn add_across(&mut self, root: &[Column<T>], tip: &[Column<T>], mass: &MassEntries<T>) {
        for row in root {
            for column in tip {
                let mixed = row.position.dot(column.slope) - row.slope.dot(column.position);
                let like = mass
                    .positions
                    .mul_add(row.position.dot(column.position), mass.slopes * row.slope.dot(column.slope));
                self.add(row.coordinate, column.coordinate, mass.across.mul_add(mixed, like));
            }
        }
    }

    /// Adds a node between two elements with itself.
    fn add_node(&mut self, first: usize, mass: &MassEntries<T>) {
        for (coordinate, value) in [mass.position, mass.position, mass.slope, mass.slope].into_iter().enumerate() {
            self.add(first + coordinate, first + coordinate, value + value);
        }
    }

    /// Adds two nodes beside each other.
    fn add_neighbours(&mut self, before: usize, behind: usize, mass: &MassEntries<T>) {
        for axis in 0..2 {
            self.add(before + axis, behind + axis, mass.positions);
            self.add(before + axis, behind + 2 + axis, mass.across);
            self.add(before + 2 + axis, behind + axis, -mass.across);
            self.add(before + 2 + axis, behind + 2 + axis, mass.slopes);
        }
    }

    /// Adds an end with the node beside it; `sign` is one at the root, minus one at the tip.
    fn add_beside_end(&mut self, columns: &[Column<T>], node: usize, mass: &MassEntries<T>, sign: T) {
        let across = sign * mass.across;
        for column in columns {
            let of_position = (column.position * mass.positions).plus(column.slope, -across);
            let of_slope = (column.position * across).plus(column.slope, mass.slopes);
            for (coordinate, value) in [of_position.x, of_position.y, of_slope.x, of_slope.y].into_iter().enumerate() {
                self.add(column.coordinate, node + coordinate, value);
            }
        }
    }
}
