//! Two bodies are one.

use super::{Column, Kind, Moving, Pose, Speeds, Twist};
use crate::geometry::Geometry;
use crate::numbers::LinkNumbers;
use loosepin_math::Real;

/// A rigid joint.
#[derive(Debug, Clone, Copy)]
pub struct Rigid;

impl<T: Real, G: Geometry<T>> Kind<T, G> for Rigid {
    #[inline(always)]
    fn turns_alone(&self) -> bool {
        false
    }
    #[inline(always)]
    fn pose(&self, numbers: &LinkNumbers<T, G>, parent: &Pose<T, G>, _: &[T]) -> Pose<T, G> {
        let rotation = G::held(&parent.rotation, &numbers.mount);
        let at_joint = parent.position + G::turn(&parent.rotation, numbers.parent_arm);
        Pose { position: at_joint - G::turn(&rotation, numbers.own_arm), rotation }
    }
    #[inline(always)]
    fn columns(&self, _: &LinkNumbers<T, G>, _: &Pose<T, G>, _: &Pose<T, G>, _: &mut [Column<T, G>]) {}
    #[inline(always)]
    fn bias(
        &self,
        _: &LinkNumbers<T, G>,
        parent: &Moving<T, G>,
        own: &Moving<T, G>,
        _: &[Column<T, G>],
        _: Speeds<'_, T>,
    ) -> Twist<T, G> {
        let linear = parent.acceleration_at(own.pose.position - parent.pose.position);
        Twist { linear, spin: parent.bias.spin }
    }
}
