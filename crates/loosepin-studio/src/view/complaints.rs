//! Complaints as the page shows them.

use loosepin::diagnostics::{Complaint, Complaints, Place};

use crate::messages::{Document, SeenComplaint, SeenLabel};
use crate::view::fixes::fix;
use crate::view::places::stretch;
use crate::view::texts::Texts;

/// Most complaints that a page is sent: a list of thousands is of no use to anybody, and takes seconds to be drawn.
const MAX_SHOWN: usize = 200;

/// The first complaints in the order of their places; the last one says how many more there are.
pub fn seen(complaints: &Complaints, texts: &Texts) -> Vec<SeenComplaint> {
    let sorted = complaints.sorted();
    let mut seen: Vec<SeenComplaint> = sorted.iter().take(MAX_SHOWN).map(|complaint| one(complaint, texts)).collect();
    if let Some(left) = sorted.get(MAX_SHOWN..).filter(|left| !left.is_empty()) {
        let gravest = left.iter().max_by_key(|complaint| complaint.severity).unwrap_or(&left[0]);
        seen.push(SeenComplaint {
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
        severity: complaint.severity,
        message: complaint.message.clone(),
        hint: complaint.hint.clone(),
        stretch: place.map(stretch),
        labels: labels.collect(),
        fix: fix(complaint, document),
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
