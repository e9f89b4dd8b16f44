//! A nominal value with its tolerance where a single value is due: a model holds nominal values, so the message shows the line of the study.

use super::iso_286::class_deviations_m;
use super::written::{SeparateTolerance, number_and_unit, separate_tolerance};
use crate::units::{Dimension, ExpressionError, ExpressionProblem, format_number, parse_quantity};

/// Letters of ISO 286, of shafts; those of holes are the same in capitals.
const LETTERS: [&str; 28] = [
    "a", "b", "c", "cd", "d", "e", "ef", "f", "fg", "g", "h", "j", "js", "k", "m", "n", "p", "r", "s", "t", "u", "v",
    "x", "y", "z", "za", "zb", "zc",
];
/// Grades that a unit with its exponent is not taken for: m^3 is a volume, m^4 a second moment of area.
const GRADES: std::ops::RangeInclusive<u8> = 5..=18;
const MM_PER_M: f64 = 1e3;

/// The error in `text`, where a single value of dimension `due`, if that is known, is to stand: where the text is a nominal value with its
/// tolerance, the error is [`ExpressionProblem::Tolerance`], and its hint has the line of the study for the quantity `path`; elsewhere it is as
/// [`ExpressionError::for_due`] has it.
#[must_use]
pub fn for_single_value(
    mut error: ExpressionError,
    text: &str,
    due: Option<Dimension>,
    path: Option<&str>,
) -> ExpressionError {
    let of_due = |error: ExpressionError| match due {
        Some(due) => error.for_due(text, due),
        None => error,
    };
    let (written, separate) = match &error.problem {
        ExpressionProblem::Tolerance { written, .. } => (written.clone(), separate_tolerance(text)),
        ExpressionProblem::MixedDimensions { .. } => match separate_tolerance(text) {
            Some(separate) => (separate.deviations.clone(), Some(separate)),
            None => return of_due(error),
        },
        ExpressionProblem::UnknownUnit { symbol, .. } => match limits_of_class(text) {
            Some(separate) if due.is_none_or(|due| due == Dimension::LENGTH) => (symbol.clone(), separate),
            _ => return of_due(error),
        },
        _ => return of_due(error),
    };
    let line = |separate: SeparateTolerance| {
        let here = separate.nominal.map_or("the nominal value".to_owned(), |nominal| format!("\"{nominal}\""));
        let path = path?;
        let deviations = separate.deviations;
        Some(format!(
            "a model holds nominal values: write {here} here, and in study.toml under [random] \"{path}\" = {{ tolerance = \"{deviations}\" }}"
        ))
    };
    // A line with another dimension than is due would be refused in the study.
    let fitting = separate.filter(|separate| due.is_none_or(|due| due == separate.dimension));
    error.problem = ExpressionProblem::Tolerance { written, instead: fitting.and_then(line) };
    error
}

/// A size with a tolerance class of ISO 286, such as `30 h9` or `30 mm H7`, with its limits; the inner option is absent where the
/// class is not in the tables, the outer where the text is none.
pub fn limits_of_class(text: &str) -> Option<Option<SeparateTolerance>> {
    let text = text.trim();
    let start = text.char_indices().rev().take_while(|(_, c)| c.is_ascii_alphanumeric()).last()?.0;
    let start = text[start..].find(|c: char| c.is_ascii_alphabetic())? + start;
    let class = &text[start..];
    let (letters, grade) = class.split_at(class.find(|c: char| c.is_ascii_digit())?);
    let is_capital = letters.chars().all(|c| c.is_ascii_uppercase());
    let is_known =
        LETTERS.contains(&if is_capital { letters.to_ascii_lowercase() } else { letters.to_owned() }.as_str());
    let is_class = is_known && grade.parse().is_ok_and(|grade| GRADES.contains(&grade));
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
        SeparateTolerance { nominal: Some(nominal), deviations, dimension: Dimension::LENGTH }
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
            let (nominal, deviations) = (Some(nominal.to_owned()), deviations.to_owned());
            let due = SeparateTolerance { nominal, deviations, dimension: Dimension::LENGTH };
            assert_eq!(limits_of_class(text), Some(Some(due)), "{text}");
        }
        assert_eq!(limits_of_class("30 c11"), Some(None), "a class that the tables here do not have");
        for text in [
            "30", "h9", "30 mm", "30 m3", "30 kg m2", "30 Hh7", "30 l7", "30 h19", "3 kg h9", "a h9", "30 mm2", "é9",
            "30 m4", "30 cm4", "30 mm4", "30 Js9", "30 mm6",
        ] {
            assert_eq!(limits_of_class(text), None, "{text}");
        }
    }
}
