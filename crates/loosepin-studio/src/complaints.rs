//! Complaints as the page shows them: places in UTF-16 units, as browsers count.

use loosepin::diagnostics::{Complaint, Complaints, Place, Source};

use crate::messages::{Document, SeenComplaint, SeenLabel, Stretch};
use crate::texts::Texts;

/// All complaints in the order of their places.
pub fn seen(complaints: &Complaints, texts: &Texts) -> Vec<SeenComplaint> {
    complaints.sorted().into_iter().map(|complaint| one(complaint, texts)).collect()
}

fn one(complaint: &Complaint, texts: &Texts) -> SeenComplaint {
    let place = complaint.place.as_ref();
    let document = place.and_then(|place| document(place, texts));
    let labels = complaint.labels.iter().map(|label| SeenLabel {
        document: self::document(&label.place, texts),
        stretch: Some(stretch(&label.place)),
        text: label.text.clone(),
    });
    SeenComplaint {
        document,
        path: place.map(|place| place.source.name().to_owned()),
        code: complaint.code.as_str(),
        severity: complaint.severity.to_string(),
        message: complaint.message.clone(),
        hint: complaint.hint.clone(),
        stretch: place.map(stretch),
        labels: labels.collect(),
        fix: None,
    }
}

fn document(place: &Place, texts: &Texts) -> Option<Document> {
    let name = place.source.name();
    if name == texts.model.name() {
        Some(Document::Model)
    } else if texts.study.as_ref().is_some_and(|study| study.name() == name) {
        Some(Document::Study)
    } else {
        None
    }
}

fn stretch(place: &Place) -> Stretch {
    let (line, column) = place.line_and_column();
    let range = place.source.clamp(place.span);
    let [from, to] = [range.start, range.end].map(|byte| utf16_units(&place.source, byte));
    Stretch { line, column, from, to }
}

/// UTF-16 units before a byte, which begins a character.
pub fn utf16_units(source: &Source, byte: usize) -> usize {
    source.text()[..byte].encode_utf16().count()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_counted_as_browsers_count() {
        let source = Source::new("model.toml", "a = \"µ𝛼\" # ü\nb = 1\n");
        // µ has two bytes and one unit, 𝛼 four bytes and two units.
        let byte = source.text().find("b =").unwrap();
        assert_eq!(utf16_units(&source, byte), "a = \"µ𝛼\" # ü\n".encode_utf16().count());
        let found = stretch(&Place::new(&source, byte..byte + 1));
        assert_eq!((found.line, found.column, found.to - found.from), (2, 1, 1));
    }
}
