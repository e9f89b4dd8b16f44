//! Which law of contact stands behind a force that is asked about, and how a study takes another one beside it.

use std::fmt::Write;

use loosepin::contact::{LONG_PIN_LAW, NormalDescription};
use loosepin::mechanism::pin_clearance;
use loosepin::model::{ContactId, JointId, Model, PlayId, Recorded, Stiffness, Values};
use loosepin::units::{Dimension, format_value};

/// Adds, for each of `joints` whose force comes from a point contact between pin and hole, what that leaves out and the list of laws for
/// a study. Nothing for other joints, and for contacts among `listed`.
pub fn push_force_laws(
    text: &mut String,
    model: &Model,
    values: &Values,
    joints: impl Iterator<Item = JointId>,
    listed: &[ContactId],
) {
    let mut told: Vec<ContactId> = Vec::new();
    for joint in joints {
        let play = PlayId::Joint(joint);
        let Some(clearance) = pin_clearance(model, play).filter(|_| model.has_play(play, values)) else { continue };
        let contact = &model.contacts[clearance.contact.0];
        let is_of_points = matches!(contact.law, NormalDescription::Point(_))
            && matches!(contact.stiffness, Stiffness::Material { .. });
        if !is_of_points || listed.contains(&clearance.contact) || told.contains(&clearance.contact) {
            continue;
        }
        told.push(clearance.contact);
        let (name, law) = (&model.joints[joint.0].name, contact.law.name());
        let length = match clearance.bearing_length_m {
            Some(id) => {
                format!("its bearing length of {} does not enter", format_value(values[id], Dimension::LENGTH))
            }
            None => "no bearing length enters".to_owned(),
        };
        let _ = writeln!(text, "\nThe force in {name} is by {law}, a point contact: {length}.");
        let _ = writeln!(
            text,
            "A long pin is a line contact, whose peak force may be twice as large. To have both in a study:"
        );
        if clearance.bearing_length_m.is_none() {
            let _ = writeln!(text, "  [joint.{name}] of the model: bearing_length = \"...\"");
        }
        let _ = writeln!(
            text,
            "  [epistemic] of the study: \"contact.{}.law\" = {{ any_of = [\"{law}\", \"{}\"] }}",
            contact.name, LONG_PIN_LAW.name
        );
    }
}

/// The joints whose force is an output of the model, in file order.
pub fn joints_of_forces(model: &Model) -> impl Iterator<Item = JointId> {
    model.outputs.iter().filter_map(|output| match output.kind.recorded() {
        Recorded::Number(reading) => reading.force_in(),
        Recorded::Path(_) | Recorded::Wear(..) => None,
    })
}
