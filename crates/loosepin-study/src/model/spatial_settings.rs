//! Values of a model in space that are set from outside, `--set path=value`.

use super::spatial_paths::find;
use loosepin_mechanics::model::{Setting, SettingError};
use loosepin_space::SpatialModel;
use loosepin_text::diagnostics::{Diagnostic, Diagnostics, Place, Source};
use loosepin_text::numbers::{QuantityId, Values};
use loosepin_text::plausible::JudgedModel;

/// What settings `path=value` set in a model.
pub(super) struct SpatialSettings {
    /// The quantities that are set, in the order of the texts.
    pub set: Vec<(QuantityId, f64)>,
    /// All values of the model.
    pub values: Values,
}

impl SpatialSettings {
    /// Reads them.
    ///
    /// # Errors
    /// Every setting that cannot be read, a quantity that is set twice, and values that break a rule together.
    pub fn read(model: &SpatialModel, texts: &[String]) -> Result<Self, Diagnostics> {
        let mut diagnostics = Diagnostics::new();
        let mut set: Vec<(QuantityId, f64)> = Vec::new();
        let quantities = &model.quantities;
        for text in texts {
            match Setting::parse(text, quantities, |path| find(model, path)) {
                Ok(setting) if set.iter().any(|(known, _)| *known == setting.id) => {
                    let error = SettingError::Twice { path: quantities[setting.id].path.clone() };
                    let place = Place::new(&Source::new("--set", text.as_str()), 0..text.len());
                    diagnostics.push(Diagnostic::error(&error, Some(place)));
                }
                Ok(setting) => set.push((setting.id, setting.value_si)),
                Err(diagnostic) => diagnostics.push(diagnostic),
            }
        }
        if !diagnostics.is_empty() {
            return Err(diagnostics);
        }
        let values = quantities.evaluate(&set);
        let values = values.map_err(|error| Diagnostics::one(&error, model.place(error.path())))?;
        Ok(Self { set, values })
    }

    /// Warnings of numbers that they make hardly possible; `texts` are those that were read.
    pub fn warnings(&self, model: &SpatialModel, texts: &[String]) -> Vec<Diagnostic> {
        let ids = self.set.iter().map(|(id, _)| *id);
        let settings: Vec<(QuantityId, &str)> = ids.zip(texts.iter().map(String::as_str)).collect();
        model.implausible_settings(&settings, &self.values)
    }
}
