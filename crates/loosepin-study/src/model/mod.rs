//! The model of a study, in the plane or in space: what a study asks of both, in one place.
//!
//! What only one of them has is reached by [`StudyModel::planar`] and [`StudyModel::spatial`].

mod inputs;
pub use inputs::Clearance;
mod settings;
mod spatial_paths;
mod turn;

use loosepin_mechanics::model::{Model, ModelProblem};
use loosepin_result::repeat::InputRole;
use loosepin_space::{SpatialModel, is_spatial, refuse_without_geometry};
use loosepin_text::diagnostics::{Diagnostic, Diagnostics, Place, Source};
use loosepin_text::document::parse_toml;
use loosepin_text::numbers::QuantityTable;
use loosepin_text::units::{Dimension, DisplayUnits, SiUnit};
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

    /// The model, if it is planar.
    pub fn planar(&self) -> Option<&Model> {
        match self {
            Self::Planar(model) => Some(model),
            Self::Spatial(_) => None,
        }
    }

    /// The model, if it is in space.
    pub fn spatial(&self) -> Option<&SpatialModel> {
        match self {
            Self::Planar(_) => None,
            Self::Spatial(model) => Some(model),
        }
    }

    /// The planar model, where no other is taken.
    ///
    /// # Errors
    /// The model is in space.
    pub fn demand_planar(&self) -> Result<&Model, Diagnostics> {
        self.planar().ok_or_else(|| refused(self.source()))
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

    /// Its name.
    pub fn name(&self) -> &str {
        match self {
            Self::Planar(model) => &model.name,
            Self::Spatial(model) => &model.name,
        }
    }

    /// Every number of it.
    pub fn quantities(&self) -> &QuantityTable {
        match self {
            Self::Planar(model) => &model.quantities,
            Self::Spatial(model) => &model.quantities,
        }
    }

    /// The file that it was read from.
    pub fn source(&self) -> &Arc<Source> {
        match self {
            Self::Planar(model) => model.source(),
            Self::Spatial(model) => model.source(),
        }
    }

    /// The CSV files that were read with it.
    pub fn tables(&self) -> &[Arc<Source>] {
        self.planar().map_or(&[], Model::tables)
    }

    /// The file of the model and the tables that it names.
    pub fn input_files(&self) -> impl Iterator<Item = (InputRole, &Source)> {
        let tables = self.tables().iter().map(|table| (InputRole::Table, &**table));
        std::iter::once((InputRole::Model, &**self.source())).chain(tables)
    }

    /// Likely mistakes in it.
    pub fn warnings(&self) -> &[Diagnostic] {
        match self {
            Self::Planar(model) => &model.warnings,
            Self::Spatial(model) => &model.warnings,
        }
    }

    /// Place of an entry of the file, by its dotted path.
    pub fn place(&self, path: &str) -> Option<Place> {
        match self {
            Self::Planar(model) => model.place(path),
            Self::Spatial(model) => model.place(path),
        }
    }

    /// Names of its outputs, in file order.
    pub fn output_names(&self) -> Vec<&str> {
        match self {
            Self::Planar(model) => model.outputs.iter().map(|output| output.name.as_str()).collect(),
            Self::Spatial(model) => model.outputs.iter().map(|output| output.name.as_str()).collect(),
        }
    }

    /// Name, words and unit of each output of a model that has no runs; `None` where runs say what they are.
    pub fn outputs_without_runs(&self) -> Option<Vec<(String, String, SiUnit)>> {
        let Self::Spatial(model) = self else { return None };
        let described = model.outputs.iter().map(|output| {
            let (words, unit) = model.output_words(output.kind);
            (output.name.clone(), words, unit)
        });
        Some(described.collect())
    }

    /// How numbers are shown to people.
    pub fn shown_in(&self, usual: DisplayUnits) -> DisplayUnits {
        match self {
            Self::Planar(model) => model.shown_in(usual),
            Self::Spatial(_) => usual,
        }
    }

    /// Dimension of a quantity by its path.
    pub fn dimension_of(&self, path: &str) -> Option<Dimension> {
        self.quantities().id(path).map(|id| self.quantities()[id].dimension)
    }
}
