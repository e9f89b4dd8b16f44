//! Values of a model in space that are set from outside, `--set path=value`.

use super::spatial_paths::find;
use loosepin_mechanics::model::{Setting, SettingError};
use loosepin_space::SpatialModel;
use loosepin_text::diagnostics::{Diagnostic, Diagnostics, Place, Source};
use loosepin_text::numbers::{QuantityId, Values};

/// The values of `model` under settings `path=value`.
///
/// # Errors
/// As for [`settings`], and values that break a rule together.
pub(super) fn values_under(model: &SpatialModel, texts: &[String]) -> Result<Values, Diagnostics> {
    let values = model.quantities.evaluate(&settings(model, texts)?);
    values.map_err(|error| Diagnostics::one(&error, model.place(error.path())))
}

/// What settings `path=value` set in `model`.
///
/// # Errors
/// Every setting that cannot be read, and a quantity that is set twice.
pub(super) fn settings(model: &SpatialModel, texts: &[String]) -> Result<Vec<(QuantityId, f64)>, Diagnostics> {
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
    if diagnostics.is_empty() { Ok(set) } else { Err(diagnostics) }
}
