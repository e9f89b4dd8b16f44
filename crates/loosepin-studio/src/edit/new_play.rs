//! Play of a joint that has none yet, with what belongs to it.

use loosepin::model::{Model, Origin};
use loosepin::space::SpatialModel;
use loosepin::study::StudyModel;

use super::toml::lines::EditedText;
use crate::network::refusal::Refusal;
use crate::view::places::unquoted;

/// Key of a radial clearance.
pub const PLAY: &str = "radial_clearance";
/// Radius of a bearing without a stated one, if no other joint has one.
const FIRST_RADIUS: &str = "8 mm";
/// Key of the length of a bearing in space, and the length if no other joint has one.
const LENGTH: &str = "bearing_length";
const FIRST_LENGTH: &str = "20 mm";
/// Name and numbers of a contact that nobody has described.
const FIRST_CONTACT: &str = "\n# first guess: steel on steel\n[contact.steel]\nlaw = \"lankarani-nikravesh\"\nrestitution = 0.9\n\
    youngs_modulus = \"207 GPa\"\npoisson_ratio = 0.3\ndensity = \"7800 kg/m^3\"\n";

/// Whether a joint of this name is there, has no play, and could have one.
pub fn can_have_play(model: &StudyModel, name: &str) -> bool {
    if let Some(model) = model.spatial() {
        return keys_in_space(model, name).is_some();
    }
    let joint = model.planar().and_then(|model| model.joints.iter().find(|joint| joint.name == name));
    joint.is_some_and(|joint| joint.kind.turns() && joint.kind.play().is_none())
}

/// Gives a joint its play.
///
/// # Errors
/// The text cannot be changed so.
pub fn give_play(text: &mut EditedText, model: &StudyModel, joint: &str, value: &str) -> Result<(), Refusal> {
    if let Some(model) = model.planar() {
        return give_planar_play(text, model, joint, value);
    }
    let table = ["joint", joint];
    text.add_entry(&table, PLAY, value)?;
    let needed = model.spatial().and_then(|model| keys_in_space(model, joint)).unwrap_or_default();
    if needed.contains(&LENGTH) && text.value_span(&[table[0], table[1], LENGTH])?.is_none() {
        let length = model.spatial().and_then(written_length).unwrap_or_else(|| FIRST_LENGTH.to_owned());
        // Nothing but its end can stand behind a comment on a line.
        let remark = if text.value_span(&table)?.is_some() { "" } else { "  # first guess" };
        text.add_entry(&table, LENGTH, &format!("\"{length}\"{remark}"))?;
    }
    Ok(())
}

/// The keys of the play of an ideal joint in space; `None` of a joint that has play, or can have none.
fn keys_in_space(model: &SpatialModel, name: &str) -> Option<&'static [&'static str]> {
    let joint = model.joints.iter().find(|joint| joint.name == name && joint.play.is_none())?;
    Some(joint.kind.play_keys()).filter(|keys| !keys.is_empty())
}

/// The length of the first bearing with play, as it is written.
fn written_length(model: &SpatialModel) -> Option<String> {
    let length = model.joints.iter().find_map(|joint| joint.play?.bearing_length_m())?;
    let source = model.source();
    Some(source.text()[unquoted(source, model.quantities[length].span?)].to_owned())
}

/// Of a joint in the plane: the radius of the bearing and the contact.
fn give_planar_play(text: &mut EditedText, model: &Model, joint: &str, value: &str) -> Result<(), Refusal> {
    let table = ["joint", joint];
    let radius = model.quantities.iter().find(|(_, quantity)| {
        quantity.path.starts_with("joint.")
            && quantity.path.ends_with(".bearing_radius")
            && quantity.origin == Origin::Literal
    });
    let source = model.source();
    let radius = radius.and_then(|(_, quantity)| Some(source.text()[unquoted(source, quantity.span?)].to_owned()));
    let radius = radius.unwrap_or_else(|| FIRST_RADIUS.to_owned());
    let contact = model.contacts.first().map(|contact| contact.name.as_str());
    let name = contact.unwrap_or("steel");
    // Nothing but its end can stand behind a comment on a line.
    let remark = if text.value_span(&table)?.is_some() { "" } else { "  # first guess" };
    // What is there already stays; a clearance of zero is replaced.
    let place = |key| [table[0], table[1], key];
    if text.value_span(&place("bearing_radius"))?.is_none() {
        text.add_entry(&table, "bearing_radius", &format!("\"{radius}\"{remark}"))?;
    }
    match text.value_span(&place(PLAY))? {
        Some(zero) => text.replace([(zero, value.to_owned())])?,
        None => text.add_entry(&table, PLAY, value)?,
    }
    if text.value_span(&place("contact"))?.is_none() {
        text.add_entry(&table, "contact", &format!("\"{name}\""))?;
    }
    if contact.is_none() {
        text.insert(text.text().len(), FIRST_CONTACT)?;
    }
    Ok(())
}
