//! Another name for something, wherever its name stands in both texts.

use super::edit::Named;
use super::names::mentions;
use crate::edit::toml::lines::EditedText;
use crate::messages::Document;
use crate::network::refusal::Refusal;

/// What can get another name here.
const TABLES: [&str; 10] =
    ["body", "contact", "joint", "coupling", "cam", "spring", "load", "drive", "control", "output"];
/// Letters of a name.
const LONGEST: usize = 64;

/// Both texts with another name.
///
/// # Errors
/// It is not there, or the new name is none, or is in use.
pub fn renamed(
    model: &EditedText,
    study: Option<&EditedText>,
    what: &Named,
    to: &str,
) -> Result<(EditedText, Option<EditedText>), Refusal> {
    if !TABLES.contains(&what.table.as_str()) || what.table == "body" && what.name == "ground" && what.point.is_none() {
        return Err(Refusal::bad(format!("{} keeps its name here", what.words())).with_hint("change it in the text"));
    }
    if !is_name(to) {
        return Err(Refusal::bad(format!("'{to}' is not a valid name"))
            .with_hint("a name begins with a letter, and has letters, digits, - and _"));
    }
    let named = mentions(Document::Model, &model.scanned()?);
    let is_there = |of: &Named| named.iter().any(|mention| mention.is_own && mention.of == *of);
    if !is_there(what) {
        return Err(Refusal::bad(format!("{} no longer exists", what.words())));
    }
    let new = match &what.point {
        Some(_) => Named::point(&what.name, to),
        None => Named::new(&what.table, to),
    };
    if new != *what && is_there(&new) {
        return Err(Refusal::bad(format!("there is a {} already", new.words())));
    }
    let of = |lines: &EditedText, document| -> Result<EditedText, Refusal> {
        let mut pieces = Vec::new();
        for mention in mentions(document, &lines.scanned()?) {
            let is_meant = mention.of == *what
                || what.point.is_none()
                    && mention.of.point.is_some()
                    && Named::new(&mention.of.table, &mention.of.name) == *what
                    && !mention.is_own;
            if is_meant {
                let written = &lines.text()[mention.span.clone()];
                pieces.push((mention.span.clone(), as_written(written, &mention.written, &mention.renamed(what, to))));
            }
        }
        let mut new = lines.clone();
        new.replace(pieces)?;
        Ok(new)
    };
    Ok((of(model, Document::Model)?, study.map(|study| of(study, Document::Study)).transpose()?))
}

/// A new text in the quotes of the old one.
fn as_written(written: &str, old: &str, new: &str) -> String {
    let quote = written.chars().next().filter(|mark| ['"', '\''].contains(mark));
    let is_bare = new.chars().all(|c| c.is_ascii_alphanumeric() || matches!(c, '_' | '-'));
    match quote {
        Some(mark) if written == format!("{mark}{old}{mark}") => format!("{mark}{new}{mark}"),
        None if is_bare => new.to_owned(),
        _ => serde_json::to_string(new).unwrap_or_default(),
    }
}

/// Whether something may be called so.
pub fn is_name(name: &str) -> bool {
    name.chars().count() <= LONGEST
        && name.chars().next().is_some_and(|first| first.is_alphabetic() || first == '_')
        && name.chars().all(|letter| letter.is_alphanumeric() || matches!(letter, '_' | '-'))
}
