//! Errors in the text of a value.

use std::ops::Range;

use thiserror::Error;

use super::{Dimension, LONGEST_EXPRESSION_CHARS};
use crate::diagnostics::{Code, Problem};

/// A problem in the text of a value, and where in that text it is.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("{problem}")]
pub struct ExpressionError {
    /// The error.
    pub problem: ExpressionProblem,
    /// Byte range within the text.
    pub span: Range<usize>,
}

/// An error in the text of a value.
#[derive(Debug, Clone, PartialEq, Error)]
#[allow(missing_docs, reason = "the text of an error says what it is, and names its fields")]
pub enum ExpressionProblem {
    #[error("the value is empty")]
    Empty,
    #[error("the expression has {length_chars} characters; at most {LONGEST_EXPRESSION_CHARS} are read")]
    TooLong { length_chars: usize },
    #[error("the expression is nested more than {limit} deep")]
    TooDeep { limit: usize },
    #[error("'{character}' does not belong in a value")]
    UnexpectedCharacter { character: char },
    #[error("'{text}' is not a number")]
    BadNumber { text: String },
    #[error("the number {text} is too large; at most 1.8e308 can be held")]
    NumberTooLarge { text: String },
    #[error("found {found}; expected {expected}")]
    Unexpected { found: String, expected: &'static str },
    #[error("'{symbol}' is not a known unit")]
    UnknownUnit { symbol: String, nearest: Option<String> },
    #[error("the unit '{symbol}' has no number before it")]
    UnitWithoutNumber { symbol: String },
    #[error("the unit '{unit}' can be read in two ways")]
    AmbiguousUnit { unit: String },
    #[error("there is no parameter '{name}'")]
    UnknownName { name: String, nearest: Option<String> },
    #[error("'{name}' is a name; expected a number with its unit")]
    NameNotAllowed { name: String },
    #[error("{function} takes {due} value(s); {given} given")]
    WrongArgumentCount { function: &'static str, due: usize, given: usize },
    #[error("{operation} needs two values of one dimension; the first is {first}, the second {second}")]
    MixedDimensions { operation: &'static str, first: Dimension, second: Dimension },
    #[error("{function} needs {due}; found {found}")]
    WrongArgument { function: &'static str, due: Dimension, found: Dimension },
    #[error("the exponent of {base} must be a fixed number")]
    ExponentNotFixed { base: Dimension },
    #[error("the value is {}; must be finite", super::format_number(*.value))]
    NotFinite { value: f64 },
}

/// Abbreviations of turns in speeds elsewhere: U/min, tr/min, ob/min, giri/min, rev/min.
const TURNS_A_MINUTE: [&str; 9] = ["U", "Umdr", "tr", "ob", "giri", "rev", "revs", "turn", "turns"];

impl Problem for ExpressionProblem {
    fn code(&self) -> Code {
        match self {
            Self::Empty
            | Self::UnexpectedCharacter { .. }
            | Self::BadNumber { .. }
            | Self::Unexpected { .. }
            | Self::AmbiguousUnit { .. }
            | Self::UnitWithoutNumber { .. }
            | Self::NameNotAllowed { .. }
            | Self::WrongArgumentCount { .. } => Code::ExpressionSyntax,
            Self::UnknownUnit { .. } => Code::UnknownUnit,
            Self::UnknownName { .. } => Code::UnknownParameter,
            Self::MixedDimensions { .. } | Self::WrongArgument { .. } | Self::ExponentNotFixed { .. } => {
                Code::MixedDimensions
            }
            Self::TooLong { .. } | Self::TooDeep { .. } => Code::ExpressionTooLong,
            Self::NumberTooLarge { .. } | Self::NotFinite { .. } => Code::NotFinite,
        }
    }

    fn hint(&self) -> Option<String> {
        match self {
            Self::Empty => Some("write a number with its unit, for example \"0.5 mm\"".to_owned()),
            Self::Unexpected { found, .. } if found == "','" => {
                Some("decimal numbers have a point, for example \"0.5 mm\"".to_owned())
            }
            Self::UnknownUnit { symbol, .. } if TURNS_A_MINUTE.contains(&symbol.as_str()) => {
                Some("write turns per minute as rpm".to_owned())
            }
            Self::UnknownUnit { nearest: Some(nearest), .. } => Some(format!("did you mean '{nearest}'?")),
            Self::UnknownUnit { .. } => Some(
                "known units include m, mm, µm, kg, g, s, ms, rad, deg, rpm, N, kN, Pa, GPa, J, W; products and powers are \
                 written kg m^2, m/s^2"
                    .to_owned(),
            ),
            Self::UnitWithoutNumber { symbol } => Some(format!("write \"1 {symbol}\" for one of it")),
            Self::AmbiguousUnit { .. } => Some("write parentheses, for example kg/(m s)".to_owned()),
            Self::UnknownName { nearest: Some(nearest), .. } => Some(format!("did you mean '{nearest}'?")),
            Self::UnknownName { name, .. } => Some(format!("define it under [parameter]: {name} = \"...\"")),
            Self::NameNotAllowed { .. } => Some("names of parameters are known in the model file only".to_owned()),
            Self::MixedDimensions { first, second, .. } if first.is_number() || second.is_number() => {
                let example = if first.is_number() { second.example() } else { first.example() };
                example.map(|example| format!("a number needs its unit, for example \"{example}\""))
            }
            Self::WrongArgument { due, found, .. } if *due == Dimension::ANGLE && found.is_number() => {
                Some("an angle needs its unit, for example 30 deg or 0.5 rad".to_owned())
            }
            Self::TooLong { .. } | Self::TooDeep { .. } => {
                Some("give parts of it names under [parameter]".to_owned())
            }
            _ => None,
        }
    }
}
