//! Diagnostics as the page shows them.

use loosepin::diagnostics::{Diagnostic, Diagnostics, Place};

use crate::messages::{DiagnosticView, Document, LabelView};
use crate::view::fixes::fix;
use crate::view::places::stretch;
use crate::view::texts::Texts;

/// Most diagnostics that a page is sent: a list of thousands is of no use to anybody, and takes seconds to be drawn.
const MAX_SHOWN: usize = 200;

/// The first diagnostics in the order of their places; the last one says how many more there are.
pub fn diagnostic_views(diagnostics: &Diagnostics, texts: &Texts) -> Vec<DiagnosticView> {
    let sorted = diagnostics.sorted();
    let mut seen: Vec<DiagnosticView> =
        sorted.iter().take(MAX_SHOWN).map(|diagnostic| one(diagnostic, texts)).collect();
    if let Some(left) = sorted.get(MAX_SHOWN..).filter(|left| !left.is_empty()) {
        let gravest = left.iter().max_by_key(|diagnostic| diagnostic.severity).unwrap_or(&left[0]);
        seen.push(DiagnosticView {
            document: None,
            path: None,
            code: gravest.code.as_str(),
            severity: gravest.severity,
            message: format!("and {} more", left.len()),
            hint: Some("they are shown when the earlier ones are corrected".to_owned()),
            stretch: None,
            labels: Vec::new(),
            fix: None,
        });
    }
    seen
}

fn one(diagnostic: &Diagnostic, texts: &Texts) -> DiagnosticView {
    let place = diagnostic.place.as_ref();
    let document = place.and_then(|place| document(place, texts));
    let labels = diagnostic.labels.iter().map(|label| LabelView {
        document: self::document(&label.place, texts),
        stretch: Some(stretch(&label.place)),
        text: label.text.clone(),
    });
    DiagnosticView {
        document,
        path: place.map(|place| place.source.name().to_owned()),
        code: diagnostic.code.as_str(),
        severity: diagnostic.severity,
        message: diagnostic.message.clone(),
        hint: diagnostic.hint.clone(),
        stretch: place.map(stretch),
        labels: labels.collect(),
        fix: fix(diagnostic, document),
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
