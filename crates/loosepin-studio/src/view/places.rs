//! Places in texts as browsers count them: in UTF-16 units.

use std::ops::Range;

use loosepin::diagnostics::{Place, Source, Span};

use crate::messages::Stretch;

/// Range of a place in its text.
pub fn stretch(place: &Place) -> Stretch {
    let (line, column) = place.line_and_column();
    let range = place.source.clamp(place.span);
    let [from, to] = [range.start, range.end].map(|byte| place.source.utf16_units(byte));
    Stretch { line, column, from, to }
}

/// The bytes of a value, without the quotes around it.
pub fn unquoted(source: &Source, span: Span) -> Range<usize> {
    let range = source.clamp(span);
    let text = &source.text()[range.clone()];
    let is_quoted = text.len() >= 2 && ['"', '\''].iter().any(|mark| text.starts_with(*mark) && text.ends_with(*mark));
    if is_quoted { range.start + 1..range.end - 1 } else { range }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_counted_as_browsers_count() {
        let source = Source::new("model.toml", "a = \"µ𝛼\" # ü\nb = 1\n");
        // µ has two bytes and one unit, 𝛼 four bytes and two units.
        let byte = source.text().find("b =").unwrap();
        assert_eq!(source.utf16_units(byte), "a = \"µ𝛼\" # ü\n".encode_utf16().count());
        let found = stretch(&Place::new(&source, byte..byte + 1));
        assert_eq!((found.line, found.column, found.to - found.from), (2, 1, 1));
    }
}
