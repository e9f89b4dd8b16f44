//! The elastic foundation of a joint whose worn shape acts back.

use crate::contact::{
    Foundation, FrictionLaw, NormalContact, NormalLaw, compliance_1_pa, liu_foundation_pa_m, point_law_foundation_pa_m,
};
use crate::model::{FoundationChoice, JointId, Model, Stiffness, Values};

/// The foundation of `joint`, unworn, where its model lets wear act back; `normal` gives the loss of the contact, and the stiffness where
/// the model takes it from there.
pub(super) fn foundation(
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
    let stiffness_pa_m = match (wear.foundation, &model.contacts[clearance.contact.0].stiffness, normal) {
        (FoundationChoice::Given(id), ..) => values[id],
        (FoundationChoice::Liu, Stiffness::Material { youngs_modulus_pa, poisson_ratio }, _) => {
            let compliance =
                |side: usize| compliance_1_pa(values[youngs_modulus_pa[side]], values[poisson_ratio[side]]);
            liu_foundation_pa_m([0, 1].map(compliance), radius_m)
        }
        (FoundationChoice::Law, _, NormalLaw::Point(point)) => {
            point_law_foundation_pa_m(point.stiffness_n_m_n, clearance_m, radius_m, length_m)
        }
        // Refused where the model is read.
        (FoundationChoice::Liu | FoundationChoice::Law, ..) => f64::NAN,
    };
    let sizes_m = [radius_m, clearance_m, length_m];
    Some(Foundation::unworn(sizes_m, stiffness_pa_m, normal.damping_factor(), *friction, wear.sectors))
}
