//! A nominal value with its tolerance where a single value is due: a model holds nominal values, so the message shows the line of the study.

use super::iso_286::class_deviations_m;
use super::written::{SeparateTolerance, number_and_unit, separate_tolerance};
use crate::units::{Dimension, ExpressionError, ExpressionProblem, format_number, parse_quantity};

/// Letters that ISO 286 leaves out, since they look like others.
const NO_LETTERS: [char; 5] = ['i', 'l', 'o', 'q', 'w'];
/// Grades that a unit with its exponent is not taken for: m3 is a volume.
const GRADES: std::ops::RangeInclusive<u8> = 4..=18;
const MM_PER_M: f64 = 1e3;

/// The error in `text`, where a single value of dimension `due`, if that is known, is to stand: where the text is a nominal value with its
/// tolerance, the error is [`ExpressionProblem::Tolerance`], and its hint has the line of the study for the quantity `path`.
#[must_use]
pub fn for_single_value(
    mut error: ExpressionError,
    text: &str,
    due: Option<Dimension>,
    path: Option<&str>,
) -> ExpressionError {
    let (written, separate) = match &error.problem {
        ExpressionProblem::Tolerance { written, .. } => (written.clone(), separate_tolerance(text)),
        ExpressionProblem::MixedDimensions { .. } => match separate_tolerance(text) {
            Some(separate) => (separate.deviations.clone(), Some(separate)),
            None => return error,
        },
        ExpressionProblem::UnknownUnit { symbol, .. } => match limits_of_class(text) {
            Some(separate) if due.is_none_or(|due| due == Dimension::LENGTH) => (symbol.clone(), separate),
            _ => return error,
        },
        _ => return error,
    };
    let line = |separate: SeparateTolerance| {
        let here = separate.nominal.map_or("the nominal value".to_owned(), |nominal| format!("\"{nominal}\""));
        let path = path?;
        let deviations = separate.deviations;
        Some(format!(
            "a model holds nominal values: write {here} here, and in study.toml under [random] \"{path}\" = {{ tolerance = \"{deviations}\" }}"
        ))
    };
    error.problem = ExpressionProblem::Tolerance { written, instead: separate.and_then(line) };
    error
}

/// A size with a tolerance class of ISO 286, such as `30 h9` or `30 mm H7`, told apart with its limits; the inner option is absent where the
/// class is not in the tables, the outer where the text is none.
pub fn limits_of_class(text: &str) -> Option<Option<SeparateTolerance>> {
    let text = text.trim();
    let start = text.char_indices().rev().take_while(|(_, c)| c.is_ascii_alphanumeric()).last()?.0;
    let start = text[start..].find(|c: char| c.is_ascii_alphabetic())? + start;
    let class = &text[start..];
    let (letters, grade) = class.split_at(class.find(|c: char| c.is_ascii_digit())?);
    let is_of_one_case =
        [char::is_ascii_uppercase, char::is_ascii_lowercase].iter().any(|is_case| letters.chars().all(|c| is_case(&c)));
    let is_class = (1..=2).contains(&letters.len())
        && is_of_one_case
        && !letters.chars().any(|c| NO_LETTERS.contains(&c.to_ascii_lowercase()))
        && grade.parse().is_ok_and(|grade| GRADES.contains(&grade));
    let (number, unit) = number_and_unit(&text[..start]).filter(|_| is_class)?;
    let nominal = format!("{number} {}", if unit.is_empty() { "mm" } else { unit });
    let size = parse_quantity(&nominal).ok().filter(|size| size.dimension == Dimension::LENGTH)?;
    Some(class_deviations_m(class, size.value_si).ok().map(|[lower_m, upper_m]| {
        let mm = |value_m: f64| format_number(MM_PER_M * value_m);
        let signed = |value_m: f64| format!("{}{}", if value_m < 0.0 { "" } else { "+" }, mm(value_m));
        let deviations = if lower_m == -upper_m {
            format!("± {} mm", mm(upper_m))
        } else {
            format!("{} {} mm", signed(upper_m), signed(lower_m))
        };
        SeparateTolerance { nominal: Some(nominal), deviations }
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn published_limits_of_classes_as_a_study_has_them() {
        // ISO 286-2, tables of limit deviations, at 30 mm: h9 0/-52 µm, H7 +21/0, js9 ±26, m6 +21/+8; at 20 mm D10 +149/+65.
        for (text, nominal, deviations) in [
            ("30 h9", "30 mm", "+0 -0.052 mm"),
            ("30h9", "30 mm", "+0 -0.052 mm"),
            ("30 mm H7", "30 mm", "+0.021 +0 mm"),
            ("30 js9", "30 mm", "± 0.026 mm"),
            ("0.03 m m6", "0.03 m", "+0.021 +0.008 mm"),
            ("20 D10", "20 mm", "+0.149 +0.065 mm"),
        ] {
            let due = SeparateTolerance { nominal: Some(nominal.to_owned()), deviations: deviations.to_owned() };
            assert_eq!(limits_of_class(text), Some(Some(due)), "{text}");
        }
        assert_eq!(limits_of_class("30 c11"), Some(None), "a class that the tables here do not have");
        for text in
            ["30", "h9", "30 mm", "30 m3", "30 kg m2", "30 Hh7", "30 l7", "30 h19", "3 kg h9", "a h9", "30 mm2", "é9"]
        {
            assert_eq!(limits_of_class(text), None, "{text}");
        }
    }
}
