//! A sweep as it is asked for.

use super::plan::SweepPlan;
use crate::{Settings, input_files};
use loosepin_mechanics::model::{Model, SetValues, SettingError, SettingRange};
use loosepin_result::repeat::Repeat;
use loosepin_result::simulation::Override;
use loosepin_text::diagnostics::Diagnostic;

/// The quantity that is varied, and its values.
#[derive(Debug, Clone, Copy)]
pub enum SweptValues<'a> {
    /// Equally spaced ones.
    Between {
        /// The quantity with its first and last value, `path=from..to`.
        over: &'a str,
        /// Values, both ends included; at least two.
        points: usize,
    },
    /// Any, which no command can state.
    Listed {
        /// Path of the quantity.
        path: &'a str,
        /// Finite values, SI; at least one.
        values_si: &'a [f64],
    },
}

/// A sweep in the words of the command.
#[derive(Debug, Clone, Copy)]
pub struct SweepRequest<'a> {
    /// What is varied.
    pub values: SweptValues<'a>,
    /// Settings `path=value` of other quantities.
    pub set: &'a [String],
    /// Turns before those that are looked at.
    pub transient_turns: u32,
    /// Turns that are looked at.
    pub recorded_turns: u32,
    /// Tolerance of positions with its unit.
    pub tolerance: &'a str,
}

impl SweepRequest<'_> {
    /// The plan for `model` with the values `set`; `tolerance_m` is what [`Self::tolerance`] states.
    ///
    /// # Errors
    /// A path or a range that cannot be read, a value that the model does not allow, a quantity that is also set.
    pub fn plan(&self, model: &Model, set: &SetValues, tolerance_m: f64) -> Result<SweepPlan, Diagnostic> {
        let (range, points, listed_si) = match self.values {
            SweptValues::Between { over, points } => (model.parse_setting_range(over)?, points, None),
            SweptValues::Listed { path, values_si } => {
                let range = listed_range(model, path, values_si)?;
                (range, values_si.len(), Some(values_si.to_vec()))
            }
        };
        if set.settings.iter().any(|setting| setting.id == range.id) {
            let path = model.quantities[range.id].path.clone();
            return Err(Diagnostic::error(&SettingError::Twice { path }, None));
        }
        Ok(SweepPlan {
            range,
            points,
            listed_si,
            transient_turns: self.transient_turns,
            recorded_turns: self.recorded_turns,
            settings: Settings { tolerance_m, ..Settings::for_study() },
            overrides: Override::from_settings(self.set),
        })
    }

    /// The command that makes the sweep of `model` again; nothing for values that are listed.
    pub fn repeat(&self, model: &Model) -> Repeat {
        let SweptValues::Between { over, points } = self.values else { return Repeat::default() };
        let mut stated: Vec<String> = Vec::new();
        let mut add = |name: &str, value: String| stated.extend([name.to_owned(), value]);
        for set in self.set {
            add("--set", set.clone());
        }
        add("--over", over.to_owned());
        add("--points", points.to_string());
        add("--transient", self.transient_turns.to_string());
        add("--turns", self.recorded_turns.to_string());
        add("--tolerance", self.tolerance.to_owned());
        Repeat::new("sweep", &stated, input_files(model))
    }
}

/// The ends of values that are listed, each checked by itself.
fn listed_range(model: &Model, path: &str, values_si: &[f64]) -> Result<SettingRange, Diagnostic> {
    let id = model.find(path).map_err(|error| Diagnostic::error(&SettingError::from(error), None))?;
    for (run, &value_si) in values_si.iter().enumerate() {
        let checked = model.quantities[id].check(value_si);
        checked.map_err(|error| {
            let diagnostic = Diagnostic::error(&error, None);
            Diagnostic { message: format!("run {run}: {}", diagnostic.message), ..diagnostic }
        })?;
    }
    let least = values_si.iter().copied().fold(f64::INFINITY, f64::min);
    let most = values_si.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    Ok(SettingRange { id, from_si: least, to_si: most })
}
