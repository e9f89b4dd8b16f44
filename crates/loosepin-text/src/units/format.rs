//! SI values as text for people, in the units that they read.

use super::Rule;
use super::dimension::Dimension;
use super::number::{ALL_DIGITS, SHOWN_DIGITS, format_digits};
use super::parser::{Measured, parse_unit};

/// The unit in which a quantity is shown.
#[derive(Debug, Clone, PartialEq)]
pub struct ReadableUnit {
    /// The unit as written, for example `mm`; empty for a pure number.
    pub text: String,
    /// One such unit in SI.
    pub si_per_unit: f64,
}

impl ReadableUnit {
    /// A unit chosen by a person; `None` if `text` is not a unit of this dimension.
    pub fn of_dimension(text: &str, dimension: Dimension) -> Option<ReadableUnit> {
        let Measured { value_si, dimension: written } = parse_unit(text).ok()?;
        (written == dimension).then(|| ReadableUnit { text: text.trim().to_owned(), si_per_unit: value_si })
    }

    /// The unit that people read this dimension in: mm, deg, rpm, N; SI where there is no custom.
    pub fn default_for(dimension: Dimension) -> ReadableUnit {
        let custom = [
            (Dimension::LENGTH, "mm"),
            (Dimension::ANGLE, "deg"),
            (Dimension::ANGULAR_VELOCITY, "rpm"),
            (Dimension::PRESSURE, "GPa"),
            (Dimension::TIME, "ms"),
            (Dimension::VOLUME, "mm^3"),
        ];
        custom
            .into_iter()
            .find(|(named, _)| *named == dimension)
            .and_then(|(_, text)| ReadableUnit::of_dimension(text, dimension))
            .unwrap_or_else(|| ReadableUnit { text: dimension.si_unit(), si_per_unit: 1.0 })
    }

    /// `value_si` as a number of this unit.
    pub fn number(&self, value_si: f64) -> f64 {
        // Dividing by 1e-3 and multiplying by 1e3 round differently; the second gives back what was written.
        let reciprocal = (1.0 / self.si_per_unit).round();
        if self.si_per_unit < 1.0 && 1.0 / reciprocal == self.si_per_unit {
            value_si * reciprocal
        } else {
            value_si / self.si_per_unit
        }
    }

    /// `value_si` as text with this unit, for example `0.5 mm`.
    pub fn format(&self, value_si: f64) -> String {
        self.format_digits(value_si, SHOWN_DIGITS)
    }

    fn format_digits(&self, value_si: f64, digits: usize) -> String {
        let number = format_digits(self.number(value_si), digits);
        if self.text.is_empty() { number } else { format!("{number} {}", self.text) }
    }
}

/// An SI value as text in the unit that people read it in, for example `0.5 mm` or `5000 rpm`.
pub fn format_value(value_si: f64, dimension: Dimension) -> String {
    ReadableUnit::default_for(dimension).format(value_si)
}

/// SI values to be compared, as by [`format_value`], with enough further digits to distinguish different ones: `1.0000001` beside `1`.
pub fn format_apart<const N: usize>(values_si: [f64; N], dimension: Dimension) -> [String; N] {
    let unit = ReadableUnit::default_for(dimension);
    let texts = |digits: usize| values_si.map(|value_si| unit.format_digits(value_si, digits));
    let is_same = |a: f64, b: f64| a == b || a.is_nan() && b.is_nan();
    let are_apart = |texts: &[String; N]| {
        (0..N).all(|k| (0..k).all(|other| texts[k] != texts[other] || is_same(values_si[k], values_si[other])))
    };
    (SHOWN_DIGITS..ALL_DIGITS).map(texts).find(are_apart).unwrap_or_else(|| texts(ALL_DIGITS))
}

/// A value that broke a [`Rule`], with enough digits to distinguish it from the numbers of the rule.
pub fn format_refused(value_si: f64, dimension: Dimension) -> String {
    let [zero, half, one, turns, angle] = Rule::LIMITS;
    let [found, ..] = format_apart([value_si, zero, half, one, turns, angle], dimension);
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_that_are_held_against_one_another_are_told_apart() {
        let apart = |values: [f64; 2], dimension| format_apart(values, dimension);
        assert_eq!(apart([0.3e-3, 0.300_000_01e-3], Dimension::LENGTH), ["0.3 mm", "0.30000001 mm"]);
        assert_eq!(apart([0.3e-3, 0.4e-3], Dimension::LENGTH), ["0.3 mm", "0.4 mm"]);
        assert_eq!(apart([1.0, 1.0], Dimension::NUMBER), ["1", "1"]);
        assert_eq!(apart([1.0, 1.0 + f64::EPSILON], Dimension::NUMBER), ["1", "1.0000000000000002"]);
        assert_eq!(format_refused(1.000_000_1, Dimension::NUMBER), "1.0000001");
        assert_eq!(format_refused(1.0 / 3.0, Dimension::NUMBER), "0.3333333");
        assert_eq!(format_refused(f64::NAN, Dimension::NUMBER), "NaN");
        assert_eq!(format_refused(-0.05e-3, Dimension::LENGTH), "-0.05 mm");
        assert_eq!(format_refused(1e6 + 1e-3, Dimension::NUMBER), "1000000.001");
    }

    #[test]
    fn every_number_that_a_rule_names_is_one_of_its_limits() {
        for rule in Rule::ALL {
            let words = rule.words().split(|c: char| !(c.is_ascii_digit() || c == '.' || c == 'e'));
            let to_si = |number: f64| if rule.words().contains("deg") { number.to_radians() } else { number };
            for number in words.filter_map(|word| word.parse::<f64>().ok()).map(to_si) {
                assert!(Rule::LIMITS.contains(&number), "{number} of {}", rule.words());
            }
        }
    }

    #[test]
    fn values_show_units_people_read() {
        assert_eq!(format_value(0.0005, Dimension::LENGTH), "0.5 mm");
        assert_eq!(format_value(500.0 * std::f64::consts::PI / 3.0, Dimension::ANGULAR_VELOCITY), "5000 rpm");
        assert_eq!(format_value(std::f64::consts::PI, Dimension::ANGLE), "180 deg");
        assert_eq!(format_value(1e-4, Dimension::INERTIA), "0.0001 kg m^2");
        assert_eq!(format_value(6.610198e10, Dimension::contact_stiffness(1.5)), "6.610198e10 N/m^1.5");
        assert_eq!(format_value(0.9, Dimension::NUMBER), "0.9");
        assert_eq!(format_value(45870.0, Dimension::FORCE), "45870 N");
        assert_eq!(format_value(2.0, Dimension::FREQUENCY), "2 1/s");
    }
}
