//! From text to operations, with dimensions checked on the way.

use std::ops::Range;

use super::lexer::{Token, TokenKind, begins_word, tokens};
use super::program::{Expression, Op, STACK_SIZE, run};
use super::{Dimension, ExpressionError, ExpressionProblem, find_unit};
use crate::diagnostics::nearest_name;

/// Parentheses, signs, functions and powers inside one another, at most. Each level holds at most four numbers on the
/// stack (the first argument of a function, a sum and a product that wait, the base of a power), so that
/// [`STACK_SIZE`] is never reached.
const DEEPEST_NESTING: usize = 24;
const _: () = assert!(4 * (DEEPEST_NESTING + 1) < STACK_SIZE);

/// A value without parameters: its SI number and its dimension.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measured {
    /// The value, SI.
    pub value_si: f64,
    /// Its dimension.
    pub dimension: Dimension,
}

/// The names that an expression may use.
pub trait Names {
    /// Slot and dimension of the value called `name`.
    fn find(&self, name: &str) -> Option<(usize, Dimension)>;
    /// All names, for suggestions. No more of them are looked at than suggestions need.
    fn all(&self) -> Box<dyn Iterator<Item = &str> + '_>;
    /// Whether `name` means nothing because it was reported where it is defined: then nothing is suggested in its place.
    fn is_reported(&self, _name: &str) -> bool {
        false
    }
    /// Whether names mean anything where this value stands.
    fn are_allowed(&self) -> bool {
        true
    }
}

/// No names at all.
struct NoNames;

impl Names for NoNames {
    fn find(&self, _name: &str) -> Option<(usize, Dimension)> {
        None
    }
    fn all(&self) -> Box<dyn Iterator<Item = &str> + '_> {
        Box::new(std::iter::empty())
    }
    fn are_allowed(&self) -> bool {
        false
    }
}

/// A function that expressions may call.
struct Function {
    name: &'static str,
    op: Op,
    arguments: usize,
    kind: FunctionKind,
}

enum FunctionKind {
    /// Angle to number.
    OfAngle,
    /// Number to angle.
    ToAngle,
    /// Keeps the dimension; two arguments must share it.
    Keeps,
    /// Halves the exponents.
    Root,
    /// Number to number.
    OfNumber,
    /// Two of one dimension to an angle.
    TwoToAngle,
}

const fn function(name: &'static str, op: Op, arguments: usize, kind: FunctionKind) -> Function {
    Function { name, op, arguments, kind }
}

static FUNCTIONS: &[Function] = &[
    function("sqrt", Op::SquareRoot, 1, FunctionKind::Root),
    function("exp", Op::Exponential, 1, FunctionKind::OfNumber),
    function("log", Op::Logarithm, 1, FunctionKind::OfNumber),
    function("sin", Op::Sine, 1, FunctionKind::OfAngle),
    function("cos", Op::Cosine, 1, FunctionKind::OfAngle),
    function("tan", Op::Tangent, 1, FunctionKind::OfAngle),
    function("asin", Op::ArcSine, 1, FunctionKind::ToAngle),
    function("acos", Op::ArcCosine, 1, FunctionKind::ToAngle),
    function("atan", Op::ArcTangent, 1, FunctionKind::ToAngle),
    function("atan2", Op::ArcTangent2, 2, FunctionKind::TwoToAngle),
    function("abs", Op::Absolute, 1, FunctionKind::Keeps),
    function("min", Op::Minimum, 2, FunctionKind::Keeps),
    function("max", Op::Maximum, 2, FunctionKind::Keeps),
];

/// Names that functions have elsewhere, and theirs here.
const OTHER_NAMES: [(&str, &str); 3] = [("ln", "log"), ("arctan", "atan"), ("arctan2", "atan2")];

/// Whether expressions know a function of this name.
pub(super) fn is_function(name: &str) -> bool {
    FUNCTIONS.iter().any(|function| function.name == name)
}

/// Whether a parameter cannot bear this name, because it is a unit, a function or `pi`.
pub fn is_reserved_name(name: &str) -> bool {
    // `min` is both the minute and the smaller of two: the parenthesis tells them apart.
    name == "pi" || find_unit(name).is_some() || is_function(name)
}

/// The names of parameters in a text, each once; empty where the text cannot be read.
pub fn referenced_names(text: &str) -> Vec<String> {
    let mut names = Vec::new();
    for token in tokens(text).unwrap_or_default() {
        if let TokenKind::Word(word) = token.kind
            && !is_reserved_name(&word)
            && !names.contains(&word)
        {
            names.push(word);
        }
    }
    names
}

/// Reads an expression over `names`.
///
/// # Errors
/// The first place where the text is no expression, or where dimensions do not agree.
pub fn parse_expression(text: &str, names: &dyn Names) -> Result<Expression, ExpressionError> {
    let tokens = tokens(text)?;
    let mut parser = Parser { text, tokens: &tokens, next: 0, ops: Vec::new(), reads: Vec::new(), names, depth: 0 };
    if tokens.len() == 1 {
        return Err(parser.error(ExpressionProblem::Empty, 0..text.len()));
    }
    let dimension = parser.sum()?;
    parser.end()?;
    Ok(Expression { ops: parser.ops, dimension, reads: parser.reads })
}

/// Reads a value without parameters, for example `0.5 mm` or `2 * (1 mm + 3 um)`.
///
/// # Errors
/// The first place where the text is no value, or where dimensions do not agree; a value that is not finite.
pub fn parse_quantity(text: &str) -> Result<Measured, ExpressionError> {
    let expression = parse_expression(text, &NoNames)?;
    let value_si = run(&expression.ops, &mut []);
    if value_si.is_finite() {
        Ok(Measured { value_si, dimension: expression.dimension })
    } else {
        Err(ExpressionError { problem: ExpressionProblem::NotFinite { value: value_si }, span: 0..text.len() })
    }
}

/// Reads a unit alone, for example `mm` or `N/m^1.5`; empty text is the unit of pure numbers.
///
/// # Errors
/// Anything that is not a unit.
pub fn parse_unit(text: &str) -> Result<Measured, ExpressionError> {
    let tokens = tokens(text)?;
    let mut parser =
        Parser { text, tokens: &tokens, next: 0, ops: Vec::new(), reads: Vec::new(), names: &NoNames, depth: 0 };
    let unit = parser.unit()?;
    parser.end()?;
    Ok(Measured { value_si: unit.to_si(1.0, "1"), dimension: unit.dimension })
}

pub(super) struct Parser<'a> {
    pub(super) text: &'a str,
    tokens: &'a [Token],
    pub(super) next: usize,
    ops: Vec<Op>,
    reads: Vec<usize>,
    pub(super) names: &'a dyn Names,
    depth: usize,
}

impl Parser<'_> {
    pub(super) fn peek(&self) -> &TokenKind {
        self.ahead(0)
    }

    pub(super) fn ahead(&self, count: usize) -> &TokenKind {
        self.tokens.get(self.next + count).map_or(&TokenKind::End, |token| &token.kind)
    }

    pub(super) fn span(&self) -> Range<usize> {
        self.tokens.get(self.next).map_or(0..0, |token| token.span.clone())
    }

    pub(super) fn is_sign(&self, sign: char) -> bool {
        *self.peek() == TokenKind::Sign(sign)
    }

    pub(super) fn take_sign(&mut self, sign: char) -> bool {
        let found = self.is_sign(sign);
        self.next += usize::from(found);
        found
    }

    pub(super) fn error(&self, problem: ExpressionProblem, span: Range<usize>) -> ExpressionError {
        ExpressionError { problem, span }
    }

    pub(super) fn unexpected(&self, expected: &'static str) -> ExpressionError {
        let found = match self.peek() {
            TokenKind::Number(value) => format!("the number {}", super::format_number(*value)),
            TokenKind::Word(word) => format!("'{word}'"),
            TokenKind::Superscript(exponent) => format!("the exponent {exponent}"),
            TokenKind::Sign(sign) => format!("'{sign}'"),
            TokenKind::End => "the end of the value".to_owned(),
        };
        self.error(ExpressionProblem::Unexpected { found, expected }, self.span())
    }

    fn end(&self) -> Result<(), ExpressionError> {
        match self.peek() {
            TokenKind::End => Ok(()),
            _ => Err(self.unexpected("an operator or the end")),
        }
    }

    fn deeper(&mut self) -> Result<(), ExpressionError> {
        self.depth += 1;
        if self.depth > DEEPEST_NESTING {
            Err(self.error(ExpressionProblem::TooDeep { limit: DEEPEST_NESTING }, self.span()))
        } else {
            Ok(())
        }
    }

    fn same(
        &self,
        operation: &'static str,
        first: Dimension,
        second: Dimension,
        span: Range<usize>,
    ) -> Result<Dimension, ExpressionError> {
        if first == second {
            Ok(first)
        } else {
            Err(self.error(ExpressionProblem::MixedDimensions { operation, first, second }, span))
        }
    }

    fn sum(&mut self) -> Result<Dimension, ExpressionError> {
        let mut dimension = self.product()?;
        loop {
            let span = self.span();
            let (op, operation) = if self.take_sign('+') {
                (Op::Add, "+")
            } else if self.take_sign('-') {
                (Op::Subtract, "-")
            } else {
                return Ok(dimension);
            };
            let second = self.product()?;
            dimension = self.same(operation, dimension, second, span)?;
            self.ops.push(op);
        }
    }

    fn product(&mut self) -> Result<Dimension, ExpressionError> {
        let mut dimension = self.signed()?;
        loop {
            let span = self.span();
            let op = if self.take_sign('*') {
                Op::Multiply
            } else if self.take_sign('/') {
                Op::Divide
            } else {
                return Ok(dimension);
            };
            let second = self.signed()?;
            dimension = if op == Op::Multiply { dimension.times(second) } else { dimension.over(second) };
            self.check_finite(dimension, span)?;
            self.ops.push(op);
        }
    }

    pub(super) fn check_finite(&self, dimension: Dimension, span: Range<usize>) -> Result<(), ExpressionError> {
        if dimension.is_finite() {
            Ok(())
        } else {
            Err(self.error(ExpressionProblem::NotFinite { value: f64::INFINITY }, span))
        }
    }

    fn signed(&mut self) -> Result<Dimension, ExpressionError> {
        if self.take_sign('-') {
            self.deeper()?;
            let dimension = self.signed()?;
            self.depth -= 1;
            self.ops.push(Op::Negate);
            Ok(dimension)
        } else if self.take_sign('+') {
            self.deeper()?;
            let dimension = self.signed()?;
            self.depth -= 1;
            Ok(dimension)
        } else {
            self.power()
        }
    }

    fn power(&mut self) -> Result<Dimension, ExpressionError> {
        let base_start = self.ops.len();
        let base = self.primary()?;
        let span = self.span();
        if !self.take_sign('^') {
            return Ok(base);
        }
        let exponent_start = self.ops.len();
        self.deeper()?;
        let exponent = self.signed()?;
        self.depth -= 1;
        if !exponent.is_number() {
            let problem =
                ExpressionProblem::WrongArgument { function: "an exponent", due: Dimension::NUMBER, found: exponent };
            return Err(self.error(problem, span));
        }
        let dimension = if base.is_number() {
            base
        } else {
            let exponent_ops = &self.ops[exponent_start..];
            if exponent_ops.iter().any(|op| matches!(op, Op::Load(_))) {
                return Err(self.error(ExpressionProblem::ExponentNotFixed { base }, span));
            }
            let dimension = base.power(run(exponent_ops, &mut []));
            self.check_finite(dimension, span.clone())?;
            dimension
        };
        let bounds = [base_start, exponent_start, self.ops.len()];
        if let [Some(number), Some(exponent)] = [[0, 1], [1, 2]].map(|[from, to]| self.known(bounds[from]..bounds[to]))
        {
            let is_whole = exponent == exponent.round();
            if (number < 0.0 && !is_whole) || (number == 0.0 && exponent < 0.0) {
                let problem = ExpressionProblem::NoPower { value_si: number, dimension: base, exponent };
                return Err(self.error(problem, span));
            }
        }
        self.ops.push(Op::Power);
        Ok(dimension)
    }

    /// The value of a range of the operations, where it depends on no name.
    fn known(&self, range: Range<usize>) -> Option<f64> {
        let ops = &self.ops[range];
        (!ops.iter().any(|op| matches!(op, Op::Load(_)))).then(|| run(ops, &mut []))
    }

    fn primary(&mut self) -> Result<Dimension, ExpressionError> {
        let span = self.span();
        match self.peek().clone() {
            TokenKind::Number(value) => {
                self.next += 1;
                let unit = self.unit()?;
                let value_si = unit.to_si(value, &self.text[span.clone()]);
                if !value_si.is_finite() {
                    return Err(self.error(ExpressionProblem::NotFinite { value: value_si }, span));
                }
                self.ops.push(Op::Number(value_si));
                Ok(unit.dimension)
            }
            TokenKind::Word(word) => {
                if *self.ahead(1) == TokenKind::Sign('(')
                    && let Some(function) = FUNCTIONS.iter().find(|function| function.name == word)
                {
                    self.next += 2;
                    self.call(function, span)
                } else if word == "pi" {
                    self.next += 1;
                    self.ops.push(Op::Number(std::f64::consts::PI));
                    Ok(Dimension::NUMBER)
                } else {
                    self.name(word, span)
                }
            }
            TokenKind::Sign('(') => {
                self.next += 1;
                self.deeper()?;
                let dimension = self.sum()?;
                self.depth -= 1;
                if self.take_sign(')') { Ok(dimension) } else { Err(self.unexpected("')'")) }
            }
            _ => Err(self.unexpected("a number with its unit, a parameter or '('")),
        }
    }

    fn name(&mut self, name: String, span: Range<usize>) -> Result<Dimension, ExpressionError> {
        if let Some((slot, dimension)) = self.names.find(&name) {
            self.next += 1;
            self.ops.push(Op::Load(slot));
            if !self.reads.contains(&slot) {
                self.reads.push(slot);
            }
            return Ok(dimension);
        }
        let problem = if find_unit(&name).is_some() {
            ExpressionProblem::UnitWithoutNumber { symbol: name }
        } else if is_function(&name) {
            ExpressionProblem::Unexpected {
                found: format!("'{name}' without values"),
                expected: "'(' after a function",
            }
        } else if !self.names.are_allowed() {
            ExpressionProblem::NameNotAllowed { name }
        } else {
            let functions = FUNCTIONS.iter().map(|function| function.name);
            let is_called = *self.ahead(1) == TokenKind::Sign('(');
            let known = is_called.then(|| functions.clone().map(str::to_owned).collect());
            let elsewhere = OTHER_NAMES.iter().find(|(other, _)| *other == name).map(|(_, here)| *here);
            // Whoever reports a name does so once: a chain of a thousand parameters, of which the last is wrong, is not searched for each.
            let is_searched = !self.names.is_reported(&name);
            let similar = || is_searched.then(|| nearest_name(&name, self.names.all().chain(functions))).flatten();
            let nearest = elsewhere.or_else(similar).map(str::to_owned);
            ExpressionProblem::UnknownName { name, known, nearest, example: None }
        };
        Err(self.error(problem, span))
    }

    fn call(&mut self, function: &Function, span: Range<usize>) -> Result<Dimension, ExpressionError> {
        self.deeper()?;
        let start = self.ops.len();
        let mut arguments = vec![self.sum()?];
        while self.take_sign(',') {
            arguments.push(self.sum()?);
        }
        self.depth -= 1;
        if !self.take_sign(')') {
            return Err(self.unexpected("')'"));
        }
        if arguments.len() != function.arguments {
            let problem = ExpressionProblem::WrongArgumentCount {
                function: function.name,
                due: function.arguments,
                given: arguments.len(),
            };
            return Err(self.error(problem, span));
        }
        let needs = |due: Dimension| {
            if arguments[0] == due {
                Ok(())
            } else {
                let problem = ExpressionProblem::WrongArgument { function: function.name, due, found: arguments[0] };
                Err(self.error(problem, span.clone()))
            }
        };
        let dimension = match function.kind {
            FunctionKind::OfAngle => needs(Dimension::ANGLE).map(|()| Dimension::NUMBER)?,
            FunctionKind::ToAngle => needs(Dimension::NUMBER).map(|()| Dimension::ANGLE)?,
            FunctionKind::OfNumber => needs(Dimension::NUMBER).map(|()| Dimension::NUMBER)?,
            FunctionKind::Root => arguments[0].power(0.5),
            FunctionKind::Keeps => match arguments.get(1) {
                Some(second) => self.same(function.name, arguments[0], *second, span.clone())?,
                None => arguments[0],
            },
            FunctionKind::TwoToAngle => {
                let second = arguments.get(1).copied().unwrap_or(arguments[0]);
                self.same(function.name, arguments[0], second, span.clone())?;
                Dimension::ANGLE
            }
        };
        if let Some(argument) = self.known(start..self.ops.len())
            && let Some(rule) = broken_rule(function.op, argument)
        {
            let problem = ExpressionProblem::OutsideDomain {
                function: function.name,
                value_si: argument,
                dimension: arguments[0],
                rule,
            };
            return Err(self.error(problem, span));
        }
        self.ops.push(function.op);
        Ok(dimension)
    }
}

/// Why a function has no value at `argument`: where it must be, in words to follow "must be". `None` if it has one.
fn broken_rule(op: Op, argument: f64) -> Option<&'static str> {
    let (keeps, rule) = match op {
        Op::Logarithm => (argument > 0.0, "> 0"),
        Op::SquareRoot => (argument >= 0.0, ">= 0"),
        Op::ArcSine | Op::ArcCosine => (argument.abs() <= 1.0, "in [-1, 1]"),
        _ => return None,
    };
    (!keeps).then_some(rule)
}

/// Whether a parameter may be called so: letters, digits and `_`, not beginning with a digit, no unit, no function.
pub fn is_parameter_name(name: &str) -> bool {
    name.chars().next().is_some_and(|first| begins_word(first) && first != '%' && first != '°')
        && name.chars().all(|character| character.is_alphanumeric() || character == '_')
        && !is_reserved_name(name)
}
