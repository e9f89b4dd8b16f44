//! SI values as text for people, in the units that they read.

use super::dimension::Dimension;
use super::number::format_number;
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
        let number = format_number(self.number(value_si));
        if self.text.is_empty() { number } else { format!("{number} {}", self.text) }
    }
}

/// An SI value as text in the unit that people read it in, for example `0.5 mm` or `5000 rpm`.
pub fn format_value(value_si: f64, dimension: Dimension) -> String {
    ReadableUnit::default_for(dimension).format(value_si)
}

#[cfg(test)]
mod tests {
    use super::*;

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
