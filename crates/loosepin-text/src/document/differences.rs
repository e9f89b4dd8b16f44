//! Differences between two TOML texts: entry by entry, by value and not by spelling.

use std::sync::Arc;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::reader::parse_toml;
use crate::diagnostics::{Diagnostics, Source};
use crate::units::parse_quantity;

/// Values that differ by less than this share of the larger one are one value: `0.1 mm` and `1e-4 m`.
const ROUND_OFF: f64 = 1e-12;

/// An entry that two texts have differently, or that only one of them has.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Difference {
    /// Keys from the top, members of lists of tables by their place from 1: `ask`, `2`, `statistic`.
    pub keys: Vec<String>,
    /// Entry of the first text, without quotes; `None` if it has no such entry.
    pub before: Option<String>,
    /// Entry of the second text.
    pub after: Option<String>,
}

impl Difference {
    /// The keys as one path, `joint.gudgeon.radial_clearance`.
    pub fn path(&self) -> String {
        self.keys.join(".")
    }
}

/// The entries that `before` and `after` have differently, in the order of the first text; those of the second one alone follow in each table.
///
/// # Errors
/// A text is no TOML.
pub fn differences(before: &Arc<Source>, after: &Arc<Source>) -> Result<Vec<Difference>, Diagnostics> {
    let (first, second) = (parse_toml(before)?, parse_toml(after)?);
    let mut walk = Walk { before, after, found: Vec::new() };
    walk.tables(&mut Vec::new(), Some(first.get_ref()), Some(second.get_ref()));
    Ok(walk.found)
}

type Value<'t> = Spanned<DeValue<'t>>;

struct Walk<'s> {
    before: &'s Source,
    after: &'s Source,
    found: Vec<Difference>,
}

impl Walk<'_> {
    fn tables(&mut self, keys: &mut Vec<String>, before: Option<&DeTable<'_>>, after: Option<&DeTable<'_>>) {
        let names = |table: Option<&DeTable<'_>>| -> Vec<String> {
            table.into_iter().flat_map(|table| table.keys()).map(|key| key.get_ref().to_string()).collect()
        };
        let own = names(before);
        let added = names(after).into_iter().filter(|name| !own.contains(name)).collect::<Vec<String>>();
        for name in own.into_iter().chain(added) {
            let (first, second) =
                (before.and_then(|table| table.get(name.as_str())), after.and_then(|table| table.get(name.as_str())));
            keys.push(name);
            self.values(keys, first, second);
            keys.pop();
        }
    }

    fn values(&mut self, keys: &mut Vec<String>, before: Option<&Value<'_>>, after: Option<&Value<'_>>) {
        let table = |value: Option<&Value<'_>>| value.is_none_or(|value| value.get_ref().is_table());
        let list = |value: Option<&Value<'_>>| value.is_none_or(is_list_of_tables);
        if before.is_none() && after.is_none() {
            return;
        }
        if table(before) && table(after) {
            self.tables(
                keys,
                before.and_then(|value| value.get_ref().as_table()),
                after.and_then(|value| value.get_ref().as_table()),
            );
        } else if list(before) && list(after) {
            let members =
                |value: Option<&Value<'_>>| value.and_then(|v| v.get_ref().as_array()).map_or(0, |list| list.len());
            for place in 0..members(before).max(members(after)) {
                keys.push((place + 1).to_string());
                self.values(
                    keys,
                    before.and_then(|value| value.get_ref().as_array()?.get(place)),
                    after.and_then(|value| value.get_ref().as_array()?.get(place)),
                );
                keys.pop();
            }
        } else {
            let told = |value: Option<&Value<'_>>, source: &Source| value.map(|value| written(value, source));
            let (first, second) = (told(before, self.before), told(after, self.after));
            let is_same = match (before, after) {
                (Some(a), Some(b)) => is_same((a, self.before), (b, self.after)),
                _ => false,
            };
            if !is_same {
                self.found.push(Difference { keys: keys.clone(), before: first, after: second });
            }
        }
    }
}

fn is_list_of_tables(value: &Value<'_>) -> bool {
    let members = value.get_ref().as_array();
    members.is_some_and(|list| !list.is_empty() && list.iter().all(|member| member.get_ref().is_table()))
}

/// What stands in the text; of a plain string what is between its quotes.
fn written(value: &Value<'_>, source: &Source) -> String {
    match value.get_ref().as_str() {
        Some(text) => text.to_owned(),
        None => source.text()[source.clamp(value.span().into())].to_owned(),
    }
}

/// Whether two entries have one value.
fn is_same((before, in_before): (&Value<'_>, &Source), (after, in_after): (&Value<'_>, &Source)) -> bool {
    match (before.get_ref().as_array(), after.get_ref().as_array()) {
        (Some(first), Some(second)) => {
            let each = || first.iter().zip(second.iter());
            first.len() == second.len() && each().all(|(a, b)| is_same((a, in_before), (b, in_after)))
        }
        (None, None) => is_same_text(&written(before, in_before), &written(after, in_after)),
        _ => false,
    }
}

fn is_same_text(before: &str, after: &str) -> bool {
    if before == after {
        return true;
    }
    let (Ok(first), Ok(second)) = (parse_quantity(before), parse_quantity(after)) else { return false };
    let largest = first.value_si.abs().max(second.value_si.abs());
    first.dimension == second.dimension && (first.value_si - second.value_si).abs() <= ROUND_OFF * largest
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(before: &str, after: &str) -> Vec<(String, Option<String>, Option<String>)> {
        let [before, after] = [("a.toml", before), ("b.toml", after)].map(|(name, text)| Source::new(name, text));
        let found = differences(&before, &after).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
        found.into_iter().map(|one| (one.path(), one.before, one.after)).collect()
    }

    fn due(path: &str, before: Option<&str>, after: Option<&str>) -> (String, Option<String>, Option<String>) {
        (path.to_owned(), before.map(str::to_owned), after.map(str::to_owned))
    }

    #[test]
    fn analytic_values_are_compared_and_not_how_they_are_written() {
        let before = "# a comment\na = \"0.1 mm\"\nb = [\"1 mm\", \"2 mm\"]\nc = 2\nd = \"50 rpm\"\n";
        assert_eq!(found(before, "d=\"50 rpm\"\na = '1e-4 m'\nb = [\"0.001 m\", \"2 mm\"]\nc = 2.0\n"), []);
        // Angles are a dimension of their own, and a length is none.
        assert_eq!(found("a = \"0.1 mm\"\n", "a = \"1e-4 rad\"\n").len(), 1);
        assert_eq!(
            found(before, &before.replace("2 mm", "3 mm")),
            [due("b", Some("[\"1 mm\", \"2 mm\"]"), Some("[\"1 mm\", \"3 mm\"]"))]
        );
    }

    #[test]
    fn entries_are_named_by_their_keys_and_places() {
        let before = "[joint.gudgeon]\nradial_clearance = \"0.1 mm\"\n[[ask]]\noutput = \"slider\"\n";
        let after = "[joint.gudgeon]\nradial_clearance = \"0.2 mm\"\nstops = 1\n[[ask]]\noutput = \"slider\"\n[[ask]]\noutput = \"crank\"\n";
        assert_eq!(
            found(before, after),
            [
                due("joint.gudgeon.radial_clearance", Some("0.1 mm"), Some("0.2 mm")),
                due("joint.gudgeon.stops", None, Some("1")),
                due("ask.2.output", None, Some("crank")),
            ]
        );
        assert_eq!(found(after, before).len(), 3);
        assert_eq!(found(after, after), []);
    }

    #[test]
    fn entries_of_another_kind_differ() {
        let table = "a = { b = 1 }\n";
        assert_eq!(found(table, "a = 1\n"), [due("a", Some("{ b = 1 }"), Some("1"))]);
        assert_eq!(found("a = [1]\n", "a = []\n"), [due("a", Some("[1]"), Some("[]"))]);
        assert_eq!(found("a = [{ b = 1 }]\n", "a = []\n"), [due("a", Some("[{ b = 1 }]"), Some("[]"))]);
        assert!(differences(&Source::new("a.toml", "a = "), &Source::new("b.toml", "")).is_err());
    }
}
