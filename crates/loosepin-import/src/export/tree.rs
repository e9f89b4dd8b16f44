//! Which joints make a tree on the ground, and which close its loops.

use super::problem::ExportProblem;
use loosepin_space::{Joint, Marker, SpatialMechanism};

/// A joint of the tree: the body that it moves, seen from the one that is nearer to the ground.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct TreeJoint {
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

/// A tree on the ground.
#[derive(Debug)]
pub(super) struct Tree {
    /// Its joints, each after that of its parent.
    pub joints: Vec<TreeJoint>,
    /// Numbers of the joints that close loops.
    pub closing: Vec<usize>,
}

impl Tree {
    /// The tree of a mechanism: joints that leave the fewest freedoms come first, so that balls rather close the loops.
    pub fn new(mechanism: &SpatialMechanism) -> Result<Tree, ExportProblem> {
        let mut is_placed = vec![false; mechanism.bodies().len()];
        if let Some(ground) = is_placed.first_mut() {
            *ground = true;
        }
        let mut joints = Vec::new();
        loop {
            let ends = |joint: &Joint| [is_placed[joint.bearing.body], is_placed[joint.journal.body]];
            let open = mechanism.joints().iter().enumerate().filter(|(_, joint)| ends(joint)[0] != ends(joint)[1]);
            let Some((number, joint)) = open.min_by_key(|(number, joint)| (joint.kind.freedoms(), *number)) else {
                break;
            };
            let is_reversed = is_placed[joint.journal.body];
            let (parent, child) = match is_reversed {
                true => (joint.journal.body, joint.bearing.body),
                false => (joint.bearing.body, joint.journal.body),
            };
            is_placed[child] = true;
            joints.push(TreeJoint { joint: number, parent, child, is_reversed });
        }
        if let Some(body) = is_placed.iter().position(|is_placed| !is_placed) {
            return Err(ExportProblem::NotConnected { body: mechanism.bodies()[body].name.clone() });
        }
        let is_closing = |number: &usize| joints.iter().all(|own: &TreeJoint| own.joint != *number);
        let closing = (0..mechanism.joints().len()).filter(is_closing).collect();
        Ok(Tree { joints, closing })
    }
}
