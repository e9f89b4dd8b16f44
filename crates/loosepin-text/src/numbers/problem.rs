//! Errors of numbers, parameters and names of a file.

use crate::diagnostics::{Code, problems};
use crate::document::listed;
use crate::units::{Dimension, ReadableUnit, format_number, quoted};

problems! {
    /// An error of numbers, parameters or names of a file. `entry` is a path in words.
    #[derive(Debug, Clone, PartialEq)]
    pub enum EntryProblem {
        BadParameterName {
            name: String,
            /// Whether it is the name of a unit or a function.
            is_reserved: bool,
        } => Code::BadName,
            says("a parameter cannot be called '{name}'"),
            hint_of(Some(if *is_reserved {
                format!(
                    "'{name}' is a unit or a function in expressions; choose another name, for example {name}_value"
                )
            } else {
                "names of parameters begin with a letter or _ and have letters, digits and _".to_owned()
            }));
        ParameterCycle {
            /// The names, the first again at the end.
            circle: Vec<String>,
        } => Code::ParameterCycle,
            says("parameters are defined by one another: {}", circle.join(" -> "));
        UnknownReference {
            entry: String,
            /// A body, point, joint, contact, drive or control.
            what: &'static str,
            name: String,
            nearest: Option<String>,
            known: Vec<String>,
        } => Code::UnknownReference,
            says("{entry}: there is no {what} '{name}'"),
            hint_of(Some(match nearest {
                Some(nearest) => format!("did you mean '{nearest}'?"),
                None if !known.is_empty() => format!("available: {}", listed(known, "and")),
                None if *what == "point" => {
                    format!("body '{}' has no points", name.split_once('.').map_or("", |(body, _)| body))
                }
                None => format!("the file defines no {what}"),
            }));
        NotAPoint { entry: String, text: String } => Code::UnknownReference,
            says("{entry} is '{text}'; must be body.point"),
            hint("for example \"crank.pin\": point 'pin' of body 'crank'");
        /// The hint is of those who know what the keys mean.
        NeedsKeys { entry: String, key: &'static str, needs: Vec<&'static str>, hint: Option<&'static str> } =>
            Code::ConflictingKeys,
            says("{entry}: '{key}' needs {}", quoted(needs)),
            hint_of(hint.map(str::to_owned));
        SameBody { entry: String, body: String } => Code::SameBody,
            says("{entry} connects body '{body}' to itself");
        WrongStart { entry: String, found: &'static str, due: &'static str, kind: &'static str, joint: String } =>
            Code::DriveNotPossible,
            says("{entry}: '{found}' does not fit the {kind} joint '{joint}'"),
            hint("write {due}");
        DrivenTwice { entry: String, joint: String, other: String } => Code::DrivenTwice,
            says("{entry}: joint '{joint}' is already driven by '{other}'");
        TooMany { what: &'static str, found: usize, most: usize } => Code::TooMany,
            says("the file has {found} {what}; at most {most} are permitted");
        /// A parameter, or another entry, that nothing refers to.
        Unused { entry: String } => Code::Unused,
            says("{entry} is not used"),
            hint("changing it has no effect on the results");
        KeyWithoutEffect { entry: String, key: &'static str, beside: &'static str } => Code::ConflictingKeys,
            says("{entry}: '{key}' cannot be used with '{beside}'");
        /// A number under `[parameter]` that is used where something is measured.
        ParameterWithoutUnit { name: String, value: f64, entry: String, due: Dimension } => Code::MissingUnit,
            says("parameter '{name}' is {} without a unit; {entry} uses it as {due}", format_number(*value)),
            hint("write its unit, for example {name} = \"{} {}\"", format_number(*value), ReadableUnit::default_for(*due).text);
    }
}
