//! Assumptions behind the force of each contact, and its force by a line-contact law: for the record of a run or study.

use loosepin_mechanics::contact::{LONG_PIN_LAW, NormalContact, force_of_same_energy_n};
use loosepin_mechanics::mechanism::{Mechanism, PlayGeometry, pin_clearance, pin_pair};
use loosepin_mechanics::model::{PlayId, Values};
use loosepin_result::{ContactBasis, ContactShape, LongPinForce};

/// Assumptions behind the force of a joint or coupling with play; `numbers` are those of the sample with `values`.
pub fn contact_basis(
    mechanism: &Mechanism,
    play: PlayId,
    numbers: &PlayGeometry<f64>,
    values: &Values,
) -> Option<ContactBasis> {
    let model = &mechanism.model;
    let contact = &model.contacts[model.play_contact(play)?.0];
    let length_m = pin_clearance(model, play).and_then(|clearance| clearance.bearing_length_m).map(|id| values[id]);
    let shape = match (contact.law.line(), length_m) {
        _ if numbers.foundation.is_some() => ContactShape::Foundation,
        _ if contact.law.materials().is_none() => ContactShape::Given,
        (Some(_), Some(length_m)) => ContactShape::Line { length_m },
        _ => ContactShape::Point { unused_length_m: length_m },
    };
    let largest_valid_m_s = numbers.largest_valid_impact_speed_m_s;
    Some(ContactBasis {
        shape,
        is_law_named: contact.is_law_named,
        minimum_impact_speed_m_s: Some(numbers.minimum_impact_speed_m_s),
        largest_valid_speed_m_s: largest_valid_m_s.is_finite().then_some(largest_valid_m_s),
        largest_valid_penetration_m: if shape == ContactShape::Foundation { None } else { numbers.normal.limit_m() },
    })
}

/// The force of a line-contact law at the energy that a point contact has stored at `penetration_m`. `None` for other contacts, and
/// where nothing touched.
pub fn long_pin_force(
    mechanism: &Mechanism,
    play: PlayId,
    numbers: &PlayGeometry<f64>,
    values: &Values,
    penetration_m: f64,
) -> Option<LongPinForce> {
    let ContactShape::Point { unused_length_m } = contact_basis(mechanism, play, numbers, values)?.shape else {
        return None;
    };
    let pair = pin_pair(&mechanism.model, values, play).filter(|_| penetration_m > 0.0)?;
    let line = (LONG_PIN_LAW.contact)(&pair, 0.0);
    Some(LongPinForce {
        law: LONG_PIN_LAW.name.to_owned(),
        length_m: pair.length_m,
        is_length_given: unused_length_m.is_some(),
        force_n: force_of_same_energy_n(&numbers.normal, penetration_m, &line),
    })
}
