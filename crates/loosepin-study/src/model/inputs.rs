//! Quantities that a study makes uncertain: by their paths, and the plays that follow from them.

use super::StudyModel;
use loosepin_mechanics::model::{ContactId, LawError, NormalDescription, PathError, PlayId};
use loosepin_space::SpatialModel;
use loosepin_text::numbers::{QuantityId, Values};

/// A clearance of something that has play.
#[derive(Debug, Clone, PartialEq)]
pub struct Clearance {
    /// Name of the joint or coupling.
    pub name: String,
    /// The clearance, m.
    pub quantity: QuantityId,
}

impl StudyModel {
    /// The quantity with this path, if it can be set.
    ///
    /// # Errors
    /// No such quantity (with the nearest name); a quantity given by an expression (with what it depends on).
    pub fn find(&self, path: &str) -> Result<QuantityId, PathError> {
        match self {
            Self::Planar(model) => model.find(path),
            Self::Spatial(model) => super::spatial_paths::find(model, path),
        }
    }

    /// The joints and couplings with play whose clearance is this quantity or depends on it.
    pub fn play_from(&self, id: QuantityId) -> Vec<Clearance> {
        match self {
            Self::Planar(model) => {
                let own = model.play_from(id);
                own.map(|(play, quantity)| Clearance { name: model.play_name(play).to_owned(), quantity }).collect()
            }
            Self::Spatial(model) => {
                spatial_clearances(model).filter(|own| model.quantities.depends_on(own.quantity, id)).collect()
            }
        }
    }

    /// Whether a play follows from this quantity.
    pub fn has_play_from(&self, id: QuantityId) -> bool {
        !self.play_from(id).is_empty()
    }

    /// The joints, not couplings, with play whose clearance is this quantity or depends on it, each with the radius of its bearing where the
    /// model has one.
    pub fn bearings_with_play_from(&self, id: QuantityId) -> Vec<(String, Option<QuantityId>)> {
        let Self::Planar(model) = self else {
            return self.play_from(id).into_iter().map(|play| (play.name, None)).collect();
        };
        let joints = model.play_from(id).filter_map(|(play, _)| match play {
            PlayId::Joint(joint) => Some(&model.joints[joint.0]),
            PlayId::Coupling(_) => None,
        });
        joints
            .map(|joint| {
                (
                    joint.name.clone(),
                    joint.kind.pin_clearance().filter(|own| own.has_radius).map(|own| own.bearing_radius_m),
                )
            })
            .collect()
    }

    /// Whether anything may have play.
    pub fn has_play(&self) -> bool {
        !self.play_names().is_empty()
    }

    /// Names of the joints and couplings that may have play, in file order.
    pub fn play_names(&self) -> Vec<String> {
        match self {
            Self::Planar(model) => model.plays().map(|play| model.play_name(play).to_owned()).collect(),
            Self::Spatial(model) => {
                let with_play = model.joints.iter().filter(|joint| joint.play.is_some());
                with_play.map(|joint| joint.name.clone()).collect()
            }
        }
    }

    /// The clearances of planar joints and couplings, which decide how finely a run is resolved; none in space, where nothing is integrated.
    pub fn integrated_clearances(&self) -> Vec<(String, QuantityId)> {
        let own = self.planar().into_iter();
        own.flat_map(|model| model.play_clearances().map(|(play, id)| (model.play_words(play), id))).collect()
    }

    /// The scale of the mechanism, m: the size of its largest body.
    pub fn largest_extent_m(&self, values: &Values) -> f64 {
        match self {
            Self::Planar(model) => model.largest_extent_m(values),
            Self::Spatial(model) => model.largest_extent_m(values),
        }
    }

    /// The contact whose law `path` names; `None` if it names no law.
    pub fn contact_of_law(&self, path: &str) -> Option<Result<ContactId, PathError>> {
        self.planar()?.contact_of_law(path)
    }

    /// Whether a contact can have a law.
    ///
    /// # Errors
    /// The numbers that the law needs are missing.
    pub fn check_law(&self, contact: ContactId, law: NormalDescription) -> Result<(), LawError> {
        self.planar().map_or(Ok(()), |model| model.with_law(contact, law).map(|_| ()))
    }
}

/// The clearances of joints in space, in file order: of a pin the radial one and that along its axis.
fn spatial_clearances(model: &SpatialModel) -> impl Iterator<Item = Clearance> {
    model.joints.iter().flat_map(|joint| {
        let own = joint.play.map_or([None, None], |play| play.clearances_m());
        own.into_iter().flatten().map(|quantity| Clearance { name: joint.name.clone(), quantity })
    })
}
