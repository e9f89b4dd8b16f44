//! Makes the list of the conditions of a geometry at a state, and hands every question on to the condition.

macro_rules! rows_at {
    ($(#[$doc:meta])* $name:ident over $geometry:ident { $($row:ident),* $(,)? }) => {
        $(#[$doc])*
        pub enum $name<T: loosepin_math::Real> {
            $(#[doc = concat!("See `", stringify!($row), "`.")] $row($row<T, $geometry>),)*
        }

        impl<T: loosepin_math::Real> $crate::mechanism::row::RowAt<T, $geometry> for $name<T> {
            #[inline(always)]
            fn residuals(&self, out: &mut [T]) {
                match self { $(Self::$row(row) => row.residuals(out),)* }
            }
            #[inline(always)]
            fn rates(
                &self,
                velocity: impl FnOnce() -> <$geometry as loosepin_math::Geometry>::Vector<T>,
                side: usize,
                spin: <$geometry as loosepin_math::Geometry>::Spin<T>,
                out: &mut [T],
            ) {
                match self { $(Self::$row(row) => row.rates(velocity, side, spin, out),)* }
            }
            #[inline(always)]
            fn biases(&self, motion: &$crate::mechanism::row::CutMotion<T, $geometry>, out: &mut [T]) {
                match self { $(Self::$row(row) => row.biases(motion, out),)* }
            }
            #[inline(always)]
            fn force_n(&self, multipliers: &[T]) -> <$geometry as loosepin_math::Geometry>::Vector<T> {
                match self { $(Self::$row(row) => row.force_n(multipliers),)* }
            }
        }
    };
}

pub(super) use rows_at;
