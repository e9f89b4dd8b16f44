//! Numbers that a line of a page must not part from their unit: in texts that files, runs and other crates have written.

/// Units that stand behind numbers.
const UNITS: [&str; 34] = [
    "%", "deg", "g", "GPa", "Hz", "J", "K", "kg", "kHz", "kJ", "km", "kN", "kPa", "kW", "m", "mJ", "mm", "MPa", "mrad",
    "ms", "mW", "N", "Nm", "ns", "Pa", "rad", "rpm", "s", "um", "us", "W", "°", "µm", "µs",
];

/// The text with spaces between a number and its unit at which no line ends.
pub(crate) fn glued(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for (at, c) in text.char_indices() {
        let is_behind_number = text[..at].ends_with(|before: char| before.is_ascii_digit());
        out.push(if c == ' ' && is_behind_number && begins_with_unit(&text[at + 1..]) { '\u{a0}' } else { c });
    }
    out
}

fn begins_with_unit(rest: &str) -> bool {
    let ends = |c: char| !(c.is_alphabetic() || c == '°' || c == '%' || c == '_');
    let word = &rest[..rest.find(ends).unwrap_or(rest.len())];
    UNITS.contains(&word)
}

#[cfg(test)]
mod tests {
    use super::glued;

    #[test]
    fn a_number_and_its_unit_stay_together_and_words_do_not() {
        let text = "normal, mean 120 mm, 3 runs at 5 rpm of 8 samples; 1e-14 s: 95 % in 2 m/s^2, 7 m_1 or 4 s";
        let due = "normal, mean 120~mm, 3 runs at 5~rpm of 8 samples; 1e-14~s: 95~% in 2~m/s^2, 7 m_1 or 4~s";
        assert_eq!(glued(text).replace('\u{a0}', "~"), due);
    }
}
