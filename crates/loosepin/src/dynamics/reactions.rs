//! Forces in the joints, ideal ones included.

use super::equations::Dynamics;
use crate::math::{Real, Vec2};
use crate::mechanism::{Attachment, CutKind, acceleration_at};
use crate::model::JointId;

impl<T: Real> Dynamics<'_, T> {
    /// Force of `joint` on its second body (journal, slider, second), N, in the ground's frame, at the last evaluation.
    ///
    /// With play: the contact force. Closing a loop: the constraint force. In the tree: what the bodies beyond the joint
    /// need, Σ (m a - m g) minus the other forces on them (Newton and Euler).
    pub fn joint_force_n(&self, joint: JointId) -> Vec2<T> {
        if let Some(index) = self.mechanism.plays.iter().position(|&play| play == joint) {
            return self.plays[index].1.on_journal_n;
        }
        let tree = &self.mechanism.real;
        let forces = self.cut_forces_n();
        if let Some(index) = tree.cuts.iter().position(|cut| cut.joint == joint) {
            return forces[index];
        }
        let Some((root, forward)) = tree.links.iter().enumerate().find_map(|(index, link)| match link.attachment {
            Attachment::Revolute { joint: own, forward, .. }
            | Attachment::DrivenRevolute { joint: own, forward, .. }
            | Attachment::Prismatic { joint: own, forward, .. }
            | Attachment::Rigid { joint: own, forward }
                if own == joint =>
            {
                Some((index + 1, forward))
            }
            _ => None,
        }) else {
            return Vec2::zero();
        };
        // Parents come before children, so one pass marks all bodies beyond the joint.
        let mut beyond = vec![false; tree.links.len() + 1];
        beyond[root] = true;
        let mut needed = Vec2::zero();
        for (index, (link, numbers)) in tree.links.iter().zip(&self.sample.real.links).enumerate() {
            let slot = index + 1;
            beyond[slot] |= beyond[link.parent_slot];
            if beyond[slot] {
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
        for ((_, force), slots) in self.plays.iter().zip(self.play_slots()) {
            subtract(*slots, force.on_journal_n);
        }
        for (index, slots) in self.spring_slots().iter().enumerate() {
            subtract(*slots, self.spring_force(index).on_second_n);
        }
        for load in self.loads() {
            if beyond[load.slot] {
                needed -= load.force_n;
            }
        }
        if forward { needed } else { -needed }
    }

    /// Forces of the cut joints on their second bodies, N: λ times the gradient with respect to the second point.
    fn cut_forces_n(&self) -> Vec<Vec2<T>> {
        let tree = &self.mechanism.real;
        let multiplier_of = |row: usize| {
            self.mechanism
                .real_rows()
                .iter()
                .position(|&independent| independent == row)
                .map_or(T::zero(), |r| self.multipliers[r])
        };
        let mut row = 0;
        tree.cuts
            .iter()
            .zip(&self.sample.real.cuts)
            .map(|(cut, numbers)| {
                let first = multiplier_of(row);
                let force = match cut.kind {
                    CutKind::Revolute | CutKind::Rigid => Vec2::new(first, multiplier_of(row + 1)),
                    CutKind::Prismatic => {
                        let angle = self.kinematics.poses[cut.slots[0]].angle_rad + numbers.angles_rad[0];
                        let (sine, cosine) = angle.sin_cos();
                        Vec2::new(-sine, cosine) * first
                    }
                };
                row += cut.kind.rows();
                force
            })
            .collect()
    }
}
