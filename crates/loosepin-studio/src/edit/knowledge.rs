//! How well a number is known, as people write it: `50 mm`, `±0.05`, `+0.02 -0.01`, `0.1..0.5 mm`, `H7/g6`, `0.1, 0.2 mm`.

use loosepin::diagnostics::Problem;
use loosepin::units::{Dimension, parse_quantity};

use crate::refusal::Refusal;

const FORMS: &str =
    "for example 50 mm, ±0.05 mm, +0.02 -0.01 mm, sd 0.03 mm, uniform ±0.1 mm, 0.1..0.5 mm, H7/g6, or 0.1, 0.2 mm";

/// How well a number is known. Values are as a file writes them: `"0.1 mm"` with its quotes, or a bare number.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Knowledge {
    /// Its value, and nothing else.
    Exact(String),
    /// A value with its limits, as on a drawing; without a value before them the limits are around that of the model.
    Tolerance(String),
    /// A standard deviation about the value of the model.
    StandardDeviation(String),
    /// Evenly within so much of the value of the model: the number and its unit.
    Uniform { half: String, unit: String },
    /// Anything between two ends.
    Interval([String; 2]),
    /// One of some values.
    OneOf(Vec<String>),
    /// A fit by ISO 286.
    Fit(String),
}

/// A number with its unit.
type Piece = (String, String);

/// Reads how well a number of this dimension is known. A number without a unit has the last unit beside it, or else `unit`.
///
/// # Errors
/// What cannot be read, and what is expected.
pub fn knowledge(text: &str, dimension: Dimension, unit: &str) -> Result<Knowledge, Refusal> {
    let text = with_points(text.trim())?;
    let text = text.replace('−', "-").replace("+/-", "±").replace("+-", "±").replace(['…', '–'], "..");
    if text.is_empty() {
        return Err(Refusal::bad("nothing is written").with_hint(FORMS));
    }
    if is_fit(&text) {
        return Ok(Knowledge::Fit(text));
    }
    let read = |parts: &[&str]| pieces(parts, dimension, unit);
    if let Some(rest) = text.strip_prefix("sd ") {
        let [piece] = &read(&[rest])?[..] else { return Err(unread(&text)) };
        return Ok(Knowledge::StandardDeviation(quoted(piece)));
    }
    if let Some(rest) = text.strip_prefix("uniform") {
        let rest = rest.trim().strip_prefix('±').ok_or_else(|| unread(&text))?;
        let [(half, unit)] = &read(&[rest])?[..] else { return Err(unread(&text)) };
        return Ok(Knowledge::Uniform { half: half.clone(), unit: unit.clone() });
    }
    if let Some((lower, upper)) = text.split_once("..").or_else(|| text.split_once(" to ")) {
        let [lower, upper] = &read(&[lower.trim_end_matches('.'), upper.trim_start_matches('.')])?[..] else {
            return Err(unread(&text));
        };
        return Ok(Knowledge::Interval([quoted(lower), quoted(upper)]));
    }
    if text.contains('±') || (text.contains('+') && text.contains('-')) {
        return tolerance(&text, unit).map(Knowledge::Tolerance).ok_or_else(|| unread(&text));
    }
    let parts: Vec<&str> = text.split(',').collect();
    let values: Vec<String> = read(&parts)?.iter().map(quoted).collect();
    Ok(match <[String; 1]>::try_from(values) {
        Ok([value]) => Knowledge::Exact(value),
        Err(values) => Knowledge::OneOf(values),
    })
}

fn unread(text: &str) -> Refusal {
    Refusal::bad(format!("'{text}' cannot be read")).with_hint(FORMS)
}

/// Decimal commas as points. A comma before three digits may separate thousands: it is refused.
fn with_points(text: &str) -> Result<String, Refusal> {
    let letters: Vec<char> = text.chars().collect();
    let is_digit = |index: Option<usize>| index.and_then(|index| letters.get(index)).is_some_and(char::is_ascii_digit);
    let mut with_points = String::new();
    for (index, letter) in letters.iter().enumerate() {
        let is_inside = *letter == ',' && is_digit(index.checked_sub(1)) && is_digit(Some(index + 1));
        if is_inside && (1..=3).all(|step| is_digit(Some(index + step))) && !is_digit(Some(index + 4)) {
            return Err(Refusal::bad(format!("the comma in '{text}' can mean a fraction or thousands")).with_hint(
                "write a point for a fraction, and nothing for thousands; a list has a space after each comma",
            ));
        }
        with_points.push(if is_inside { '.' } else { *letter });
    }
    Ok(with_points)
}

fn is_fit(text: &str) -> bool {
    let Some((hole, shaft)) = text.split_once('/') else { return false };
    let zone = |part: &str, is_letter: fn(&char) -> bool| {
        let letters = part.chars().take_while(is_letter).count();
        let grade = &part[letters.min(part.len())..];
        letters > 0 && !grade.is_empty() && grade.chars().all(|c| c.is_ascii_digit())
    };
    zone(hole.trim(), char::is_ascii_uppercase) && zone(shaft.trim(), char::is_ascii_lowercase)
}

/// The numbers of some parts, each with its unit.
fn pieces(parts: &[&str], dimension: Dimension, unit: &str) -> Result<Vec<Piece>, Refusal> {
    let split: Vec<(&str, &str)> = parts.iter().map(|part| number_and_unit(part)).collect();
    let last = split.iter().rev().map(|(_, unit)| *unit).find(|unit| !unit.is_empty()).unwrap_or(unit);
    let read = |(number, own): (&str, &str)| {
        let unit = if own.is_empty() { last } else { own };
        let text = format!("{number} {unit}");
        let text = text.trim();
        let is_number = number.parse::<f64>().is_ok_and(f64::is_finite);
        if !is_number {
            return Err(unread(text));
        }
        let found = parse_quantity(text).map_err(|error| {
            let problem = error.for_due(text, dimension).problem;
            Refusal { hint: problem.hint(), ..Refusal::bad(problem.to_string()) }
        })?;
        if found.dimension == dimension {
            Ok((number.to_owned(), unit.to_owned()))
        } else {
            Err(Refusal::bad(format!("'{text}' is {}; expected {dimension}", found.dimension)))
        }
    };
    split.into_iter().map(read).collect()
}

fn number_and_unit(part: &str) -> (&str, &str) {
    let part = part.trim();
    let is_number = |c: char| matches!(c, '0'..='9' | '.' | '-' | '+' | 'e' | 'E');
    let end = part.find(|c: char| !is_number(c)).unwrap_or(part.len());
    (part[..end].trim(), part[end..].trim())
}

/// A value as a file has it.
fn quoted((number, unit): &Piece) -> String {
    if unit.is_empty() { number.clone() } else { format!("\"{number} {unit}\"") }
}

/// Limits with a unit at their end; what stands in them is read where the file is.
fn tolerance(text: &str, unit: &str) -> Option<String> {
    let is_plain = |c: char| c.is_alphanumeric() || matches!(c, ' ' | '.' | '+' | '-' | '±' | '/' | '°');
    let has_unit = text.trim_end().ends_with(|c: char| c.is_alphabetic() || c == '°');
    text.chars()
        .all(is_plain)
        .then(|| if has_unit || unit.is_empty() { text.to_owned() } else { format!("{text} {unit}") })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn length(text: &str) -> Result<Knowledge, String> {
        knowledge(text, Dimension::LENGTH, "mm").map_err(|refusal| refusal.message)
    }

    #[test]
    fn what_people_write_is_read() {
        let interval = |lower: &str, upper: &str| Ok(Knowledge::Interval([lower.into(), upper.into()]));
        assert_eq!(length("50"), Ok(Knowledge::Exact("\"50 mm\"".into())));
        assert_eq!(length("2 in"), Ok(Knowledge::Exact("\"2 in\"".into())));
        for text in
            ["0.1..0.5 mm", "0.1 .. 0.5", "0,1..0,5 mm", "0.1 to 0.5 mm", "0.1…0.5 mm", "0.1–0.5", "0.1 mm..0.5 mm"]
        {
            assert_eq!(length(text), interval("\"0.1 mm\"", "\"0.5 mm\""), "{text}");
        }
        for text in ["±0.05", "± 0.05 mm", "+/-0.05 mm"] {
            let Ok(Knowledge::Tolerance(found)) = length(text) else { panic!("{text}") };
            assert_eq!(found.replace("± ", "±"), "±0.05 mm", "{text}");
        }
        assert_eq!(length("+0.02 -0.01"), Ok(Knowledge::Tolerance("+0.02 -0.01 mm".into())));
        assert_eq!(length("120 ± 0.1 mm"), Ok(Knowledge::Tolerance("120 ± 0.1 mm".into())));
        assert_eq!(length("sd 0.03"), Ok(Knowledge::StandardDeviation("\"0.03 mm\"".into())));
        assert_eq!(length("uniform ±0.1"), Ok(Knowledge::Uniform { half: "0.1".into(), unit: "mm".into() }));
        assert_eq!(length("H7/g6"), Ok(Knowledge::Fit("H7/g6".into())));
        assert_eq!(length("0.1, 0.2 mm"), Ok(Knowledge::OneOf(vec!["\"0.1 mm\"".into(), "\"0.2 mm\"".into()])));
        let number = knowledge("0.7..0.9", Dimension::NUMBER, "").map_err(|refusal| refusal.message);
        assert_eq!(number, interval("0.7", "0.9"));
    }

    #[test]
    fn what_cannot_be_read_is_refused_with_words() {
        for (text, words) in [
            ("", "nothing is written"),
            ("1,000 mm", "the comma in '1,000 mm' can mean a fraction or thousands"),
            ("0.1..0.5 mn", "'mn' is not a known unit"),
            ("3 kg", "'3 kg' is a mass; expected a length"),
            ("about 3", "'about 3'"),
            ("±\"]\n[x]", "cannot be read"),
            ("uniform 3", "'uniform 3' cannot be read"),
        ] {
            let found = length(text).expect_err(text);
            assert!(found.contains(words), "{text}: {found}");
        }
    }
}
