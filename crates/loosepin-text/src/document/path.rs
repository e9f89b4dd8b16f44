//! Path of an entry in a file, as a dotted path and in words.

/// The keys from the top of the file to an entry.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct EntryPath(Vec<String>);

impl EntryPath {
    /// The path of an entry of this table.
    pub fn join(&self, key: &str) -> EntryPath {
        let mut keys = self.0.clone();
        keys.push(key.to_owned());
        EntryPath(keys)
    }

    /// Keys with dots between them, for example `joint.gudgeon.radial_clearance`.
    pub fn dotted(&self) -> String {
        self.0.join(".")
    }

    /// In words, for example `joint 'gudgeon': radial clearance`.
    pub fn describe(&self) -> String {
        describe(&self.0.iter().map(String::as_str).collect::<Vec<_>>())
    }
}

/// A dotted path in words: `joint.gudgeon.radial_clearance` is `joint 'gudgeon': radial clearance`.
pub fn describe_path(dotted: &str) -> String {
    describe(&dotted.split('.').collect::<Vec<_>>())
}

/// Tables whose entries are tables under names of the person's choosing.
const NAMED: [&str; 15] = [
    "body",
    "contact",
    "joint",
    "spring",
    "load",
    "coupling",
    "cam",
    "drive",
    "control",
    "output",
    "outputs",
    "random",
    "epistemic",
    "expected",
    "history",
];

fn describe(keys: &[&str]) -> String {
    match keys {
        [] => String::new(),
        ["initial", kind @ ("body" | "joint"), name] => format!("initial: {kind} '{name}'"),
        ["initial", kind @ ("body" | "joint"), name, rest @ ..] => {
            format!("initial: {kind} '{name}': {}", plain_words(rest))
        }
        ["assembly", "guess", body] => format!("assembly: guess of '{body}'"),
        ["parameter", name] => format!("parameter '{name}'"),
        [kind, name] if NAMED.contains(kind) => format!("{kind} '{name}'"),
        [kind, name, rest @ ..] if NAMED.contains(kind) => format!("{kind} '{name}': {}", plain_words(rest)),
        [kind @ ("ask" | "require"), number] => format!("[[{kind}]] {number}"),
        [kind @ ("ask" | "require"), number, rest @ ..] => format!("[[{kind}]] {number}: {}", plain_words(rest)),
        [kind @ ("sampling" | "cycle"), rest @ ..] if !rest.is_empty() => format!("{kind}: {}", plain_words(rest)),
        _ => plain_words(keys),
    }
}

fn plain_words(keys: &[&str]) -> String {
    match keys {
        ["points", point, rest @ ..] => {
            let coordinates: String = rest.iter().map(|key| format!(" {key}")).collect();
            format!("point '{point}'{coordinates}")
        }
        _ => keys.iter().map(|key| key.replace('_', " ")).collect::<Vec<_>>().join(" "),
    }
}

/// Whether bodies, points, joints and outputs may be called so.
pub fn is_name(name: &str) -> bool {
    name.chars().next().is_some_and(|first| first.is_alphabetic() || first == '_')
        && name.chars().all(|character| character.is_alphanumeric() || matches!(character, '_' | '-'))
}

#[cfg(test)]
mod tests {
    use super::describe_path;

    #[test]
    fn paths_are_read_aloud() {
        for (path, words) in [
            ("joint.gudgeon.radial_clearance", "joint 'gudgeon': radial clearance"),
            ("body.crank.points.pin.x", "body 'crank': point 'pin' x"),
            ("body.crank.centre_of_mass.y", "body 'crank': centre of mass y"),
            ("parameter.crank_length", "parameter 'crank_length'"),
            ("assembly.guess.rocker", "assembly: guess of 'rocker'"),
            ("contact.steel.friction.coefficient", "contact 'steel': friction coefficient"),
            ("gravity", "gravity"),
            ("cycle.recorded_turns", "cycle: recorded turns"),
        ] {
            assert_eq!(describe_path(path), words);
        }
    }
}
