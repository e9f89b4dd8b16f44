//! How well a number is known, as people write it: `50 mm`, `±0.05`, `+0.02 -0.01`, `0.1..0.5 mm`, `H7/g6`, `0.1, 0.2 mm`.

use loosepin::diagnostics::Problem;
use loosepin::study::{number_and_unit, signed_parts};
use loosepin::units::{Dimension, format_number, parse_quantity};

use crate::network::refusal::Refusal;

const FORMS: &str =
    "for example 50 mm, ±0.05 mm, +0.02 -0.01 mm, sd 0.03 mm, uniform ±0.1 mm, 0.1..0.5 mm, H7/g6, or 0.1, 0.2 mm";

/// A number with its unit; the unit is empty for a plain number.
#[derive(Debug, Clone, PartialEq)]
pub struct WrittenQuantity {
    /// As it stands in a file.
    pub number: String,
    /// As it is written.
    pub unit: String,
    /// SI.
    pub value_si: f64,
}

impl WrittenQuantity {
    /// A value as a file has it: `"0.1 mm"` with its quotes, or a bare number.
    pub fn quoted(&self) -> String {
        if self.unit.is_empty() { self.number.clone() } else { format!("\"{self}\"") }
    }
}

impl std::fmt::Display for WrittenQuantity {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let space = if self.unit.is_empty() { "" } else { " " };
        write!(formatter, "{}{space}{}", self.number, self.unit)
    }
}

/// How well a number is known.
#[derive(Debug, Clone, PartialEq)]
pub enum UncertaintySpec {
    /// Its value, and nothing else.
    Exact(WrittenQuantity),
    /// A value with its limits, as on a drawing: the nominal value, where it is written, and the limits.
    Tolerance(Option<WrittenQuantity>, String),
    /// A standard deviation about the value of the model.
    StandardDeviation(WrittenQuantity),
    /// Uniform within this distance of the value of the model.
    Uniform(WrittenQuantity),
    /// Anything between two ends.
    Interval([WrittenQuantity; 2]),
    /// One of some values.
    OneOf(Vec<WrittenQuantity>),
    /// A fit by ISO 286.
    Fit(String),
}

/// Reads how well a number of this dimension is known. A number without a unit has that of the next one with a unit, or of the one
/// before, or else `unit`.
///
/// # Errors
/// What cannot be read, and what is expected.
pub fn uncertainty_spec(text: &str, dimension: Dimension, unit: &str) -> Result<UncertaintySpec, Refusal> {
    let text = with_points(text.replace(['\u{a0}', '\u{202f}'], " ").trim())?;
    let text = text.replace('−', "-").replace("+/-", "±").replace("+-", "±").replace(['…', '–'], "..");
    if text.is_empty() {
        return Err(Refusal::bad("nothing is written").with_hint(FORMS));
    }
    if is_fit(&text) {
        return Ok(UncertaintySpec::Fit(text));
    }
    let read = |parts: &[&str]| pieces(parts, dimension, unit);
    let only = |part: &str| Ok(read(&[part])?.swap_remove(0));
    if let Some(rest) = text.strip_prefix("sd ") {
        return Ok(UncertaintySpec::StandardDeviation(only(rest)?));
    }
    if let Some(rest) = text.strip_prefix("uniform") {
        let rest = rest.trim().strip_prefix('±').ok_or_else(|| unread(&text))?;
        return Ok(UncertaintySpec::Uniform(only(rest)?));
    }
    if let Some((lower, upper)) = ends(&text)? {
        let [lower, upper] = <[WrittenQuantity; 2]>::try_from(read(&[lower, upper])?).map_err(|_| unread(&text))?;
        return Ok(UncertaintySpec::Interval([lower, upper]));
    }
    if let Some((nominal, half)) = text.split_once('±') {
        let has_nominal = !nominal.trim().is_empty();
        let mut read = if has_nominal { read(&[nominal, half])? } else { read(&[half])? };
        let limits = format!("± {}", read.pop().ok_or_else(|| unread(&text))?);
        return Ok(UncertaintySpec::Tolerance(read.pop(), limits));
    }
    // Without a nominal value a zero stands for it.
    let with_nominal = if text.starts_with(['+', '-']) { format!("0 {text}") } else { text.clone() };
    if let Some([nominal, first, second]) = signed_parts(&with_nominal) {
        let has_nominal = with_nominal == text;
        let mut read = if has_nominal { read(&[nominal, first, second])? } else { read(&[first, second])? };
        let second = read.pop().ok_or_else(|| unread(&text))?;
        let first = read.pop().ok_or_else(|| unread(&text))?;
        let signed =
            |piece: &WrittenQuantity| if piece.value_si < 0.0 { piece.to_string() } else { format!("+{piece}") };
        let limits = format!("{} {}", signed(&first), signed(&second));
        return Ok(UncertaintySpec::Tolerance(read.pop(), limits));
    }
    let mut values = read(&text.split(',').collect::<Vec<_>>())?;
    Ok(if values.len() == 1 { UncertaintySpec::Exact(values.swap_remove(0)) } else { UncertaintySpec::OneOf(values) })
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

/// The ends of an interval: `0.1..0.5`, `0.1 ... 0.5`, `0.1 to 0.5`.
fn ends(text: &str) -> Result<Option<(&str, &str)>, Refusal> {
    if let Some(found) = text.split_once(" to ") {
        return Ok(Some(found));
    }
    let Some((lower, upper)) = text.split_once("..") else { return Ok(None) };
    match upper.strip_prefix('.') {
        // A third point is a part of the sign where a space follows, and could be that of a fraction elsewhere.
        Some(rest) if rest.starts_with(' ') => Ok(Some((lower, rest))),
        Some(_) => Err(Refusal::bad(format!("the third point in '{text}' can belong to the number behind it"))
            .with_hint("write two points, and a zero before a fraction: 0.1..0.5")),
        None => Ok(Some((lower, upper))),
    }
}

/// The numbers of some parts, each with its unit.
fn pieces(parts: &[&str], dimension: Dimension, unit: &str) -> Result<Vec<WrittenQuantity>, Refusal> {
    let split: Vec<(&str, &str)> =
        parts.iter().map(|part| number_and_unit(part).ok_or_else(|| unread(part.trim()))).collect::<Result<_, _>>()?;
    let mut read = Vec::new();
    for (place, (number, _)) in split.iter().enumerate() {
        let units = || split.iter().map(|(_, unit)| *unit);
        let next = units().skip(place).find(|unit| !unit.is_empty());
        let last = || split[..place].iter().map(|(_, unit)| *unit).rfind(|unit| !unit.is_empty());
        read.push(piece(number, next.or_else(last).unwrap_or(unit), dimension)?);
    }
    Ok(read)
}

/// A number with a unit of a dimension.
///
/// # Errors
/// What of it cannot be read.
pub fn piece(number: &str, unit: &str, dimension: Dimension) -> Result<WrittenQuantity, Refusal> {
    let text = format!("{number} {unit}");
    let text = text.trim();
    let value: f64 = number.parse().ok().filter(|value: &f64| value.is_finite()).ok_or_else(|| unread(text))?;
    // A unit and no sum, product or second number: `mm - 0.2 mm` is none.
    let follows_power =
        |(place, _): &(usize, char)| unit[..*place].ends_with(['^', '-']) || unit[..*place].ends_with(char::is_numeric);
    let has_number =
        unit.char_indices().filter(|(_, letter)| letter.is_ascii_digit()).any(|digit| !follows_power(&digit));
    if has_number || unit.contains(['+', '*', '(', '"', '\'', '\\']) || unit.contains(" -") || unit.ends_with('/') {
        return Err(unread(text));
    }
    let found = parse_quantity(text).map_err(|error| {
        let problem = error.for_due(text, dimension).problem;
        Refusal { hint: problem.hint(), ..Refusal::bad(problem.to_string()) }
    })?;
    if found.dimension != dimension {
        return Err(Refusal::bad(format!("'{text}' is {}; expected {dimension}", found.dimension)));
    }
    Ok(WrittenQuantity { number: canonical(number, value), unit: unit.to_owned(), value_si: found.value_si })
}

/// A number with its digits as written, if a file accepts them: `.5`, `5.`, `+5`, `007` and `8e1` are rewritten.
fn canonical(number: &str, value: f64) -> String {
    let digits = number.strip_prefix('-').unwrap_or(number);
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, "0"));
    let is_digits = |part: &str| !part.is_empty() && part.chars().all(|c| c.is_ascii_digit());
    let is_plain = is_digits(whole) && is_digits(fraction) && (whole == "0" || !whole.starts_with('0'));
    if is_plain { number.to_owned() } else { format_number(value) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn length(text: &str) -> Result<UncertaintySpec, String> {
        uncertainty_spec(text, Dimension::LENGTH, "mm").map_err(|refusal| refusal.message)
    }

    /// The values as a file has them, in a line.
    fn shown(text: &str) -> String {
        match length(text).unwrap_or_else(|words| panic!("{text}: {words}")) {
            UncertaintySpec::Exact(value) => format!("= {}", value.quoted()),
            UncertaintySpec::Tolerance(None, limits) => limits,
            UncertaintySpec::Tolerance(Some(nominal), limits) => format!("{nominal} {limits}"),
            UncertaintySpec::StandardDeviation(value) => format!("sd {}", value.quoted()),
            UncertaintySpec::Uniform(value) => format!("uniform {}", value.quoted()),
            UncertaintySpec::Interval([lower, upper]) => format!("{} .. {}", lower.quoted(), upper.quoted()),
            UncertaintySpec::OneOf(values) => values.iter().map(WrittenQuantity::quoted).collect::<Vec<_>>().join(", "),
            UncertaintySpec::Fit(fit) => fit,
        }
    }

    #[test]
    fn what_people_write_is_read() {
        let interval = "\"0.1 mm\" .. \"0.5 mm\"";
        for text in [
            "0.1..0.5 mm",
            "0.1 .. 0.5",
            "0,1..0,5 mm",
            "0.1 to 0.5 mm",
            "0.1…0.5 mm",
            "0.1–0.5",
            "0.1 mm..0.5 mm",
            ".1 to .5",
            "0.1 ... 0.5",
        ] {
            assert_eq!(shown(text), interval, "{text}");
        }
        for text in ["±0.05", "± 0.05 mm", "+/-0.05 mm", "±\u{a0}0.05\u{a0}mm", "±.05"] {
            assert_eq!(shown(text), "± 0.05 mm", "{text}");
        }
        for (text, due) in [
            ("50", "= \"50 mm\""),
            ("2 in", "= \"2 in\""),
            ("8e1 mm", "= \"80 mm\""),
            ("007", "= \"7 mm\""),
            ("+0.02 -0.01", "+0.02 mm -0.01 mm"),
            ("-0.01 -0.03", "-0.01 mm -0.03 mm"),
            ("120 +0.02/-0.01 mm", "120 mm +0.02 mm -0.01 mm"),
            ("120 ± 0.1 mm", "120 mm ± 0.1 mm"),
            ("3.15 in ± 0.01", "3.15 in ± 0.01 in"),
            ("-5 ± 1", "-5 mm ± 1 mm"),
            ("sd 0.03", "sd \"0.03 mm\""),
            ("uniform ±0.1", "uniform \"0.1 mm\""),
            ("H7/g6", "H7/g6"),
            ("0.1, 0.2 mm", "\"0.1 mm\", \"0.2 mm\""),
            ("0.1, 0.2 mm, 8 µm", "\"0.1 mm\", \"0.2 mm\", \"8 µm\""),
        ] {
            assert_eq!(shown(text), due, "{text}");
        }
        let number = uncertainty_spec("0.7...9", Dimension::NUMBER, "").map_err(|refusal| refusal.message);
        assert!(number.is_err_and(|words| words.contains("third point")));
        let Ok(UncertaintySpec::Interval([lower, upper])) = uncertainty_spec("0.7..  .9", Dimension::NUMBER, "") else {
            panic!("an interval")
        };
        assert_eq!((lower.quoted().as_str(), upper.quoted().as_str()), ("0.7", "0.9"));
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
            ("0.1...5 mm", "third point"),
            ("0.1 mm-0.5 mm", "cannot be read"),
            ("0.5 mm - 0.1 mm", "cannot be read"),
            ("80 mm / 2", "cannot be read"),
            ("2 * 40 mm", "cannot be read"),
            ("80 ±0.05 mm +0.1", "cannot be read"),
            ("±5 nonsense", "not a known unit"),
            ("±1/16 in", "cannot be read"),
        ] {
            let found = length(text).expect_err(text);
            assert!(found.contains(words), "{text}: {found}");
        }
    }
}
