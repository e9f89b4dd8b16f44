//! The joints between the ground and a body.

use crate::chain::error::ChainError;
use crate::mechanism::spatial_mechanism::SpatialMechanism;

/// A joint on the way from the ground, and whether its bearing is on the far side.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct PathJoint {
    pub joint: usize,
    pub is_reversed: bool,
}

/// The joints from the ground to `body`, if there is one way only.
pub(crate) fn path_to(mechanism: &SpatialMechanism, body: usize) -> Result<Vec<PathJoint>, ChainError> {
    if body == 0 || body >= mechanism.bodies().len() {
        return Err(ChainError::NoBody { body });
    }
    let not_a_chain = || ChainError::NotAChain { body: mechanism.bodies()[body].name.clone() };
    let reached = reached_by(mechanism, None);
    let (mut path, mut at) = (Vec::new(), body);
    while let Some((joint, near)) = reached[at] {
        path.push(joint);
        at = near;
    }
    path.reverse();
    // Where the body is reached without a joint of the way as well, there is a loop.
    let is_in_loop = path.iter().any(|joint| reached_by(mechanism, Some(joint.joint))[body].is_some());
    if path.is_empty() || is_in_loop { Err(not_a_chain()) } else { Ok(path) }
}

/// By which joint each body is reached first from the ground, and from which body; without the joint `left_out`.
fn reached_by(mechanism: &SpatialMechanism, left_out: Option<usize>) -> Vec<Option<(PathJoint, usize)>> {
    let mut reached = vec![None; mechanism.bodies().len()];
    let mut open = vec![0];
    while let Some(near) = open.pop() {
        for (joint, own) in mechanism.joints().iter().enumerate() {
            let ends = [own.bearing.body, own.journal.body];
            let is_reversed = ends[1] == near;
            let far = if is_reversed { ends[0] } else { ends[1] };
            if Some(joint) == left_out || !ends.contains(&near) || far == 0 || reached[far].is_some() {
                continue;
            }
            reached[far] = Some((PathJoint { joint, is_reversed }, near));
            open.push(far);
        }
    }
    reached
}
