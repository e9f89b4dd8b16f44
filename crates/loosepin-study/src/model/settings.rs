//! Values of a model that are set from outside, `--set path=value`: those of a model in space, and models that have them as their own.

use super::StudyModel;
use loosepin_mechanics::model::{SetValues, Setting, SettingError};
use loosepin_text::diagnostics::{Diagnostic, Diagnostics, Place, Source};
use loosepin_text::numbers::{QuantityId, Values};
use loosepin_text::plausible::JudgedModel;

impl StudyModel {
    /// The model with the values of settings `path=value` in place of those of its file, and with warnings about them.
    ///
    /// # Errors
    /// As for `set_values` of a planar model and [`Self::spatial_values`].
    pub fn with_settings(self, texts: &[String]) -> Result<Self, Diagnostics> {
        match self {
            Self::Planar(model) => {
                let set = model.set_values(texts)?;
                let warnings = set.warnings();
                let SetValues { mut model, values, .. } = set;
                model.quantities.set_nominal(values);
                model.warnings.extend(warnings);
                Ok(model.into())
            }
            Self::Spatial(mut model) => {
                let own = Self::Spatial(model.clone());
                model.quantities.set_nominal(own.spatial_values(texts)?);
                model.warnings.extend(own.warnings_of_settings(texts));
                Ok(Self::Spatial(model))
            }
        }
    }

    /// The values of a model in space under settings `path=value`.
    ///
    /// # Errors
    /// As for [`Self::spatial_settings`], and values that break a rule together.
    pub fn spatial_values(&self, texts: &[String]) -> Result<Values, Diagnostics> {
        let values = self.quantities().evaluate(&self.spatial_settings(texts)?);
        values.map_err(|error| Diagnostics::one(&error, self.place(error.path())))
    }

    /// Warnings of values that settings `path=value` make hardly possible; none where they cannot be read, which is refused elsewhere.
    pub fn warnings_of_settings(&self, texts: &[String]) -> Vec<Diagnostic> {
        match self {
            Self::Planar(model) => model.set_values(texts).map_or(Vec::new(), |set| set.warnings()),
            Self::Spatial(model) => {
                let set = self.spatial_settings(texts).and_then(|set| Ok((set, self.spatial_values(texts)?)));
                let Ok((set, values)) = set else { return Vec::new() };
                let settings: Vec<(QuantityId, &str)> =
                    set.iter().map(|(id, _)| *id).zip(texts.iter().map(String::as_str)).collect();
                model.implausible_settings(&settings, &values)
            }
        }
    }

    /// What settings `path=value` set in a model in space.
    ///
    /// # Errors
    /// Every setting that cannot be read, and a quantity that is set twice.
    pub fn spatial_settings(&self, texts: &[String]) -> Result<Vec<(QuantityId, f64)>, Diagnostics> {
        let mut diagnostics = Diagnostics::new();
        let mut set: Vec<(QuantityId, f64)> = Vec::new();
        let quantities = self.quantities();
        for text in texts {
            match Setting::parse(text, quantities, |path| self.find(path)) {
                Ok(setting) if set.iter().any(|(known, _)| *known == setting.id) => {
                    let error = SettingError::Twice { path: quantities[setting.id].path.clone() };
                    let place = Place::new(&Source::new("--set", text.as_str()), 0..text.len());
                    diagnostics.push(Diagnostic::error(&error, Some(place)));
                }
                Ok(setting) => set.push((setting.id, setting.value_si)),
                Err(diagnostic) => diagnostics.push(diagnostic),
            }
        }
        if diagnostics.is_empty() { Ok(set) } else { Err(diagnostics) }
    }
}
