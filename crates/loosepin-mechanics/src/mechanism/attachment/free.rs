//! A body that hangs on nothing: the coordinates are the position of its frame, m, and its orientation.

use super::form::{FormOfAttachment, TreeGeometry};
use super::kind::{Columns, KindOfAttachment, Place, Rates};
use crate::mechanism::tree::kinematics::{Kinematics, Pose, Twist};
use crate::mechanism::tree::numbers::LinkNumbers;
use crate::mechanism::tree::spanning_tree::Tree;
use crate::model::JointId;
use core::ops::Range;
use loosepin_math::{Real, Vector};

/// On nothing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Free;

impl<G: TreeGeometry> FormOfAttachment<G> for Free {
    fn joint(&self) -> Option<(JointId, bool)> {
        None
    }
    fn counts(&self) -> [usize; 2] {
        [G::ORIENTATION_COORDINATES, G::ORIENTATION_SPEEDS].map(|count| G::POSITION + count)
    }
    fn lengths(&self) -> Range<usize> {
        0..G::POSITION
    }
    fn angle(&self) -> Option<usize> {
        (G::ORIENTATION_COORDINATES == 1).then_some(G::POSITION)
    }
    fn turns(&self) -> bool {
        true
    }
    fn turns_alone(&self) -> bool {
        true
    }
}

impl<G: TreeGeometry> KindOfAttachment<G> for Free {
    #[inline(always)]
    fn pose<T: Real>(
        &self,
        _: &Place<'_, T, G>,
        _: &Pose<T, G>,
        own: &[T],
        _: &[T],
        sin_cos: impl Fn(T) -> (T, T),
    ) -> Pose<T, G> {
        Pose { position_m: G::position(&own[..G::POSITION]), rotation: G::oriented(&own[G::POSITION..], sin_cos) }
    }
    #[inline(always)]
    fn columns<T: Real>(
        &self,
        _: &Place<'_, T, G>,
        [_, own]: [&Pose<T, G>; 2],
        _: &[T],
        Columns { linear, turnings }: Columns<'_, T, G>,
    ) {
        for (index, linear) in linear.iter_mut().enumerate() {
            *linear = if index < G::POSITION { G::unit(index) } else { G::Vector::zero() };
        }
        turnings[G::POSITION..].copy_from_slice(G::turnings(&own.rotation).as_ref());
    }
    #[inline(always)]
    fn bias<T: Real>(&self, _: &Place<'_, T, G>, _: &Kinematics<T, G>, _: Rates<'_, T>) -> Twist<T, G> {
        Twist::zero()
    }
    fn coordinates_between(
        &self,
        _: &LinkNumbers<f64, G>,
        _: (&Pose<f64, G>, &Twist<f64, G>),
        (pose, twist): (&Pose<f64, G>, &Twist<f64, G>),
        coordinates: &mut [f64],
        rates: &mut [f64],
    ) {
        for index in 0..G::POSITION {
            coordinates[index] = pose.position_m.component(index);
            rates[index] = twist.linear.component(index);
        }
        G::orientation(&pose.rotation, &twist.angular, &mut coordinates[G::POSITION..], &mut rates[G::POSITION..]);
    }
    fn coordinate_rates<T: Real>(&self, own: &[T], speeds: &[T], rates: &mut [T]) {
        rates[..G::POSITION].copy_from_slice(&speeds[..G::POSITION]);
        G::orientation_rates(&own[G::POSITION..], &speeds[G::POSITION..], &mut rates[G::POSITION..]);
    }
    fn first_turnings<T: Real>(&self, _: &Tree<G>) -> Vec<G::Turning<T>> {
        vec![G::still(); G::POSITION + G::ORIENTATION_SPEEDS]
    }
}
