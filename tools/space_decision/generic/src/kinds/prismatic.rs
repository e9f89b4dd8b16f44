//! A slider moves along a line.

use super::{Column, Kind, Moving, Pose, Speeds, Twist};
use crate::geometry::Geometry;
use crate::numbers::LinkNumbers;
use loosepin_math::Real;

/// A prismatic joint.
#[derive(Debug, Clone, Copy)]
pub struct Prismatic {
    pub forward: bool,
}

impl<T: Real, G: Geometry<T>> Kind<T, G> for Prismatic {
    #[inline(always)]
    fn turns_alone(&self) -> bool {
        false
    }
    #[inline(always)]
    fn pose(&self, numbers: &LinkNumbers<T, G>, parent: &Pose<T, G>, own: &[T]) -> Pose<T, G> {
        let line = G::line(&parent.rotation, &numbers.mount);
        let line = if self.forward { line } else { -line };
        let rotation = G::held(&parent.rotation, &numbers.mount);
        let at_joint = parent.position + G::turn(&parent.rotation, numbers.parent_arm);
        Pose { position: at_joint + line * own[0] - G::turn(&rotation, numbers.own_arm), rotation }
    }
    #[inline(always)]
    fn columns(&self, numbers: &LinkNumbers<T, G>, parent: &Pose<T, G>, _: &Pose<T, G>, columns: &mut [Column<T, G>]) {
        let line = G::line(&parent.rotation, &numbers.mount);
        columns[0] = Column::sliding(if self.forward { line } else { -line });
    }
    #[inline(always)]
    fn bias(
        &self,
        _: &LinkNumbers<T, G>,
        parent: &Moving<T, G>,
        own: &Moving<T, G>,
        columns: &[Column<T, G>],
        speeds: Speeds<'_, T>,
    ) -> Twist<T, G> {
        let line = columns[0].linear;
        let carried = parent.acceleration_at(own.pose.position - parent.pose.position);
        let linear = carried + G::coriolis(parent.twist.spin, line, speeds.own[0]);
        Twist { linear: speeds.driven.map_or(linear, |driven| linear + line * driven), spin: parent.bias.spin }
    }
}
