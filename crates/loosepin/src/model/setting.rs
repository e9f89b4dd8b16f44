//! Values set from outside: `--set path=value`, and the inputs of a study.

use thiserror::Error;

use super::quantity::{Origin, QuantityError, QuantityId};
use super::topology::Model;
use crate::diagnostics::{Code, Complaint, Place, Problem, Source, nearest_name};
use crate::document::listed;
use crate::units::{Dimension, ExpressionProblem, parse_quantity};

/// A quantity with the value that it is to have.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Setting {
    /// The quantity.
    pub id: QuantityId,
    /// Its value, SI.
    pub value_si: f64,
}

/// Why a path names no quantity that can be set.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum PathError {
    /// The model has no such quantity.
    #[error("the model has no quantity '{path}'")]
    Unknown {
        /// The path.
        path: String,
        /// The nearest quantity that can be set.
        nearest: Option<String>,
    },
    /// The quantity follows from others.
    #[error("'{path}' is given by an expression and cannot be set")]
    Expression {
        /// The path.
        path: String,
        /// Paths of the quantities that it depends on.
        depends_on: Vec<String>,
    },
    /// The quantity fixes the unit of others, or the kind of a joint.
    #[error("'{path}' cannot be set")]
    Fixed {
        /// The path.
        path: String,
    },
}

/// Why a setting cannot be read.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum SettingError {
    /// No equals sign.
    #[error("'{text}' is not written path=value")]
    NoEqualsSign {
        /// The text.
        text: String,
    },
    /// A path that cannot be set.
    #[error(transparent)]
    Path(#[from] PathError),
    /// A value that cannot be read.
    #[error(transparent)]
    Value(#[from] ExpressionProblem),
    /// A value without its unit.
    #[error("{path} is {text} without a unit; must be {due}")]
    MissingUnit {
        /// The path.
        path: String,
        /// The text.
        text: String,
        /// What is due.
        due: Dimension,
    },
    /// A value of another dimension.
    #[error("{path} is {found}; must be {due}")]
    WrongDimension {
        /// The path.
        path: String,
        /// What it measures.
        found: Dimension,
        /// What is due.
        due: Dimension,
    },
    /// A value that breaks a rule.
    #[error(transparent)]
    Rule(#[from] QuantityError),
    /// A quantity set twice.
    #[error("'{path}' is set a second time")]
    Twice {
        /// The path.
        path: String,
    },
    /// An argument outside its range.
    #[error("{name} is {found}; must be {rule}")]
    ArgumentBreaksRule {
        /// The argument.
        name: String,
        /// Its value with unit.
        found: String,
        /// The range.
        rule: &'static str,
    },
}

impl Problem for PathError {
    fn code(&self) -> Code {
        match self {
            Self::Unknown { .. } => Code::UnknownPath,
            Self::Expression { .. } | Self::Fixed { .. } => Code::NotSettable,
        }
    }

    fn hint(&self) -> Option<String> {
        match self {
            Self::Unknown { nearest: Some(nearest), .. } => Some(format!("did you mean '{nearest}'?")),
            Self::Unknown { .. } => {
                Some("paths follow the model file, for example joint.gudgeon.radial_clearance".to_owned())
            }
            Self::Expression { depends_on, .. } => {
                let names: Vec<String> = depends_on.iter().map(|path| format!("'{path}'")).collect();
                Some(format!("it depends on {}", listed(&names, "and")))
            }
            Self::Fixed { path } if path.ends_with(".radial_clearance") => {
                Some("a joint with play needs bearing_radius and contact in the model file".to_owned())
            }
            Self::Fixed { .. } => Some("it fixes the unit of the stiffness; change both in the model file".to_owned()),
        }
    }
}

impl Problem for SettingError {
    fn code(&self) -> Code {
        match self {
            Self::NoEqualsSign { .. } => Code::SettingSyntax,
            Self::Path(error) => error.code(),
            Self::Value(problem) => problem.code(),
            Self::MissingUnit { .. } => Code::MissingUnit,
            Self::WrongDimension { .. } => Code::WrongDimension,
            Self::Rule(error) => error.code(),
            Self::Twice { .. } => Code::SetTwice,
            Self::ArgumentBreaksRule { .. } => Code::BreaksRule,
        }
    }

    fn hint(&self) -> Option<String> {
        match self {
            Self::NoEqualsSign { .. } => Some("for example --set joint.gudgeon.radial_clearance=0.3mm".to_owned()),
            Self::Path(error) => error.hint(),
            Self::Value(problem) => problem.hint(),
            Self::MissingUnit { due, .. } | Self::WrongDimension { due, .. } => {
                Some(due.example().map_or_else(
                    || format!("its unit is {}", due.si_unit()),
                    |example| format!("for example {example}"),
                ))
            }
            Self::Rule(error) => error.hint(),
            Self::Twice { .. } | Self::ArgumentBreaksRule { .. } => None,
        }
    }
}

impl Model {
    /// The quantity with this path, if it can be set.
    ///
    /// # Errors
    /// No such quantity (with the nearest name); a quantity given by an expression (with what it depends on).
    pub fn find(&self, path: &str) -> Result<QuantityId, PathError> {
        let Some(id) = self.quantities.id(path) else {
            let settable = self.quantities.iter().filter(|(_, quantity)| quantity.is_settable());
            let nearest = nearest_name(path, settable.map(|(_, quantity)| quantity.path.as_str())).map(str::to_owned);
            return Err(PathError::Unknown { path: path.to_owned(), nearest });
        };
        match &self.quantities[id].origin {
            Origin::Literal | Origin::Default => Ok(id),
            Origin::Fixed => Err(PathError::Fixed { path: path.to_owned() }),
            Origin::Expression { .. } => {
                let depends_on = self.roots(id).into_iter().map(|root| self.quantities[root].path.clone()).collect();
                Err(PathError::Expression { path: path.to_owned(), depends_on })
            }
        }
    }

    /// The free numbers that a quantity depends on, itself if it is one.
    pub fn roots(&self, id: QuantityId) -> Vec<QuantityId> {
        let mut roots = Vec::new();
        let mut seen = vec![false; self.quantities.len()];
        let mut waiting = vec![id];
        while let Some(id) = waiting.pop() {
            if std::mem::replace(&mut seen[id.0], true) {
                continue;
            }
            match &self.quantities[id].origin {
                Origin::Expression { depends_on } => waiting.extend(depends_on),
                _ => roots.push(id),
            }
        }
        roots.sort();
        roots
    }

    /// Reads a setting `path=value` and checks it by itself: path, unit, rule of the value. Rules between several
    /// values are checked by [`super::QuantityTable::evaluate`] once all settings are known.
    ///
    /// # Errors
    /// A complaint whose place is in the text of the setting.
    pub fn parse_setting(&self, text: &str) -> Result<Setting, Complaint> {
        let source = Source::new("--set", text);
        let complain = |error: SettingError, span: std::ops::Range<usize>| {
            Complaint::error(&error, Some(Place::new(&source, span)))
        };
        let Some((path, value)) = text.split_once('=') else {
            return Err(complain(SettingError::NoEqualsSign { text: text.to_owned() }, 0..text.len()));
        };
        let value_start = path.len() + 1;
        let id = self.find(path.trim()).map_err(|error| complain(error.into(), 0..path.len()))?;
        let measured = parse_quantity(value).map_err(|error| {
            complain(error.problem.into(), value_start + error.span.start..value_start + error.span.end)
        })?;
        let quantity = &self.quantities[id];
        let (path, due, found) = (quantity.path.clone(), quantity.dimension, measured.dimension);
        let error = if found == due {
            quantity.check(measured.value_si).err().map(SettingError::from)
        } else if found.is_number() {
            Some(SettingError::MissingUnit { path, text: value.trim().to_owned(), due })
        } else {
            Some(SettingError::WrongDimension { path, found, due })
        };
        match error {
            None => Ok(Setting { id, value_si: measured.value_si }),
            Some(error) => Err(complain(error, value_start..text.len())),
        }
    }
}
