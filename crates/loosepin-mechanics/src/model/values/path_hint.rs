//! Suggestion for a path that names no quantity: its wrong part, and the replacement.

use crate::model::parts::topology::Model;
use crate::model::values::path_error::PathError;
use loosepin_text::diagnostics::nearest_name;
use loosepin_text::document::describe_path;
use loosepin_text::numbers::RADIAL;
use loosepin_text::units::listed;

/// Names that a hint lists, at most.
const MAX_LISTED: usize = 8;

impl Model {
    /// Why `path` names no quantity of the model.
    pub(in crate::model) fn unknown_path(&self, path: &str) -> PathError {
        let (why, hint) = self.of_table(path).unwrap_or_else(|| (None, self.without_table(path)));
        PathError::Unknown { path: path.to_owned(), why, hint }
    }

    /// Suggestion where the first word is a table, `joint`: the name or the key behind it is wrong.
    fn of_table(&self, path: &str) -> Option<(Option<String>, String)> {
        let (kind, behind) = path.split_once('.')?;
        let names = self.names_of(kind);
        if names.is_empty() {
            return None;
        }
        let (name, key) = behind.split_once('.').unwrap_or((behind, ""));
        if !names.contains(&name) {
            let meant = nearest_name(name, names.iter().copied()).map(|near| format!("{kind}.{near}"));
            let whole = meant.map(|table| if key.is_empty() { table } else { format!("{table}.{key}") });
            // The same key of another table of the kind, where only one has it.
            let mut same = names
                .iter()
                .map(|name| format!("{kind}.{name}.{key}"))
                .filter(|path| self.quantities.id(path).is_some());
            let only = same.next().filter(|_| same.next().is_none());
            if let Some(near) = whole.filter(|whole| self.quantities.id(whole).is_some()) {
                return Some((None, format!("did you mean '{near}'?")));
            }
            let hint = match only {
                Some(only) => format!("did you mean '{only}'?"),
                None => format!("available: {}", named(names.iter().copied())),
            };
            return Some((Some(format!("it has no {kind} '{name}'")), hint));
        }
        let table = format!("{kind}.{name}.");
        let keys: Vec<&str> = self
            .quantities
            .iter()
            .filter(|(_, quantity)| quantity.is_settable())
            .filter_map(|(_, quantity)| quantity.path.strip_prefix(table.as_str()))
            .collect();
        let below: Vec<&str> = keys.iter().copied().filter(|known| known.starts_with(&format!("{key}."))).collect();
        let words = describe_path(table.trim_end_matches('.'));
        // `clearance` for `radial_clearance`, where nothing else ends so.
        let mut ending = keys.iter().copied().filter(|known| known.ends_with(&format!("_{key}")));
        let only = ending.next().filter(|_| ending.next().is_none());
        let hint = match only.or_else(|| nearest_name(key, keys.iter().copied())) {
            _ if keys.is_empty() => format!("{words} has no number that can be set"),
            _ if key == "temperature_rise" => {
                format!(
                    "{words} states no temperature_rise of its own: add it to the model, or name the one at the top"
                )
            }
            _ if !below.is_empty() && !key.is_empty() => format!("{words} has {}", named(below.iter().copied())),
            _ if key.contains("diamet") && keys.contains(&RADIAL) => {
                format!("did you mean '{table}{RADIAL}'? It is half of the clearance on the diameter")
            }
            Some(near) => format!("did you mean '{table}{near}'?"),
            None => format!("{words} has {}", named(keys.iter().copied())),
        };
        Some((None, hint))
    }

    /// Suggestion where the first word is no table: the words before it may be missing, or one letter may be wrong.
    fn without_table(&self, path: &str) -> String {
        let all = || {
            self.quantities.iter().filter(|(_, quantity)| quantity.is_settable()).map(|(_, known)| known.path.as_str())
        };
        let ending: Vec<&str> = all().filter(|known| known.ends_with(&format!(".{path}"))).collect();
        match ending.as_slice() {
            [] => match nearest_name(path, all()) {
                Some(near) => format!("did you mean '{near}'?"),
                None => "paths follow the model file, for example joint.gudgeon.radial_clearance".to_owned(),
            },
            some => {
                let quoted: Vec<String> = some.iter().take(MAX_LISTED).map(|known| format!("'{known}'")).collect();
                format!("did you mean {}?", listed(&quoted, "or"))
            }
        }
    }

    /// Names of the tables of a kind, `joint`, and of parameters.
    fn names_of(&self, kind: &str) -> Vec<&str> {
        let prefix = format!("{kind}.");
        let tables = self.places.keys().filter_map(|path| path.strip_prefix(prefix.as_str()));
        let mut names: Vec<&str> = tables.filter(|name| !name.contains('.')).collect();
        names.sort_by_key(|name| self.places.get(&format!("{prefix}{name}")).map(|span| span.start));
        names
    }
}

/// Names in quotes, the first few of many.
fn named<'n>(names: impl Iterator<Item = &'n str>) -> String {
    let mut quoted: Vec<String> = names.map(|name| format!("'{name}'")).collect();
    if quoted.len() > MAX_LISTED {
        quoted.truncate(MAX_LISTED);
        return format!("{} and more", quoted.join(", "));
    }
    listed(&quoted, "and")
}
