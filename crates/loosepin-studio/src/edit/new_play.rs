//! Play of a joint that has none yet, with what belongs to it.

use loosepin::diagnostics::Span;
use loosepin::model::Origin;
use loosepin::study::StudyModel;

use super::toml::lines::EditedText;
use crate::network::refusal::Refusal;
use crate::view::places::unquoted;

/// Key of a radial clearance.
pub const PLAY: &str = "radial_clearance";
/// Key of the radius of a bearing, and the radius if no other joint has a stated one.
const RADIUS: &str = "bearing_radius";
const FIRST_RADIUS: &str = "8 mm";
/// Key of the length of a bearing, and the length if no other joint has one.
const LENGTH: &str = "bearing_length";
const FIRST_LENGTH: &str = "20 mm";
/// Key of a contact; name and numbers of one that nobody has described.
const CONTACT: &str = "contact";
const FIRST_CONTACT: &str = "\n# first guess: steel on steel\n[contact.steel]\nlaw = \"lankarani-nikravesh\"\nrestitution = 0.9\n\
    youngs_modulus = \"207 GPa\"\npoisson_ratio = 0.3\ndensity = \"7800 kg/m^3\"\n";

/// Gives a joint its play: the clearance, and the other keys that it needs.
///
/// # Errors
/// The text cannot be changed so.
pub fn give_play(text: &mut EditedText, model: &StudyModel, joint: &str, value: &str) -> Result<(), Refusal> {
    let needed = model.keys_of_new_play(joint);
    let table = ["joint", joint];
    let place = |key| [table[0], table[1], key];
    // What is there already stays; a clearance of zero is replaced.
    if needed.contains(&RADIUS) && text.value_span(&place(RADIUS))?.is_none() {
        let remark = remark(text, &table)?;
        text.add_entry(&table, RADIUS, &format!("\"{}\"{remark}", radius(model)))?;
    }
    match text.value_span(&place(PLAY))? {
        Some(zero) => text.replace([(zero, value.to_owned())])?,
        None => text.add_entry(&table, PLAY, value)?,
    }
    if needed.contains(&LENGTH) && text.value_span(&place(LENGTH))?.is_none() {
        let remark = remark(text, &table)?;
        text.add_entry(&table, LENGTH, &format!("\"{}\"{remark}", length(model)))?;
    }
    if needed.contains(&CONTACT) {
        let contacts = model.contact_names();
        if text.value_span(&place(CONTACT))?.is_none() {
            text.add_entry(&table, CONTACT, &format!("\"{}\"", contacts.first().unwrap_or(&"steel")))?;
        }
        if contacts.is_empty() {
            text.insert(text.text().len(), FIRST_CONTACT)?;
        }
    }
    Ok(())
}

/// What is said behind a first guess. Nothing but its end can stand behind a comment on a line.
fn remark(text: &EditedText, table: &[&str]) -> Result<&'static str, Refusal> {
    Ok(if text.value_span(table)?.is_some() { "" } else { "  # first guess" })
}

/// The first radius of a bearing that is stated as a number, as it is written.
fn radius(model: &StudyModel) -> String {
    let is_radius = |path: &str| path.starts_with("joint.") && path.rsplit('.').next() == Some(RADIUS);
    let radius = model.quantities().iter().find(|(_, own)| is_radius(&own.path) && own.origin == Origin::Literal);
    radius.and_then(|(_, quantity)| Some(written(model, quantity.span?))).unwrap_or_else(|| FIRST_RADIUS.to_owned())
}

/// The length of the first bearing with play, as it is written.
fn length(model: &StudyModel) -> String {
    let length = model.first_bearing_length().and_then(|length| model.quantities()[length].span);
    length.map_or_else(|| FIRST_LENGTH.to_owned(), |span| written(model, span))
}

fn written(model: &StudyModel, span: Span) -> String {
    let source = model.source();
    source.text()[unquoted(source, span)].to_owned()
}
