//! A number that writes down what is done with it: from the equations, evaluated once on these, comes the straight-line
//! program that [`crate::native`] turns into machine code.

use crate::native::{Graph, Mask, Slot, Value};
use core::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};
use loosepin_math::{Real, full_range_exponential, full_range_logarithm, full_range_power, power, sin_cos};
use std::cell::RefCell;

thread_local! {
    /// The expression that this thread is writing down.
    static GRAPH: RefCell<Graph> = RefCell::new(Graph::new());
}

/// A number of the program that is being written down on this thread, inside of [`record`].
#[derive(Debug, Clone, Copy)]
pub struct Traced(Value);

/// Writes down what `work` does with [`Traced`] numbers.
pub fn record<R>(work: impl FnOnce() -> R) -> (Graph, R) {
    GRAPH.set(Graph::new());
    let result = work();
    (GRAPH.take(), result)
}

impl Traced {
    /// The number that the program reads from `slot`.
    pub fn input(slot: Slot) -> Self {
        write(|graph| graph.input(slot))
    }
    /// Its place in the graph.
    pub fn value(self) -> Value {
        self.0
    }
}

fn write(node: impl FnOnce(&mut Graph) -> Value) -> Traced {
    Traced(GRAPH.with_borrow_mut(node))
}

macro_rules! operators {
    ($($operator:ident $method:ident $assign:ident $assign_method:ident $node:ident),*) => {$(
        impl $operator for Traced {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                write(|graph| graph.$node(self.0, other.0))
            }
        }
        impl $assign for Traced {
            fn $assign_method(&mut self, other: Self) {
                *self = $operator::$method(*self, other);
            }
        }
    )*};
}
operators!(
    Add add AddAssign add_assign add,
    Sub sub SubAssign sub_assign subtract,
    Mul mul MulAssign mul_assign multiply
);

impl Div for Traced {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        write(|graph| graph.divide(self.0, other.0))
    }
}
impl Neg for Traced {
    type Output = Self;
    fn neg(self) -> Self {
        write(|graph| graph.negate(self.0))
    }
}

impl Real for Traced {
    type Mask = Mask;

    fn from_f64(value: f64) -> Self {
        write(|graph| graph.constant(value))
    }
    fn to_f64(self) -> f64 {
        f64::NAN
    }
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        write(|graph| graph.mul_add(self.0, factor.0, addend.0))
    }
    fn sqrt(self) -> Self {
        write(|graph| graph.square_root(self.0))
    }
    fn sin_cos(self) -> (Self, Self) {
        sin_cos(self)
    }
    fn powf(self, exponent: f64) -> Self {
        if exponent == 1.5 {
            self * self.sqrt()
        } else if exponent == 1.0 {
            self
        } else {
            power(self, exponent)
        }
    }
    fn exponential(self) -> Self {
        full_range_exponential(self)
    }
    fn logarithm(self) -> Self {
        full_range_logarithm(self)
    }
    fn power(self, exponent: Self) -> Self {
        full_range_power(self, exponent)
    }
    fn min(self, other: Self) -> Self {
        write(|graph| graph.minimum(self.0, other.0))
    }
    fn max(self, other: Self) -> Self {
        write(|graph| graph.maximum(self.0, other.0))
    }
    fn abs(self) -> Self {
        write(|graph| graph.absolute(self.0))
    }
    fn less_than(self, other: Self) -> Mask {
        GRAPH.with_borrow_mut(|graph| graph.less_than(self.0, other.0))
    }
    fn select(mask: Mask, chosen: Self, otherwise: Self) -> Self {
        write(|graph| graph.select(mask, chosen.0, otherwise.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::native::Program;

    #[test]
    fn identity_a_recorded_function_is_the_function_bit_for_bit() {
        fn f<T: Real>(x: T, y: T) -> T {
            let (sine, cosine) = (x * T::from_f64(3.1)).sin_cos();
            let root = (x.mul_add(x, y * y)).sqrt();
            let larger = T::select(sine.less_than(cosine), root.powf(1.5), cosine.abs().max(y).min(root.powf(1.3)));
            let any = x.power(y) + (root.logarithm() * x).exponential() + x.abs().power(y);
            (larger - sine) / (cosine + T::from_f64(2.0)) + T::select(x.less_than(T::zero()), root.logarithm(), any)
        }
        let slot = |index| Slot { block: 0, index };
        let (graph, result) = record(|| f(Traced::input(slot(0)), Traced::input(slot(1))));
        let program = Program::new(&graph, &[(Slot { block: 1, index: 0 }, result.value())]).expect("one output");
        for k in 0..200 {
            let (x, y) = (-4.0 + 0.041 * f64::from(k), 1.7 - 0.013 * f64::from(k));
            let (mut inputs, mut output) = ([x, y], [f64::NAN]);
            program.evaluate(1, &mut [&mut inputs, &mut output]).expect("blocks fit");
            assert_eq!(output[0], f(x, y), "at {x}, {y}");
        }
    }
}
