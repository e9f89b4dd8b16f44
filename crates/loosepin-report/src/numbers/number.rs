//! Numbers as people read them: their unit, sensible digits, and rounding that never makes a bound narrower.

use loosepin_result::study::{InputDescription, InputKind, Witness, WitnessValue};
use std::f64::consts::TAU;

pub(crate) use crate::numbers::rounding::Rounding;
use crate::numbers::tag::{Tag, marked, same_wording};
use loosepin_text::article::Medium;
use loosepin_text::units::{DisplayUnits, SiUnit, decimal_exponent};

/// Digits of a value whose error is not known.
pub(crate) const PLAIN_DIGITS: usize = 4;
/// Digits of a result, at most.
const RESULT_DIGITS: usize = 3;
/// Digits of an error.
const ERROR_DIGITS: usize = 1;
/// Digits beyond which a value is not written out even if its error is smaller.
const MAX_DIGITS: usize = 7;
/// Digits of what a person wrote, before zeros at the end are dropped.
const INPUT_DIGITS: usize = 8;
/// Below this, powers of ten are used.
const MIN_PLAIN: f64 = 1e-5;
/// From this up, powers of ten are used.
const MAX_PLAIN: f64 = 1e7;
/// A scaled value this close to a whole number (relative) is that number: decimal fractions have no exact binary form.
const REPRESENTATION_NOISE: f64 = 1e-12;

/// Text for not-a-number, without a unit.
const NOT_KNOWN: &str = "not known";

/// Writes SI numbers in the units of people.
#[derive(Debug, Clone, Copy)]
pub(crate) struct NumberWriter<'a> {
    pub units: &'a DisplayUnits,
    pub medium: Medium,
    /// What the next numbers are.
    tag: Option<&'a Tag>,
}

/// An angle within its turn, from 0 to below 2π. What is nearly a whole turn is 0, so that it is not shown as 360°.
pub(crate) fn within_turn_rad(angle_rad: f64) -> f64 {
    const NEARLY_A_TURN_RAD: f64 = 1e-3;
    let within_rad = angle_rad.rem_euclid(TAU);
    if TAU - within_rad < NEARLY_A_TURN_RAD { 0.0 } else { within_rad }
}

impl<'a> NumberWriter<'a> {
    pub fn for_page(units: &'a DisplayUnits) -> Self {
        NumberWriter { units, medium: Medium::Page, tag: None }
    }

    pub fn for_terminal(units: &'a DisplayUnits) -> Self {
        NumberWriter { units, medium: Medium::Terminal, tag: None }
    }

    /// The same writer with other units.
    pub fn in_units<'u>(&self, units: &'u DisplayUnits) -> NumberWriter<'u>
    where
        'a: 'u,
    {
        NumberWriter { units, ..*self }
    }

    /// The same writer for numbers that are `tag`.
    pub fn with_tag<'t>(&self, tag: &'t Tag) -> NumberWriter<'t>
    where
        'a: 't,
    {
        NumberWriter { tag: Some(tag), ..*self }
    }

    /// The same writer for numbers that are `tag`, where it is known.
    pub fn with_optional_tag<'t>(&self, tag: Option<&'t Tag>) -> NumberWriter<'t>
    where
        'a: 't,
    {
        NumberWriter { tag, ..*self }
    }

    /// Tag of the next numbers.
    pub fn tag(&self) -> Option<&'a Tag> {
        self.tag
    }

    /// Number without unit, with digits and direction of rounding.
    pub fn rounded_without_unit(&self, value_si: f64, unit: &SiUnit, digits: usize, rounding: Rounding) -> String {
        let digits = significant(self.scaled(value_si, unit), digits, rounding);
        marked(self.dress(digits.clone()), &digits, self.tag, self.scaled(value_si, unit), rounding)
    }

    /// The symbol behind numbers of this unit; empty for a pure number.
    pub fn symbol(&self, unit: &SiUnit) -> String {
        self.units.of(unit).symbol
    }

    /// The number in its display unit.
    pub fn scaled(&self, value_si: f64, unit: &SiUnit) -> f64 {
        self.units.of(unit).from_si(value_si)
    }

    /// Number with unit.
    pub fn value(&self, value_si: f64, unit: &SiUnit) -> String {
        self.rounded(value_si, unit, PLAIN_DIGITS, Rounding::Nearest)
    }

    /// Number with unit to four digits, without zeros at its end: for values that are exact or nearly so.
    pub fn value_trimmed(&self, value_si: f64, unit: &SiUnit) -> String {
        self.trimmed(value_si, unit, PLAIN_DIGITS)
    }

    fn trimmed(&self, value_si: f64, unit: &SiUnit, digits: usize) -> String {
        let text = significant(self.scaled(value_si, unit), digits, Rounding::Nearest);
        self.with_symbol(without_trailing_zeros(text), value_si, unit, Rounding::Nearest)
    }

    /// An input number without unit, in the fewest digits that identify it.
    pub fn shortest(&self, value_si: f64, unit: &SiUnit) -> String {
        let digits = self.shortest_digits(value_si, unit);
        marked(self.dress(digits.clone()), &digits, self.tag, self.scaled(value_si, unit), Rounding::Nearest)
    }

    fn shortest_digits(&self, value_si: f64, unit: &SiUnit) -> String {
        without_trailing_zeros(significant(self.scaled(value_si, unit), INPUT_DIGITS, Rounding::Nearest))
    }

    /// An input number with unit, in the fewest digits that identify it.
    pub fn value_shortest(&self, value_si: f64, unit: &SiUnit) -> String {
        self.with_symbol(self.shortest_digits(value_si, unit), value_si, unit, Rounding::Nearest)
    }

    /// Number with unit, digits and direction of rounding.
    pub fn rounded(&self, value_si: f64, unit: &SiUnit, digits: usize, rounding: Rounding) -> String {
        self.with_symbol(significant(self.scaled(value_si, unit), digits, rounding), value_si, unit, rounding)
    }

    /// The angle of a drive within its turn, from 0° to below 360°.
    pub fn angle_in_turn(&self, angle_rad: f64, digits: usize) -> String {
        self.rounded(within_turn_rad(angle_rad), &SiUnit::ANGLE, digits, Rounding::Nearest)
    }

    /// Number with unit, to as many places as its error allows, rounded in the given direction.
    pub fn down_to_error(&self, value_si: f64, error_si: f64, unit: &SiUnit, rounding: Rounding) -> String {
        let display = self.units.of(unit);
        let text = to_error(display.from_si(value_si), display.from_si(error_si), MAX_DIGITS, rounding);
        self.with_symbol(text, value_si, unit, rounding)
    }

    /// Like [`Self::down_to_error`], but to three digits at most: for results.
    pub fn for_sentence(&self, value_si: f64, error_si: f64, unit: &SiUnit, rounding: Rounding) -> String {
        let display = self.units.of(unit);
        let text = to_error(display.from_si(value_si), display.from_si(error_si), RESULT_DIGITS, rounding);
        self.with_symbol(text, value_si, unit, rounding)
    }

    /// An error: one digit, rounded up, with unit.
    pub fn error(&self, error_si: f64, unit: &SiUnit) -> String {
        if error_si.is_infinite() {
            return NOT_KNOWN.to_owned();
        }
        self.rounded(error_si, unit, ERROR_DIGITS, Rounding::Up)
    }

    /// A text that may be a number, as a file has it.
    pub fn as_written(&self, text: &str) -> String {
        marked(text.to_owned(), text, self.tag, f64::NAN, Rounding::Nearest)
    }

    /// A count.
    pub fn count(&self, value: u64) -> String {
        let digits = value.to_string();
        marked(self.dress(digits.clone()), &digits, self.tag, value as f64, Rounding::Nearest)
    }

    /// A share from 0 to 1 in percent.
    pub fn percent(&self, share: f64, rounding: Rounding) -> String {
        let digits = percent(share, rounding);
        let text = format!("{}{}%", self.dress(digits.clone()), self.space());
        marked(text, &digits, self.tag, 100.0 * share, rounding)
    }

    /// Two shares, the lower rounded down and the upper up; one where they are the same.
    pub fn percent_range(&self, least: f64, most: f64) -> String {
        let [lower, upper] = ["lower", "upper"].map(|part| self.tag.map(|tag| tag.part(part)));
        let [of_lower, of_upper] = [&lower, &upper].map(|tag| self.with_optional_tag(tag.as_ref()));
        let (least, most) = (of_lower.percent(least, Rounding::Down), of_upper.percent(most, Rounding::Up));
        if same_wording(&least, &most) { least } else { format!("{least} to {most}") }
    }

    /// The epistemic inputs of a witness in plain words, in the order of the study file.
    pub fn witness(&self, witness: &Witness, inputs: &[InputDescription]) -> String {
        let place = |path: &str| inputs.iter().position(|input| input.path == path).unwrap_or(usize::MAX);
        let mut ordered: Vec<(&String, &WitnessValue)> = witness.iter().collect();
        ordered.sort_by_key(|(path, _)| place(path));
        let parts: Vec<String> = ordered
            .into_iter()
            .map(|(path, value)| {
                let input = inputs.get(place(path));
                let unit = input.map_or(&SiUnit::NONE, |input| &input.unit);
                let shown = match value {
                    WitnessValue::Number(value_si) => {
                        let digits = input.map_or(PLAIN_DIGITS, |input| digits_within(&input.kind, *value_si));
                        let tag = self.tag.map(|tag| tag.at(path));
                        self.with_optional_tag(tag.as_ref()).trimmed(*value_si, unit, digits)
                    }
                    WitnessValue::Choice(choice) => {
                        let tag = self.tag.map(|tag| tag.at(path));
                        self.with_optional_tag(tag.as_ref()).as_written(choice)
                    }
                };
                format!("{} {shown}", plain_name(path, inputs))
            })
            .collect();
        parts.join(", ")
    }

    /// The digits of a number as the medium has them, with its unit.
    fn with_symbol(&self, digits: String, value_si: f64, unit: &SiUnit, rounding: Rounding) -> String {
        let symbol = self.symbol(unit);
        // Nor inside a unit: `N m`.
        let symbol = if self.medium == Medium::Page { symbol.replace(' ', "\u{a0}") } else { symbol };
        let text = self.dress(digits.clone());
        let text = match symbol.as_str() {
            _ if digits == NOT_KNOWN => return digits,
            "" => text,
            "°" => format!("{text}°"),
            _ => format!("{text}{}{symbol}", self.space()),
        };
        marked(text, &digits, self.tag, self.scaled(value_si, unit), rounding)
    }

    /// Between a number and its unit: a line must not end there. Terminal text turns it into a space once it is wrapped.
    pub fn space(&self) -> char {
        '\u{a0}'
    }

    /// Typographic minus and powers of ten where the medium has them.
    fn dress(&self, text: String) -> String {
        if self.medium == Medium::Terminal {
            return text;
        }
        match text.split_once('e') {
            Some((mantissa, exponent)) => {
                let raised: String = exponent.chars().map(superscript).collect();
                format!("{}\u{a0}·\u{a0}10{raised}", mantissa.replace('-', "−"))
            }
            None => grouped(&text).replace('-', "−"),
        }
    }
}

/// The words of a path: `joint.gudgeon.radial_clearance` is "gudgeon radial clearance". Where two inputs would read the
/// same, the path itself.
pub(crate) fn plain_name(path: &str, inputs: &[InputDescription]) -> String {
    let words = path_words(path);
    let same = inputs.iter().filter(|input| path_words(&input.path) == words).count();
    if same > 1 || words.is_empty() { path.to_owned() } else { words }
}

fn path_words(path: &str) -> String {
    let shortened = path.split_once('.').map_or(path, |(_, rest)| rest);
    shortened.replace(['.', '_'], " ")
}

/// A finite number with `digits` significant digits, in powers of ten (`1.2e-9`) where it is very small or large.
pub(crate) fn significant(value: f64, digits: usize, rounding: Rounding) -> String {
    if !value.is_finite() {
        return not_finite(value);
    }
    if value == 0.0 {
        return "0".to_owned();
    }
    let magnitude = decimal_magnitude(value);
    let last_place = magnitude - digits as i32 + 1;
    if value.abs() < MIN_PLAIN || value.abs() >= MAX_PLAIN {
        let mantissa_places = digits.saturating_sub(1);
        let mantissa = round_to_place(value / 10f64.powi(magnitude), -(mantissa_places as i32), rounding);
        if mantissa.abs() >= 10.0 {
            return format!("{:.*}e{}", mantissa_places, mantissa / 10.0, magnitude + 1);
        }
        return format!("{mantissa:.mantissa_places$}e{magnitude}");
    }
    let rounded = round_to_place(value, last_place, rounding);
    // 0.999 to two digits is 1.0, not 1.00.
    let carried = i32::from(decimal_magnitude(rounded) > magnitude);
    fixed(rounded, last_place + carried)
}

/// A value to the place of the first digit of its error (the second, where the first is a 1), in at most `max_digits` digits.
fn to_error(value: f64, error: f64, max_digits: usize, rounding: Rounding) -> String {
    if !value.is_finite() {
        return not_finite(value);
    }
    if !error.is_finite() || error <= 0.0 || value == 0.0 {
        return significant(value, PLAIN_DIGITS.min(max_digits), rounding);
    }
    let error_magnitude = decimal_magnitude(error);
    let leading = error / 10f64.powi(error_magnitude);
    let place = if leading < 2.0 { error_magnitude - 1 } else { error_magnitude };
    let digits = decimal_magnitude(value) - place + 1;
    significant(value, digits.clamp(2, max_digits as i32) as usize, rounding)
}

/// A share in percent: more places the nearer it is to 0 or 1, where they matter.
fn percent(share: f64, rounding: Rounding) -> String {
    if !share.is_finite() {
        return not_finite(share);
    }
    let percent = 100.0 * share;
    let distance = percent.min(100.0 - percent).abs();
    let last_place = if distance == 0.0 {
        0
    } else if distance < 1.0 {
        (decimal_magnitude(distance) - 1).max(-6)
    } else {
        -1
    };
    without_trailing_zeros(fixed(round_to_place(percent, last_place, rounding), last_place))
}

fn not_finite(value: f64) -> String {
    if value.is_nan() {
        NOT_KNOWN.to_owned()
    } else if value > 0.0 {
        "∞".to_owned()
    } else {
        "-∞".to_owned()
    }
}

fn decimal_magnitude(value: f64) -> i32 {
    decimal_exponent(value).unwrap_or(0)
}

fn round_to_place(value: f64, place: i32, rounding: Rounding) -> f64 {
    let scaled = if place >= 0 { value / 10f64.powi(place) } else { value * 10f64.powi(-place) };
    let nearest = scaled.round();
    let whole = if (scaled - nearest).abs() <= REPRESENTATION_NOISE * scaled.abs().max(1.0) {
        nearest
    } else {
        match rounding {
            Rounding::Nearest => nearest,
            Rounding::Down => scaled.floor(),
            Rounding::Up => scaled.ceil(),
        }
    };
    if place >= 0 { whole * 10f64.powi(place) } else { whole / 10f64.powi(-place) }
}

fn fixed(value: f64, last_place: i32) -> String {
    let text = format!("{:.*}", (-last_place).max(0) as usize, value);
    // A value that rounds to nothing has no sign.
    if text.trim_start_matches('-').chars().all(|c| c == '0' || c == '.') {
        text.trim_start_matches('-').to_owned()
    } else {
        text
    }
}

/// Thousands apart from five digits on, with a narrow space that does not break.
fn grouped(text: &str) -> String {
    let whole = text.find('.').unwrap_or(text.len());
    let digits = text[..whole].trim_start_matches('-').len();
    if digits < 5 || !text[..whole].trim_start_matches('-').chars().all(|c| c.is_ascii_digit()) {
        return text.to_owned();
    }
    let mut result = String::new();
    for (index, character) in text.char_indices() {
        if index > 0 && index < whole && character.is_ascii_digit() && (whole - index).is_multiple_of(3) {
            let after_sign = text.starts_with('-') && index == 1;
            if !after_sign {
                result.push('\u{202f}');
            }
        }
        result.push(character);
    }
    result
}

fn without_trailing_zeros(text: String) -> String {
    let (mantissa, exponent) = match text.split_once('e') {
        Some((mantissa, exponent)) => (mantissa.to_owned(), format!("e{exponent}")),
        None => (text, String::new()),
    };
    if !mantissa.contains('.') {
        return mantissa + &exponent;
    }
    mantissa.trim_end_matches('0').trim_end_matches('.').to_owned() + &exponent
}

fn superscript(character: char) -> char {
    match character {
        '-' => '⁻',
        '0' => '⁰',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '4' => '⁴',
        '5' => '⁵',
        '6' => '⁶',
        '7' => '⁷',
        '8' => '⁸',
        '9' => '⁹',
        other => other,
    }
}

/// Digits that resolve a value of the input to a thousandth of its range.
fn digits_within(kind: &InputKind, value_si: f64) -> usize {
    let width = match kind {
        InputKind::Interval { lower_si, upper_si }
        | InputKind::SecondOrder { lower_si, upper_si }
        | InputKind::Periodic { lower_si, upper_si } => upper_si - lower_si,
        InputKind::Evidence { elements, .. } => {
            let lower = elements.iter().map(|element| element.lower_si).fold(f64::INFINITY, f64::min);
            elements.iter().map(|element| element.upper_si).fold(f64::NEG_INFINITY, f64::max) - lower
        }
        InputKind::Fuzzy { cuts } => cuts.first().map_or(f64::NAN, |cut| cut.upper_si - cut.lower_si),
        InputKind::Random | InputKind::DrawnPlay | InputKind::Play | InputKind::Choice { .. } => f64::NAN,
    };
    let ahead = (value_si.abs() / width).log10().ceil();
    if ahead.is_finite() { (ahead.max(0.0) as usize + 3).clamp(PLAIN_DIGITS, INPUT_DIGITS) } else { PLAIN_DIGITS }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_rounding_never_narrows_a_bound() {
        assert_eq!(significant(0.5347, 2, Rounding::Up), "0.54");
        assert_eq!(significant(0.5347, 2, Rounding::Nearest), "0.53");
        assert_eq!(significant(-0.5347, 2, Rounding::Down), "-0.54");
        assert_eq!(significant(0.53, 2, Rounding::Up), "0.53", "0.53 has no exact binary form, and is still 0.53");
        assert_eq!(significant(0.999, 2, Rounding::Up), "1.0");
        assert_eq!(percent(0.97449, Rounding::Down), "97.4");
        assert_eq!(percent(0.95, Rounding::Nearest), "95");
        assert_eq!(percent(0.99731, Rounding::Down), "99.73");
        assert_eq!(percent(1.0, Rounding::Down), "100");
        assert_eq!(percent(0.0, Rounding::Up), "0");
    }

    #[test]
    fn a_value_within_a_narrow_interval_keeps_the_digits_that_tell_it() {
        let interval = |lower_si, upper_si| InputKind::Interval { lower_si, upper_si };
        let shown = |kind: &InputKind, value: f64| {
            without_trailing_zeros(significant(value, digits_within(kind, value), Rounding::Nearest))
        };
        assert_eq!(shown(&interval(49.975, 50.025), 50.025), "50.025");
        assert_eq!(shown(&interval(119.999, 120.001), 119.999), "119.999");
        assert_eq!(shown(&interval(119.999, 120.001), 119.999_123_4), "119.99912");
        assert_eq!(shown(&interval(0.7, 0.9), 0.774_831), "0.7748");
        assert_eq!(shown(&interval(-1.0, 1.0), 0.0), "0");
        assert_eq!(shown(&InputKind::Random, 123.456), "123.5");
    }

    #[test]
    fn analytic_digits_follow_the_error() {
        assert_eq!(to_error(0.53467, 0.0042, MAX_DIGITS, Rounding::Nearest), "0.535");
        assert_eq!(to_error(0.53467, 0.0012, MAX_DIGITS, Rounding::Nearest), "0.5347");
        assert_eq!(to_error(0.53467, 0.0012, RESULT_DIGITS, Rounding::Up), "0.535");
        assert_eq!(to_error(123.4, 30.0, MAX_DIGITS, Rounding::Nearest), "120");
        assert_eq!(to_error(0.5, f64::INFINITY, MAX_DIGITS, Rounding::Nearest), "0.5000");
        assert_eq!(significant(1.2346e-9, 3, Rounding::Nearest), "1.23e-9");
        assert_eq!(significant(9.999e-9, 2, Rounding::Nearest), "1.0e-8");
        assert_eq!(significant(327334.2, 4, Rounding::Nearest), "327300");
        assert_eq!(significant(f64::NAN, 4, Rounding::Nearest), "not known");
    }

    #[test]
    fn analytic_page_and_terminal_characters() {
        let units = DisplayUnits::default();
        let page = NumberWriter::for_page(&units);
        let terminal = NumberWriter::for_terminal(&units);
        assert_eq!(page.value(-0.0005347, &SiUnit::LENGTH), "−0.5347\u{a0}mm");
        assert_eq!(terminal.value(-0.0005347, &SiUnit::LENGTH), "-0.5347\u{a0}mm");
        assert_eq!(page.value(1.2346e-9, &SiUnit::NONE), "1.235\u{a0}·\u{a0}10⁻⁹");
        assert_eq!(page.value(std::f64::consts::FRAC_PI_3, &SiUnit::ANGLE), "60.00°");
        assert_eq!(page.value(-327_334.2, &SiUnit::FORCE), "−327\u{202f}300\u{a0}N");
        assert_eq!(page.value(45_870.0, &SiUnit::FORCE), "45\u{202f}870\u{a0}N");
        assert_eq!(plain_name("joint.gudgeon.radial_clearance", &[]), "gudgeon radial clearance");
    }
}
