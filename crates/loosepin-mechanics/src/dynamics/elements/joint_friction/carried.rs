//! Joints with friction in the equations of motion: what they carry, and what their friction adds.

use super::{Carrier, JointFrictions, PARTS};
use crate::dynamics::equations::Dynamics;
use crate::mechanism::acceleration_at;
use crate::mechanism::constraints;
use crate::model::JointId;
use loosepin_math::{Geometry, Plane, Real, Vec2, solve_ldl};

impl<T: Real> Dynamics<'_, T> {
    /// Adds the friction of ideal joints to the motion that was solved without it.
    #[inline(always)]
    pub(in crate::dynamics) fn add_joint_friction(&mut self) {
        let Some(mut frictions) = self.joint_frictions.take() else { return };
        self.answer_unit_wrenches(&mut frictions);
        for index in 0..frictions.entries.len() {
            self.find_carried(&mut frictions, index);
        }
        frictions.solve();
        let (n, columns) = (self.mechanism.real.free, self.mechanism.real.coordinates());
        let rows = self.equations.multipliers.len();
        for (index, entry) in frictions.entries.iter().enumerate() {
            let force = entry.coefficient * entry.normal_n;
            let add = |to: &mut [T], from: &[T]| {
                for (to, from) in to.iter_mut().zip(from) {
                    *to = from.mul_add(force, *to);
                }
            };
            add(&mut self.equations.accelerations, &frictions.answers[index * n..(index + 1) * n]);
            add(&mut self.equations.multipliers, &frictions.multipliers[index * rows..(index + 1) * rows]);
            add(&mut self.equations.forces, &frictions.pushes[index * columns..(index + 1) * columns]);
        }
        self.joint_frictions = Some(frictions);
    }

    /// Effect of each unit wrench on accelerations and multipliers: q̈ = M⁻¹(g + Jᵀ λ) with J q̈ = 0.
    #[inline(never)]
    fn answer_unit_wrenches(&mut self, frictions: &mut JointFrictions<T>) {
        let tree = &self.mechanism.real;
        let (n, columns, rows) = (tree.free, tree.coordinates(), tree.constraint_rows());
        let JointFrictions { entries, pushes, answers, multipliers, .. } = frictions;
        pushes.fill(T::zero());
        for (index, entry) in entries.iter().enumerate() {
            let push = &mut pushes[index * columns..(index + 1) * columns];
            for (slot, sign) in entry.slots.into_iter().zip([-T::one(), T::one()]) {
                if slot == 0 {
                    continue;
                }
                let force = entry.wrench.0 * sign;
                let arm = entry.place_m - self.kinematics.poses[slot].position_m;
                let about_origin = entry.wrench.1 * sign + arm.cross(force);
                self.kinematics.add_push(tree, slot, force, about_origin, push);
            }
            let answer = &mut answers[index * n..(index + 1) * n];
            answer.copy_from_slice(&push[..n]);
            solve_ldl(&self.equations.mass, n, answer);
            if rows == 0 {
                continue;
            }
            let multipliers = &mut multipliers[index * rows..(index + 1) * rows];
            for (row, multiplier) in multipliers.iter_mut().enumerate() {
                let mobility = &self.equations.gram.mobilities()[row * n..(row + 1) * n];
                let along = mobility.iter().zip(&push[..n]).fold(T::zero(), |sum, (a, b)| a.mul_add(*b, sum));
                *multiplier = -along;
            }
            self.equations.gram.solve(multipliers);
            self.equations.gram.add_correction(multipliers, answer);
        }
    }

    /// ρ0 of the joint `index`, and what each unit wrench adds to it.
    #[inline(never)]
    fn find_carried(&mut self, frictions: &mut JointFrictions<T>, index: usize) {
        let rows = self.equations.multipliers.len();
        let count = frictions.entries.len();
        if let Carrier::Cut { row } = frictions.entries[index].carrier {
            let entry = &frictions.entries[index];
            let size_m = self.sample.frictions[index].size_m;
            let turn_cosine = if entry.is_slider {
                constraints::turn_cosine(&self.mechanism.real, &self.sample.real, &self.kinematics, row)
            } else {
                T::one()
            };
            let is_slider = entry.is_slider;
            let parts = |multipliers: &[T]| {
                let [first, second] = [multipliers[row], multipliers[row + 1]];
                if !is_slider {
                    return [first, second];
                }
                let (half, couple) = (first * T::from_f64(0.5), second * turn_cosine / size_m);
                [half - couple, half + couple]
            };
            let free = parts(&self.equations.multipliers);
            for other in 0..count {
                let added = parts(&frictions.multipliers[other * rows..(other + 1) * rows]);
                frictions.influence[index * count + other] = added;
            }
            frictions.entries[index].free = free;
            return;
        }
        for part in 0..PARTS {
            let carried = self.balance(frictions, index, part);
            frictions.entries[index].free[part] = carried;
        }
    }

    /// The balance of forces on the bodies beyond a joint of the tree along one forbidden motion: inertia minus what is applied
    /// minus what the loops add. The influence of each unit wrench is written on the way.
    #[inline(always)]
    fn balance(&mut self, frictions: &mut JointFrictions<T>, index: usize, part: usize) -> T {
        let tree = &self.mechanism.real;
        let (n, rows) = (tree.free, self.equations.multipliers.len());
        let JointFrictions { entries, answers, multipliers, influence, gradient, .. } = frictions;
        let (entry, count) = (&entries[index], entries.len());
        let influence = &mut influence[index * count..(index + 1) * count];
        let mut sum = -entry.applied[part];
        for other in influence.iter_mut() {
            other[part] = T::zero();
        }
        let spin = entry.forbidden[part].angular;
        for (link_index, numbers) in self.sample.real.links.iter().enumerate() {
            let slot = link_index + 1;
            if !entry.moves(slot) {
                continue;
            }
            let pose = &self.kinematics.poses[slot];
            let arm = pose.turn(numbers.centre_of_mass_m);
            let velocity = entry.velocity(part, pose.position_m + arm);
            let bias = self.kinematics.biases[slot];
            let acceleration =
                acceleration_at(&bias, &self.kinematics.twists[slot], arm) - self.sample.real.gravity_m_s2;
            sum += numbers.mass_kg * acceleration.dot(velocity) + numbers.inertia_kg_m2 * bias.angular * spin;
            for column in self.kinematics.columns(tree, slot) {
                let coordinate = column.coordinate;
                if coordinate >= n {
                    continue;
                }
                let linear = numbers.mass_kg * column.at(arm).dot(velocity);
                let coupling = Plane::push(numbers.inertia_kg_m2 * spin, column.turning, linear);
                sum = coupling.mul_add(self.equations.accelerations[coordinate], sum);
                for (other, answer) in influence.iter_mut().zip(answers.chunks_exact(n)) {
                    other[part] = coupling.mul_add(answer[coordinate], other[part]);
                }
            }
        }
        if rows > 0 {
            constraints::gradient(
                tree,
                &self.sample.real,
                &self.kinematics,
                |slot| entry.moves(slot),
                |slot| (entry.velocity(part, self.kinematics.poses[slot].position_m), spin),
                gradient,
            );
            for (row, slope) in gradient.iter().enumerate() {
                sum -= *slope * self.equations.multipliers[row];
                for (other, added) in influence.iter_mut().zip(multipliers.chunks_exact(rows)) {
                    other[part] -= *slope * added[row];
                }
            }
        }
        for (other_index, other) in entries.iter().enumerate() {
            let sides = other.slots.map(|slot| entry.moves(slot));
            // Between two bodies that move together action and reaction cancel; its own friction has no part in what is forbidden.
            if other_index == index || sides[0] == sides[1] {
                continue;
            }
            let power = entry.power(part, other.place_m, other.wrench.0, other.wrench.1);
            influence[other_index][part] -= if sides[1] { power } else { -power };
        }
        sum
    }

    /// Friction forces of the ideal joints at the last evaluation: what each carries, N, and its friction force, N, at the surface
    /// of the pin or along the guide.
    pub fn joint_frictions(&self) -> impl Iterator<Item = (JointId, T, T)> + '_ {
        let entries = self.joint_frictions.iter().flat_map(|frictions| &frictions.entries);
        entries.map(|entry| (entry.joint, entry.normal_n, entry.coefficient * entry.normal_n))
    }

    /// Friction force on the second body of `joint` along its guide, N, in the ground's frame; zero for other joints.
    pub(in crate::dynamics) fn guide_friction_n(&self, joint: JointId) -> Vec2<T> {
        let entries = self.joint_frictions.iter().flat_map(|frictions| &frictions.entries);
        let mut own = entries.filter(|entry| entry.joint == joint);
        own.next().map_or(Vec2::zero(), |entry| entry.wrench.0 * (entry.coefficient * entry.normal_n))
    }

    /// Residual of what each joint with friction carries over its size at the last evaluation; one where it jams.
    #[inline(always)]
    pub fn joint_friction_residuals(&self, mut show: impl FnMut(usize, T)) {
        if let Some(frictions) = &self.joint_frictions {
            for (index, entry) in frictions.entries.iter().enumerate() {
                show(index, entry.residual);
            }
        }
    }

    /// Rate of the bristles of the joint with friction `index` at the last evaluation, m/s.
    #[inline(always)]
    pub fn joint_bristle_rate_m_s(&self, index: usize) -> T {
        self.joint_frictions.as_ref().map_or(T::zero(), |frictions| frictions.entries[index].bristle_rate_m_s)
    }

    /// Deflection of the bristles of the joint with friction `index`, m, where its law has them.
    pub fn joint_bristle_m(&self, index: usize) -> Option<T> {
        self.joint_frictions.as_ref().and_then(|frictions| frictions.bristles_m[index])
    }

    /// Sets the deflection of the bristles of the joint with friction `index`, m.
    #[inline(always)]
    pub fn set_joint_bristle(&mut self, index: usize, deflection_m: T) {
        if let Some(frictions) = &mut self.joint_frictions {
            frictions.bristles_m[index] = Some(deflection_m);
        }
    }

    /// Power that the friction of the joint with friction `index` turns into heat, W: -F v.
    #[inline(always)]
    pub fn own_joint_friction_loss_w(&self, index: usize) -> T {
        self.joint_frictions.as_ref().map_or(T::zero(), |frictions| {
            let entry = &frictions.entries[index];
            -(entry.coefficient * entry.normal_n * entry.sliding_m_s)
        })
    }

    /// Power that friction in ideal joints turns into heat, W: -F v.
    #[inline(always)]
    pub(in crate::dynamics) fn joint_friction_loss_w(&self) -> T {
        let mut loss_w = T::zero();
        if let Some(frictions) = &self.joint_frictions {
            for entry in &frictions.entries {
                loss_w -= entry.coefficient * entry.normal_n * entry.sliding_m_s;
            }
        }
        loss_w
    }
}
