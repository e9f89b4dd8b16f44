//! Numbers as text: the shortest decimal that is the number, or next to it.

use loosepin_space::Vec3;

/// Relative distance of two numbers that are next to each other.
const NEXT: f64 = f64::EPSILON;

/// The shortest decimal within a rounding of `value`, times 10^`power`: the decimal point is moved, so that no digit changes.
pub(super) fn shifted(value: f64, power: i32) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let is_near = |text: &String| text.parse::<f64>().is_ok_and(|back| (back - value).abs() <= NEXT * value.abs());
    let text = (0..17_usize).map(|digits| format!("{value:.digits$e}")).find(is_near);
    // What is too large for a number keeps its word, which no model takes.
    let text = text.unwrap_or_else(|| format!("{value:e}"));
    let Some((mantissa, exponent)) = text.split_once('e') else { return text };
    let (sign, mantissa) = mantissa.strip_prefix('-').map_or(("", mantissa), |rest| ("-", rest));
    let digits: String = mantissa.chars().filter(char::is_ascii_digit).collect();
    let exponent = exponent.parse::<i32>().unwrap_or_default() + power;
    format!("{sign}{}", placed(&digits, exponent))
}

/// Digits with the point behind the first one, times 10^`exponent`.
fn placed(digits: &str, exponent: i32) -> String {
    let count = digits.len() as i32;
    match exponent {
        0..=15 if count <= exponent + 1 => format!("{digits}{}", "0".repeat((exponent + 1 - count) as usize)),
        0..=15 => {
            let (whole, rest) = digits.split_at(exponent as usize + 1);
            format!("{whole}.{rest}")
        }
        -4..=-1 => format!("0.{}{digits}", "0".repeat((-exponent - 1) as usize)),
        _ => {
            let (whole, rest) = digits.split_at(1);
            let point = if rest.is_empty() { "" } else { "." };
            format!("{whole}{point}{rest}e{exponent}")
        }
    }
}

/// A number.
pub(crate) fn number(value: f64) -> String {
    shifted(value, 0)
}

/// A length in mm, with its unit, as TOML.
pub(super) fn length(value_m: f64) -> String {
    format!("\"{} mm\"", shifted(value_m, 3))
}

/// Three lengths as TOML.
pub(super) fn lengths(vector_m: Vec3) -> String {
    listed(without_round_off(vector_m).to_array().map(length))
}

/// An angle with its unit: in degrees or radians, whichever has fewer digits.
pub(super) fn angle(value_rad: f64) -> String {
    let (degrees, radians) = (number(value_rad.to_degrees()), number(value_rad));
    if degrees.len() <= radians.len() { format!("{degrees} deg") } else { format!("{radians} rad") }
}

/// A direction as TOML: a coordinate axis by its word, else three numbers.
pub(super) fn direction(vector: Vec3) -> String {
    word(vector).map_or_else(|| listed(without_round_off(vector).to_array().map(number)), |word| format!("\"{word}\""))
}

/// The word for a coordinate axis.
pub(super) fn word(vector: Vec3) -> Option<&'static str> {
    let [x, y, z] = without_round_off(vector).to_array();
    let words = [(x, [y, z], ["x", "-x"]), (y, [x, z], ["y", "-y"]), (z, [x, y], ["z", "-z"])];
    let own = words.into_iter().find(|(along, across, _)| *along != 0.0 && *across == [0.0; 2]);
    own.map(|(along, _, words)| if along > 0.0 { words[0] } else { words[1] })
}

fn listed(parts: [String; 3]) -> String {
    format!("[{}]", parts.join(", "))
}

/// Share of the largest component of a vector below which a component is round-off.
const ROUND_OFF: f64 = 1e-15;

fn without_round_off(vector: Vec3) -> Vec3 {
    let size = ROUND_OFF * vector.to_array().into_iter().fold(0.0_f64, |size, component| size.max(component.abs()));
    Vec3::from(vector.to_array().map(|component| if component.abs() <= size { 0.0 } else { component }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_keep_their_digits_when_the_point_moves() {
        for (value, power, text) in [
            (0.1025, 3, "102.5"),
            (-0.4318, 3, "-431.8"),
            (0.1 + 0.2, 3, "300"),
            (1.0 / 3.0, 3, "333.3333333333333"),
            (1e-9, 3, "1e-6"),
            (1.25e-7, 0, "1.25e-7"),
            (12.0, 3, "12000"),
            (0.0, 3, "0"),
            (6.02e23, 0, "6.02e23"),
            (1e-4, 0, "0.0001"),
        ] {
            assert_eq!(shifted(value, power), text);
        }
    }

    #[test]
    fn directions_along_the_axes_are_words() {
        assert_eq!(direction(Vec3::new(0.0, 0.0, -2.0)), "\"-z\"");
        assert_eq!(direction(Vec3::new(1.0, 6.1e-17, 0.0)), "\"x\"");
        assert_eq!(direction(Vec3::new(0.0, 0.6, 0.8)), "[0, 0.6, 0.8]");
    }
}
