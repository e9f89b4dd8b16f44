//! The numbers of the texts, each with the stretch that a field of the page replaces.

use loosepin::diagnostics::{Source, Span};
use loosepin::document::{describe_path, parse_toml};
use loosepin::model::QuantityTable;
use std::sync::Arc;

use crate::edit::Locks;
use crate::messages::{Document, QuantityKind, QuantityView};
use crate::view::places::unquoted;
use crate::view::texts::Texts;

/// Tables of a study whose entries describe uncertainties, and their names on the page.
const KNOWN: [(&str, QuantityKind); 2] = [("random", QuantityKind::Scatter), ("epistemic", QuantityKind::Unknown)];

/// Numbers of the model in the order of its text, then what the study says of them.
pub fn quantities(numbers: &QuantityTable, texts: &Texts) -> Vec<QuantityView> {
    let locks = Locks::of(texts.model.text());
    let mut of_model: Vec<QuantityView> = numbers
        .iter()
        .filter_map(|(_, quantity)| {
            let span = quantity.span?;
            let entry = entry(&texts.model, Document::Model, &quantity.path, span, QuantityKind::Number);
            Some(QuantityView { is_locked: locks.hold(span.start), ..entry })
        })
        .collect();
    of_model.sort_by_key(|quantity| quantity.from);
    of_model.into_iter().chain(texts.study.iter().flat_map(of_study)).collect()
}

fn of_study(study: &Arc<Source>) -> Vec<QuantityView> {
    let Ok(toml) = parse_toml(study) else { return Vec::new() };
    let mut found = Vec::new();
    for (table, kind) in KNOWN {
        let entries = toml.get_ref().get(table).and_then(|table| table.get_ref().as_table());
        for (path, value) in entries.into_iter().flatten() {
            found.push(entry(study, Document::Study, path.get_ref(), value.span().into(), kind));
        }
    }
    found
}

fn entry(source: &Source, document: Document, path: &str, span: Span, kind: QuantityKind) -> QuantityView {
    let range = unquoted(source, span);
    QuantityView {
        path: path.to_owned(),
        words: describe_path(path),
        document,
        written: source.text()[range.clone()].to_owned(),
        from: source.utf16_units(range.start),
        to: source.utf16_units(range.end),
        kind,
        is_locked: false,
    }
}
