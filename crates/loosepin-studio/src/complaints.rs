//! Complaints as the page shows them.

use loosepin::diagnostics::{Complaint, Complaints, Place};

use crate::fixes::fix;
use crate::messages::{Document, SeenComplaint, SeenLabel};
use crate::places::stretch;
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
