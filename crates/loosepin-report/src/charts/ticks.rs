//! Ticks of axes: where they stand, and their numbers. `scripts/ticks.ts` has the same rules for charts that are zoomed.

/// Steps between the ticks of angles in degrees.
const ANGLE_STEPS: [f64; 12] = [0.5, 1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 45.0, 90.0, 180.0, 360.0, 720.0];
/// Closer than this angles have steps like other numbers.
const MIN_OF_ANGLES: f64 = 0.2;
/// From here on numbers have a power of ten.
const LARGE: f64 = 1e7;
/// Steps below this give numbers a power of ten.
const SMALL: f64 = 1e-4;

/// Round numbers from `from` to `to`, and the step between them, which is at least `least`: 1, 2 or 5 times a power of ten, or one
/// of the steps of angles. The step is smaller where there would be one number or none: then an axis could not be read.
pub(crate) fn ticks(from: f64, to: f64, least: f64, are_angles: bool) -> (Vec<f64>, f64) {
    let is_usable = from.is_finite() && to.is_finite() && to > from && least > 0.0;
    if !is_usable {
        return (Vec::new(), 1.0);
    }
    let are_angle_steps = are_angles && least > MIN_OF_ANGLES;
    let of_angles = ANGLE_STEPS.into_iter().find(|step| are_angle_steps && *step >= least);
    let step = of_angles.unwrap_or_else(|| {
        let power = 10_f64.powf(least.log10().floor());
        [1.0, 2.0, 5.0, 10.0].into_iter().map(|multiple| multiple * power).find(|step| *step >= least).unwrap_or(least)
    });
    // Round-off of the ends must not cost a tick.
    let slack = 1e-9;
    let (first, last) = ((from / step - slack).ceil() as i64, (to / step + slack).floor() as i64);
    if last <= first {
        return ticks(from, to, 0.5 * least, are_angles);
    }
    ((first..=last).map(|k| k as f64 * step).collect(), step)
}

/// A tick with the places that its step has: 0.25 of 0.25, 5.0 never.
pub(crate) fn tick_text(value: f64, step: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let magnitude = value.abs();
    if magnitude >= LARGE || step < SMALL {
        let exponent = magnitude.log10().floor();
        let places = (exponent - step.log10().floor()).max(0.0) as usize;
        let mantissa = format!("{:.*}", places, value / 10_f64.powf(exponent));
        return format!("{}·10{}", mantissa.replace('-', "−"), superscript(exponent as i32));
    }
    let places = (0..=10).find(|places| is_whole(step * 10_f64.powi(*places))).unwrap_or(10);
    let text = format!("{value:.*}", places as usize).replace('-', "−");
    grouped(&text)
}

fn is_whole(value: f64) -> bool {
    (value - value.round()).abs() < 1e-6
}

/// Thousands set apart where there are five digits or more before the point.
fn grouped(text: &str) -> String {
    let (whole, rest) = text.split_once('.').map_or((text, None), |(whole, rest)| (whole, Some(rest)));
    let digits = whole.trim_start_matches('−');
    let sign = &whole[..whole.len() - digits.len()];
    let mut out = sign.to_owned();
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && digits.len() > 4 && (digits.len() - place) % 3 == 0 {
            out.push('\u{202f}');
        }
        out.push(digit);
    }
    if let Some(rest) = rest {
        out.push('.');
        out.push_str(rest);
    }
    out
}

fn superscript(exponent: i32) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let digit = |c: char| c.to_digit(10).map_or('⁻', |digit| DIGITS[digit as usize]);
    exponent.to_string().chars().map(digit).collect()
}

#[cfg(test)]
mod tests {
    use super::{tick_text, ticks};

    #[derive(serde::Deserialize)]
    struct Case {
        from: f64,
        to: f64,
        least: f64,
        are_angles: bool,
        texts: Vec<String>,
    }

    fn texts(from: f64, to: f64, least: f64, are_angles: bool) -> Vec<String> {
        let (values, step) = ticks(from, to, least, are_angles);
        values.into_iter().map(|value| tick_text(value, step)).collect()
    }

    /// `tests/browser` holds the script of the page to the same cases.
    #[test]
    fn analytic_ticks_are_round_and_inside() {
        let cases: Vec<Case> = serde_json::from_str(include_str!("../../scripts/ticks_cases.json")).unwrap();
        for case in cases {
            let found = texts(case.from, case.to, case.least, case.are_angles);
            assert_eq!(found, case.texts, "from {} to {}, at least {}", case.from, case.to, case.least);
        }
    }

    #[test]
    fn analytic_an_axis_without_extent_has_no_ticks() {
        assert!(texts(1.0, 1.0, 0.1, false).is_empty() && texts(f64::NAN, 1.0, 0.1, false).is_empty());
    }
}
