//! Numbers that a line of a page must not part from their unit: in texts that files, runs and other crates have written.

use loosepin_text::units::find_unit;

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
    // `5 in all`.
    word == "%" || word == "°" || (word != "in" && find_unit(word).is_some())
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
