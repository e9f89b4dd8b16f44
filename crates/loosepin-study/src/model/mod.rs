//! The model of a study, in the plane or in space. What a study asks of both is [`KindOfModel`], which each says of itself in a file of its
//! own; nobody else asks which of the two it is.

mod kind;
pub use kind::{Clearance, DeviationProofs, KindOfModel, PLAY, PlayProofs, ProvenDeviations, ValuesUnderSettings};
mod motion_request;
pub use motion_request::MotionRequest;
pub(crate) mod outputs;
mod planar;
mod planar_outputs;
mod spatial;
mod spatial_motion;
mod spatial_outputs;
mod spatial_paths;
mod spatial_settings;
mod spatial_turn;

use loosepin_mechanics::model::{Model, ModelProblem};
use loosepin_result::repeat::InputRole;
use loosepin_space::{SpatialModel, is_spatial, refuse_without_geometry};
use loosepin_text::diagnostics::{Diagnostics, Place, Source};
use loosepin_text::document::parse_toml;
use std::ops::{Deref, DerefMut};
use std::sync::Arc;

/// A model of a mechanism.
#[derive(Debug, Clone)]
pub enum StudyModel {
    /// In the plane, with its dynamics.
    Planar(Box<Model>),
    /// In space, without dynamics.
    Spatial(Box<SpatialModel>),
}

/// That a model in space is where only planar ones are taken, at its key `geometry`.
fn refused(source: &Arc<Source>) -> Diagnostics {
    let toml = parse_toml(source).ok();
    let value = toml.as_ref().and_then(|toml| toml.get_ref().get("geometry"));
    let span = value.map_or(0..0, |value| value.span());
    Diagnostics::one(&ModelProblem::InSpace, Some(Place::new(source, span)))
}

impl From<Model> for StudyModel {
    fn from(model: Model) -> Self {
        Self::Planar(Box::new(model))
    }
}

impl From<SpatialModel> for StudyModel {
    fn from(model: SpatialModel) -> Self {
        Self::Spatial(Box::new(model))
    }
}

/// All that both kinds say of themselves.
impl Deref for StudyModel {
    type Target = dyn KindOfModel;

    fn deref(&self) -> &Self::Target {
        match self {
            Self::Planar(model) => &**model,
            Self::Spatial(model) => &**model,
        }
    }
}

impl DerefMut for StudyModel {
    fn deref_mut(&mut self) -> &mut Self::Target {
        match self {
            Self::Planar(model) => &mut **model,
            Self::Spatial(model) => &mut **model,
        }
    }
}

impl StudyModel {
    /// Reads the text of a model file.
    ///
    /// # Errors
    /// Everything that is wrong with it, each with its place.
    pub fn from_source(source: Arc<Source>) -> Result<Self, Diagnostics> {
        if is_spatial(&source) {
            return SpatialModel::from_source(&source).map(Self::from);
        }
        refuse_without_geometry(&source)?;
        Model::from_source(source).map(Self::from)
    }

    /// The same with the values of settings `path=value` in place of those of its file, and with warnings about them.
    ///
    /// # Errors
    /// Every setting that cannot be read, a quantity that is set twice, and values that break a rule together.
    pub fn with_settings(mut self, texts: &[String]) -> Result<Self, Diagnostics> {
        let under = self.take_settings(texts)?;
        self.take_values(under);
        Ok(self)
    }

    /// The file of the model and the tables that it names.
    pub fn input_files(&self) -> impl Iterator<Item = (InputRole, &Source)> {
        let tables = self.tables().iter().map(|table| (InputRole::Table, &**table));
        std::iter::once((InputRole::Model, &**self.source())).chain(tables)
    }

    /// The planar model, where no other is taken.
    ///
    /// # Errors
    /// The model is in space.
    pub fn demand_planar(&self) -> Result<&Model, Diagnostics> {
        match self {
            Self::Planar(model) => Ok(model),
            Self::Spatial(model) => Err(refused(model.source())),
        }
    }

    /// The planar model itself, where no other is taken.
    ///
    /// # Errors
    /// The model is in space.
    pub fn into_planar(self) -> Result<Model, Diagnostics> {
        match self {
            Self::Planar(model) => Ok(*model),
            Self::Spatial(model) => Err(refused(model.source())),
        }
    }
}
