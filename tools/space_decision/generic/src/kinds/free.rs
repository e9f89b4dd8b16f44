//! A body that hangs on nothing.

use super::{Column, Kind, Moving, Pose, Speeds, Twist};
use crate::geometry::{Geometry, Vector};
use crate::numbers::LinkNumbers;
use loosepin_math::Real;

/// A position and an orientation.
#[derive(Debug, Clone, Copy)]
pub struct Free;

impl<T: Real, G: Geometry<T>> Kind<T, G> for Free {
    #[inline(always)]
    fn turns_alone(&self) -> bool {
        true
    }
    #[inline(always)]
    fn pose(&self, _: &LinkNumbers<T, G>, _: &Pose<T, G>, own: &[T]) -> Pose<T, G> {
        let count = G::COUNTS.position;
        let sum = |sum: G::Vector, k: usize| sum.plus(G::unit(k), own[k]);
        Pose { position: (0..count).fold(G::Vector::zero(), sum), rotation: G::oriented(&own[count..]) }
    }
    #[inline(always)]
    fn columns(&self, _: &LinkNumbers<T, G>, _: &Pose<T, G>, own: &Pose<T, G>, columns: &mut [Column<T, G>]) {
        let (position, orientation) = columns.split_at_mut(G::COUNTS.position);
        for (k, column) in position.iter_mut().enumerate() {
            *column = Column::sliding(G::unit(k));
        }
        for (column, turning) in orientation.iter_mut().zip(G::turnings(&own.rotation).as_ref()) {
            *column = Column { linear: G::Vector::zero(), turning: *turning };
        }
    }
    #[inline(always)]
    fn bias(
        &self,
        _: &LinkNumbers<T, G>,
        _: &Moving<T, G>,
        _: &Moving<T, G>,
        _: &[Column<T, G>],
        _: Speeds<'_, T>,
    ) -> Twist<T, G> {
        Twist::zero()
    }
    fn rates(&self, own: &[T], speeds: &[T], rates: &mut [T]) {
        let count = G::COUNTS.position;
        rates[..count].copy_from_slice(&speeds[..count]);
        G::orientation_rates(&own[count..], &speeds[count..], &mut rates[count..]);
    }
}
