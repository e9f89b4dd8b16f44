//! Functions of time and of joints, written as expressions in a model file and evaluated inside the equations of motion.

use loosepin_math::Real;
use loosepin_text::numbers::QuantityId;
use loosepin_text::units::{Dimension, Names, Op, run};

/// Whole and half exponents up to this are powers by multiplication.
const MAX_MULTIPLIED: f64 = 32.0;

/// A variable of a function: its name and what it measures.
pub(in crate::model) type Variable = (&'static str, Dimension);

/// The time.
pub(in crate::model) const TIME: Variable = ("time", Dimension::TIME);

/// A function as a straight line of steps, each over results of earlier ones: no choice but minimum and maximum, so that it
/// runs on lanes, on dual numbers and as machine code.
#[derive(Debug, Clone, PartialEq)]
pub struct Function {
    steps: Vec<Step>,
    /// The quantities that it reads.
    pub parameters: Vec<QuantityId>,
    /// Dimension of its value.
    pub dimension: Dimension,
}

/// A step; operands are indices of earlier steps.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Step {
    Number(f64),
    /// Index in [`Function::parameters`].
    Parameter(usize),
    /// Index in the list of variables that the function was read with.
    Variable(usize),
    One(Op, usize),
    Two(Op, usize, usize),
    /// A power with half this number as its exponent.
    Power(usize, i32),
}

/// A value that may change.
#[derive(Debug, Clone, PartialEq)]
pub enum Changing {
    /// A value without variables.
    Constant(QuantityId),
    /// A function of the variables.
    Function(Function),
}

/// Operation that a function cannot have.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::model) enum Beyond {
    /// An inverse trigonometric function.
    Inverse,
}

impl Function {
    /// Number of steps: what [`Function::value`] needs as room.
    pub fn steps(&self) -> usize {
        self.steps.len()
    }

    /// Its value at `variables`, with `parameters` in its own order, seen through `number`; `workspace` holds at least
    /// [`Function::steps`] numbers.
    #[inline(always)]
    pub fn value<T: Copy, N: Real>(
        &self,
        parameters: &[T],
        variables: &[N],
        number: impl Fn(T) -> N,
        workspace: &mut [N],
    ) -> N {
        for (index, step) in self.steps.iter().enumerate() {
            workspace[index] = match *step {
                Step::Number(value) => N::from_f64(value),
                Step::Parameter(place) => number(parameters[place]),
                Step::Variable(place) => variables[place],
                Step::One(op, a) => of_one(op, workspace[a]),
                Step::Two(op, a, b) => of_two(op, workspace[a], workspace[b]),
                Step::Power(a, halves) => half_power(workspace[a], halves),
            };
        }
        workspace[self.steps.len() - 1]
    }

    /// From the operations of an expression, whose last result is its value. The largest slots are the variables.
    pub(in crate::model) fn compile(ops: &[Op], dimension: Dimension, variables: usize) -> Result<Self, Beyond> {
        let mut function = Self { steps: Vec::new(), parameters: Vec::new(), dimension };
        let mut stack: Vec<usize> = Vec::new();
        for op in ops {
            let second = if op.is_binary() { stack.pop() } else { None };
            let first = if matches!(op, Op::Number(_) | Op::Load(_)) { None } else { stack.pop() };
            let result = function.operation(*op, first.unwrap_or(0), second, variables)?;
            stack.push(result);
        }
        Ok(function)
    }

    fn operation(&mut self, op: Op, first: usize, second: Option<usize>, variables: usize) -> Result<usize, Beyond> {
        let number = |index: usize| match self.steps[index] {
            Step::Number(value) => Some(value),
            _ => None,
        };
        let is_leaf = matches!(op, Op::Number(_) | Op::Load(_));
        if !is_leaf && let Some(a) = number(first) {
            // Numbers are worked out once, whatever the operation.
            let folded = match second {
                None => Some(run(&[Op::Number(a), op], &mut [])),
                Some(second) => number(second).map(|b| run(&[Op::Number(a), Op::Number(b), op], &mut [])),
            };
            if let Some(value) = folded {
                return Ok(self.push(Step::Number(value)));
            }
        }
        let (a, b) = (first, second.unwrap_or(0));
        let step = match op {
            Op::Number(value) => Step::Number(value),
            Op::Load(slot) if usize::MAX - slot < variables => Step::Variable(usize::MAX - slot),
            Op::Load(slot) => {
                let id = QuantityId(slot);
                let known = self.parameters.iter().position(|known| *known == id);
                Step::Parameter(known.unwrap_or_else(|| {
                    self.parameters.push(id);
                    self.parameters.len() - 1
                }))
            }
            Op::Power => {
                let halves = number(b).map(|exponent| 2.0 * exponent);
                let multiplied = |halves: &f64| *halves == halves.round() && halves.abs() <= 2.0 * MAX_MULTIPLIED;
                match halves.filter(multiplied) {
                    Some(halves) => Step::Power(a, halves as i32),
                    None => Step::Two(op, a, b),
                }
            }
            Op::Tangent => {
                let sine = self.push(Step::One(Op::Sine, a));
                let cosine = self.push(Step::One(Op::Cosine, a));
                Step::Two(Op::Divide, sine, cosine)
            }
            Op::ArcSine | Op::ArcCosine | Op::ArcTangent | Op::ArcTangent2 | Op::Store(_) => {
                return Err(Beyond::Inverse);
            }
            _ if op.is_binary() => Step::Two(op, a, b),
            _ => Step::One(op, a),
        };
        Ok(self.push(step))
    }

    fn push(&mut self, step: Step) -> usize {
        self.steps.push(step);
        self.steps.len() - 1
    }
}

#[inline(always)]
fn of_one<N: Real>(op: Op, a: N) -> N {
    match op {
        Op::Negate => -a,
        Op::SquareRoot => a.sqrt(),
        Op::Exponential => a.exponential(),
        Op::Logarithm => a.logarithm(),
        Op::Sine => a.sin_cos().0,
        Op::Cosine => a.sin_cos().1,
        _ => a.abs(),
    }
}

#[inline(always)]
fn of_two<N: Real>(op: Op, a: N, b: N) -> N {
    match op {
        Op::Add => a + b,
        Op::Subtract => a - b,
        Op::Multiply => a * b,
        Op::Divide => a / b,
        Op::Power => a.power(b),
        Op::Minimum => N::select(a.less_than(b), a, N::select(b.less_than(a), b, equal_or_none(a, b))),
        _ => N::select(b.less_than(a), a, N::select(a.less_than(b), b, equal_or_none(a, b))),
    }
}

/// Both numbers where they are equal, and none where one of them is none: a minimum must not hide that a function has no value.
#[inline(always)]
fn equal_or_none<N: Real>(a: N, b: N) -> N {
    N::from_f64(0.5) * (a + b)
}

/// x to the power of half of `halves`, by multiplications and a root.
#[inline(always)]
fn half_power<N: Real>(base: N, halves: i32) -> N {
    let mut left = halves.unsigned_abs() / 2;
    let mut power = if halves % 2 == 0 { N::one() } else { base.sqrt() };
    let mut square = base;
    while left > 0 {
        if left % 2 == 1 {
            power *= square;
        }
        left /= 2;
        if left > 0 {
            square *= square;
        }
    }
    if halves < 0 { N::one() / power } else { power }
}

/// Parameters and variables together.
pub(in crate::model) struct FunctionNames<'n> {
    pub parameters: &'n dyn Names,
    pub variables: &'n [Variable],
}

impl Names for FunctionNames<'_> {
    fn find(&self, name: &str) -> Option<(usize, Dimension)> {
        let variable = self.variables.iter().position(|(variable, _)| *variable == name);
        // Variables are numbered from the largest slot downwards, where no quantity is.
        variable.map(|place| (usize::MAX - place, self.variables[place].1)).or_else(|| self.parameters.find(name))
    }
    fn all(&self) -> Box<dyn Iterator<Item = &str> + '_> {
        Box::new(self.variables.iter().map(|(name, _)| *name).chain(self.parameters.all()))
    }
    fn is_reported(&self, name: &str) -> bool {
        self.parameters.is_reported(name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use loosepin_math::Dual;
    use loosepin_text::units::parse_expression;

    struct Nothing;
    impl Names for Nothing {
        fn find(&self, name: &str) -> Option<(usize, Dimension)> {
            (name == "swing").then_some((4, Dimension::ANGLE))
        }
        fn all(&self) -> Box<dyn Iterator<Item = &str> + '_> {
            Box::new(std::iter::empty())
        }
    }

    fn function(text: &str) -> Result<Function, Beyond> {
        let variables = [TIME];
        let names = FunctionNames { parameters: &Nothing, variables: &variables };
        let expression = parse_expression(text, &names).expect("an expression");
        Function::compile(&expression.ops, expression.dimension, variables.len())
    }

    #[test]
    fn analytic_value_and_derivatives_of_a_swing() {
        let swing = function("swing * sin(2.7 rad/s * time + 0.3 rad) - 0.4 rad * (time / 1 s)^1.5").expect("a line");
        assert_eq!(swing.parameters, [QuantityId(4)]);
        let (t, amplitude): (f64, f64) = (0.83, 1.7);
        let time = Dual { value: Dual::variable(t), derivative: Dual::constant(1.0) };
        let mut workspace = vec![Dual::constant(Dual::constant(f64::NAN)); swing.steps()];
        let found = swing.value(&[amplitude], &[time], |a| Dual::constant(Dual::constant(a)), &mut workspace);
        let (sine, cosine) = (2.7 * t + 0.3).sin_cos();
        let expected = [
            amplitude * sine - 0.4 * t.powf(1.5),
            2.7 * amplitude * cosine - 0.6 * t.sqrt(),
            -2.7 * 2.7 * amplitude * sine - 0.3 / t.sqrt(),
        ];
        let found = [found.value.value, found.value.derivative, found.derivative.derivative];
        // Round-off of a dozen operations on numbers up to ten.
        assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-14), "{found:?} {expected:?}");
    }

    #[test]
    fn analytic_powers() {
        for (halves, expected) in [(-3, 1.3_f64.powf(-1.5)), (0, 1.0), (1, 1.3_f64.sqrt()), (14, 1.3_f64.powi(7))] {
            // A few multiplications.
            assert!((half_power(1.3_f64, halves) - expected).abs() < 1e-14, "{halves}");
        }
    }

    #[test]
    fn what_has_no_straight_line_is_refused() {
        assert_eq!(function("1 N * time / 1 s * cos(asin(0.3))").map(|_| ()), Ok(()));
        assert_eq!(function("atan(time / 1 s)").map(|_| ()), Err(Beyond::Inverse));
    }

    /// Value and first two derivatives over the time.
    fn jet(text: &str, time_s: f64, parameter: f64) -> [f64; 3] {
        let function = function(text).expect("a line");
        let time = Dual { value: Dual::variable(time_s), derivative: Dual::constant(1.0) };
        let mut workspace = vec![Dual::constant(Dual::constant(f64::NAN)); function.steps()];
        let found = function.value(&[parameter], &[time], |a: f64| Dual::constant(Dual::constant(a)), &mut workspace);
        [found.value.value, found.value.derivative, found.derivative.derivative]
    }

    #[test]
    fn analytic_exponentials_logarithms_and_any_power() {
        let t: f64 = 0.83;
        for (text, due) in [
            ("exp(-time / 0.4 s)", [1.0, -2.5, 6.25].map(|share| share * (-t / 0.4).exp())),
            ("log(time / 1 s)", [t.ln(), 1.0 / t, -1.0 / (t * t)]),
            ("(time / 1 s)^0.3", [t.powf(0.3), 0.3 * t.powf(-0.7), -0.21 * t.powf(-1.7)]),
            ("(time / 1 s)^(swing / 1 rad)", [t.powf(1.7), 1.7 * t.powf(0.7), 1.19 * t.powf(-0.3)]),
            ("2^(time / 1 s)", [1.0, 2.0_f64.ln(), 2.0_f64.ln().powi(2)].map(|share| share * 2.0_f64.powf(t))),
            ("min(time, 1 s) / max(time, 2 s)", [t / 2.0, 0.5, 0.0]),
        ] {
            let found = jet(text, t, 1.7);
            // Round-off of a few operations on numbers up to ten.
            assert!(found.iter().zip(due).all(|(a, b)| (a - b).abs() < 1e-14), "{text}: {found:?} {due:?}");
        }
    }

    #[test]
    fn what_has_no_value_shows_through_minimum_and_maximum() {
        for text in
            ["log(0.5 - time / 1 s)", "sqrt(0.5 - time / 1 s)", "(0.5 - time / 1 s)^0.3", "(time / 1 s - 0.5)^-0.3"]
        {
            assert!(jet(text, 0.25, 0.0)[0].is_nan() == text.starts_with("(time"), "{text}");
            for text in
                [text.to_owned(), format!("min({text}, 2)"), format!("max(-3, {text})"), format!("max({text}, 0)")]
            {
                assert!(jet(&text, 0.75, 0.0)[0].is_nan() != text.contains("(time / 1 s - "), "{text}");
            }
        }
    }
}
