//! The rules of `docs/architecture.md`, read from that page and held against the tree: who may import whom, how long a
//! file may be, which names a module may not have, and that every dependency says what it is for.

use proc_macro2::{Delimiter, TokenStream, TokenTree};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// Longest file, in lines before its test module.
const LONGEST_FILE_LINES: usize = 800;

/// Names that say nothing about what is inside.
const EMPTY_NAMES: [&str; 7] = ["utils", "util", "common", "helpers", "helper", "misc", "shared"];

/// A breach of a rule.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
enum Breach {
    /// `file` mentions `imported`, and the row of `importer` does not list it.
    Edge { file: String, importer: String, imported: String },
    /// `file` climbs out of its module with `super`.
    Climbs { file: String },
    /// The module has a folder or file and no row in the table.
    NoRow { module: String },
    /// The table has a row and the module does not exist.
    NoModule { module: String },
    /// A row lists a module that has no row itself.
    UnknownImport { module: String, imported: String },
    /// The rows, followed, lead from the module back to itself.
    Cycle { module: String },
    /// The file has more lines than allowed, and is not listed as a flat table.
    TooLong { file: String, lines: usize },
    /// The file is listed as a flat table, and is not there.
    NoFlatTable { file: String },
    /// The module has one of the [`EMPTY_NAMES`].
    EmptyName { file: String },
    /// Rust cannot split the file into tokens.
    Unreadable { file: String, reason: String },
}

/// A source file: its path below `src`, with `/`, and its text.
struct Source {
    path: String,
    text: String,
}

impl Source {
    fn new(path: &str, text: &str) -> Self {
        Self { path: path.to_owned(), text: text.to_owned() }
    }

    /// The module path, `["model", "quantity"]` for `model/quantity.rs`; empty for the crate root.
    fn module_path(&self) -> Vec<String> {
        let mut parts: Vec<String> = self.path.trim_end_matches(".rs").split('/').map(str::to_owned).collect();
        if parts.last().is_some_and(|last| last == "mod" || last == "lib") {
            parts.pop();
        }
        parts
    }
}

type ImportTable = BTreeMap<String, BTreeSet<String>>;

/// The content of the fenced block of `page` that opens with three backticks and `label`.
fn fenced_block<'a>(page: &'a str, label: &str) -> Option<&'a str> {
    let opening = format!("```{label}\n");
    let start = page.find(&opening)? + opening.len();
    Some(&page[start..start + page[start..].find("```")?])
}

/// Rows `module : imported imported ...`.
fn import_table(block: &str) -> ImportTable {
    block
        .lines()
        .filter_map(|line| line.split_once(':'))
        .map(|(module, imported)| {
            (module.trim().to_owned(), imported.split_whitespace().map(str::to_owned).collect::<BTreeSet<_>>())
        })
        .collect()
}

/// What the tokens of a file mention: top-level modules of this crate, and whether `super` leads to the crate root.
#[derive(Default)]
struct Mentions {
    modules: BTreeSet<String>,
    climbs_to_root: bool,
}

fn is_punctuation(token: Option<&TokenTree>, character: char) -> bool {
    matches!(token, Some(TokenTree::Punct(punctuation)) if punctuation.as_char() == character)
}

fn is_path_separator(tokens: &[TokenTree], at: usize) -> bool {
    is_punctuation(tokens.get(at), ':') && is_punctuation(tokens.get(at + 1), ':')
}

/// Collects `crate::x` and `crate::{x, y}` from `stream`, which stands `depth` modules below the crate root. Comments
/// are no tokens and documentation is a string, so neither counts.
fn collect_mentions(stream: TokenStream, depth: usize, found: &mut Mentions) {
    let tokens: Vec<TokenTree> = stream.into_iter().collect();
    let mut module_body_at = None;
    for (at, token) in tokens.iter().enumerate() {
        match token {
            TokenTree::Group(group) => {
                let inner_depth = depth + usize::from(module_body_at == Some(at));
                collect_mentions(group.stream(), inner_depth, found);
            }
            // `mod name { ... }` goes one module down.
            TokenTree::Ident(word) if word == "mod" => module_body_at = Some(at + 2),
            TokenTree::Ident(word) if word == "crate" && is_path_separator(&tokens, at + 1) => {
                match tokens.get(at + 3) {
                    Some(TokenTree::Ident(module)) => {
                        found.modules.insert(module.to_string());
                    }
                    Some(TokenTree::Group(list)) if list.delimiter() == Delimiter::Brace => {
                        found.modules.extend(first_words(list.stream()));
                    }
                    _ => {}
                }
            }
            TokenTree::Ident(word) if word == "super" => {
                let follows_super = at >= 3
                    && matches!(&tokens[at - 3], TokenTree::Ident(before) if before == "super")
                    && is_path_separator(&tokens, at - 2);
                if !follows_super && climb(&tokens, at) >= depth {
                    found.climbs_to_root = true;
                }
            }
            _ => {}
        }
    }
}

/// How many `super::` follow each other from `at` on.
fn climb(tokens: &[TokenTree], at: usize) -> usize {
    let mut levels = 0;
    while matches!(tokens.get(at + 3 * levels), Some(TokenTree::Ident(word)) if word == "super")
        && is_path_separator(tokens, at + 3 * levels + 1)
    {
        levels += 1;
    }
    levels
}

/// The first word of each item of a `use` list.
fn first_words(list: TokenStream) -> Vec<String> {
    let mut words = Vec::new();
    let mut at_start = true;
    for token in list {
        match token {
            TokenTree::Ident(word) if at_start => {
                words.push(word.to_string());
                at_start = false;
            }
            TokenTree::Punct(punctuation) if punctuation.as_char() == ',' => at_start = true,
            _ => {}
        }
    }
    words
}

/// Lines before the test module that ends the file.
fn lines_before_tests(text: &str) -> usize {
    let lines: Vec<&str> = text.lines().collect();
    lines.windows(2).position(|pair| pair[0] == "#[cfg(test)]" && pair[1].starts_with("mod ")).unwrap_or(lines.len())
}

/// Every breach of the rules by the sources below one `src` folder.
fn breaches(sources: &[Source], table: &ImportTable, flat_tables: &BTreeSet<String>) -> BTreeSet<Breach> {
    let mut found = BTreeSet::new();
    let modules: BTreeSet<String> =
        sources.iter().filter_map(|source| source.module_path().into_iter().next()).collect();
    found.extend(
        modules.iter().filter(|module| !table.contains_key(*module)).cloned().map(|module| Breach::NoRow { module }),
    );
    found.extend(
        table.keys().filter(|module| !modules.contains(*module)).cloned().map(|module| Breach::NoModule { module }),
    );
    found.extend(table_breaches(table));
    for file in flat_tables {
        if !sources.iter().any(|source| &source.path == file) {
            found.insert(Breach::NoFlatTable { file: file.clone() });
        }
    }
    for source in sources {
        let file = source.path.clone();
        let module_path = source.module_path();
        let lines = lines_before_tests(&source.text);
        if lines > LONGEST_FILE_LINES && !flat_tables.contains(&file) {
            found.insert(Breach::TooLong { file: file.clone(), lines });
        }
        if module_path.iter().any(|part| EMPTY_NAMES.contains(&part.as_str())) {
            found.insert(Breach::EmptyName { file: file.clone() });
        }
        let Some(importer) = module_path.first() else {
            continue; // the crate root names every module
        };
        let tokens: TokenStream = match source.text.parse() {
            Ok(tokens) => tokens,
            Err(error) => {
                found.insert(Breach::Unreadable { file, reason: format!("{error}") });
                continue;
            }
        };
        let mut mentions = Mentions::default();
        collect_mentions(tokens, module_path.len(), &mut mentions);
        if mentions.climbs_to_root {
            found.insert(Breach::Climbs { file: file.clone() });
        }
        let allowed = table.get(importer).cloned().unwrap_or_default();
        for imported in mentions.modules.intersection(&modules) {
            if imported != importer && !allowed.contains(imported) {
                found.insert(Breach::Edge {
                    file: file.clone(),
                    importer: importer.clone(),
                    imported: imported.clone(),
                });
            }
        }
    }
    found
}

/// Rows that name what has no row, and rows that lead back to themselves.
fn table_breaches(table: &ImportTable) -> BTreeSet<Breach> {
    let mut found = BTreeSet::new();
    for (module, imported) in table {
        for name in imported.iter().filter(|name| !table.contains_key(*name)) {
            found.insert(Breach::UnknownImport { module: module.clone(), imported: name.clone() });
        }
        let mut reached: BTreeSet<&String> = BTreeSet::new();
        let mut open: Vec<&String> = imported.iter().collect();
        while let Some(next) = open.pop() {
            if reached.insert(next) {
                open.extend(table.get(next).into_iter().flatten());
            }
        }
        if reached.contains(module) {
            found.insert(Breach::Cycle { module: module.clone() });
        }
    }
    found
}

// ---------------------------------------------------------------------------------------------------------------------
// The tree as it is.

fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// All Rust files below `folder`, with paths relative to it.
fn sources_below(folder: &Path) -> Vec<Source> {
    let mut sources = Vec::new();
    let mut open = vec![folder.to_owned()];
    while let Some(next) = open.pop() {
        for entry in std::fs::read_dir(&next).unwrap_or_else(|error| panic!("{}: {error}", next.display())) {
            let path = entry.expect("a folder entry can be read").path();
            if path.is_dir() {
                open.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let relative = path.strip_prefix(folder).expect("the file lies below the folder");
                let parts: Vec<_> = relative.iter().map(|part| part.to_string_lossy()).collect();
                sources.push(Source { path: parts.join("/"), text: read(&path) });
            }
        }
    }
    sources
}

/// The folders below `crates`.
fn packages() -> Vec<PathBuf> {
    let entries = std::fs::read_dir(repository().join("crates")).expect("there is a folder crates");
    entries.map(|entry| entry.expect("a folder entry can be read").path()).filter(|path| path.is_dir()).collect()
}

fn architecture_page() -> String {
    read(&repository().join("docs/architecture.md"))
}

#[test]
fn library_follows_the_import_table() {
    let page = architecture_page();
    let table = import_table(fenced_block(&page, "imports").expect("the page has a block ```imports"));
    let flat_tables = fenced_block(&page, "flat-tables").expect("the page has a block ```flat-tables");
    let flat_tables = flat_tables.split_whitespace().map(str::to_owned).collect();
    let found = breaches(&sources_below(&repository().join("crates/loosepin/src")), &table, &flat_tables);
    assert!(found.is_empty(), "docs/architecture.md is not followed:\n{found:#?}");
}

#[test]
fn other_crates_have_no_long_files_and_no_empty_names() {
    let mut found = Vec::new();
    for package in packages().iter().filter(|package| package.file_name().is_some_and(|name| name != "loosepin")) {
        for source in sources_below(package) {
            let lines = lines_before_tests(&source.text);
            let is_empty_name = source.module_path().iter().any(|part| EMPTY_NAMES.contains(&part.as_str()));
            if lines > LONGEST_FILE_LINES || is_empty_name {
                found.push(format!("{}/{} ({lines} lines)", package.display(), source.path));
            }
        }
    }
    assert!(found.is_empty(), "too long, or a name that says nothing: {found:#?}");
}

#[test]
fn every_dependency_says_what_it_is_for() {
    let page = read(&repository().join("docs/dependencies.md"));
    let described: BTreeSet<String> = page
        .lines()
        .filter_map(|line| line.strip_prefix("| `"))
        .filter_map(|row| row.split_once('`'))
        .map(|(name, _)| name.to_owned())
        .collect();
    let mut used = BTreeSet::new();
    for package in packages() {
        used.extend(dependencies(&read(&package.join("Cargo.toml"))));
    }
    for manifest in ["Cargo.toml", "tests/fuzz/Cargo.toml"] {
        used.extend(dependencies(&read(&repository().join(manifest))));
    }
    let missing: Vec<_> = used.difference(&described).collect();
    let left_over: Vec<_> = described.difference(&used).collect();
    assert!(missing.is_empty(), "no row in docs/dependencies.md for: {missing:?}");
    assert!(left_over.is_empty(), "docs/dependencies.md has a row for what nothing depends on: {left_over:?}");
}

#[test]
fn the_lock_file_of_the_fuzzed_library_is_up_to_date() {
    let manifest: toml::Value = toml::from_str(&read(&repository().join("crates/loosepin/Cargo.toml"))).expect("TOML");
    let lock: toml::Value = toml::from_str(&read(&repository().join("tests/fuzz/Cargo.lock"))).expect("TOML");
    let packages = lock["package"].as_array().expect("packages");
    let own = packages.iter().find(|package| package["name"].as_str() == Some("loosepin")).expect("the library");
    let words = own["dependencies"].as_array().expect("names").iter().filter_map(toml::Value::as_str);
    // "name", or "name version" where there are several.
    let locked: BTreeSet<&str> = words.filter_map(|name| name.split(' ').next()).collect();
    let asked = manifest["dependencies"].as_table().expect("dependencies").keys().map(String::as_str);
    let missing: Vec<&str> = asked.filter(|name| !locked.contains(name)).collect();
    assert!(missing.is_empty(), "cargo check in tests/fuzz adds to its lock file: {missing:?}");
}

/// Names of the packages that a manifest asks for, our own ones left out.
fn dependencies(manifest: &str) -> BTreeSet<String> {
    fn collect(value: &toml::Value, found: &mut BTreeSet<String>) {
        let Some(table) = value.as_table() else { return };
        for (key, inner) in table {
            if matches!(key.as_str(), "dependencies" | "dev-dependencies" | "build-dependencies") {
                for (name, wanted) in inner.as_table().into_iter().flatten() {
                    let package = wanted.get("package").and_then(toml::Value::as_str).unwrap_or(name);
                    if wanted.get("path").is_none() {
                        found.insert(package.to_owned());
                    }
                }
            } else if matches!(key.as_str(), "target" | "workspace") || key.starts_with("cfg(") {
                collect(inner, found);
            }
        }
    }
    let value: toml::Value = toml::from_str(manifest).expect("the manifest is TOML");
    let mut found = BTreeSet::new();
    collect(&value, &mut found);
    found
}

// ---------------------------------------------------------------------------------------------------------------------
// The rules fail when they should.

/// A tree of three modules: contact uses math, model uses both.
fn small_tree() -> (Vec<Source>, ImportTable) {
    let sources = vec![
        Source::new("lib.rs", "pub mod contact; pub mod math; pub mod model;"),
        Source::new("math/mod.rs", "pub struct Vector;"),
        Source::new("contact/mod.rs", "mod hertz; use crate::math::Vector;"),
        Source::new("contact/hertz.rs", "use super::Vector; mod tests { use super::super::hertz; }"),
        Source::new("model/mod.rs", "use crate::{contact::{self}, math};"),
    ];
    (sources, import_table("math :\ncontact : math\nmodel : math contact\n"))
}

fn breaches_with(path: &str, text: &str) -> Vec<Breach> {
    let (mut sources, table) = small_tree();
    sources.push(Source::new(path, text));
    breaches(&sources, &table, &BTreeSet::new()).into_iter().collect()
}

fn edge(file: &str, importer: &str, imported: &str) -> Breach {
    Breach::Edge { file: file.to_owned(), importer: importer.to_owned(), imported: imported.to_owned() }
}

#[test]
fn sound_tree_has_no_breach() {
    let (sources, table) = small_tree();
    assert_eq!(breaches(&sources, &table, &BTreeSet::new()), BTreeSet::new());
}

#[test]
fn edge_that_is_not_in_the_table_is_found_however_it_is_written() {
    let path = "contact/friction.rs";
    let expected = vec![edge(path, "contact", "model")];
    for text in [
        "use crate::model::Model;",
        "use crate::{math, model::Model};",
        "use crate::{\n    math::{Vector},\n    model,\n};",
        "fn f(x: &crate::model::Model) {}",
        "fn f() { println!(\"{}\", crate::model::NAME); }",
        "mod tests { use crate :: model; }",
        "macro_rules! m { () => { $crate::model::NAME }; }",
    ] {
        assert_eq!(breaches_with(path, text), expected, "in: {text}");
    }
}

#[test]
fn mention_in_comment_documentation_or_text_is_no_edge() {
    for text in [
        "// use crate::model::Model;",
        "//! [`crate::model`] compiles it.",
        "/// See [`crate::model::Model`].\nstruct Friction;",
        "/* crate::model /* crate::model */ */",
        "const TEXT: &str = \"crate::model\"; const RAW: &str = r#\"crate::model \"quoted\" \"#;",
    ] {
        assert_eq!(breaches_with("contact/friction.rs", text), Vec::new(), "in: {text}");
    }
}

#[test]
fn climbing_to_the_crate_root_is_found() {
    let climbs = |file: &str| vec![Breach::Climbs { file: file.to_owned() }];
    assert_eq!(breaches_with("contact/a.rs", "use super::super::model;"), climbs("contact/a.rs"));
    assert_eq!(breaches_with("contact.rs", "use super::model;"), climbs("contact.rs"));
    let nested = "mod tests { use super::super::super::model; }";
    assert_eq!(breaches_with("contact/a.rs", nested), climbs("contact/a.rs"));
}

#[test]
fn module_without_row_and_row_without_module_are_found() {
    let no_row = Breach::NoRow { module: "report".to_owned() };
    assert_eq!(breaches_with("report/mod.rs", ""), vec![no_row]);

    let (sources, mut table) = small_tree();
    table.insert("bounds".to_owned(), BTreeSet::new());
    let no_module = Breach::NoModule { module: "bounds".to_owned() };
    assert_eq!(breaches(&sources, &table, &BTreeSet::new()), BTreeSet::from([no_module]));
}

#[test]
fn table_with_a_cycle_or_an_unknown_name_is_found() {
    let cycle = |module: &str| Breach::Cycle { module: module.to_owned() };
    assert_eq!(
        table_breaches(&import_table("a : b\nb : c\nc : a\nd : a\n")),
        [cycle("a"), cycle("b"), cycle("c")].into()
    );
    let unknown = Breach::UnknownImport { module: "a".to_owned(), imported: "e".to_owned() };
    assert_eq!(table_breaches(&import_table("a : e\n")), [unknown].into());
}

#[test]
fn long_file_is_found_unless_its_end_is_tests_or_it_is_a_flat_table() {
    let body = "const X: u8 = 3;\n".repeat(LONGEST_FILE_LINES + 1);
    let path = "contact/long.rs".to_owned();
    let too_long = Breach::TooLong { file: path.clone(), lines: LONGEST_FILE_LINES + 1 };
    assert_eq!(breaches_with(&path, &body), vec![too_long]);

    let with_tests = format!("#[cfg(test)]\nmod tests {{\n{body}}}\n");
    assert_eq!(breaches_with(&path, &with_tests), Vec::new());

    let (mut sources, table) = small_tree();
    sources.push(Source::new(&path, &body));
    assert_eq!(breaches(&sources, &table, &[path.clone()].into()), BTreeSet::new());
    sources.pop();
    let no_flat_table = Breach::NoFlatTable { file: path.clone() };
    assert_eq!(breaches(&sources, &table, &[path].into()), [no_flat_table].into());
}

#[test]
fn module_whose_name_says_nothing_is_found() {
    let path = "contact/utils.rs";
    assert_eq!(breaches_with(path, ""), vec![Breach::EmptyName { file: path.to_owned() }]);
}

#[test]
fn dependencies_are_read_from_every_kind_of_section() {
    let manifest = r#"
        [dependencies]
        plain = "3"
        ours = { path = "../ours" }
        renamed = { package = "real", version = "2" }
        [dev-dependencies]
        only-tests = "4"
        [target.'cfg(unix)'.dependencies]
        only-unix = "5"
        [workspace.dependencies]
        of-all = "6"
    "#;
    let expected = ["of-all", "only-tests", "only-unix", "plain", "real"].map(str::to_owned);
    assert_eq!(dependencies(manifest), BTreeSet::from(expected));
}
