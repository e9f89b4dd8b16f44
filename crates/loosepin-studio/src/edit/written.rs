//! A number with its unit as it is written, and the same with another value.

use loosepin::units::{format_number, parse_unit};

/// Fixed notation beyond these many decimals is no length that anybody makes.
const MAX_DECIMALS: usize = 12;

/// A number with its unit: `120 mm`.
#[derive(Debug, Clone, PartialEq)]
pub struct Written {
    value: f64,
    /// Size of its unit, SI.
    unit_si: f64,
    /// What stands behind the digits: the unit with the space before it.
    behind: String,
}

impl Written {
    /// Reads a plain number with its unit; `None` if the text is an expression.
    pub fn read(text: &str) -> Option<Self> {
        let text = text.trim();
        let end = text.find(|c: char| !matches!(c, '0'..='9' | '.' | '-' | '+')).unwrap_or(text.len());
        let (digits, behind) = text.split_at(end);
        let value: f64 = digits.parse().ok().filter(|value: &f64| value.is_finite())?;
        let unit = behind.trim();
        let is_plain =
            !unit.is_empty() && !unit.contains(['*', '/', '^', '(', '+', '-']) && unit.starts_with(char::is_alphabetic);
        let unit_si = parse_unit(unit).ok().filter(|_| is_plain)?.value_si;
        Some(Self { value, unit_si, behind: behind.to_owned() })
    }

    /// Its value, SI.
    pub fn value_si(&self) -> f64 {
        self.value * self.unit_si
    }

    /// The same number with another value, rounded to the next step of 1, 2 or 5 times a power of ten that is not below `step_si`.
    pub fn with_value_si(&self, value_si: f64, step_si: f64) -> String {
        let (step, decimals) = round_step(step_si / self.unit_si);
        let value = (value_si / self.unit_si / step).round() * step;
        // Zero has no sign.
        format!("{:.decimals$}{}", value + 0.0, self.behind)
    }

    /// The same number, moved by a difference; it has the decimals that the difference needs.
    pub fn moved_by_si(&self, difference_si: f64) -> String {
        let moved = self.value + difference_si / self.unit_si;
        // Digits that are round-off of the sum go.
        let scale = 10_f64.powi(MAX_DECIMALS as i32);
        format!("{}{}", format_number((moved * scale).round() / scale), self.behind)
    }
}

/// The least of 1, 2, 5 times a power of ten that is not below `least`, and the decimals that write its multiples.
fn round_step(least: f64) -> (f64, usize) {
    let power = (least.log10() - 1e-9).floor().clamp(-(MAX_DECIMALS as f64), 12.0) as i32;
    let (first, power) = [(1.0, power), (2.0, power), (5.0, power), (1.0, power + 1)]
        .into_iter()
        .find(|(first, power)| first * 10_f64.powi(*power) >= least * (1.0 - 1e-9))
        .unwrap_or((1.0, power + 1));
    (first * 10_f64.powi(power), usize::try_from(-power).unwrap_or(0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_keeps_its_unit_and_takes_a_round_value() {
        let written = Written::read("120 mm").unwrap();
        assert!((written.value_si() - 0.12).abs() < 1e-15);
        // 0.7 mm a step: the next round one is 1 mm.
        assert_eq!(written.with_value_si(0.123_4, 0.7e-3), "123 mm");
        assert_eq!(written.with_value_si(0.123_46, 0.04e-3), "123.45 mm");
        assert_eq!(Written::read("4.75in").unwrap().with_value_si(0.1, 0.02 * 0.0254), "3.94in");
        assert_eq!(Written::read("-3 mm").unwrap().with_value_si(-0.000_2, 1e-3), "0 mm");
    }

    #[test]
    fn a_number_that_is_moved_has_no_round_off() {
        assert_eq!(Written::read("120.02 mm").unwrap().moved_by_si(0.001), "121.02 mm");
        assert_eq!(Written::read("1 in").unwrap().moved_by_si(0.0254), "2 in");
    }

    #[test]
    fn an_expression_is_no_number() {
        for text in ["crank_length", "120 mm / 2", "2 * 60 mm", "", "120", "1e-3 m", "120 mn", "50 mm + 1 mm"] {
            assert_eq!(Written::read(text), None, "{text}");
        }
    }

    #[test]
    fn steps_are_round() {
        let steps = [
            (0.7, 1.0, 0),
            (1.0, 1.0, 0),
            (1.1, 2.0, 0),
            (3.0, 5.0, 0),
            (6.0, 10.0, 0),
            (0.03, 0.05, 2),
            (40.0, 50.0, 0),
        ];
        for (least, step, decimals) in steps {
            let found = round_step(least);
            assert!((found.0 - step).abs() < 1e-12 * step && found.1 == decimals, "{least}: {found:?}");
        }
    }
}
