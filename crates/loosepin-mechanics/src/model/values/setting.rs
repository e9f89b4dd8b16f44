//! Values set from outside: `--set path=value`, and the inputs of a study.

use crate::model::contact::LawError;
use crate::model::ids::PlayId;
use crate::model::parts::topology::Model;
use crate::model::values::path_error::PathError;
use loosepin_text::numbers::{DIAMETRAL, Quantity, QuantityError, QuantityId, QuantityTable, RADIAL};
use std::sync::Arc;

use loosepin_text::diagnostics::{Code, Diagnostic, Place, Source, problems};
use loosepin_text::tolerance::for_single_value;
use loosepin_text::units::{Dimension, ExpressionProblem, format_value, parse_quantity};

/// A quantity with the value that it is to have.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Setting {
    /// The quantity.
    pub id: QuantityId,
    /// Its value, SI.
    pub value_si: f64,
}

/// A quantity with the ends of the values that it is to go through.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SettingRange {
    /// The quantity.
    pub id: QuantityId,
    /// The first value, SI.
    pub from_si: f64,
    /// The last value, SI; another than the first.
    pub to_si: f64,
}

problems! {
    /// Why a setting cannot be read.
    #[derive(Debug, Clone, PartialEq)]
    pub enum SettingError | Path(PathError) | Value(ExpressionProblem) | Rule(QuantityError) | Law(LawError) {
        NoEqualsSign { text: String } => Code::SettingSyntax,
            says("'{text}' is not written path=value"),
            hint("for example --set joint.gudgeon.radial_clearance=0.3mm");
        NoRange { text: String } => Code::SettingSyntax,
            says("'{text}' is not written path=from..to"),
            hint("for example --over joint.gudgeon.radial_clearance=0.1mm..0.5mm");
        EmptyRange { path: String, value: String } => Code::BreaksRule,
            says("{path} goes from {value} to the same value; must be two different values");
        MissingUnit { path: String, text: String, due: Dimension } => Code::MissingUnit,
            says("{path} is {text} without a unit; must be {due}"),
            hint_of(Some(example_of(*due)));
        WrongDimension { path: String, found: Dimension, due: Dimension } => Code::WrongDimension,
            says("{path} is {found}; must be {due}"),
            hint_of(Some(example_of(*due)));
        UnknownLaw { name: String, nearest: Option<String> } => Code::UnknownChoice,
            says("there is no contact law '{name}'"),
            hint_of(Some(match nearest {
                Some(nearest) => format!("did you mean '{nearest}'?"),
                None => "loosepin schema model lists them".to_owned(),
            }));
        Twice { path: String } => Code::SetTwice,
            says("'{path}' is set a second time");
        ArgumentBreaksRule { name: String, found: String, rule: &'static str } => Code::BreaksRule,
            says("{name} is {found}; must be {rule}");
    }
}

fn example_of(due: Dimension) -> String {
    due.example().map_or_else(|| format!("its unit is {}", due.si_unit()), |example| format!("for example {example}"))
}

impl Model {
    /// The quantity with this path, if it can be set.
    ///
    /// # Errors
    /// No such quantity (with the nearest name); a quantity given by an expression (with what it depends on).
    pub fn find(&self, path: &str) -> Result<QuantityId, PathError> {
        if let Some(stated) = self.other_clearance(path) {
            return Err(PathError::OtherClearance { path: path.to_owned(), stated });
        }
        let Some(id) = self.quantities.id(path) else {
            let joint = path.strip_prefix("joint.").and_then(|rest| rest.strip_suffix("clearance"));
            let joint = joint.and_then(|rest| rest.split('.').next());
            let is_ideal = |joint: &str| self.joints.iter().any(|own| own.name == joint && own.kind.play().is_none());
            if let Some(joint) = joint.filter(|joint| is_ideal(joint)) {
                return Err(PathError::NoPlay { path: path.to_owned(), joint: joint.to_owned() });
            }
            return Err(self.unknown_path(path));
        };
        PathError::demand_settable(&self.quantities, id)
    }

    /// The clearance that a joint states, where `path` names the other of radial and diametral clearance.
    fn other_clearance(&self, path: &str) -> Option<String> {
        let (joint, key) = path.rsplit_once('.')?;
        let [radial, diametral] = [RADIAL, DIAMETRAL].map(|key| format!("{joint}.{key}"));
        let states_diametral = self.quantities.id(&diametral).is_some();
        match key {
            RADIAL if states_diametral => Some(diametral),
            DIAMETRAL if !states_diametral && self.quantities.id(&radial).is_some() => Some(radial),
            _ => None,
        }
    }

    /// The joints and couplings with play whose stated clearance is this quantity or depends on it, each with its clearance: that of the
    /// parts at their temperature.
    pub fn play_from(&self, id: QuantityId) -> impl Iterator<Item = (PlayId, QuantityId)> {
        self.play_clearances()
            .filter(move |(_, clearance)| self.quantities.depends_on(self.quantities.stated_clearance(*clearance), id))
    }

    /// Reads a setting `path=value` and checks it by itself: path, unit, rule of the value. Rules between several
    /// values are checked by [`crate::model::QuantityTable::evaluate`] once all settings are known.
    ///
    /// # Errors
    /// A diagnostic whose place is in the text of the setting.
    pub fn parse_setting(&self, text: &str) -> Result<Setting, Diagnostic> {
        Setting::parse(text, &self.quantities, |path| self.find(path))
    }

    /// Reads a range `path=from..to` and checks both ends like [`Self::parse_setting`].
    ///
    /// # Errors
    /// A diagnostic whose place is in the text of the range.
    pub fn parse_setting_range(&self, text: &str) -> Result<SettingRange, Diagnostic> {
        let source = Source::new("--over", text);
        let whole = || Some(Place::new(&source, 0..text.len()));
        let parts = text.split_once('=').and_then(|(path, values)| Some((path, values.split_once("..")?)));
        let Some((path, (from, to))) = parts else {
            return Err(Diagnostic::error(&SettingError::NoRange { text: text.to_owned() }, whole()));
        };
        let id = self.find_in(&source, path)?;
        let from_start = path.len() + 1;
        let from_si = self.value_in(&source, id, from_start, from)?;
        let to_si = self.value_in(&source, id, from_start + from.len() + 2, to)?;
        if from_si == to_si {
            let quantity = &self.quantities[id];
            let value = format_value(from_si, quantity.dimension);
            return Err(Diagnostic::error(&SettingError::EmptyRange { path: quantity.path.clone(), value }, whole()));
        }
        Ok(SettingRange { id, from_si, to_si })
    }

    /// The quantity named at the start of the text of `source`.
    fn find_in(&self, source: &Arc<Source>, path: &str) -> Result<QuantityId, Diagnostic> {
        find_in(source, path, |path| self.find(path))
    }

    /// The value of the quantity `id` that stands at `start` in the text of `source`, SI.
    fn value_in(&self, source: &Arc<Source>, id: QuantityId, start: usize, value: &str) -> Result<f64, Diagnostic> {
        value_in(source, &self.quantities[id], start, value)
    }
}

impl Setting {
    /// Whether the text `path=value` sets the quantity with this path.
    pub fn is_of(text: &str, path: &str) -> bool {
        text.split_once('=').is_some_and(|(own, _)| own.trim() == path)
    }

    /// Reads a setting `path=value` of a table of quantities and checks it by itself; `find` gives the quantity with a path.
    ///
    /// # Errors
    /// A diagnostic whose place is in the text of the setting.
    pub fn parse(
        text: &str,
        quantities: &QuantityTable,
        find: impl Fn(&str) -> Result<QuantityId, PathError>,
    ) -> Result<Setting, Diagnostic> {
        let source = Source::new("--set", text);
        let Some((path, value)) = text.split_once('=') else {
            let error = SettingError::NoEqualsSign { text: text.to_owned() };
            return Err(Diagnostic::error(&error, Some(Place::new(&source, 0..text.len()))));
        };
        let id = find_in(&source, path, find)?;
        let value_si = value_in(&source, &quantities[id], path.len() + 1, value)?;
        Ok(Setting { id, value_si })
    }
}

/// The quantity named at the start of the text of `source`.
fn find_in(
    source: &Arc<Source>,
    path: &str,
    find: impl Fn(&str) -> Result<QuantityId, PathError>,
) -> Result<QuantityId, Diagnostic> {
    find(path.trim())
        .map_err(|error| Diagnostic::error(&SettingError::from(error), Some(Place::new(source, 0..path.len()))))
}

/// The value of a quantity that stands at `start` in the text of `source`, SI.
fn value_in(source: &Arc<Source>, quantity: &Quantity, start: usize, value: &str) -> Result<f64, Diagnostic> {
    let (path, due) = (quantity.path.as_str(), quantity.dimension);
    let check = |value_si| quantity.check(value_si).map_err(SettingError::from);
    measured(source, start, value, path, Some(path), due, check)
}

/// The value with its unit that stands at `start` in the text of `source`, SI: of the dimension that is due, and as `check` wants it. `path` is that of a
/// quantity of the model.
pub(in crate::model) fn measured(
    source: &Arc<Source>,
    start: usize,
    text: &str,
    name: &str,
    path: Option<&str>,
    due: Dimension,
    check: impl Fn(f64) -> Result<(), SettingError>,
) -> Result<f64, Diagnostic> {
    let report = |error: SettingError, span: std::ops::Range<usize>| {
        Diagnostic::error(&error, Some(Place::new(source, start + span.start..start + span.end)))
    };
    let measured = parse_quantity(text).map_err(|error| {
        let error = for_single_value(error, text, Some(due), path);
        report(error.problem.into(), error.span)
    })?;
    let (path, found) = (name.to_owned(), measured.dimension);
    let checked = if found == due {
        check(measured.value_si)
    } else if found.is_number() {
        Err(SettingError::MissingUnit { path, text: text.trim().to_owned(), due })
    } else {
        Err(SettingError::WrongDimension { path, found, due })
    };
    checked.map(|()| measured.value_si).map_err(|error| report(error, 0..text.len()))
}
