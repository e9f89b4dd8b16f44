//! The contact law behind a requested force, and how a study compares it with another law.

use loosepin_mechanics::contact::LONG_PIN_LAW;
use loosepin_mechanics::mechanism::pin_clearance;
use loosepin_mechanics::model::{ContactId, JointId, Model, PlayId, Values};
use loosepin_text::article::{Content, Fact, Section};
use loosepin_text::units::{Dimension, format_value};

/// For each of `joints` whose force comes from a point contact between pin and hole: what that leaves out, and the list of laws for a
/// study. Nothing for other joints, and for contacts among `listed`.
pub fn force_laws(
    model: &Model,
    values: &Values,
    joints: impl Iterator<Item = JointId>,
    listed: &[ContactId],
) -> Vec<Section> {
    let mut told: Vec<ContactId> = Vec::new();
    let of_joint = |joint: JointId| {
        let play = PlayId::Joint(joint);
        let clearance = pin_clearance(model, play).filter(|_| model.has_play(play, values))?;
        let contact = &model.contacts[clearance.contact.0];
        let is_of_points = contact.law.materials().is_some() && contact.law.line().is_none();
        if !is_of_points || listed.contains(&clearance.contact) || told.contains(&clearance.contact) {
            return None;
        }
        told.push(clearance.contact);
        let (name, law) = (&model.joints[joint.0].name, contact.law.name());
        let length = match clearance.bearing_length_m {
            Some(id) => {
                format!("its bearing length of {} has no effect", format_value(values[id], Dimension::LENGTH))
            }
            None => "it uses no bearing length".to_owned(),
        };
        let mut section = Section::of_sentences(
            "force-law",
            [
                format!("The force in {name} is by {law}, a point contact: {length}."),
                "A long pin is a line contact, whose peak force may be twice as large. To use both in a study:"
                    .to_owned(),
            ],
        );
        let lacks_length = clearance.bearing_length_m.is_none();
        let of_model = lacks_length.then(|| format!("[joint.{name}] of the model: bearing_length = \"...\""));
        let (contact, long_pin) = (&contact.name, LONG_PIN_LAW.name);
        let of_study =
            format!("[epistemic] of the study: \"contact.{contact}.law\" = {{ any_of = [\"{law}\", \"{long_pin}\"] }}");
        section.push_close(Content::Facts(of_model.into_iter().chain([of_study]).map(Fact::nameless).collect()));
        Some(section)
    };
    joints.filter_map(of_joint).collect()
}

/// The joints whose force is an output of the model, in file order.
pub fn joints_with_force_output(model: &Model) -> impl Iterator<Item = JointId> {
    model.outputs.iter().filter_map(|output| output.kind.reading()?.force_in())
}
