//! Flexible bodies in the equations of motion.
//!
//! With V = AᵀṘ of the frame's root, ω and q̇ = E_q ż, and T = [Aᵀ J_R; e_θ; E_q], the body adds Tᵀ M T to the mass matrix and
//! -Tᵀ (h + M (Aᵀ (γ_R - g), γ_θ, 0) + (0, 0, K q + C q̇)) to the forces (F3), γ the acceleration where the free coordinates have none.

use crate::dynamics::equations::Dynamics;
use crate::mechanism::acceleration_at;
use loosepin_flexible::Inertia;
use loosepin_math::{Geometry, Plane, Real, Vec2, Vector};

impl<T: Real> Dynamics<'_, T> {
    /// Adds mass matrix and forces of all flexible bodies. Not every mechanism has them: out of line, or the compiler would take many
    /// times as long for the evaluation as a whole.
    #[inline(never)]
    pub(in crate::dynamics) fn add_beams(&mut self) {
        self.beam_loss_w = T::zero();
        for index in 0..self.mechanism.real.beams.len() {
            self.add_beam(index);
        }
        for index in 0..self.mechanism.real.nodal_beams.len() {
            self.add_nodal_beam(index);
        }
    }

    fn add_beam(&mut self, index: usize) {
        let tree = &self.mechanism.real;
        let n = tree.free;
        let (place, numbers, workspace) =
            (&tree.beams[index], &self.sample.real.beams[index], &mut self.beam_workspaces[index]);
        let link = &tree.links[place.slot - 1];
        let pose = &self.kinematics.poses[place.slot];
        let (twist, bias) = (&self.kinematics.twists[place.slot], &self.kinematics.biases[place.slot]);
        let (q, rates) = (&self.coordinates[place.coordinates.clone()], &self.rates[place.coordinates.clone()]);
        let beam = &numbers.beam;
        let axis = pose.turn(numbers.axis);
        let root_arm = pose.turn(numbers.root_m);
        let into_frame = |vector: Vec2<T>| vector.rotated(-axis.y, axis.x);
        beam.inertia(&place.shapes, q, rates, twist.angular, &mut workspace.inertia);
        workspace.inertia.add_to_shapes(&numbers.added_mass);
        let Inertia { size, mass, bias: own_bias, .. } = &workspace.inertia;
        let size = *size;

        // Accelerations of the frame without those of the free coordinates, and weight.
        let fall = into_frame(acceleration_at(bias, twist, root_arm) - self.sample.real.gravity_m_s2);
        let given = [fall.x, fall.y, bias.angular];
        for (row, force) in workspace.forces.iter_mut().enumerate() {
            let products = mass[row * size..row * size + 3].iter().zip(given);
            *force = products.fold(-own_bias[row], |sum, (mass, given)| (-*mass).mul_add(given, sum));
        }
        if numbers.damping.is_empty() {
            beam.add_elastic(&place.shapes, q, rates, &mut workspace.forces[3..]);
            if place.is_damped {
                self.beam_loss_w += beam.damping_loss_w(&place.shapes, rates);
            }
        } else {
            beam.add_stiffness(&place.shapes, q, &mut workspace.forces[3..]);
            let rows = numbers.damping.chunks_exact(rates.len());
            for ((row, force), rate) in rows.zip(&mut workspace.forces[3..]).zip(rates) {
                let drag = product(row, rates);
                *force -= drag;
                self.beam_loss_w = drag.mul_add(*rate, self.beam_loss_w);
            }
        }

        let on_root = Vec2::new(workspace.forces[0], workspace.forces[1]).rotated(axis.y, axis.x);
        for (k, column) in self.kinematics.columns(tree, place.slot).enumerate() {
            let velocity = column.at(root_arm);
            let force = &mut self.equations.forces[column.coordinate];
            *force = on_root.inner_plus(velocity, Plane::push(workspace.forces[2], column.turning, *force));
            let own = into_frame(velocity);
            for (row, carried) in workspace.carried[k * size..(k + 1) * size].iter_mut().enumerate() {
                let row = &mass[row * size..row * size + 3];
                let moving = row[0].mul_add(own.x, row[1] * own.y);
                *carried = Plane::push(row[2], column.turning, moving);
            }
            for (l, other) in link.dependences[..=k].iter().enumerate() {
                let (high, low) = (column.coordinate.max(*other), column.coordinate.min(*other));
                if low >= n {
                    continue;
                }
                let to = if high < n {
                    &mut self.equations.mass[high * n + low]
                } else {
                    &mut self.equations.driven_mass[(high - n) * n + low]
                };
                let of_other = &workspace.carried[l * size..(l + 1) * size];
                let sum = of_other[0].mul_add(own.x, of_other[1].mul_add(own.y, *to));
                *to = Plane::push(of_other[2], column.turning, sum);
            }
            for (shape, coordinate) in place.coordinates.clone().enumerate() {
                let coupling = workspace.carried[k * size + 3 + shape];
                let (high, low) = (column.coordinate.max(coordinate), column.coordinate.min(coordinate));
                if high < n {
                    self.equations.mass[high * n + low] += coupling;
                } else {
                    self.equations.driven_mass[(high - n) * n + low] += coupling;
                }
            }
        }
        for (shape, coordinate) in place.coordinates.clone().enumerate() {
            self.equations.forces[coordinate] += workspace.forces[3 + shape];
            for (other, column) in place.coordinates.clone().take(shape + 1).enumerate() {
                self.equations.mass[coordinate * n + column] += mass[(3 + shape) * size + 3 + other];
            }
        }
    }

    /// Force that the flexible body `index` needs at the last evaluation, Σ m (a - g), N.
    pub(in crate::dynamics) fn beam_force_n(&self, index: usize) -> Vec2<T> {
        let (place, numbers) = (&self.mechanism.real.beams[index], &self.sample.real.beams[index]);
        let pose = &self.kinematics.poses[place.slot];
        let axis = pose.turn(numbers.axis);
        let change = self.acceleration(place.slot);
        let at_root = acceleration_at(&change, &self.kinematics.twists[place.slot], pose.turn(numbers.root_m));
        let fall = (at_root - self.sample.real.gravity_m_s2).rotated(-axis.y, axis.x);
        let Inertia { size, mass, bias, .. } = &self.beam_workspaces[index].inertia;
        let of_shapes = &self.equations.accelerations[place.coordinates.clone()];
        let along = |row: usize| {
            let row_of = &mass[row * size..(row + 1) * size];
            let frame =
                row_of[0].mul_add(fall.x, row_of[1].mul_add(fall.y, row_of[2].mul_add(change.angular, bias[row])));
            row_of[3..].iter().zip(of_shapes).fold(frame, |sum, (mass, change)| mass.mul_add(*change, sum))
        };
        Vec2::new(along(0), along(1)).rotated(axis.y, axis.x)
    }

    /// Kinetic, potential and strain energy of the flexible body `index` at the last state that was set, J.
    pub(in crate::dynamics) fn beam_energy_j(&self, index: usize) -> [T; 3] {
        let (place, numbers) = (&self.mechanism.real.beams[index], &self.sample.real.beams[index]);
        let (pose, twist) = (&self.kinematics.poses[place.slot], &self.kinematics.twists[place.slot]);
        let (q, rates) = (&self.coordinates[place.coordinates.clone()], &self.rates[place.coordinates.clone()]);
        let (axis, root_arm) = (pose.turn(numbers.axis), pose.turn(numbers.root_m));
        let velocity = twist.at(root_arm).rotated(-axis.y, axis.x);
        let mut kinetic_j = numbers.beam.kinetic_j(&place.shapes, q, rates, velocity, twist.angular);
        for (row, rate) in numbers.added_mass.chunks_exact(rates.len()).zip(rates) {
            let momentum = product(row, rates);
            kinetic_j = (momentum * *rate).mul_add(T::from_f64(0.5), kinetic_j);
        }
        let centre = numbers.beam.centre_of_mass_m(&place.shapes, q).rotated(axis.y, axis.x);
        let height = self.sample.real.gravity_m_s2.dot(pose.position_m + root_arm + centre);
        [kinetic_j, -(numbers.beam.mass_kg * height), numbers.beam.strain_j(&place.shapes, q)]
    }
}

/// Product of a row of a matrix with a vector.
fn product<T: Real>(row: &[T], vector: &[T]) -> T {
    row.iter().zip(vector).fold(T::zero(), |sum, (entry, number)| entry.mul_add(*number, sum))
}
