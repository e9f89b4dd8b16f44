//! Forces in the joints, ideal ones included.

use super::equations::Dynamics;
use crate::dynamics::play::contact_motion::ContactMotion;
use crate::dynamics::play::flanks;
use crate::mechanism::{CouplingGeometry, CouplingPlace, Cut, acceleration_at, cut_forces_n};
use crate::model::{JointId, PlayId};
use loosepin_math::{Real, Vec2, solve_ldl};

impl<T: Real> Dynamics<'_, T> {
    /// The mechanism's inverse mass along the normal of the contact `contact` at the last evaluation, 1/kg: by how much a
    /// normal force of one newton changes the rate of the penetration's rate, n·(a_j - a_i), all else being equal.
    ///
    /// gᵀ M⁻¹ g with the generalised force g of the pair of unit forces; what the loops of ideal joints forbid is taken out:
    /// minus (J M⁻¹ g)ᵀ (J M⁻¹ Jᵀ)⁻¹ (J M⁻¹ g).
    pub fn inverse_mass_along_normal_1_kg(&self, contact: usize) -> T {
        let tree = &self.mechanism.real;
        let n = tree.free;
        let at = self.sample.contacts[contact];
        let motion = &self.plays[at.play];
        let ContactMotion { normal, reaches_m, .. } = motion.contact(&self.sample.plays[at.play], at.place);
        let [bearing, journal] = self.play_slots[at.play];
        let mut push = vec![T::zero(); tree.coordinates()];
        if let Some(flanks) = self.sample.plays[at.play].shape.flanks() {
            let shares = flanks::shares(&self.kinematics, flanks);
            for side in [0, 1] {
                let factor = shares[side] * normal.x;
                flanks.coupling.joints[side].add_gradient(
                    &flanks.places[side],
                    tree,
                    &self.kinematics,
                    factor,
                    &mut push,
                );
            }
        }
        let bearing = (bearing, motion.bearing_arm_m + reaches_m[0], -normal);
        let journal = (journal, motion.journal_arm_m + reaches_m[1], normal);
        for (slot, arm, force_n) in [bearing, journal] {
            if slot > 0 {
                self.kinematics.add_push(tree, slot, force_n, arm.cross(force_n), &mut push);
            }
        }
        let along = |left: &[T], right: &[T]| {
            left.iter().zip(right).fold(T::zero(), |sum, (left, right)| left.mul_add(*right, sum))
        };
        let mut answer = push[..n].to_vec();
        solve_ldl(&self.equations.mass, n, &mut answer);
        let mut inverse_mass_1_kg = along(&push[..n], &answer);
        // The rows of the mobilities are M⁻¹ Jᵀ, so that J M⁻¹ g needs no Jacobian.
        let mobility = |row: usize| &self.equations.gram.mobilities()[row * n..(row + 1) * n];
        let defects: Vec<T> = (0..tree.constraint_rows()).map(|row| along(mobility(row), &push[..n])).collect();
        let mut multipliers = defects.clone();
        self.equations.gram.clone().solve(&mut multipliers);
        inverse_mass_1_kg -= along(&defects, &multipliers);
        inverse_mass_1_kg
    }

    /// Force of `joint` on its second body (journal, slider, second), N, in the ground's frame, at the last evaluation.
    ///
    /// With play: the sum of the contact forces. Closing a loop: the constraint force. In the tree: what the bodies beyond the joint
    /// need, Σ (m a - m g) minus the other forces on them (Newton and Euler).
    ///
    /// Teeth whose force the joints of their wheels feel add it there.
    pub fn joint_force_n(&self, joint: JointId) -> Vec2<T> {
        let force_n = self.force_without_teeth_n(joint);
        self.tooth_force_n(joint).map_or(force_n, |added_n| force_n + added_n)
    }

    /// That force where couplings act with torques alone, and along guides.
    fn force_without_teeth_n(&self, joint: JointId) -> Vec2<T> {
        if let Some(index) = self.mechanism.plays.iter().position(|&play| play == PlayId::Joint(joint)) {
            return self.play_force_n(index) + self.actuator_force_n(joint);
        }
        let tree = &self.mechanism.real;
        let forces = self.cut_forces_n();
        if let Some(index) = tree.cuts.iter().position(|cut| cut.joint == joint) {
            return forces[index] + self.actuator_force_n(joint);
        }
        let root = tree.links.iter().enumerate().find_map(|(index, link)| {
            let (own, forward) = link.joint()?;
            (own == joint).then_some((index + 1, forward))
        });
        let Some((root, forward)) = root else { return Vec2::zero() };
        // Parents come before children, so one pass marks all bodies beyond the joint.
        let mut beyond = vec![false; tree.links.len() + 1];
        beyond[root] = true;
        let mut needed = Vec2::zero();
        for (index, (link, numbers)) in tree.links.iter().zip(&self.sample.real.links).enumerate() {
            let slot = index + 1;
            beyond[slot] |= beyond[link.parent_slot];
            if let (true, Some(beam)) = (beyond[slot], link.beam) {
                needed += self.beam_force_n(beam);
            } else if let (true, Some(beam)) = (beyond[slot], link.nodal_beam) {
                needed += self.nodal_force_n(beam);
            } else if beyond[slot] && link.has_own_mass {
                let arm = self.kinematics.poses[slot].turn(numbers.centre_of_mass_m);
                let change = self.acceleration(slot);
                let acceleration = acceleration_at(&change, &self.kinematics.twists[slot], arm);
                needed += (acceleration - self.sample.real.gravity_m_s2) * numbers.mass_kg;
            }
        }
        let mut subtract = |slots: [usize; 2], on_second: Vec2<T>| {
            if beyond[slots[1]] {
                needed -= on_second;
            }
            if beyond[slots[0]] {
                needed += on_second;
            }
        };
        for (cut, force) in tree.cuts.iter().zip(&forces) {
            subtract(cut.slots, *force);
        }
        for (play, slots) in self.play_slots().iter().enumerate() {
            subtract(*slots, self.play_force_n(play));
        }
        for (index, slots) in self.spring_slots().iter().enumerate() {
            subtract(*slots, self.spring_force(index).on_second_n);
        }
        for (slots, on_second) in self.coupling_forces_n() {
            subtract(slots, on_second);
        }
        for load in self.loads() {
            subtract([0, load.slot], load.force_n);
        }
        for ((force, places), control) in
            self.actuators.iter().zip(&self.control_places).zip(&self.mechanism.model.controls)
        {
            // The actuator of this very joint is part of what the joint does.
            if control.joint != joint {
                subtract(places[0].slots, force.on_second_n);
            }
        }
        if forward { needed } else { -needed }
    }

    /// Force of the joint with play `play` on its journal, N: the sum over its contacts. Of a coupling the force along x.
    fn play_force_n(&self, play: usize) -> Vec2<T> {
        let forces = self.contacts.iter().zip(&self.sample.contacts).filter(|(_, at)| at.play == play);
        forces.map(|(force, _)| force.on_journal_n).reduce(|sum, force| sum + force).unwrap_or(Vec2::zero())
    }

    /// Forces of couplings on prismatic joints: slots of guide and slider, and force on the slider, N. Revolute joints get torques
    /// alone: λ ∂Φ/∂q along the coordinate of each joint.
    fn coupling_forces_n(&self) -> Vec<([usize; 2], Vec2<T>)> {
        let tree = &self.mechanism.real;
        let mut forces = Vec::new();
        let multipliers = &self.equations.multipliers[tree.cut_rows()..];
        for ((places, numbers), multiplier) in tree.couplings.iter().zip(&self.sample.real.couplings).zip(multipliers) {
            let slope = numbers.slope(places, &self.kinematics);
            for (side, gradient) in [(0, -slope), (1, T::one())] {
                if places[side].is_prismatic {
                    let (_, line) = numbers.joints[side].line_of_action(&places[side], &self.kinematics);
                    forces.push((places[side].slots, line * (gradient * *multiplier)));
                }
            }
        }
        for (play, numbers) in self.sample.plays.iter().enumerate() {
            let Some(flanks) = numbers.shape.flanks() else { continue };
            let force_n = self.play_force_n(play).x;
            let shares = flanks::shares(&self.kinematics, flanks);
            for (side, share) in shares.into_iter().enumerate() {
                if flanks.places[side].is_prismatic {
                    let joint = &flanks.coupling.joints[side];
                    let (_, line) = joint.line_of_action(&flanks.places[side], &self.kinematics);
                    forces.push((flanks.places[side].slots, line * (share * force_n)));
                }
            }
        }
        forces
    }

    /// What teeth add to the force of `joint` on its second body, N.
    fn tooth_force_n(&self, joint: JointId) -> Option<Vec2<T>> {
        let (tree, model) = (&self.mechanism.real, &self.mechanism.model);
        let side_of = |index: usize| {
            let coupling = &model.couplings[index];
            [coupling.first, coupling.second].iter().position(|own| *own == joint)
        };
        let mut sum: Option<Vec2<T>> = None;
        let mut add = |index: usize, numbers: &CouplingGeometry<T>, places: &CouplingPlace, effort: T| {
            let Some((teeth, side)) = numbers.teeth.zip(side_of(index)) else { return };
            let force_n = teeth.on_second_body_n(&numbers.joints, places, &self.kinematics, effort, side);
            sum = Some(sum.map_or(force_n, |sum| sum + force_n));
        };
        let multipliers = &self.equations.multipliers[tree.cut_rows()..];
        let ideal = tree.couplings.iter().zip(&self.sample.real.couplings).zip(multipliers);
        for (index, ((places, numbers), multiplier)) in tree.coupling_indices.iter().zip(ideal) {
            add(*index, numbers, places, *multiplier);
        }
        for (play, numbers) in self.sample.plays.iter().enumerate() {
            if let (Some(flanks), PlayId::Coupling(id)) = (numbers.shape.flanks(), &self.mechanism.plays[play]) {
                let [_, share] = flanks::shares(&self.kinematics, flanks);
                add(*id, &flanks.coupling, &flanks.places, share * self.play_force_n(play).x);
            }
        }
        sum
    }

    /// Force of the actuator in `joint` on its second body, N; zero where there is none.
    fn actuator_force_n(&self, joint: JointId) -> Vec2<T> {
        let control = self.mechanism.model.controls.iter().position(|control| control.joint == joint);
        control.map_or(Vec2::zero(), |control| self.actuators[control].on_second_n)
    }

    /// Forces of the cut joints on their second bodies, N: of the constraints, and friction along guides.
    fn cut_forces_n(&self) -> Vec<Vec2<T>> {
        let (tree, model) = (&self.mechanism.real, &self.mechanism.model);
        let forces = cut_forces_n(tree, &self.sample.real, &self.kinematics, &self.equations.multipliers);
        let with_friction = |(cut, force_n): (&Cut, Vec2<T>)| {
            let has_line = model.joints[cut.joint.0].kind.line().is_some();
            if has_line { force_n + self.guide_friction_n(cut.joint) } else { force_n }
        };
        tree.cuts.iter().zip(forces).map(with_friction).collect()
    }
}
