//! Who imports whom inside of a crate, file by file, read from the tokens of the sources.
//!
//! A path is followed to the file that defines its name: through folders, and through the re-exports of `mod.rs`. Comments are
//! no tokens and documentation is a string, so neither counts; nor does what stands behind `#[cfg(test)]`.

use crate::sources::Source;
use proc_macro2::{Delimiter, TokenStream, TokenTree};
use std::collections::{BTreeMap, BTreeSet};

/// A path below the crate root: `["model", "quantity", "Rule"]`.
type Path = Vec<String>;

/// A name that a module brings in with `use`.
struct Import {
    /// The name it has there; None for `*`.
    name: Option<String>,
    target: Path,
    is_public: bool,
}

/// What the tokens of one module say.
#[derive(Default)]
struct Module {
    /// The file it stands in.
    file: String,
    imports: Vec<Import>,
    /// Paths in its code.
    mentions: Vec<Path>,
    /// Whether it is declared behind `#[cfg(test)]`.
    is_test: bool,
}

/// The modules of a crate by their paths.
struct Tree {
    modules: BTreeMap<Path, Module>,
}

/// The imports of a crate: for each file the files that it names something of.
pub fn imports(sources: &[Source]) -> Result<BTreeMap<String, BTreeSet<String>>, String> {
    let mut tree = Tree { modules: BTreeMap::new() };
    for source in sources {
        tree.modules.entry(source.module_path()).or_default().file.clone_from(&source.path);
    }
    for source in sources {
        let tokens = source.text.parse().map_err(|error| format!("{}: {error}", source.path))?;
        tree.read(&source.module_path(), &source.path, tokens);
    }
    Ok(tree.edges())
}

/// Groups of files that import each other in a circle.
pub fn circles(edges: &BTreeMap<String, BTreeSet<String>>) -> Vec<BTreeSet<String>> {
    let reached: BTreeMap<&String, BTreeSet<&String>> =
        edges.keys().map(|file| (file, reached_from(file, edges))).collect();
    let mut found: Vec<BTreeSet<String>> = Vec::new();
    for (file, others) in &reached {
        if others.contains(file) && !found.iter().any(|circle| circle.contains(*file)) {
            let circle = others.iter().filter(|other| reached.get(**other).is_some_and(|back| back.contains(file)));
            found.push(circle.map(|other| (*other).clone()).collect());
        }
    }
    found
}

fn reached_from<'a>(file: &str, edges: &'a BTreeMap<String, BTreeSet<String>>) -> BTreeSet<&'a String> {
    let mut reached = BTreeSet::new();
    let mut open: Vec<&String> = edges.get(file).into_iter().flatten().collect();
    while let Some(next) = open.pop() {
        if reached.insert(next) {
            open.extend(edges.get(next).into_iter().flatten());
        }
    }
    reached
}

impl Tree {
    /// Reads the tokens of the module at `at`, which stand in `file`.
    fn read(&mut self, at: &Path, file: &str, stream: TokenStream) {
        let tokens: Vec<TokenTree> = stream.into_iter().collect();
        let (mut k, mut is_test, mut is_public) = (0, false, false);
        while k < tokens.len() {
            match &tokens[k] {
                TokenTree::Punct(mark) if mark.as_char() == '#' => {
                    if let Some(TokenTree::Group(attribute)) = tokens.get(k + 1) {
                        is_test |= attribute.stream().to_string().replace(' ', "") == "cfg(test)";
                        k += 1;
                    }
                }
                TokenTree::Ident(word) if word == "pub" => {
                    is_public = true;
                    if let Some(TokenTree::Group(_)) = tokens.get(k + 1) {
                        k += 1;
                    }
                }
                TokenTree::Ident(word) if word == "use" => {
                    let end = (k + 1..tokens.len()).find(|&j| is_mark(&tokens[j], ';')).unwrap_or(tokens.len());
                    if !is_test {
                        for (path, name) in use_paths(&tokens[k + 1..end]) {
                            if let Some(target) = self.rooted(at, &path) {
                                self.module(at).imports.push(Import { name, target, is_public });
                            }
                        }
                    }
                    (k, is_test, is_public) = (end, false, false);
                }
                TokenTree::Ident(word) if word == "mod" => {
                    if let Some(TokenTree::Ident(name)) = tokens.get(k + 1) {
                        let mut inner = at.clone();
                        inner.push(name.to_string());
                        match tokens.get(k + 2) {
                            Some(TokenTree::Group(body)) if !is_test => {
                                self.module(&inner).file = file.to_owned();
                                self.read(&inner, file, body.stream());
                            }
                            Some(TokenTree::Punct(_)) if is_test => self.module(&inner).is_test = true,
                            _ => {}
                        }
                        k += 2;
                    }
                    (is_test, is_public) = (false, false);
                }
                TokenTree::Group(group) => {
                    if !is_test {
                        self.mentions(at, group.stream());
                    }
                    if group.delimiter() == Delimiter::Brace {
                        (is_test, is_public) = (false, false);
                    }
                }
                TokenTree::Ident(_) if !is_test => k = self.mention(at, &tokens, k),
                TokenTree::Punct(mark) if mark.as_char() == ';' => (is_test, is_public) = (false, false),
                _ => {}
            }
            k += 1;
        }
    }

    fn module(&mut self, at: &Path) -> &mut Module {
        self.modules.entry(at.clone()).or_default()
    }

    /// Paths in code, however deep in blocks.
    fn mentions(&mut self, at: &Path, stream: TokenStream) {
        let tokens: Vec<TokenTree> = stream.into_iter().collect();
        let mut k = 0;
        while k < tokens.len() {
            match &tokens[k] {
                TokenTree::Group(group) => self.mentions(at, group.stream()),
                TokenTree::Ident(word) if word == "use" => {
                    let end = (k + 1..tokens.len()).find(|&j| is_mark(&tokens[j], ';')).unwrap_or(tokens.len());
                    for (path, _) in use_paths(&tokens[k + 1..end]) {
                        if let Some(target) = self.rooted(at, &path) {
                            self.module(at).mentions.push(target);
                        }
                    }
                    k = end;
                }
                TokenTree::Ident(_) => k = self.mention(at, &tokens, k),
                _ => {}
            }
            k += 1;
        }
    }

    /// The path that begins at token `k`, if it is one of this crate; the last token of it.
    fn mention(&mut self, at: &Path, tokens: &[TokenTree], k: usize) -> usize {
        let (mut path, mut last) = (vec![tokens[k].to_string()], k);
        while is_separator(tokens, last + 1)
            && let Some(TokenTree::Ident(next)) = tokens.get(last + 3)
        {
            path.push(next.to_string());
            last += 3;
        }
        if path.len() > 1
            && let Some(target) = self.rooted(at, &path)
        {
            self.module(at).mentions.push(target);
        }
        last
    }

    /// `path`, written in the module at `at`, from the crate root; None for another crate's, or a type's.
    fn rooted(&self, at: &Path, path: &[String]) -> Option<Path> {
        let mut base = match path[0].as_str() {
            "crate" => Vec::new(),
            "self" | "super" => at.clone(),
            child => {
                let mut below = at.clone();
                below.push(child.to_owned());
                return self.modules.contains_key(&below).then(|| [at.clone(), path.to_vec()].concat());
            }
        };
        let mut rest = path;
        while rest.first().is_some_and(|word| matches!(word.as_str(), "crate" | "self" | "super")) {
            if rest[0] == "super" {
                base.pop();
            }
            rest = &rest[1..];
        }
        base.extend_from_slice(rest);
        Some(base)
    }

    /// The file that defines what `path` names.
    fn file_of(&self, path: &[String], depth: usize) -> Option<&str> {
        let length = (0..=path.len()).rev().find(|&length| self.modules.contains_key(&path[..length]))?;
        let module = &self.modules[&path[..length]];
        let Some(name) = path.get(length) else { return Some(&module.file) };
        // A name that came by `use`; re-exports that lead to each other end somewhere.
        let import = module.imports.iter().find(|import| import.name.as_ref() == Some(name));
        if let Some(import) = import.filter(|_| depth < 8) {
            let target = [import.target.clone(), path[length + 1..].to_vec()].concat();
            return self.file_of(&target, depth + 1);
        }
        Some(&module.file)
    }

    fn edges(&self) -> BTreeMap<String, BTreeSet<String>> {
        let mut edges: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
        for (path, module) in &self.modules {
            if (1..=path.len()).any(|length| self.modules.get(&path[..length]).is_some_and(|module| module.is_test)) {
                continue;
            }
            let to = edges.entry(module.file.clone()).or_default();
            let imported = module.imports.iter().filter(|import| !import.is_public).map(|import| &import.target);
            for target in imported.chain(&module.mentions) {
                if let Some(file) = self.file_of(target, 0)
                    && file != module.file
                {
                    to.insert(file.to_owned());
                }
            }
        }
        edges
    }
}

fn is_mark(token: &TokenTree, character: char) -> bool {
    matches!(token, TokenTree::Punct(mark) if mark.as_char() == character)
}

fn is_separator(tokens: &[TokenTree], at: usize) -> bool {
    tokens.get(at).is_some_and(|token| is_mark(token, ':'))
        && tokens.get(at + 1).is_some_and(|token| is_mark(token, ':'))
}

/// The paths of a `use`, with the name that each brings in (None for `*`).
fn use_paths(tokens: &[TokenTree]) -> Vec<(Path, Option<String>)> {
    let mut paths = Vec::new();
    let (mut path, mut alias): (Path, Option<String>) = (Vec::new(), None);
    let mut k = 0;
    let finish = |path: &mut Path, alias: &mut Option<String>, paths: &mut Vec<(Path, Option<String>)>| {
        if path.last().is_some_and(|word| word == "self") && path.len() > 1 {
            path.pop();
        }
        if let Some(last) = path.last().cloned() {
            let name = alias.take().unwrap_or(last);
            paths.push((std::mem::take(path), Some(name)));
        }
    };
    while k < tokens.len() {
        match &tokens[k] {
            TokenTree::Ident(word) if word == "as" => {
                alias = tokens.get(k + 1).map(ToString::to_string);
                k += 1;
            }
            TokenTree::Ident(word) => path.push(word.to_string()),
            TokenTree::Punct(mark) if mark.as_char() == '*' => paths.push((std::mem::take(&mut path), None)),
            TokenTree::Punct(mark) if mark.as_char() == ',' => finish(&mut path, &mut alias, &mut paths),
            TokenTree::Group(list) => {
                let inner: Vec<TokenTree> = list.stream().into_iter().collect();
                for (tail, name) in use_paths(&inner) {
                    let whole = match tail.as_slice() {
                        [only] if only == "self" => path.clone(),
                        _ => [path.clone(), tail].concat(),
                    };
                    let name =
                        name.map(|name| if name == "self" { whole.last().cloned().unwrap_or(name) } else { name });
                    paths.push((whole, name));
                }
                path.clear();
            }
            _ => {}
        }
        k += 1;
    }
    finish(&mut path, &mut alias, &mut paths);
    paths
}
