//! Poses, velocities and accelerations of all bodies from the coordinates of the tree, in every geometry.

use crate::mechanism::attachment::{Columns, Hung, KindOfAttachment, MovingGeometry, Place, Rates};
use crate::mechanism::tree::kinematics::{Kinematics, Pose, Twist};
use crate::mechanism::tree::numbers::TreeNumbers;
use crate::mechanism::tree::spanning_tree::Tree;
use loosepin_math::{KnownAngle, Real, Vector};

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
        for place in Place::all(tree, numbers) {
            let Place { link, slot, .. } = place;
            let near = self.is_near.then_some(&self.known[slot]);
            let (first, last) = (self.offsets[slot] + link.inherited, self.offsets[slot + 1]);
            let columns =
                Columns { linear: &mut self.partials[first..last], turnings: &mut self.turnings[first..last] };
            let parent = &self.poses[link.parent_slot];
            let Hung { pose, reach_m, turns_alone } = link.attachment.hang(&place, parent, coordinates, near, columns);
            self.poses[slot] = pose;
            self.carry_columns(place, (reach_m, turns_alone));
        }
    }

    /// The columns of the parent, carried to the body: with the point of the joint where it turns alone, else as part of the parent.
    #[inline(always)]
    fn carry_columns(&mut self, place: Place<'_, T, G>, (reach_m, turns_alone): (G::Vector<T>, bool)) {
        let Place { tree, link, slot, .. } = place;
        let (from, to) = (self.offsets[link.parent_slot], self.offsets[slot]);
        debug_assert!(
            tree.dependences(link.parent_slot).len() >= link.inherited,
            "a body inherits from its parent alone"
        );
        let (partials, own_partials) = self.partials.split_at_mut(to);
        let (turnings, own_turnings) = self.turnings.split_at_mut(to);
        let last = from + link.inherited;
        let of_parent = partials[from..last].iter().zip(&turnings[from..last]);
        let own = own_partials[..link.inherited].iter_mut().zip(&mut own_turnings[..link.inherited]);
        for ((own_partial, own_turning), (partial, turning)) in own.zip(of_parent) {
            *own_partial = G::moved(*partial, *turning, reach_m);
            *own_turning = if turns_alone { G::still() } else { *turning };
        }
    }

    /// Accelerations that the rates cause when the free coordinates have none and the driven ones have
    /// `driven_accelerations` (in the order of the tree's drives). Needs [`Self::set_velocities`].
    #[inline(never)]
    pub fn set_biases(&mut self, tree: &Tree<G>, numbers: &TreeNumbers<T, G>, rates: &[T], driven_accelerations: &[T]) {
        for place in Place::all(tree, numbers) {
            self.biases[place.slot] = place.link.attachment.bias(&place, self, Rates { rates, driven_accelerations });
        }
    }
}
