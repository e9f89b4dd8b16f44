//! A ball in a socket. Its speeds are the spin in the axes of the body: its columns are these axes, and nothing is singular. In the plane
//! it is a revolute joint that turns alone.

use super::{Column, Kind, Moving, Pose, Speeds, Twist, bias_about_point};
use crate::geometry::Geometry;
use crate::numbers::LinkNumbers;
use loosepin_math::Real;

/// A ball joint.
#[derive(Debug, Clone, Copy)]
pub struct Ball;

impl<T: Real, G: Geometry<T>> Kind<T, G> for Ball {
    #[inline(always)]
    fn turns_alone(&self) -> bool {
        true
    }
    #[inline(always)]
    fn pose(&self, numbers: &LinkNumbers<T, G>, parent: &Pose<T, G>, own: &[T]) -> Pose<T, G> {
        let rotation = G::oriented(own);
        let at_joint = parent.position + G::turn(&parent.rotation, numbers.parent_arm);
        Pose { position: at_joint - G::turn(&rotation, numbers.own_arm), rotation }
    }
    #[inline(always)]
    fn columns(&self, numbers: &LinkNumbers<T, G>, _: &Pose<T, G>, own: &Pose<T, G>, columns: &mut [Column<T, G>]) {
        let arm = -G::turn(&own.rotation, numbers.own_arm);
        for (column, turning) in columns.iter_mut().zip(G::turnings(&own.rotation).as_ref()) {
            *column = Column::turning(*turning, arm);
        }
    }
    #[inline(always)]
    fn bias(
        &self,
        numbers: &LinkNumbers<T, G>,
        parent: &Moving<T, G>,
        own: &Moving<T, G>,
        _: &[Column<T, G>],
        _: Speeds<'_, T>,
    ) -> Twist<T, G> {
        bias_about_point(numbers, parent, own, None)
    }
    fn rates(&self, own: &[T], speeds: &[T], rates: &mut [T]) {
        G::orientation_rates(own, speeds, rates);
    }
}
