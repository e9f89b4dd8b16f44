//! Text with units to SI numbers and back.
//!
//! A value in a file is text such as `"0.5 mm"`, `"5000 rpm"`, `"6.6e10 N/m^1.5"`, or arithmetic over such values and
//! named parameters, `"2 * crank_length + 1 mm"`. One grammar serves both:
//!
//! ```text
//! sum      = product { ("+" | "-") product }
//! product  = power { ("*" | "/") power }                  unary minus binds weaker than "^"
//! power    = primary [ "^" power ]
//! primary  = number [ unit ] | name | "pi" | function "(" sum { "," sum } ")" | "(" sum ")"
//! unit     = factor { ["*"] factor } [ "/" ( factor | "(" factor { ["*"] factor } ")" ) ] ...
//! factor   = symbol [ "^" exponent ]                      exponent: 2, -1, 1.5, (3/2)
//! ```
//!
//! A unit belongs to the number before it, so a parameter cannot bear the name of a unit. Angles are a dimension of
//! their own here (`rad`, `deg`, `rpm`), so that a bare number is never taken for one; SI values are in radians.
//! Factors stand in one table (`unit.rs`); sums, powers and dimensions are checked while reading.

mod compound;
mod dimension;
pub mod display;
mod error;
pub mod extended;
mod format;
mod lexer;
mod listing;
mod number;
mod parser;
mod program;
mod rule;
mod unit;

pub use dimension::Dimension;
pub use display::{DisplayUnit, DisplayUnits, SiUnit};
pub use error::{ExpressionError, ExpressionProblem};
pub use format::{ReadableUnit, format_apart, format_refused, format_value};
pub use listing::{counted, counted_or_no, distinct, duration_words, listed, quoted};
pub use number::{decimal_exponent, format_number, power_of_ten};
pub use parser::{Measured, parse_quantity, parse_unit};
pub use parser::{Names, is_parameter_name, is_reserved_name, parse_expression, referenced_names};
pub use program::LONGEST_EXPRESSION_CHARS;
pub use program::{Expression, Op, run};
pub use rule::Rule;
pub use unit::{UNITS, Unit, find_unit};

#[cfg(test)]
mod tests;
