//! Who imports whom in a folder of Python, TypeScript or Svelte.
//!
//! Read from the statements alone: `from .name import`, `from . import name`, and a path that begins with a dot behind `from` or `import`.
//! Imports of types count as well: a file depends on the files of the types that it names.

use crate::sources::Source;
use std::collections::{BTreeMap, BTreeSet};

/// The imports of a folder: for each file the files of the folder that it imports.
pub fn imports(sources: &[Source]) -> BTreeMap<String, BTreeSet<String>> {
    let files: BTreeSet<&str> = sources.iter().map(|source| source.path.as_str()).collect();
    let of = |source: &Source| {
        let wanted = if source.path.ends_with(".py") { python(source) } else { typescript(source) };
        let found = wanted.into_iter().filter_map(|names| names.into_iter().find(|name| files.contains(name.as_str())));
        (source.path.clone(), found.collect())
    };
    sources.iter().map(of).collect()
}

/// For each import the files that it may mean. One package without folders.
fn python(source: &Source) -> Vec<Vec<String>> {
    let mut found = Vec::new();
    for line in source.text.lines().map(str::trim) {
        let Some((module, names)) = line.strip_prefix("from .").and_then(|rest| rest.split_once("import ")) else {
            continue;
        };
        match module.trim() {
            "" => found.extend(names.split(',').filter_map(|name| name.split_whitespace().next()).map(module_files)),
            module => found.push(module_files(module)),
        }
    }
    found
}

fn module_files(name: &str) -> Vec<String> {
    vec![format!("{name}.py"), format!("{name}.pyi")]
}

fn typescript(source: &Source) -> Vec<Vec<String>> {
    let folder = source.path.rsplit_once('/').map_or("", |(folder, _)| folder);
    let quoted = |rest: &str| {
        let rest = rest.trim_start().trim_start_matches('(');
        let mark = rest.chars().next().filter(|mark| matches!(mark, '\'' | '"'))?;
        let path = rest[1..].split(mark).next()?;
        path.starts_with('.').then(|| path.to_owned())
    };
    let behind = |word: &str| source.text.match_indices(word).map(|(at, word)| at + word.len()).collect::<Vec<_>>();
    let places = [behind("from "), behind("import "), behind("import(")].concat();
    let paths = places.into_iter().filter_map(|at| quoted(&source.text[at..]));
    paths
        .map(|path| {
            let path = joined(folder, &path);
            vec![path.clone(), format!("{path}.ts"), format!("{path}/index.ts")]
        })
        .collect()
}

/// `path` as seen from `folder`.
fn joined(folder: &str, path: &str) -> String {
    let mut parts: Vec<&str> = folder.split('/').filter(|part| !part.is_empty()).collect();
    for part in path.split('/') {
        match part {
            "." => {}
            ".." => {
                parts.pop();
            }
            part => parts.push(part),
        }
    }
    parts.join("/")
}
