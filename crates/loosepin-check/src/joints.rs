//! Descriptions of joints and their contacts.

use loosepin_mechanics::contact::NormalContact;
use loosepin_mechanics::mechanism::{Mechanism, PlayGeometry, Sample};
use loosepin_mechanics::model::{
    Contact, Coupling, Friction, Joint, JointId, JointPlay, JointWear, Model, PlayId, QuantityId, SlidingVelocity,
    Values,
};
use loosepin_text::article::{Fact, Section};
use loosepin_text::units::{Dimension, counted_or_no, format_number, format_value, listed};

use super::names::ModelNames;

/// Each joint with its drive, its friction, its wear and its play.
pub fn joints(mechanism: &Mechanism, values: &Values) -> Section {
    let model = &mechanism.model;
    let with_play = mechanism.plays.iter().filter(|play| matches!(play, PlayId::Joint(_))).count();
    let heading = format!("{}, {with_play} with play", counted_or_no(model.joints.len(), "joint", "joints"));
    let sample = Sample::<f64>::new(mechanism, values).ok();
    let fact = |(index, joint): (usize, &Joint)| {
        Fact::new(&joint.name, joint_lines((mechanism, sample.as_ref()), (JointId(index), joint), values))
    };
    Section::of_facts("joints", heading, model.joints.iter().enumerate().map(fact))
}

fn joint_lines(
    (mechanism, sample): (&Mechanism, Option<&Sample<f64>>),
    (id, joint): (JointId, &Joint),
    values: &Values,
) -> Vec<String> {
    let model = &mechanism.model;
    let names = ModelNames { model, values };
    let mut lines = vec![format!("{}{}", joint.kind.words(&names), drive_words(model, id, values))];
    if let Some(friction) = &joint.friction {
        let what = if joint.kind.slides() { "a guide length of" } else { "a pin radius of" };
        let size = format_value(values[friction.size_m], Dimension::LENGTH);
        lines.push(format!("{}, at {what} {size}", friction_words(model, &friction.friction, values)));
    }
    lines.extend(joint.wear.as_ref().map(|wear| wear_words(model, wear, values)));
    let Some(JointPlay { contact, .. }) = joint.kind.play() else { return lines };
    let Some(play) = mechanism.plays.iter().position(|play| *play == PlayId::Joint(id)) else {
        lines.push(format!("ideal, because its {} is 0 mm", joint.kind.clearance_key().replace('_', " ")));
        return lines;
    };
    let numbers = sample.map(|sample| &sample.plays[play]);
    let contact = &model.contacts[contact.0];
    let length = joint.kind.pin_clearance().and_then(|clearance| clearance.bearing_length_m);
    lines.extend(joint.kind.play_words(&names));
    lines.extend(contact_lines(model, contact, length, values, numbers));
    lines
}

/// Lines on the play of each coupling; none for couplings without play.
pub fn coupling_lines(mechanism: &Mechanism, values: &Values) -> Vec<Vec<String>> {
    let model = &mechanism.model;
    let sample = Sample::<f64>::new(mechanism, values).ok();
    let lines = |(index, coupling): (usize, &Coupling)| {
        let Some(play) = coupling.play else { return Vec::new() };
        let Some(place) = mechanism.plays.iter().position(|play| *play == PlayId::Coupling(index)) else {
            return vec!["ideal, because its backlash is 0 mm".to_owned()];
        };
        let words = play.words(&ModelNames { model, values });
        let numbers = sample.as_ref().map(|sample| &sample.plays[place]);
        let contact = contact_lines(model, &model.contacts[play.contact.0], None, values, numbers);
        std::iter::once(words).chain(contact).collect()
    };
    model.couplings.iter().enumerate().map(lines).collect()
}

fn drive_words(model: &Model, joint: JointId, values: &Values) -> String {
    let Some(drive) = model.drives.iter().find(|drive| drive.joint == joint) else { return String::new() };
    format!(", driven by '{}' {}", drive.name, drive.law.words(&ModelNames { model, values }))
}

fn wear_words(model: &Model, wear: &JointWear, values: &Values) -> String {
    let surfaces = ["bearing", "journal"].into_iter().zip(wear.coefficients_m2_n);
    let surfaces = surfaces.filter_map(|(surface, coefficient)| {
        let coefficient = format_value(values[coefficient?], Dimension::WEAR_COEFFICIENT);
        Some(format!("{surface} {coefficient}"))
    });
    let surfaces = surfaces.collect::<Vec<String>>().join(", ");
    let cycles = model.wear.map_or(1.0, |life| values[life.cycles]);
    let word = if cycles == 1.0 { "cycle" } else { "cycles" };
    format!(
        "wear: {surfaces}, in {} sectors; shown after {} {word}",
        wear.sectors,
        format_value(cycles, Dimension::NUMBER)
    )
}

fn contact_lines(
    model: &Model,
    contact: &Contact,
    bearing_length_m: Option<QuantityId>,
    values: &Values,
    numbers: Option<&PlayGeometry<f64>>,
) -> Vec<String> {
    if contact.is_missing {
        return vec!["no contact is named".to_owned()];
    }
    let mut lines = Vec::new();
    let default = if contact.is_law_named { "" } else { " by default" };
    let mut law = format!("contact '{}': {}{default}", contact.name, contact.law.name());
    if let (Some(_), Some(loss)) = (contact.law.line(), contact.law.loss()) {
        law.push_str(&format!(", energy loss of {}", loss.name));
    }
    match (contact.law.restitution(), contact.law.damping_coefficient()) {
        (Some(restitution), _) => {
            law.push_str(&format!(", restitution {}", format_number(values[restitution])));
            if let Some(delivered) = numbers.and_then(|numbers| numbers.delivered_restitution) {
                law.push_str(&format!(" (a free impact gives {delivered:.4})"));
            }
        }
        (None, Some(damping)) => {
            let damping = format_value(values[damping], Dimension::DAMPING);
            law.push_str(&format!(", damping {damping} (the restitution of a free impact depends on the masses)"));
        }
        (None, None) => {}
    }
    lines.push(law);
    let stiffness =
        numbers.map_or(String::new(), |numbers| stiffness_words(contact, bearing_length_m, numbers, values));
    let friction = match &contact.friction {
        None => "no friction".to_owned(),
        Some(friction) => friction_words(model, friction, values),
    };
    lines.push(format!("{stiffness}{friction}"));
    if let Some(film) = &contact.film {
        let length = |id| format_value(values[id], Dimension::LENGTH);
        let bearing = bearing_length_m.map_or(String::new(), |id| format!(", {} of bearing", length(id)));
        lines.push(format!(
            "film of oil by {}: viscosity {}, roughness {}{bearing}",
            film.law.name,
            format_value(values[film.viscosity_pa_s], Dimension::VISCOSITY),
            length(film.roughness_m)
        ));
    }
    if let Some(limit_m_s) =
        numbers.map(|numbers| numbers.largest_valid_impact_speed_m_s).filter(|limit| limit.is_finite())
    {
        let about_m_s = numbers.zip(fastest_drive_rad_s(model, values)).map(|(own, rate)| rate * own.clearance_m);
        let expected = match about_m_s.filter(|speed| *speed > limit_m_s) {
            Some(speed) => {
                format!("drive speed times clearance is already {}, so faster impacts are likely", rounded_speed(speed))
            }
            None => "a run shows the share of faster impacts".to_owned(),
        };
        lines.push(format!("the law is valid for impacts up to {}; {expected}", rounded_speed(limit_m_s)));
    }
    lines
}

/// Speed of the fastest drive that turns at a constant one, rad/s.
fn fastest_drive_rad_s(model: &Model, values: &Values) -> Option<f64> {
    let rotary = model.drives.iter().filter(|drive| model.joints[drive.joint.0].kind.turns());
    let speeds = rotary.filter_map(|drive| Some(values[drive.law.steady()?.speed].abs()));
    speeds.max_by(f64::total_cmp)
}

fn stiffness_words(
    contact: &Contact,
    bearing_length_m: Option<QuantityId>,
    numbers: &PlayGeometry<f64>,
    values: &Values,
) -> String {
    match (numbers.normal.stiffness(), bearing_length_m) {
        (Some((stiffness, exponent)), _) => {
            let shown = |stiffness| format_value(stiffness, Dimension::contact_stiffness(exponent));
            let origin = if contact.law.materials().is_some() { "from the materials" } else { "as given" };
            match numbers.shape.wall_shares() {
                Some(walls) => {
                    let walls = walls.map(|(wall, share)| format!("{} {wall}", shown(stiffness * share)));
                    format!("stiffness {}, {origin}; ", listed(&walls, "and"))
                }
                None => format!("stiffness {} {origin}; ", shown(stiffness)),
            }
        }
        (None, Some(length)) => {
            let limit = numbers.normal.limit_m().map_or(String::new(), |limit_m| {
                format!(", valid up to a penetration of {}", format_value(limit_m, Dimension::LENGTH))
            });
            format!("line contact over {}{limit}; ", format_value(values[length], Dimension::LENGTH))
        }
        (None, None) => String::new(),
    }
}

fn friction_words(model: &Model, friction: &Friction, values: &Values) -> String {
    let reading = match friction.sliding_velocity {
        SlidingVelocity::Material => "",
        SlidingVelocity::Literal => ", sliding velocity by the literal reading",
    };
    let numbers: Vec<String> = friction
        .law
        .numbers
        .iter()
        .zip(&friction.numbers)
        .map(|(number, id)| {
            let value = format_value(values[*id], model.quantities[*id].dimension);
            format!("{} {value}", number.name().replace('_', " "))
        })
        .collect();
    format!("friction by {}: {}{reading}", friction.law.name, numbers.join(", "))
}

/// A speed with two digits, however small it is.
fn rounded_speed(speed_m_s: f64) -> String {
    let rounded: f64 = format!("{speed_m_s:.1e}").parse().unwrap_or(speed_m_s);
    format_value(rounded, Dimension::VELOCITY)
}

#[cfg(test)]
mod tests {
    use super::rounded_speed;

    #[test]
    fn a_slow_speed_keeps_its_digits() {
        assert_eq!(
            [0.050_31, 0.002_14, 12.34, 3e-7].map(rounded_speed),
            ["0.05 m/s", "0.0021 m/s", "12 m/s", "3e-7 m/s"]
        );
    }
}
