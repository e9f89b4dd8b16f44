//! The elastic foundation of a joint whose worn shape acts back.

use crate::contact::{
    Foundation, FrictionLaw, NormalContact, NormalLaw, liu_foundation_pa_m, point_law_foundation_pa_m,
};
use crate::model::{FoundationChoice, JointId, Model, Values};

/// The foundation of `joint`, unworn, where its model lets wear act back; `normal` gives the loss of the contact, and the stiffness where
/// the model takes it from there.
pub(in crate::mechanism) fn foundation(
    model: &Model,
    values: &Values,
    joint: JointId,
    normal: &NormalLaw<f64>,
    friction: &FrictionLaw<f64>,
) -> Option<Foundation> {
    if !model.has_worn_geometry() {
        return None;
    }
    let wear = model.joints[joint.0].wear.as_ref()?;
    let clearance = model.joints[joint.0].kind.pin_clearance()?;
    let (radius_m, length_m) = (values[clearance.bearing_radius_m], values[wear.bearing_length_m]);
    let clearance_m = values[clearance.radial_clearance_m];
    let materials = model.contacts[clearance.contact.0].law.materials();
    let stiffness_pa_m = match (wear.foundation, materials, normal.stiffness()) {
        (FoundationChoice::Given(id), ..) => values[id],
        (FoundationChoice::Liu, Some(materials), _) => {
            liu_foundation_pa_m(materials.compliances_1_pa(values), radius_m)
        }
        (FoundationChoice::Law, _, Some((stiffness_n_m1_5, _))) => {
            point_law_foundation_pa_m(stiffness_n_m1_5, clearance_m, radius_m, length_m)
        }
        // Refused where the model is read, and where another law is set.
        (FoundationChoice::Liu | FoundationChoice::Law, ..) => f64::NAN,
    };
    let sizes_m = [radius_m, clearance_m, length_m];
    Some(Foundation::unworn(sizes_m, stiffness_pa_m, normal.damping_factor(), *friction, wear.sectors))
}
