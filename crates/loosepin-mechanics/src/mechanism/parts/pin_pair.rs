//! Sizes and materials of a pin in its hole, whichever law of contact it has.

use crate::contact::LinePair;
use crate::model::{Clearance, Model, PlayId, Values};

/// The pin and its hole, with the length of the bearing or, where none is given, that of its diameter. `None` for what is no pin in a
/// hole, and where the stiffness does not come from materials.
pub fn pin_pair(model: &Model, values: &Values, play: PlayId) -> Option<LinePair> {
    let clearance = pin_clearance(model, play)?;
    let materials = model.contacts[clearance.contact.0].law.materials()?;
    let bearing_radius_m = values[clearance.bearing_radius_m];
    Some(LinePair {
        bearing_radius_m,
        clearance_m: values[clearance.radial_clearance_m],
        length_m: clearance.bearing_length_m.map_or(2.0 * bearing_radius_m, |id| values[id]),
        compliances_1_pa: materials.compliances_1_pa(values),
    })
}

/// The clearance of a pin in a hole.
pub fn pin_clearance(model: &Model, play: PlayId) -> Option<&Clearance> {
    let PlayId::Joint(joint) = play else { return None };
    model.joints[joint.0].kind.pin_clearance()
}
