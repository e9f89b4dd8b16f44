//! A body that hangs on nothing: the coordinates are the position of its frame, m, and its orientation.

use super::form::{FormOfAttachment, TreeGeometry};
use super::kind::{Columns, Hung, KindOfAttachment, Place, Rates};
use crate::mechanism::tree::kinematics::{Kinematics, Pose, Twist};
use crate::mechanism::tree::numbers::LinkNumbers;
use core::ops::Range;
use loosepin_math::{KnownAngle, Real, Vector};

/// On nothing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Free;

impl<G: TreeGeometry> FormOfAttachment<G> for Free {
    fn counts(&self) -> [usize; 2] {
        [G::ORIENTATION_COORDINATES, G::ORIENTATION_SPEEDS].map(|count| G::POSITION + count)
    }
    fn lengths(&self) -> Range<usize> {
        0..G::POSITION
    }
    fn angle(&self) -> Option<usize> {
        (G::ORIENTATION_COORDINATES == 1).then_some(G::POSITION)
    }
}

impl<G: TreeGeometry> KindOfAttachment<G> for Free {
    #[inline(always)]
    fn hang<T: Real>(
        &self,
        place: &Place<'_, T, G>,
        _: &Pose<T, G>,
        coordinates: &[T],
        near: Option<&KnownAngle<T>>,
        Columns { linear, turnings }: Columns<'_, T, G>,
    ) -> Hung<T, G> {
        let own = place.own(coordinates);
        let rotation = G::oriented(&own[G::POSITION..], near);
        for (index, linear) in linear.iter_mut().enumerate() {
            *linear = if index < G::POSITION { G::unit(index) } else { G::Vector::zero() };
        }
        turnings[G::POSITION..].copy_from_slice(G::turnings(&rotation).as_ref());
        Hung::alone(Pose { position_m: G::position(&own[..G::POSITION]), rotation }, G::Vector::zero())
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
        pose.position_m.write(coordinates);
        twist.linear.write(rates);
        G::orientation(&pose.rotation, &twist.angular, &mut coordinates[G::POSITION..], &mut rates[G::POSITION..]);
    }
    fn coordinate_rates<T: Real>(&self, own: &[T], speeds: &[T], rates: &mut [T]) {
        rates[..G::POSITION].copy_from_slice(&speeds[..G::POSITION]);
        G::orientation_rates(&own[G::POSITION..], &speeds[G::POSITION..], &mut rates[G::POSITION..]);
    }
}
