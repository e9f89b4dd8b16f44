//! Expressions as flat lists of operations on a stack, for speed in every run of a study.
//!
//! Sine, cosine and their kin are those of `libm`, so that a study gives the same bits on every platform.

use super::Dimension;

/// The longest expression that is read, characters.
pub const LONGEST_EXPRESSION_CHARS: usize = 1000;

/// Numbers on the stack at once, at most; the parser refuses deeper nesting.
pub(super) const STACK_SIZE: usize = 128;

/// One operation. Operands are taken from the stack and the result is put there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Op {
    /// Puts a number on the stack.
    Number(f64),
    /// Puts the value in this slot on the stack.
    Load(usize),
    /// Takes the result off the stack into this slot.
    Store(usize),
    /// a + b.
    Add,
    /// a - b.
    Subtract,
    /// a b.
    Multiply,
    /// a / b.
    Divide,
    /// a to the power b.
    Power,
    /// The smaller of two.
    Minimum,
    /// The larger of two.
    Maximum,
    /// Angle of the point (b, a) from the x axis, rad.
    ArcTangent2,
    /// -a.
    Negate,
    /// Square root.
    SquareRoot,
    /// e to the power a.
    Exponential,
    /// Natural logarithm.
    Logarithm,
    /// Sine of an angle in radians.
    Sine,
    /// Cosine of an angle in radians.
    Cosine,
    /// Tangent of an angle in radians.
    Tangent,
    /// Inverse sine, rad.
    ArcSine,
    /// Inverse cosine, rad.
    ArcCosine,
    /// Inverse tangent, rad.
    ArcTangent,
    /// Magnitude.
    Absolute,
}

impl Op {
    /// Whether it takes two operands from the stack.
    #[inline(always)]
    pub fn is_binary(&self) -> bool {
        matches!(
            self,
            Self::Add
                | Self::Subtract
                | Self::Multiply
                | Self::Divide
                | Self::Power
                | Self::Minimum
                | Self::Maximum
                | Self::ArcTangent2
        )
    }
}

/// A parsed expression: its operations, what it measures and the slots it reads.
#[derive(Debug, Clone, PartialEq)]
pub struct Expression {
    /// The operations, leaving one number on the stack.
    pub ops: Vec<Op>,
    /// The dimension of the result.
    pub dimension: Dimension,
    /// The slots that it reads, each once, in order of appearance.
    pub reads: Vec<usize>,
}

impl Expression {
    /// A bare number.
    pub fn number(value: f64) -> Expression {
        Expression { ops: vec![Op::Number(value)], dimension: Dimension::NUMBER, reads: Vec::new() }
    }
}

/// Runs operations made by the parser over the slots `values`; returns the top of the stack, NaN if it is empty.
///
/// A list may hold many expressions, each ending in [`Op::Store`]. Nothing is allocated.
pub fn run(ops: &[Op], values: &mut [f64]) -> f64 {
    let mut stack = [f64::NAN; STACK_SIZE];
    let mut top = 0;
    for op in ops {
        match *op {
            Op::Number(number) => {
                stack[top] = number;
                top += 1;
            }
            Op::Load(slot) => {
                stack[top] = values[slot];
                top += 1;
            }
            Op::Store(slot) => {
                top -= 1;
                values[slot] = stack[top];
            }
            _ if op.is_binary() => {
                top -= 1;
                stack[top - 1] = of_two(*op, stack[top - 1], stack[top]);
            }
            _ => stack[top - 1] = of_one(*op, stack[top - 1]),
        }
    }
    if top == 0 { f64::NAN } else { stack[top - 1] }
}

fn of_two(op: Op, a: f64, b: f64) -> f64 {
    match op {
        Op::Add => a + b,
        Op::Subtract => a - b,
        Op::Multiply => a * b,
        Op::Divide => a / b,
        // The square is by far the commonest power, and exact this way.
        Op::Power if b == 2.0 => a * a,
        Op::Power => libm::pow(a, b),
        // Not f64::min, which would drop a NaN and with it the trace of what went wrong.
        Op::Minimum => {
            if a.is_nan() || a < b {
                a
            } else {
                b
            }
        }
        Op::Maximum => {
            if a.is_nan() || a > b {
                a
            } else {
                b
            }
        }
        _ => libm::atan2(a, b),
    }
}

fn of_one(op: Op, a: f64) -> f64 {
    match op {
        Op::Negate => -a,
        Op::SquareRoot => a.sqrt(),
        Op::Exponential => libm::exp(a),
        Op::Logarithm => libm::log(a),
        Op::Sine => libm::sin(a),
        Op::Cosine => libm::cos(a),
        Op::Tangent => libm::tan(a),
        Op::ArcSine => libm::asin(a),
        Op::ArcCosine => libm::acos(a),
        Op::ArcTangent => libm::atan(a),
        _ => a.abs(),
    }
}
