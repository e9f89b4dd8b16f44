//! Values that a result was run with, taken into the texts of the page: "make it the model".

use std::sync::Arc;

use loosepin::report::known_values;
use loosepin::study::result::WitnessValue;
use loosepin::study::{StudyModel, number_and_unit};
use loosepin::units::{ReadableUnit, format_value};
use serde::Serialize;

use crate::edit;
use crate::files::folder::Folder;
use crate::files::stored::stored_study;
use crate::messages::Document;
use crate::network::refusal::Refusal;
use crate::view::places::unquoted;
use crate::view::texts::{Texts, unreadable};

/// Both texts with the values in them.
#[derive(Debug, Serialize)]
pub struct AdoptedTexts {
    /// The model.
    pub model: String,
    /// The study.
    pub study: Option<String>,
    /// The values, in words.
    pub words: String,
    /// Whether the study on the page is another one than the result was made of, but for these values.
    pub has_changed: bool,
}

/// The texts in which each of the values is known exactly that the result in the folder `path` offers at `place`.
///
/// # Errors
/// There is no such result or value; a value cannot be known so in these texts.
pub fn adopted(folder: &Folder, texts: &Texts, path: &str, place: usize) -> Result<AdoptedTexts, Refusal> {
    let result = stored_study(folder, path)?;
    let known = known_values(&result).into_iter().nth(place);
    let known = known.ok_or_else(|| Refusal::bad(format!("the result '{path}' has no such value")))?;
    let made_of = Texts::of_result(&result).ok();
    let is_same = |made_of: &Texts| {
        let text = |texts: &Texts| texts.study.as_ref().map(|study| study.text().to_owned());
        made_of.model.text() == texts.model.text() && text(made_of) == text(texts)
    };
    let mut now = texts.with(folder, None, None);
    for (path, value) in &known.values {
        let WitnessValue::Number(value_si) = value else {
            return Err(Refusal::bad(format!("'{path}' is chosen from a list, so the model has no number for it"))
                .with_hint("change it in the text"));
        };
        let text = written(&now, path, *value_si)?;
        let changes = edit::set_uncertainty(folder, &now, path, &text)?;
        let new = |document: Document, old: &str| edit::applied(old, &changes, document);
        let model = new(Document::Model, now.model.text());
        let study = now.study.as_ref().map(|study| new(Document::Study, study.text()));
        now = now.with(folder, Some(&model), study.as_deref());
    }
    Ok(AdoptedTexts {
        model: now.model.text().to_owned(),
        study: now.study.as_ref().map(|study| study.text().to_owned()),
        words: known.words,
        has_changed: !made_of.as_ref().is_some_and(is_same),
    })
}

/// A value in the unit in which the model has it.
fn written(texts: &Texts, path: &str, value_si: f64) -> Result<String, Refusal> {
    let model = StudyModel::from_source(Arc::clone(&texts.model)).map_err(|_| unreadable("model"))?;
    let missing = || Refusal::bad(format!("the model has no number '{path}'"));
    let quantities = model.quantities();
    let quantity = quantities.id(path).map(|id| &quantities[id]).ok_or_else(missing)?;
    let source = model.source();
    let old = quantity.span.map(|span| &source.text()[unquoted(source, span)]);
    let unit = old.and_then(|text| number_and_unit(text.trim())).map(|(_, unit)| unit);
    let unit = unit.and_then(|unit| ReadableUnit::of_dimension(unit, quantity.dimension));
    Ok(unit.map_or_else(|| format_value(value_si, quantity.dimension), |unit| unit.format(value_si)))
}
