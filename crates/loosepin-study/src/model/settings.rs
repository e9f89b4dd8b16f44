//! Values of a model in space that are set from outside: `--set path=value`.

use super::StudyModel;
use loosepin_mechanics::model::{Setting, SettingError};
use loosepin_text::diagnostics::{Diagnostic, Diagnostics, Place, Source};
use loosepin_text::numbers::{QuantityId, Values};

impl StudyModel {
    /// The values of a model in space under settings `path=value`.
    ///
    /// # Errors
    /// As for [`Self::spatial_settings`], and values that break a rule together.
    pub fn spatial_values(&self, texts: &[String]) -> Result<Values, Diagnostics> {
        let values = self.quantities().evaluate(&self.spatial_settings(texts)?);
        values.map_err(|error| Diagnostics::one(&error, self.place(error.path())))
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
