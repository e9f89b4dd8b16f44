//! Poses, velocities and accelerations of all bodies from the coordinates of the tree, in every geometry.

use crate::mechanism::attachment::{Columns, FormOfAttachment, Hung, KindOfAttachment, MovingGeometry, Place, Rates};
use crate::mechanism::tree::kinematics::{Kinematics, Pose, Twist};
use crate::mechanism::tree::numbers::TreeNumbers;
use crate::mechanism::tree::spanning_tree::{Link, Tree};
use loosepin_math::{KnownAngle, Real, Vector, sin_cos_near};

impl<T: Real, G: MovingGeometry> Kinematics<T, G> {
    /// Room for `tree`.
    pub fn new(tree: &Tree<G>) -> Self {
        let slots = tree.links.len() + 1;
        let mut offsets = vec![0; slots + 1];
        let mut next = 0;
        for (index, link) in tree.links.iter().enumerate() {
            offsets[index + 1] = next;
            next += link.dependences.len();
        }
        offsets[slots] = next;
        let mut turnings = vec![G::still(); next];
        for (link, offset) in tree.links.iter().zip(&offsets[1..]) {
            let first = link.attachment.first_turnings(tree);
            turnings[offset + link.inherited..offset + link.dependences.len()].copy_from_slice(&first);
        }
        Self {
            poses: vec![Pose::ground(); slots],
            twists: vec![Twist::zero(); slots],
            biases: vec![Twist::zero(); slots],
            partials: vec![G::Vector::zero(); next],
            turnings,
            offsets,
            known: vec![KnownAngle::zero(); slots],
            is_near: false,
        }
    }

    /// Poses and partial velocities at `coordinates` (m and rad, free ones first).
    #[inline(never)]
    pub fn set_positions(&mut self, tree: &Tree<G>, numbers: &TreeNumbers<T, G>, coordinates: &[T]) {
        for (index, link) in tree.links.iter().enumerate() {
            let slot = index + 1;
            let place = Place { tree, numbers, slot };
            let parent = self.poses[link.parent_slot];
            let (is_near, known) = (self.is_near, &self.known[slot]);
            let sin_cos = |angle_rad: T| if is_near { sin_cos_near(angle_rad, known) } else { angle_rad.sin_cos() };
            let own = (&coordinates[link.coordinates.clone()], coordinates);
            let range = self.offsets[slot] + link.inherited..self.offsets[slot + 1];
            let columns = Columns { linear: &mut self.partials[range.clone()], turnings: &mut self.turnings[range] };
            let Hung { pose, reach_m } = link.attachment.hang(&place, &parent, own, sin_cos, columns);
            self.poses[slot] = pose;
            self.carry_columns(tree, link, slot, reach_m);
        }
    }

    /// The columns of the parent, carried to the body: with the point of the joint where it turns alone, else as part of the parent.
    #[inline(always)]
    fn carry_columns(&mut self, tree: &Tree<G>, link: &Link<G>, slot: usize, reach_m: G::Vector<T>) {
        let turns_alone = link.attachment.turns_alone();
        let (from, to) = (self.offsets[link.parent_slot], self.offsets[slot]);
        debug_assert!(
            tree.dependences(link.parent_slot).len() >= link.inherited,
            "a body inherits from its parent alone"
        );
        for k in 0..link.inherited {
            let turning = self.turnings[from + k];
            self.partials[to + k] = G::moved(self.partials[from + k], turning, reach_m);
            self.turnings[to + k] = if turns_alone { G::still() } else { turning };
        }
    }

    /// Accelerations that the rates cause when the free coordinates have none and the driven ones have
    /// `driven_accelerations` (in the order of the tree's drives). Needs [`Self::set_velocities`].
    #[inline(never)]
    pub fn set_biases(&mut self, tree: &Tree<G>, numbers: &TreeNumbers<T, G>, rates: &[T], driven_accelerations: &[T]) {
        for (index, link) in tree.links.iter().enumerate() {
            let place = Place { tree, numbers, slot: index + 1 };
            self.biases[index + 1] = link.attachment.bias(&place, self, Rates { rates, driven_accelerations });
        }
    }
}
