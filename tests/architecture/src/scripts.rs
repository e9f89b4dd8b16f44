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

/// For each import the files that it may mean.
fn python(source: &Source) -> Vec<Vec<String>> {
    let folder = source.path.rsplit_once('/').map_or("", |(folder, _)| folder);
    let mut found = Vec::new();
    for line in source.text.lines().map(str::trim) {
        let Some((module, names)) = line.strip_prefix("from .").and_then(|rest| rest.split_once("import ")) else {
            continue;
        };
        // The first dot is the folder of the file, each further one a folder up.
        let inside = module.trim().trim_start_matches('.');
        let up = "../".repeat(module.trim().len() - inside.len());
        let module = joined(folder, &format!("{up}{}", inside.replace('.', "/")));
        let names = names.split(',').filter_map(|name| name.split_whitespace().next());
        found.extend(names.map(|name| module_files(inside, &module, name)));
    }
    found
}

/// The files that `name`, imported from `module`, may be or be in.
fn module_files(inside: &str, module: &str, name: &str) -> Vec<String> {
    let (module, own) = (module.trim_end_matches('/'), format!("{module}/{name}"));
    let own = own.trim_start_matches('/').replace("//", "/");
    let mut files = vec![format!("{own}.py"), format!("{own}.pyi")];
    if !inside.is_empty() {
        files.extend([format!("{module}.py"), format!("{module}.pyi"), format!("{module}/__init__.py")]);
    }
    files
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
