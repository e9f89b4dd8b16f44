//! Hands every question about a condition of a geometry on to its kind.

macro_rules! rows {
    ($geometry:ident, $conditions:ident, |$state:ident| { $($condition:pat => $kind:expr),* $(,)? }) => {
        impl $crate::mechanism::row::RowGeometry for $geometry {
            #[inline(always)]
            fn residuals<T: loosepin_math::Real>(
                row: $conditions,
                $state: &$crate::mechanism::row::CutState<'_, T, Self>,
                out: &mut [T],
            ) {
                match row { $($condition => $crate::mechanism::row::RowAt::residuals(&$kind, out),)* }
            }
            #[inline(always)]
            fn add_columns<T: loosepin_math::Real>(
                row: $conditions,
                $state: &$crate::mechanism::row::CutState<'_, T, Self>,
                columns: &$crate::mechanism::row::CutColumns<'_, T, Self>,
                out: &mut [T],
            ) {
                match row { $($condition => $crate::mechanism::row::RowAt::add_columns(&$kind, columns, row.count(), out),)* }
            }
            #[inline(always)]
            fn rates<T: loosepin_math::Real>(
                row: $conditions,
                $state: &$crate::mechanism::row::CutState<'_, T, Self>,
                velocity: impl FnOnce() -> Self::Vector<T>,
                (side, spin): (usize, Self::Spin<T>),
                out: &mut [T],
            ) {
                match row { $($condition => $crate::mechanism::row::RowAt::<T, Self>::rates(&$kind, velocity, side, spin, out),)* }
            }
            #[inline(always)]
            fn biases<T: loosepin_math::Real>(
                row: $conditions,
                $state: &$crate::mechanism::row::CutState<'_, T, Self>,
                motion: &$crate::mechanism::row::CutMotion<T, Self>,
                out: &mut [T],
            ) {
                match row { $($condition => $crate::mechanism::row::RowAt::biases(&$kind, motion, out),)* }
            }
            #[inline(always)]
            fn force_n<T: loosepin_math::Real>(
                row: $conditions,
                $state: &$crate::mechanism::row::CutState<'_, T, Self>,
                multipliers: &[T],
            ) -> Self::Vector<T> {
                match row { $($condition => $crate::mechanism::row::RowAt::force_n(&$kind, multipliers),)* }
            }
        }
    };
}

pub(super) use rows;
