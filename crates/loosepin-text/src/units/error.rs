//! Errors in the text of a value.

use std::ops::Range;

use thiserror::Error;

use super::{Dimension, LONGEST_EXPRESSION_CHARS, UNITS};
use crate::diagnostics::{Code, nearest_name, problems};

/// A problem in the text of a value, and where in that text it is.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("{problem}")]
pub struct ExpressionError {
    /// The error.
    pub problem: ExpressionProblem,
    /// Byte range within the text.
    pub span: Range<usize>,
}

impl ExpressionError {
    /// The error in `text`, where a value of dimension `due` is to stand: where the unit alone is not known, the hint names one that
    /// measures what is due.
    #[must_use]
    pub fn for_due(mut self, text: &str, due: Dimension) -> Self {
        if let ExpressionProblem::UnknownUnit { symbol, nearest } = &mut self.problem {
            let before = text.trim().strip_suffix(symbol.as_str());
            let is_alone = before.is_some_and(|number| number.trim().parse::<f64>().is_ok());
            let measuring = UNITS.iter().filter(|unit| unit.dimension == due).map(|unit| unit.symbol);
            if let Some(unit) = nearest_name(symbol, measuring).filter(|_| is_alone) {
                *nearest = Some(unit.to_owned());
            }
        }
        let is_turns = due == Dimension::ANGULAR_VELOCITY && text.replace(' ', "").contains("1/min");
        if is_turns && matches!(self.problem, ExpressionProblem::Unexpected { .. }) {
            self.problem = ExpressionProblem::UnknownUnit { symbol: "1/min".to_owned(), nearest: None };
        }
        self
    }

    /// The error where the whole of `text` is a name that stands for nothing: the hint shows what the key takes, `example`.
    #[must_use]
    pub fn for_key(mut self, text: &str, key_example: Option<String>) -> Self {
        if let ExpressionProblem::UnknownName { name, example, .. } = &mut self.problem
            && name == text.trim()
        {
            *example = key_example;
        }
        self
    }
}

problems! {
    /// An error in the text of a value.
    #[derive(Debug, Clone, PartialEq)]
    pub enum ExpressionProblem {
        Empty => Code::ExpressionSyntax,
            says("the value is empty"),
            hint("write a number with its unit, for example \"0.5 mm\"");
        TooLong { length_chars: usize } => Code::ExpressionTooLong,
            says("the expression has {length_chars} characters; must have at most {LONGEST_EXPRESSION_CHARS}"),
            hint("define parts of it under [parameter]");
        TooDeep { limit: usize } => Code::ExpressionTooLong,
            says("the expression is nested more than {limit} levels deep"),
            hint("define parts of it under [parameter]");
        UnexpectedCharacter { character: char } => Code::ExpressionSyntax,
            says("the character '{character}' is not permitted in a value");
        /// A nominal value with its tolerance where a single value is due.
        Tolerance {
            /// The sign, or the tolerance class.
            written: String,
            /// What to write, where that is known.
            instead: Option<String>,
        } => Code::ExpressionSyntax,
            says("'{written}' gives a tolerance; a single value is expected here"),
            hint_of(Some(instead.clone().unwrap_or_else(|| {
                "tolerances stand under [random] in study.toml, for example \"parameter.length\" = { tolerance = \"± 0.05 mm\" }; a \
                 difference is written with - alone"
                    .to_owned()
            })));
        BadNumber { text: String } => Code::ExpressionSyntax,
            says("'{text}' is not a number");
        NumberTooLarge { text: String } => Code::NotFinite,
            says("the number {text} is too large; must be at most 1.8e308");
        Unexpected { found: String, expected: &'static str } => Code::ExpressionSyntax,
            says("found {found}; expected {expected}"),
            hint_of(match found.as_str() {
                "','" => Some("decimal numbers have a point, for example \"0.5 mm\"".to_owned()),
                "'*'" => Some("a power is written with ^, for example length^2".to_owned()),
                _ => None,
            });
        UnknownUnit { symbol: String, nearest: Option<String> } => Code::UnknownUnit,
            says("'{symbol}' is not a known unit"),
            hint_of(Some(match nearest {
                _ if TURNS_A_MINUTE.contains(&symbol.as_str()) => "write turns per minute as rpm".to_owned(),
                _ if CELSIUS.contains(&symbol.as_str()) => {
                    "write temperatures as differences in K: 60 °C is 40 K above the 20 °C of a drawing (ISO 1)".to_owned()
                }
                _ if in_words(symbol).is_some() => {
                    format!("write it as {}", in_words(symbol).unwrap_or_default())
                }
                Some(nearest) => format!("did you mean '{nearest}'?"),
                None => "known units include m, mm, µm, kg, g, s, ms, rad, deg, rpm, N, kN, Pa, GPa, J, W, K; products and \
                         powers are written kg m^2, m/s^2"
                    .to_owned(),
            }));
        UnitWithoutNumber { symbol: String } => Code::ExpressionSyntax,
            says("the unit '{symbol}' has no number before it"),
            hint("write a number before the unit, for example \"1 {symbol}\"");
        AmbiguousUnit { unit: String } => Code::ExpressionSyntax,
            says("the unit '{unit}' can be read in two ways"),
            hint("write parentheses, for example kg/(m s)");
        UnknownName {
            name: String,
            /// The functions there are, where the name stands for one.
            known: Option<Vec<String>>,
            nearest: Option<String>,
            /// An example of the key, with its meaning, if the name stands alone.
            example: Option<String>,
        } => Code::UnknownParameter,
            says("there is no {} '{name}'", if known.is_some() { "function" } else { "parameter" }),
            hint_of(Some(match nearest {
                _ if TENTH_LOGARITHMS.contains(&name.as_str()) => "log is natural; write log(x) / log(10)".to_owned(),
                _ if name == "pow" => "write a power with ^, for example (x / 1 mm)^1.3".to_owned(),
                Some(nearest) => format!("did you mean '{nearest}'?"),
                None => match known {
                    Some(functions) => format!("available: {}", super::listed(functions, "and")),
                    None => match example {
                        Some(example) => format!("for example {example}; '{name}' would be a value under [parameter]"),
                        None => format!("define it under [parameter]: {name} = \"...\""),
                    },
                },
            }));
        NameNotAllowed { name: String } => Code::ExpressionSyntax,
            says("'{name}' is a name; expected a number with its unit"),
            hint("names of parameters can be used only in the model file");
        WrongArgumentCount { function: &'static str, due: usize, given: usize } => Code::ExpressionSyntax,
            says("{function} needs {}; found {given}", super::counted(*due, "value"));
        MixedDimensions { operation: &'static str, first: Dimension, second: Dimension } => Code::MixedDimensions,
            says("{operation} needs two values of one dimension; the first is {first}, the second {second}"),
            hint_of(
                match (first.is_number(), second.is_number()) {
                    (true, _) => second.example(),
                    (_, true) => first.example(),
                    _ => None,
                }
                .map(|example| format!("a number needs its unit, for example \"{example}\""))
            );
        WrongArgument { function: &'static str, due: Dimension, found: Dimension } => Code::MixedDimensions,
            says("{function} needs {due}; found {found}"),
            hint_of((*due == Dimension::ANGLE && found.is_number())
                .then(|| "an angle needs its unit, for example 30 deg or 0.5 rad".to_owned()));
        ExponentNotFixed { base: Dimension } => Code::MixedDimensions,
            says("the exponent of {base} must be a fixed number"),
            hint("a number without a unit can have any exponent, for example (x / 1 mm)^n");
        OutsideDomain { function: &'static str, value_si: f64, dimension: Dimension, rule: &'static str } =>
            Code::NotFinite,
            says("{function} of {}; must be {rule}", in_si(*value_si, *dimension));
        NoPower { value_si: f64, dimension: Dimension, exponent: f64 } => Code::NotFinite,
            says("{} has no power {}", in_si(*value_si, *dimension), super::format_number(*exponent));
        NotFinite { value: f64 } => Code::NotFinite,
            says("the value is {}; must be finite", super::format_number(*value));
    }
}

/// A value with its SI unit.
fn in_si(value_si: f64, dimension: Dimension) -> String {
    format!("{} {}", super::format_number(value_si), dimension.si_unit()).trim_end().to_owned()
}

/// Names of the logarithm with base 10 elsewhere.
const TENTH_LOGARITHMS: [&str; 3] = ["log10", "lg", "lg10"];

/// The symbol of a unit that is written in words.
fn in_words(word: &str) -> Option<&'static str> {
    let word = word.to_lowercase();
    let singular = word.strip_suffix('s').unwrap_or(&word);
    let known = [
        ("gram", "g"),
        ("kilogram", "kg"),
        ("kilo", "kg"),
        ("ton", "t"),
        ("tonne", "t"),
        ("meter", "m"),
        ("metre", "m"),
        ("millimeter", "mm"),
        ("millimetre", "mm"),
        ("micron", "um"),
        ("micrometer", "um"),
        ("micrometre", "um"),
        ("inch", "in"),
        ("second", "s"),
        ("sec", "s"),
        ("minute", "min"),
        ("hour", "h"),
        ("degree", "deg"),
        ("grad", "deg"),
        ("radian", "rad"),
        ("newton", "N"),
        ("pascal", "Pa"),
        ("hertz", "Hz"),
        ("percent", "%"),
        ("kelvin", "K"),
    ];
    known.into_iter().find(|(name, _)| *name == singular).map(|(_, symbol)| symbol)
}

/// Abbreviations of turns in speeds elsewhere: U/min, tr/min, ob/min, giri/min, rev/min.
const TURNS_A_MINUTE: [&str; 10] = ["1/min", "U", "Umdr", "tr", "ob", "giri", "rev", "revs", "turn", "turns"];

/// Ways to write degrees on scales that do not begin at zero.
const CELSIUS: [&str; 6] = ["°C", "degC", "C", "Celsius", "celsius", "degF"];
