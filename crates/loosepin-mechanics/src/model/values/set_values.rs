//! All settings of a command line together, and other measured arguments.

use crate::model::contact::{LawError, NormalDescription};
use crate::model::ids::ContactId;
use crate::model::parts::topology::Model;
use crate::model::values::setting::{Setting, SettingError, measured};
use loosepin_text::diagnostics::{Diagnostic, Diagnostics, Place, Source, nearest_name};
use loosepin_text::numbers::{Origin, QuantityError, QuantityId, Values};
use loosepin_text::plausible::JudgedModel;
use loosepin_text::units::{Dimension, Rule, format_refused};

/// Settings read from text, and the values of the model that follow from them.
#[derive(Debug, Clone)]
pub struct SetValues {
    /// The model with the laws that were set; without any, the model as it was.
    pub model: Model,
    /// The settings of numbers, in the order of the texts.
    pub settings: Vec<Setting>,
    /// Every value of the model.
    pub values: Values,
    /// The text of each of these settings.
    pub texts: Vec<String>,
}

impl SetValues {
    /// Warnings of numbers that the settings make hardly possible.
    pub fn warnings(&self) -> Vec<Diagnostic> {
        let texts = self.settings.iter().zip(&self.texts).map(|(setting, text)| (setting.id, text.as_str()));
        self.model.implausible_settings(&texts.collect::<Vec<_>>(), &self.values)
    }
}

impl Model {
    /// Reads settings `path=value` and gives the values of the model under all of them. `contact.NAME.law=LAW` gives a contact
    /// another law.
    ///
    /// # Errors
    /// Every setting that cannot be read, a quantity that is set twice, and values that break a rule together.
    pub fn set_values(&self, texts: &[String]) -> Result<SetValues, Diagnostics> {
        let mut diagnostics = Diagnostics::new();
        let mut settings: Vec<(Setting, &str)> = Vec::new();
        let mut laws: Vec<(ContactId, &str)> = Vec::new();
        let mut model = self.clone();
        for text in texts {
            if let Some(law) = self.law_setting(text) {
                let set = law.and_then(|(contact, law)| {
                    if let Some((_, earlier)) = laws.iter().find(|(known, _)| *known == contact) {
                        let path = format!("contact.{}.law", self.contacts[contact.0].name);
                        let diagnostic = Diagnostic::error(&SettingError::Twice { path }, Some(whole("--set", text)));
                        return Err(diagnostic.with_label(whole("--set (the earlier one)", earlier), "set here"));
                    }
                    laws.push((contact, text));
                    let report =
                        |error: LawError| Diagnostic::error(&SettingError::from(error), Some(whole("--set", text)));
                    model.with_law(contact, law).map_err(report)
                });
                match set {
                    Ok(changed) => model = changed,
                    Err(diagnostic) => diagnostics.push(diagnostic),
                }
                continue;
            }
            match self.parse_setting(text) {
                Err(diagnostic) => diagnostics.push(diagnostic),
                Ok(setting) => match settings.iter().find(|(earlier, _)| earlier.id == setting.id) {
                    Some((_, earlier)) => {
                        let path = self.quantities[setting.id].path.clone();
                        let diagnostic = Diagnostic::error(&SettingError::Twice { path }, Some(whole("--set", text)));
                        diagnostics.push(diagnostic.with_label(whole("--set (the earlier one)", earlier), "set here"));
                    }
                    None => settings.push((setting, text)),
                },
            }
        }
        if !diagnostics.is_empty() {
            return Err(diagnostics);
        }
        let set: Vec<(QuantityId, f64)> = settings.iter().map(|(setting, _)| (setting.id, setting.value_si)).collect();
        match self.quantities.evaluate(&set) {
            Ok(values) => {
                let (settings, texts) = settings.into_iter().map(|(setting, text)| (setting, text.to_owned())).unzip();
                Ok(SetValues { model, settings, values, texts })
            }
            Err(error) => Err(self.diagnostic_of_set(&error, &settings).into()),
        }
    }

    /// A setting of a law; `None` if the text sets something else.
    fn law_setting(&self, text: &str) -> Option<Result<(ContactId, NormalDescription), Diagnostic>> {
        let (path, name) = text.split_once('=')?;
        let contact = self.contact_of_law(path.trim())?;
        let source = Source::new("--set", text);
        let report = |error: SettingError, span| Diagnostic::error(&error, Some(Place::new(&source, span)));
        Some(contact.map_err(|error| report(error.into(), 0..path.len())).and_then(|contact| {
            let name = name.trim();
            NormalDescription::all().find(|law| law.name() == name).map(|law| (contact, law)).ok_or_else(|| {
                let nearest = nearest_name(name, NormalDescription::all().map(|law| law.name())).map(str::to_owned);
                report(SettingError::UnknownLaw { name: name.to_owned(), nearest }, path.len() + 1..text.len())
            })
        }))
    }

    /// A diagnostic at the setting that is to blame, if one is, and otherwise in the file.
    fn diagnostic_of_set(&self, error: &QuantityError, settings: &[(Setting, &str)]) -> Diagnostic {
        let blamed = |path: &str| {
            let id = self.quantities.id(path)?;
            let roots = self.quantities.roots(id);
            settings.iter().find(|(setting, _)| setting.id == id || roots.contains(&setting.id))
        };
        let limit_path = match error {
            QuantityError::OutOfOrder { limit_path, .. } => Some(limit_path.as_str()),
            QuantityError::BreaksRule { .. } | QuantityError::NotSettable { .. } => None,
        };
        match blamed(error.path()).or_else(|| limit_path.and_then(blamed)) {
            None => Diagnostic::error(error, self.place(error.path())),
            Some((setting, text)) => {
                let diagnostic = Diagnostic::error(error, Some(whole("--set", text)));
                let is_set_itself = self.quantities[setting.id].path == error.path();
                match self.place(error.path()).filter(|_| !is_set_itself) {
                    Some(place) if self.is_an_expression(error.path()) => {
                        diagnostic.with_label(place, "which gives this its value")
                    }
                    Some(place) => diagnostic.with_label(place, "which must be smaller"),
                    None => diagnostic,
                }
            }
        }
    }

    fn is_an_expression(&self, path: &str) -> bool {
        let id = self.quantities.id(path);
        id.is_some_and(|id| matches!(self.quantities[id].origin, Origin::Expression { .. }))
    }
}

/// Reads an argument that is a value with its unit, for example `--tolerance "1e-9 m"`.
///
/// # Errors
/// A diagnostic whose place is in the text of the argument.
pub fn measured_argument(name: &str, text: &str, due: Dimension, rule: Rule) -> Result<f64, Diagnostic> {
    measured(&Source::new(name, text), 0, text, name, None, due, |value_si| {
        if rule.allows(value_si) {
            return Ok(());
        }
        let found = format_refused(value_si, due);
        Err(SettingError::ArgumentBreaksRule { name: name.to_owned(), found, rule: rule.words() })
    })
}

/// The whole text of an argument.
fn whole(name: &str, text: &str) -> Place {
    Place::new(&Source::new(name, text), 0..text.len())
}
