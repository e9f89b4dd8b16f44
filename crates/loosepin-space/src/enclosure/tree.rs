//! A tree of bodies: each moves against the one that its branch comes from.

use crate::mechanism::spatial_mechanism::SpatialMechanism;

/// For each body but the ground the joint that its branch comes through; the others close loops.
pub(crate) struct BodyTree {
    /// Body and joint; of the ground itself and no joint.
    from: Vec<Option<(usize, usize)>>,
}

impl BodyTree {
    /// The nearest bodies to the ground first; `None` if a body hangs on no other.
    pub(crate) fn new(mechanism: &SpatialMechanism) -> Option<Self> {
        let mut from = vec![None; mechanism.bodies().len()];
        let mut reached = vec![0];
        let mut next = 0;
        while let Some(&body) = reached.get(next) {
            for (number, joint) in mechanism.joints().iter().enumerate() {
                let pair = [joint.bearing.body, joint.journal.body];
                for [near, far] in [pair, [pair[1], pair[0]]] {
                    if near == body && far != 0 && from[far].is_none() {
                        from[far] = Some((body, number));
                        reached.push(far);
                    }
                }
            }
            next += 1;
        }
        (reached.len() == from.len()).then_some(Self { from })
    }

    /// The joint that the branch of a body comes through.
    pub(crate) fn joint(&self, body: usize) -> Option<usize> {
        self.from[body].map(|(_, joint)| joint)
    }

    /// From the ground to the body, without the ground.
    pub(crate) fn branch(&self, body: usize) -> Vec<usize> {
        let mut branch = Vec::new();
        let mut at = body;
        while let Some((before, _)) = self.from[at] {
            branch.push(at);
            at = before;
        }
        branch.reverse();
        branch
    }

    /// The branches of two bodies from where they part.
    pub(crate) fn apart(&self, bodies: [usize; 2]) -> [Vec<usize>; 2] {
        let [mut first, mut second] = bodies.map(|body| self.branch(body));
        let shared = first.iter().zip(&second).take_while(|(a, b)| a == b).count();
        first.drain(..shared);
        second.drain(..shared);
        [first, second]
    }
}
