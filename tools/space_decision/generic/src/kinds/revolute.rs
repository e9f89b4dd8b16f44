//! A pin turns in a hole.

use super::{Column, Kind, Moving, Pose, Speeds, Twist, bias_about_point};
use crate::geometry::Geometry;
use crate::numbers::LinkNumbers;
use loosepin_math::Real;

/// A revolute joint.
#[derive(Debug, Clone, Copy)]
pub struct Revolute {
    pub forward: bool,
    /// Whether its coordinate is the angle from the ground.
    pub turns_alone: bool,
}

impl<T: Real, G: Geometry<T>> Kind<T, G> for Revolute {
    #[inline(always)]
    fn turns_alone(&self) -> bool {
        self.turns_alone
    }
    #[inline(always)]
    fn pose(&self, numbers: &LinkNumbers<T, G>, parent: &Pose<T, G>, own: &[T]) -> Pose<T, G> {
        let is_reversed = !(self.forward || self.turns_alone);
        let angle = if is_reversed { -own[0] } else { own[0] };
        let rotation = G::revolved(&parent.rotation, &numbers.mount, angle, self.turns_alone);
        let at_joint = parent.position + G::turn(&parent.rotation, numbers.parent_arm);
        Pose { position: at_joint - G::turn(&rotation, numbers.own_arm), rotation }
    }
    #[inline(always)]
    fn columns(
        &self,
        numbers: &LinkNumbers<T, G>,
        parent: &Pose<T, G>,
        own: &Pose<T, G>,
        columns: &mut [Column<T, G>],
    ) {
        let is_reversed = !(self.forward || self.turns_alone);
        let axis = G::axis(&parent.rotation, &numbers.mount, self.turns_alone, is_reversed);
        columns[0] = Column::turning(axis, -G::turn(&own.rotation, numbers.own_arm));
    }
    #[inline(always)]
    fn bias(
        &self,
        numbers: &LinkNumbers<T, G>,
        parent: &Moving<T, G>,
        own: &Moving<T, G>,
        columns: &[Column<T, G>],
        speeds: Speeds<'_, T>,
    ) -> Twist<T, G> {
        let axis = columns[0].turning;
        let spin = (!self.turns_alone).then(|| {
            let carried = G::precessed(parent.bias.spin, parent.twist.spin, axis, speeds.own[0]);
            speeds.driven.map_or(carried, |driven| G::turned(carried, axis, driven))
        });
        bias_about_point(numbers, parent, own, spin)
    }
}
