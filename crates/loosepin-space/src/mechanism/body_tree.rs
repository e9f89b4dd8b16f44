//! Which joints make a tree on the ground, and which close its loops.

use crate::mechanism::joint::Joint;
use crate::mechanism::marker::Marker;
use crate::mechanism::spatial_mechanism::SpatialMechanism;

/// A joint of the tree: the body that it moves, seen from the one that is nearer to the ground.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TreeJoint {
    /// Number of the joint.
    pub joint: usize,
    /// The body nearer to the ground.
    pub parent: usize,
    /// The body that it moves.
    pub child: usize,
    /// Whether the child has the bearing: its coordinate is that of the joint the other way round.
    pub is_reversed: bool,
}

impl TreeJoint {
    /// The markers on parent and child.
    pub fn markers<'j>(&self, joint: &'j Joint) -> [&'j Marker; 2] {
        if self.is_reversed { [&joint.journal, &joint.bearing] } else { [&joint.bearing, &joint.journal] }
    }

    /// 1, or -1 where the joint is the other way round.
    pub fn sign(&self) -> f64 {
        if self.is_reversed { -1.0 } else { 1.0 }
    }
}

/// A tree on the ground, of all bodies that joints connect with it.
#[derive(Debug, Clone)]
pub struct BodyTree {
    /// Its joints, each after that of its parent.
    pub joints: Vec<TreeJoint>,
    /// Numbers of the joints that are not in the tree: they close loops, or are between bodies that no joints connect with the ground.
    pub closing: Vec<usize>,
    /// The joint of the tree that moves each body.
    of_body: Vec<Option<usize>>,
}

impl BodyTree {
    /// The tree in which the fewest joints lie between a body and the ground: motions that add up along a branch stay small.
    pub(crate) fn of_short_branches(mechanism: &SpatialMechanism) -> Self {
        Self::new(mechanism, |_, place_of_parent| place_of_parent)
    }

    /// The tree of the joints that leave the fewest freedoms, so that balls rather close the loops.
    pub fn of_stiff_joints(mechanism: &SpatialMechanism) -> Self {
        Self::new(mechanism, |joint, _| joint.kind.freedoms())
    }

    /// Takes, of the joints between a body of the tree and another one, always that of the least rank, and of these the first. `rank` is given
    /// the joint and the place of its parent in the order in which bodies came to the tree.
    fn new(mechanism: &SpatialMechanism, rank: impl Fn(&Joint, usize) -> usize) -> Self {
        let bodies = mechanism.bodies().len();
        let mut tree = Self { joints: Vec::new(), closing: Vec::new(), of_body: vec![None; bodies] };
        loop {
            // The ground is the first, and each joint of the tree brings the next one.
            let place = |body: usize| if body == 0 { Some(0) } else { tree.of_body[body].map(|joint| joint + 1) };
            let open = mechanism.joints().iter().enumerate().filter_map(|(number, joint)| {
                let [bearing, journal] = [joint.bearing.body, joint.journal.body];
                let (parent, child, is_reversed) = match [place(bearing), place(journal)] {
                    [Some(_), None] => (bearing, journal, false),
                    [None, Some(_)] => (journal, bearing, true),
                    _ => return None,
                };
                Some((rank(joint, place(parent)?), TreeJoint { joint: number, parent, child, is_reversed }))
            });
            // The first of the least.
            let Some((_, next)) = open.min_by_key(|(rank, joint)| (*rank, joint.joint)) else { break };
            tree.of_body[next.child] = Some(tree.joints.len());
            tree.joints.push(next);
        }
        let is_closing = |number: &usize| tree.joints.iter().all(|own| own.joint != *number);
        tree.closing = (0..mechanism.joints().len()).filter(is_closing).collect();
        tree
    }

    /// The joint that moves a body, and which its branch comes through; `None` of the ground and of a body that no joints connect with it.
    pub fn joint_of(&self, body: usize) -> Option<&TreeJoint> {
        self.of_body.get(body).copied().flatten().map(|place| &self.joints[place])
    }

    /// The first body that no joints connect with the ground.
    pub fn unconnected(&self) -> Option<usize> {
        (1..self.of_body.len()).find(|body| self.of_body[*body].is_none())
    }

    /// The joints from the ground to a body.
    pub(crate) fn branch(&self, body: usize) -> Vec<TreeJoint> {
        let mut branch = Vec::new();
        let mut at = body;
        while let Some(joint) = self.joint_of(at) {
            branch.push(*joint);
            at = joint.parent;
        }
        branch.reverse();
        branch
    }

    /// The branches of two bodies from where they part.
    pub(crate) fn apart(&self, bodies: [usize; 2]) -> [Vec<TreeJoint>; 2] {
        let [mut first, mut second] = bodies.map(|body| self.branch(body));
        let shared = first.iter().zip(&second).take_while(|(a, b)| a == b).count();
        first.drain(..shared);
        second.drain(..shared);
        [first, second]
    }

    /// Whether a loop passes through a joint of the tree.
    pub(crate) fn is_in_loop(&self, mechanism: &SpatialMechanism, joint: &TreeJoint) -> bool {
        self.closing.iter().any(|number| {
            let closing = &mechanism.joints()[*number];
            self.apart([closing.bearing.body, closing.journal.body]).iter().flatten().any(|own| own == joint)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kind::{Revolute, Spherical};
    use crate::mechanism::body::Body;
    use loosepin_math::{Pose, Vec3};

    /// A loop of three bodies and the ground with one ball, and an arm on one of them.
    fn mechanism() -> SpatialMechanism {
        let marker = |body| Marker::new(body, Vec3::ZERO, Vec3::Z, Vec3::X).expect("axes at a right angle");
        let body = |name: &str| Body::new(name, Pose::GROUND);
        let joint = |name: &str, from, to| Joint::new(name, Revolute, marker(from), marker(to));
        let joints = vec![
            Joint::new("ball", Spherical, marker(1), marker(0)),
            joint("one", 1, 2),
            joint("two", 3, 2),
            joint("three", 0, 3),
            joint("arm", 2, 4),
        ];
        let bodies = vec![Body::ground(), body("one"), body("two"), body("three"), body("arm")];
        SpatialMechanism::new(bodies, joints, Vec::new()).expect("it is sound")
    }

    #[test]
    fn branches_are_short_or_stiff_and_loops_are_known() {
        let mechanism = mechanism();
        let names = |tree: &BodyTree, body| -> Vec<&str> {
            tree.branch(body).iter().map(|own| mechanism.joints()[own.joint].name.as_str()).collect()
        };
        let short = BodyTree::of_short_branches(&mechanism);
        assert_eq!((names(&short, 2), &short.closing[..]), (vec!["ball", "one"], &[2][..]));
        let stiff = BodyTree::of_stiff_joints(&mechanism);
        assert_eq!((names(&stiff, 4), &stiff.closing[..]), (vec!["three", "two", "arm"], &[0][..]));
        let [arm, other] = stiff.apart([4, 1]).map(|branch| branch.iter().map(|own| own.child).collect::<Vec<_>>());
        assert_eq!((arm, other), (vec![4], vec![1]));
        for tree in [&short, &stiff] {
            assert_eq!(tree.unconnected(), None);
            let in_loop: Vec<usize> =
                tree.joints.iter().filter(|own| tree.is_in_loop(&mechanism, own)).map(|own| own.child).collect();
            assert!(in_loop.len() == 3 && !in_loop.contains(&4), "{in_loop:?}");
        }
        // The ball has its bearing on the far side.
        assert!(short.joint_of(1).is_some_and(|own| own.is_reversed && own.sign() == -1.0));
    }
}
