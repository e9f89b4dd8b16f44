//! Structures of numbers: made of constants, and shown number by number.

use super::{Real, Vec2};

/// A structure over numbers of type `T`. [`numbers!`](crate::numbers) implements it from the names of the parts.
pub trait Numbers<T: Real> {
    /// The same structure over plain numbers.
    type Plain;

    /// The numbers of `plain` as constants of `T`; what is no number, as it is.
    fn broadcast(plain: &Self::Plain) -> Self;

    /// Shows every number, in an order that does not depend on their values.
    fn visit(&mut self, visit: &mut impl FnMut(&mut T));
}

impl<T: Real> Numbers<T> for T {
    type Plain = f64;
    fn broadcast(plain: &f64) -> Self {
        T::from_f64(*plain)
    }
    fn visit(&mut self, visit: &mut impl FnMut(&mut T)) {
        visit(self);
    }
}

impl<T: Real, N: Numbers<T>> Numbers<T> for Vec<N> {
    type Plain = Vec<N::Plain>;
    fn broadcast(plain: &Vec<N::Plain>) -> Self {
        plain.iter().map(N::broadcast).collect()
    }
    fn visit(&mut self, visit: &mut impl FnMut(&mut T)) {
        self.iter_mut().for_each(|part| part.visit(visit));
    }
}

impl<T: Real, N: Numbers<T>> Numbers<T> for Option<N> {
    type Plain = Option<N::Plain>;
    fn broadcast(plain: &Option<N::Plain>) -> Self {
        plain.as_ref().map(N::broadcast)
    }
    fn visit(&mut self, visit: &mut impl FnMut(&mut T)) {
        self.iter_mut().for_each(|part| part.visit(visit));
    }
}

impl<T: Real, N: Numbers<T>, const COUNT: usize> Numbers<T> for [N; COUNT] {
    type Plain = [N::Plain; COUNT];
    fn broadcast(plain: &[N::Plain; COUNT]) -> Self {
        plain.each_ref().map(N::broadcast)
    }
    fn visit(&mut self, visit: &mut impl FnMut(&mut T)) {
        self.iter_mut().for_each(|part| part.visit(visit));
    }
}

/// Implements [`Numbers`] for a structure by the names of its parts: those that are numbers or hold some, in the order in which they
/// are shown; behind a semicolon those that hold none. An enum is written with its variants.
#[macro_export]
macro_rules! numbers {
    (struct $name:ident { $($number:ident),* $(; $($other:ident),*)? }) => {
        impl<T: $crate::Real> $crate::Numbers<T> for $name<T> {
            type Plain = $name<f64>;
            fn broadcast(plain: &$name<f64>) -> Self {
                Self {
                    $($number: $crate::Numbers::<T>::broadcast(&plain.$number),)*
                    $($($other: Clone::clone(&plain.$other),)*)?
                }
            }
            fn visit(&mut self, visit: &mut impl FnMut(&mut T)) {
                $($crate::Numbers::<T>::visit(&mut self.$number, visit);)*
            }
        }
    };
    (enum $name:ident { $($variant:ident $({ $($number:ident),* })? $(($inner:ident))?),* $(,)? }) => {
        impl<T: $crate::Real> $crate::Numbers<T> for $name<T> {
            type Plain = $name<f64>;
            fn broadcast(plain: &$name<f64>) -> Self {
                match plain {
                    $($name::$variant $({ $($number),* })? $(($inner))? => Self::$variant
                        $({ $($number: $crate::Numbers::<T>::broadcast($number)),* })?
                        $(($crate::Numbers::<T>::broadcast($inner)))?,)*
                }
            }
            fn visit(&mut self, visit: &mut impl FnMut(&mut T)) {
                match self {
                    $(Self::$variant $({ $($number),* })? $(($inner))? => {
                        $($($crate::Numbers::<T>::visit($number, visit);)*)?
                        $($crate::Numbers::<T>::visit($inner, visit);)?
                    })*
                }
            }
        }
    };
}

numbers!(struct Vec2 { x, y });
