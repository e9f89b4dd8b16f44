//! Which places of the two texts name a body, a point, a joint or anything else.

use std::ops::Range;

use super::edit::Named;
use crate::edit::toml::scan::{Key, Scanned, Value, ValueKind, element};
use crate::messages::Document;

/// Tables of a study whose keys are paths of numbers.
const BY_PATH: [&str; 3] = ["random", "epistemic", "allow"];

/// A place that names something.
#[derive(Debug, Clone, PartialEq)]
pub struct NameReference {
    /// The named item.
    pub of: Named,
    /// The key or the value that names it, from the top of the file.
    pub path: Vec<String>,
    /// Bytes of the whole key or text, quotes and all.
    pub span: Range<usize>,
    /// Contents of that, without quotes.
    pub written: String,
    /// Whether it is the definition of the item itself.
    pub is_own: bool,
}

impl NameReference {
    /// The contents with another name for what is named: of a point where it is one, of its body else.
    pub fn renamed(&self, what: &Named, to: &str) -> String {
        let mut steps: Vec<&str> = self.written.split('.').collect();
        // Keys of the thing itself hold its name alone; texts have what it is a part of before it, and so have paths of numbers.
        let (name, point) = match steps.as_slice() {
            // The name of a point alone, where its body is plain from the place: it stays when the body gets another one.
            [_] if self.of.point.is_some() => (1, 0),
            [_] => (0, 0),
            ["body", _, "points", _, ..] => (1, 3),
            ["assembly", "guess", _] | ["initial", _, _, ..] => (2, 2),
            [_, _] if self.of.point.is_some() => (0, 1),
            _ => (1, 1),
        };
        let place = if what.point.is_some() { point } else { name };
        if let Some(step) = steps.get_mut(place) {
            *step = to;
        }
        steps.join(".")
    }
}

/// All places of a text that name something.
pub fn mentions(document: Document, scanned: &Scanned) -> Vec<NameReference> {
    let mut found = Vec::new();
    for statement in &scanned.statements {
        let mut path = statement.path.clone();
        for (nth, key) in statement.keys.iter().enumerate() {
            let end = match &statement.value {
                None => end_of_key(&path, nth),
                Some(_) => path.len() - statement.keys.len() + nth + 1,
            };
            of_key(document, &path[..end], key, &mut found);
        }
        if let Some(value) = &statement.value {
            of_value(document, &mut path, value, &mut found);
        }
    }
    found
}

/// How many steps of the path of a header its keys take up to the one with this number: elements of lists have no key.
fn end_of_key(path: &[String], nth: usize) -> usize {
    let keys = path.iter().enumerate().filter(|(_, step)| !step.starts_with('#'));
    keys.map(|(place, _)| place + 1).nth(nth).unwrap_or(path.len())
}

fn of_value(document: Document, path: &mut Vec<String>, value: &Value, found: &mut Vec<NameReference>) {
    match &value.kind {
        ValueKind::Text(text) => {
            let steps: Vec<&str> = path.iter().map(String::as_str).collect();
            let named = match document {
                Document::Model => named_in_model(&steps, text),
                Document::Study => named_in_study(&steps, text),
            };
            found.extend(named.map(|of| NameReference {
                of,
                path: path.clone(),
                span: value.span.clone(),
                written: text.clone(),
                is_own: false,
            }));
        }
        ValueKind::Other => {}
        ValueKind::List(values) => {
            for (index, value) in values.iter().enumerate() {
                path.push(element(index));
                of_value(document, path, value, found);
                path.pop();
            }
        }
        ValueKind::Table(items) => {
            for item in items {
                for key in &item.keys {
                    path.push(key.name.clone());
                    of_key(document, path, key, found);
                }
                of_value(document, path, &item.value, found);
                path.truncate(path.len() - item.keys.len());
            }
        }
    }
}

/// What a key names, where it is the last of a path.
fn of_key(document: Document, path: &[String], key: &Key, found: &mut Vec<NameReference>) {
    let steps: Vec<&str> = path.iter().map(String::as_str).collect();
    let (of, is_own) = match (document, steps.as_slice()) {
        (Document::Model, ["assembly", "guess", body]) => (Some(Named::new("body", body)), false),
        (Document::Model, ["initial", table @ ("body" | "joint"), name]) => (Some(Named::new(table, name)), false),
        (Document::Model, ["body", body, "points", point]) => (Some(Named::point(body, point)), true),
        (Document::Model, [table, name]) if is_named(table) => (Some(Named::new(table, name)), true),
        (Document::Study, [table, number]) if BY_PATH.contains(table) => (of_number(number), false),
        (Document::Study, ["ask" | "require", _, "poses", drive] | ["measured", _, "pose", drive]) => {
            (Some(Named::new("drive", drive)), false)
        }
        _ => (None, false),
    };
    let Some(of) = of else { return };
    found.push(NameReference { of, path: path.to_vec(), span: key.span.clone(), written: key.name.clone(), is_own });
}

/// Tables of a model whose entries have names of the person's choosing.
fn is_named(table: &str) -> bool {
    const TABLES: [&str; 11] =
        ["parameter", "body", "contact", "joint", "coupling", "cam", "spring", "load", "drive", "control", "output"];
    TABLES.contains(&table)
}

/// What the path of a number begins with.
fn of_number(path: &str) -> Option<Named> {
    let steps: Vec<&str> = path.split('.').collect();
    match steps.as_slice() {
        ["body", body, "points", point, ..] => Some(Named::point(body, point)),
        ["assembly", "guess", body] => Some(Named::new("body", body)),
        ["initial", table @ ("body" | "joint"), name, ..] => Some(Named::new(table, name)),
        [table, name, ..] if is_named(table) => Some(Named::new(table, name)),
        _ => None,
    }
}

fn named_in_study(path: &[&str], text: &str) -> Option<Named> {
    match path {
        ["ask" | "require" | "measured", _, "output"] => Some(Named::new("output", text)),
        ["measured", _, "at"] => text.split_once('.').map(|(body, point)| Named::point(body, point)),
        ["correlation", _, "of", _] => of_number(text),
        _ => None,
    }
}

/// What a text of a model names, by the key behind which it stands.
fn named_in_model(path: &[&str], text: &str) -> Option<Named> {
    let point = || text.split_once('.').map(|(body, point)| Named::point(body, point));
    let body = || Some(Named::new("body", text));
    let joint = || Some(Named::new("joint", text.strip_prefix("joint.").unwrap_or(text)));
    match path {
        ["body", own, "beam", "from" | "to"] => Some(Named::point(own, text)),
        ["joint", _, "bearing" | "journal" | "slider" | "pin" | "first" | "second"] => point(),
        ["joint", _, "guide" | "slot" | "slider", "point"] => point(),
        ["joint" | "coupling" | "cam", _, "contact"] => Some(Named::new("contact", text)),
        ["spring", _, "joint"] | ["load", _, "joint"] | ["drive", _, "joint"] => joint(),
        ["control", _, "joint" | "measured"] | ["coupling", _, "first" | "second"] => joint(),
        ["cam", _, "joint" | "follower"] => joint(),
        ["load", _, "point"] => point(),
        ["load", _, "body"] => body(),
        // A torsion spring has bodies, another one points.
        ["spring", _, "first" | "second"] => point().or_else(body),
        ["cycle", "drive"] => Some(Named::new("drive", text)),
        ["output", _, "position_of" | "velocity_of" | "acceleration_of" | "path_of"] => point(),
        ["output", _, "angle_of" | "angular_velocity_of" | "angular_acceleration_of"] => body(),
        ["output", _, "relative_to"] => point().or_else(body),
        ["output", _, "stress_in"] => body(),
        ["output", _, "force_in" | "wear_of"] => joint(),
        ["wear", "limit_of"] => Some(Named::new("output", text.strip_prefix("output.").unwrap_or(text))),
        ["output", _, "torque_of" | "force_of" | "power_of"] => {
            let (table, name) = text.split_once('.')?;
            ["drive", "control"].contains(&table).then(|| Named::new(table, name))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::edit::toml::scan::scan;

    fn found(document: Document, text: &str) -> Vec<(String, String)> {
        let scanned = scan(text).unwrap();
        let all = mentions(document, &scanned);
        all.iter().map(|mention| (mention.of.words(), text[mention.span.clone()].to_owned())).collect()
    }

    #[test]
    fn names_are_found_however_they_are_written() {
        let model = "[body.rod.points]\npin = [\"0 mm\", \"0 mm\"]\n[joint]\na = { kind = 'prismatic', guide.point = \"rod.pin\", slider = \"x.y\" }\n\
             [assembly]\nguess.rod = \"1 deg\"\n[output.\"o\"]\nforce_in = \"joint.a\"\n";
        let due = [
            ("body 'rod'", "rod"),
            ("point 'rod.pin'", "pin"),
            ("joint 'a'", "a"),
            ("point 'rod.pin'", "\"rod.pin\""),
            ("point 'x.y'", "\"x.y\""),
            ("body 'rod'", "rod"),
            ("output 'o'", "\"o\""),
            ("joint 'a'", "\"joint.a\""),
        ];
        let due: Vec<(String, String)> = due.iter().map(|(a, b)| ((*a).to_owned(), (*b).to_owned())).collect();
        assert_eq!(found(Document::Model, model), due);
        let study = "[random]\n\"joint.a.radial_clearance\" = 1\n[[ask]]\noutput = \"o\"\nposes = { crank = [] }\n[[correlation]]\n\
             of = [\"parameter.p\", \"body.rod.points.pin.x\"]\n";
        let due = [
            ("joint 'a'", "\"joint.a.radial_clearance\""),
            ("output 'o'", "\"o\""),
            ("drive 'crank'", "crank"),
            ("parameter 'p'", "\"parameter.p\""),
            ("point 'rod.pin'", "\"body.rod.points.pin.x\""),
        ];
        let due: Vec<(String, String)> = due.iter().map(|(a, b)| ((*a).to_owned(), (*b).to_owned())).collect();
        assert_eq!(found(Document::Study, study), due);
    }

    #[test]
    fn names_of_beams_wear_and_readings_are_found() {
        let model = "[body.rod.beam]\nfrom = \"big\"\nto = \"small\"\n[wear]\nlimit_of = \"output.o\"\n[output.s]\nstress_in = \"rod\"\n\
             [output.w]\nwear_of = \"joint.pin\"\n";
        let of_model = found(Document::Model, model);
        for (words, written) in [
            ("point 'rod.big'", "\"big\""),
            ("point 'rod.small'", "\"small\""),
            ("output 'o'", "\"output.o\""),
            ("body 'rod'", "\"rod\""),
            ("joint 'pin'", "\"joint.pin\""),
        ] {
            assert!(of_model.contains(&(words.to_owned(), written.to_owned())), "{words}: {of_model:?}");
        }
        let study = "[[measured]]\noutput = \"o\"\npose = { crank = \"60 deg\" }\nat = \"slider.pin\"\n";
        let due = [("output 'o'", "\"o\""), ("drive 'crank'", "crank"), ("point 'slider.pin'", "\"slider.pin\"")];
        assert_eq!(found(Document::Study, study), due.map(|(a, b)| (a.to_owned(), b.to_owned())));
        // Another name of the body leaves that of a point alone which stands without it.
        let scanned = scan(model).unwrap();
        let from = mentions(Document::Model, &scanned).into_iter().find(|one| one.of == Named::point("rod", "big"));
        assert_eq!(from.unwrap().renamed(&Named::new("body", "rod"), "bar"), "big");
    }
}
