//! Makes the list of the attachments of a geometry, and hands every question on to the kind.

macro_rules! attachments {
    ($(#[$doc:meta])* $name:ident over $geometry:ident { $($kind:ident),* $(,)? }) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum $name {
            $(#[doc = concat!("See `", stringify!($kind), "`.")] $kind($kind),)*
        }

        $(impl From<$kind> for $name {
            fn from(kind: $kind) -> Self {
                Self::$kind(kind)
            }
        })*

        impl $crate::mechanism::attachment::FormOfAttachment<$geometry> for $name {
            fn joint(&self) -> Option<($crate::model::JointId, bool)> {
                match self { $(Self::$kind(kind) => $crate::mechanism::attachment::FormOfAttachment::<$geometry>::joint(kind),)* }
            }
            fn counts(&self) -> [usize; 2] {
                match self { $(Self::$kind(kind) => $crate::mechanism::attachment::FormOfAttachment::<$geometry>::counts(kind),)* }
            }
            fn lengths(&self) -> core::ops::Range<usize> {
                match self { $(Self::$kind(kind) => $crate::mechanism::attachment::FormOfAttachment::<$geometry>::lengths(kind),)* }
            }
            fn angle(&self) -> Option<usize> {
                match self { $(Self::$kind(kind) => $crate::mechanism::attachment::FormOfAttachment::<$geometry>::angle(kind),)* }
            }
            fn turns(&self) -> bool {
                match self { $(Self::$kind(kind) => $crate::mechanism::attachment::FormOfAttachment::<$geometry>::turns(kind),)* }
            }
        }

        impl $crate::mechanism::attachment::KindOfAttachment<$geometry> for $name {
            #[inline(always)]
            fn hang<T: loosepin_math::Real>(
                &self,
                place: &$crate::mechanism::attachment::Place<'_, T, $geometry>,
                parent: &$crate::mechanism::Pose<T, $geometry>,
                coordinates: &[T],
                near: Option<&loosepin_math::KnownAngle<T>>,
                columns: $crate::mechanism::attachment::Columns<'_, T, $geometry>,
            ) -> $crate::mechanism::attachment::Hung<T, $geometry> {
                match self { $(Self::$kind(kind) => kind.hang(place, parent, coordinates, near, columns),)* }
            }
            #[inline(always)]
            fn bias<T: loosepin_math::Real>(
                &self,
                place: &$crate::mechanism::attachment::Place<'_, T, $geometry>,
                kinematics: &$crate::mechanism::Kinematics<T, $geometry>,
                rates: $crate::mechanism::attachment::Rates<'_, T>,
            ) -> $crate::mechanism::Twist<T, $geometry> {
                match self { $(Self::$kind(kind) => kind.bias(place, kinematics, rates),)* }
            }
            #[inline(always)]
            fn coordinate_rates<T: loosepin_math::Real>(&self, own: &[T], speeds: &[T], rates: &mut [T]) {
                match self { $(Self::$kind(kind) => $crate::mechanism::attachment::KindOfAttachment::<$geometry>::coordinate_rates(kind, own, speeds, rates),)* }
            }
            fn first_turnings<T: loosepin_math::Real>(
                &self,
                tree: &$crate::mechanism::Tree<$geometry>,
            ) -> Vec<<$geometry as loosepin_math::Geometry>::Turning<T>> {
                match self { $(Self::$kind(kind) => kind.first_turnings::<T>(tree),)* }
            }
            fn coordinates_between(
                &self,
                numbers: &$crate::mechanism::LinkNumbers<f64, $geometry>,
                parent: (&$crate::mechanism::Pose<f64, $geometry>, &$crate::mechanism::Twist<f64, $geometry>),
                own: (&$crate::mechanism::Pose<f64, $geometry>, &$crate::mechanism::Twist<f64, $geometry>),
                coordinates: &mut [f64],
                rates: &mut [f64],
            ) {
                match self { $(Self::$kind(kind) => kind.coordinates_between(numbers, parent, own, coordinates, rates),)* }
            }
        }
    };
}

pub(super) use attachments;
