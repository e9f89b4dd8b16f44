//! Kinds are known in one folder: what they are is asked of them, and a kind that is added changes nothing elsewhere.

#![allow(clippy::disallowed_methods, reason = "tests make files of their own")]

use architecture::sources::sources_below;
use std::collections::BTreeMap;
use std::path::Path;

/// An enum of kinds, the folder or file that knows them by their names, and the other files that may, with how often and why.
struct Kinds {
    name: &'static str,
    home: &'static str,
    elsewhere: &'static [(&'static str, usize, &'static str)],
}

const KINDS: [Kinds; 3] = [
    Kinds { name: "JointKind", home: "loosepin-mechanics/src/model/joint/", elsewhere: &[] },
    Kinds {
        name: "PlayShape",
        home: "loosepin-mechanics/src/mechanism/play_shape.rs",
        elsewhere: &[
            ("loosepin-mechanics/src/mechanism/sample.rs", 4, "makes each of its numbers"),
            ("loosepin-mechanics/src/dynamics/contact.rs", 4, "hands every question on to the file of the shape"),
        ],
    },
    Kinds { name: "DrawnJointKind", home: "loosepin-result/src/simulation/drawn_joint.rs", elsewhere: &[] },
];

/// How often `text` names a variant of `name`, in a `match`, an `if let`, a `matches!`, a comparison or to make one. A variant begins with a
/// capital and goes on with a small letter; comments do not count.
fn mentions(text: &str, name: &str) -> usize {
    let code = text.lines().filter(|line| !line.trim_start().starts_with("//"));
    let is_variant = |rest: &str| {
        let mut letters = rest.chars();
        letters.next().is_some_and(char::is_uppercase) && letters.next().is_some_and(char::is_lowercase)
    };
    let path = format!("{name}::");
    let of_line = |line: &str| {
        let places = line.match_indices(&path).filter(|(place, _)| {
            let is_whole = !line[..*place].ends_with(|letter: char| letter.is_alphanumeric() || letter == '_');
            is_whole && is_variant(&line[place + path.len()..])
        });
        places.count()
    };
    code.map(of_line).sum()
}

#[test]
fn kinds_are_named_in_their_folder_alone() {
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../crates");
    let sources = sources_below(&crates);
    let is_production =
        |path: &str| path.contains("/src/") && !path.ends_with("/tests.rs") && !path.contains("/tests/");
    let mut found = Vec::new();
    for Kinds { name, home, elsewhere } in &KINDS {
        let mut allowed: BTreeMap<&str, usize> = elsewhere.iter().map(|(path, count, _)| (*path, *count)).collect();
        for source in sources.iter().filter(|source| is_production(&source.path) && !source.path.starts_with(home)) {
            let production: Vec<&str> = source.text.lines().take(source.lines_before_tests()).collect();
            let (count, due) = (mentions(&production.join("\n"), name), allowed.remove(&source.path[..]).unwrap_or(0));
            if count != due {
                found.push(format!("{}: {count} mentions of kinds of {name}, {due} in the list", source.path));
            }
        }
        found.extend(allowed.keys().map(|path| format!("{path} is in the list of {name} and does not exist")));
    }
    assert!(found.is_empty(), "{found:#?}\nask the kind in place of naming it, or list the file with a reason");
}

#[test]
fn every_way_to_name_a_kind_is_counted() {
    let text = "match kind { JointKind::Slot(slot) => 1, _ => 2 }\nif let JointKind::Rigid(_) = kind {}\n\
                matches!(kind, JointKind::Slot(_)); kind == DrawnJointKind::Slot; JointKind::read(word);\n/// JointKind::Slot\n";
    assert_eq!(mentions(text, "JointKind"), 3);
    assert_eq!(mentions(text, "DrawnJointKind"), 1);
}
