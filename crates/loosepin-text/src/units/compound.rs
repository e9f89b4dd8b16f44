//! Products, quotients and powers of units behind a number.

use super::lexer::TokenKind;
use super::parser::{Parser, is_function};
use super::{Dimension, ExpressionError, ExpressionProblem, UNITS, find_unit};
use crate::diagnostics::nearest_name;

/// A product of units: SI value of one as a fraction, and dimension.
#[derive(Clone, Copy)]
pub(super) struct UnitProduct {
    numerator: f64,
    denominator: f64,
    pub dimension: Dimension,
}

impl UnitProduct {
    const ONE: UnitProduct = UnitProduct { numerator: 1.0, denominator: 1.0, dimension: Dimension::NUMBER };

    /// `value`, written as `text`, in SI. Where the unit is a power of ten the point is moved before rounding, so that
    /// `0.03 mm` and `3e-5 m` are the same number.
    pub fn to_si(self, value: f64, text: &str) -> f64 {
        let plain = value * self.numerator / self.denominator;
        let Some((over, under)) = decimal_exponent(self.numerator).zip(decimal_exponent(self.denominator)) else {
            return plain;
        };
        let (digits, exponent) = match text.split_once(['e', 'E']) {
            Some((digits, exponent)) => (digits, exponent.parse::<i32>().ok()),
            None => (text, Some(0)),
        };
        exponent
            .and_then(|exponent| exponent.checked_add(over - under))
            .and_then(|exponent| format!("{digits}e{exponent}").parse().ok())
            .unwrap_or(plain)
    }

    fn times(self, other: UnitProduct) -> UnitProduct {
        UnitProduct {
            numerator: self.numerator * other.numerator,
            denominator: self.denominator * other.denominator,
            dimension: self.dimension.times(other.dimension),
        }
    }

    fn over(self, other: UnitProduct) -> UnitProduct {
        UnitProduct {
            numerator: self.numerator * other.denominator,
            denominator: self.denominator * other.numerator,
            dimension: self.dimension.over(other.dimension),
        }
    }

    fn power(self, exponent: f64) -> UnitProduct {
        let power = |base: f64, exponent: f64| if base == 1.0 { 1.0 } else { libm::pow(base, exponent) };
        let (numerator, denominator) = if exponent < 0.0 {
            (power(self.denominator, -exponent), power(self.numerator, -exponent))
        } else {
            (power(self.numerator, exponent), power(self.denominator, exponent))
        };
        UnitProduct { numerator, denominator, dimension: self.dimension.power(exponent) }
    }
}

/// k where `factor` is exactly 10^k, for the k whose powers a double holds exactly.
fn decimal_exponent(factor: f64) -> Option<i32> {
    const MAX_EXACT: i32 = 22;
    (0..=MAX_EXACT).find(|exponent| 10_f64.powi(*exponent) == factor)
}

impl Parser<'_> {
    /// The unit behind a number, one if there is none.
    pub(super) fn unit(&mut self) -> Result<UnitProduct, ExpressionError> {
        let start = self.span().start;
        // `12e-6 1/K`; turns a minute are rpm. A word that is no unit was meant as one.
        let is_inverse = *self.peek() == TokenKind::Number(1.0)
            && *self.ahead(1) == TokenKind::Sign('/')
            && matches!(self.ahead(2), TokenKind::Word(word) if word != "min" && self.names.find(word).is_none());
        self.next += usize::from(is_inverse);
        if !is_inverse && !self.unit_begins(0) {
            return match self.peek() {
                // A word right behind a number was meant as a unit, unless it is a parameter that lacks its operator.
                TokenKind::Word(word) if self.names.find(word).is_none() => Err(self.unknown_unit(word)),
                TokenKind::Word(_) => Err(self.unexpected("an operator or a unit")),
                _ => Ok(UnitProduct::ONE),
            };
        }
        let mut product = if is_inverse { UnitProduct::ONE } else { self.unit_factor()? };
        let mut divided = false;
        loop {
            if self.unit_begins(0) || (self.is_sign('*') && self.unit_begins(1)) {
                if divided {
                    let span = start..self.span().end;
                    let unit = self.text.get(span.clone()).unwrap_or_default().to_owned();
                    return Err(self.error(ExpressionProblem::AmbiguousUnit { unit }, span));
                }
                self.take_sign('*');
                product = product.times(self.unit_factor()?);
            } else if self.is_sign('/') && (self.unit_begins(1) || is_inverse && !divided) {
                self.next += 1;
                divided = true;
                product = product.over(self.unit_factor()?);
            } else if self.is_sign('/') && *self.ahead(1) == TokenKind::Sign('(') && self.unit_begins(2) {
                self.next += 2;
                divided = true;
                let mut group = self.unit_factor()?;
                while self.unit_begins(0) || (self.is_sign('*') && self.unit_begins(1)) {
                    self.take_sign('*');
                    group = group.times(self.unit_factor()?);
                }
                if !self.take_sign(')') {
                    return Err(self.unexpected("')' behind the unit"));
                }
                product = product.over(group);
            } else if let TokenKind::Word(word) = self.peek()
                && self.names.find(word).is_none()
            {
                return Err(self.unknown_unit(word));
            } else {
                return Ok(product);
            }
        }
    }

    fn unknown_unit(&self, symbol: &str) -> ExpressionError {
        let nearest = nearest_name(symbol, UNITS.iter().map(|unit| unit.symbol)).map(str::to_owned);
        self.error(ExpressionProblem::UnknownUnit { symbol: symbol.to_owned(), nearest }, self.span())
    }

    fn unit_begins(&self, ahead: usize) -> bool {
        match self.ahead(ahead) {
            // `min(` is the function.
            TokenKind::Word(word) if *self.ahead(ahead + 1) == TokenKind::Sign('(') => {
                find_unit(word).is_some() && !is_function(word)
            }
            TokenKind::Word(word) => find_unit(word).is_some(),
            _ => false,
        }
    }

    fn unit_factor(&mut self) -> Result<UnitProduct, ExpressionError> {
        let TokenKind::Word(word) = self.peek() else { return Err(self.unexpected("a unit")) };
        let Some(unit) = find_unit(word) else { return Err(self.unknown_unit(word)) };
        let (numerator, denominator) = unit.factor();
        let product = UnitProduct { numerator, denominator, dimension: unit.dimension };
        self.next += 1;
        let span = self.span();
        let raised = match *self.peek() {
            TokenKind::Superscript(exponent) => {
                self.next += 1;
                product.power(exponent)
            }
            TokenKind::Sign('^') => {
                self.next += 1;
                product.power(self.unit_exponent()?)
            }
            _ => product,
        };
        self.check_finite(raised.dimension, span.clone())?;
        if raised.numerator.is_finite() && raised.denominator.is_finite() && raised.denominator > 0.0 {
            Ok(raised)
        } else {
            Err(self.error(ExpressionProblem::NotFinite { value: f64::INFINITY }, span))
        }
    }

    fn unit_exponent(&mut self) -> Result<f64, ExpressionError> {
        const EXPECTED: &str = "the exponent of a unit, for example 2, -1, 1.5 or (3/2)";
        let in_parentheses = self.take_sign('(');
        let negative = self.take_sign('-');
        let TokenKind::Number(mut exponent) = *self.peek() else { return Err(self.unexpected(EXPECTED)) };
        self.next += 1;
        if in_parentheses {
            if self.take_sign('/') {
                let TokenKind::Number(divisor) = *self.peek() else { return Err(self.unexpected(EXPECTED)) };
                self.next += 1;
                exponent /= divisor;
            }
            if !self.take_sign(')') {
                return Err(self.unexpected("')'"));
            }
        }
        Ok(if negative { -exponent } else { exponent })
    }
}
