//! The rules of `docs/architecture.md`, held against the tree: which crate stands on which, that no files of a crate import
//! each other in a circle, who may name the variants of an enum that is one place, who may ask
//! whether a model is of the plane or of space, how long a file may be, which names say nothing, and that every dependency says what it is for.
//! What one crate may name of another is what its manifest says, and the compiler holds it.

#![allow(clippy::disallowed_methods, reason = "tests make files of their own")]

use architecture::imports;
use architecture::mentions::{calls, mentions};
use architecture::scripts;
use architecture::sources::{Source, files_below, read, sources_below};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// Longest file, in lines before its test module.
const LONGEST_FILE_LINES: usize = 800;

/// Names that say nothing about what is inside.
const EMPTY_NAMES: [&str; 7] = ["utils", "util", "common", "helpers", "helper", "misc", "shared"];

fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The folders below `crates`.
fn packages() -> Vec<PathBuf> {
    let entries = std::fs::read_dir(repository().join("crates")).expect("there is a folder crates");
    entries.map(|entry| entry.expect("a folder entry can be read").path()).filter(|path| path.is_dir()).collect()
}

fn manifest(package: &Path) -> toml::Value {
    toml::from_str(&read(&package.join("Cargo.toml"))).expect("the manifest is TOML")
}

/// The content of the fenced block of `page` that opens with three backticks and `label`.
fn fenced_block<'a>(page: &'a str, label: &str) -> &'a str {
    let opening = format!("```{label}\n");
    let start = page.find(&opening).unwrap_or_else(|| panic!("the page has no block ```{label}")) + opening.len();
    &page[start..start + page[start..].find("```").expect("the block ends")]
}

/// Rows `crate : crate crate ...`.
fn rows(block: &str) -> BTreeMap<String, BTreeSet<String>> {
    let rows = block.lines().filter_map(|line| line.split_once(':'));
    rows.map(|(name, on)| (name.trim().to_owned(), on.split_whitespace().map(str::to_owned).collect())).collect()
}

/// Our own crates that a manifest depends on, for more than tests, without the `loosepin-` before each.
fn own_dependencies(manifest: &toml::Value) -> BTreeSet<String> {
    let names =
        manifest.get("dependencies").and_then(toml::Value::as_table).into_iter().flatten().map(|(name, _)| name);
    names.filter_map(|name| name.strip_prefix("loosepin-")).map(str::to_owned).collect()
}

/// The crates that are products and wrap the library; what they depend on is the library alone.
const AROUND_THE_LIBRARY: [&str; 5] =
    ["loosepin", "loosepin-bench", "loosepin-cli", "loosepin-python", "loosepin-studio"];

#[test]
fn the_page_shows_which_crate_stands_on_which() {
    let page = read(&repository().join("docs/architecture.md"));
    let mut found = BTreeMap::new();
    for package in packages() {
        let name = package.file_name().expect("a name").to_string_lossy().into_owned();
        if !AROUND_THE_LIBRARY.contains(&name.as_str()) {
            let short = name.strip_prefix("loosepin-").expect("crates are called loosepin-...").to_owned();
            found.insert(short, own_dependencies(&manifest(&package)));
        }
    }
    assert_eq!(
        rows(fenced_block(&page, "crates")),
        found,
        "the block ```crates of docs/architecture.md is not what is built"
    );
}

#[test]
fn the_wings_do_not_know_each_other() {
    let page = read(&repository().join("docs/architecture.md"));
    let rows = rows(fenced_block(&page, "crates"));
    let below = |name: &str| {
        let (mut reached, mut open) = (BTreeSet::new(), vec![name.to_owned()]);
        while let Some(next) = open.pop() {
            open.extend(rows[&next].iter().filter(|on| reached.insert((*on).clone())).cloned());
        }
        reached
    };
    for uncertainty in ["uncertainty", "surrogate", "bounds"] {
        assert!(!below("simulate").contains(uncertainty), "mechanics knows {uncertainty}");
    }
    for mechanics in ["mechanics", "simulate"] {
        assert!(!below("bounds").contains(mechanics), "bounds know {mechanics}");
    }
}

#[test]
fn no_files_of_a_crate_import_each_other_in_a_circle() {
    let mut found = String::new();
    for package in packages() {
        let name = package.file_name().expect("a name").to_string_lossy().into_owned();
        let edges = imports::imports(&sources_below(&package.join("src"))).expect("Rust can read its sources");
        for circle in imports::circles(&edges) {
            found += &format!("{name}: {} files in a circle\n", circle.len());
            for file in &circle {
                let to: Vec<&String> = edges[file].intersection(&circle).collect();
                found += &format!("    {file} -> {to:?}\n");
            }
        }
    }
    for (folder, extensions) in SCRIPTS {
        let edges = scripts::imports(&files_below(&repository().join(folder), extensions));
        assert!(edges.values().any(|to| !to.is_empty()) || edges.len() < 10, "no import is found in {folder}");
        for circle in imports::circles(&edges) {
            found += &format!("{folder}: {circle:?}\n");
        }
    }
    assert!(found.is_empty(), "{found}");
}

/// Folders of other languages.
const SCRIPTS: [(&str, &[&str]); 3] = [
    ("crates/loosepin-python/python/loosepin", &["py"]),
    ("crates/loosepin-report/scripts", &["ts"]),
    ("crates/loosepin-studio/front/src", &["ts", "svelte"]),
];

/// Enums whose variants only their own folder names, with that folder. Everybody else asks a variant what it is like.
const ONE_PLACE: [(&str, &str); 33] = [
    ("Deviation", "loosepin-terms/src/deviation.rs"),
    ("Reduction", "loosepin-terms/src/reduction/"),
    ("Where", "loosepin-study/src/places.rs"),
    ("Location", "loosepin-study/src/places.rs"),
    ("Statistic", "loosepin-terms/src/statistic/"),
    ("Estimation", "loosepin-terms/src/statistic/"),
    ("JointKind", "loosepin-mechanics/src/model/joint/"),
    ("OutputKind", "loosepin-mechanics/src/model/output/"),
    ("LoadKind", "loosepin-mechanics/src/model/load/"),
    ("SpringKind", "loosepin-mechanics/src/model/parts/spring.rs"),
    ("CouplingKind", "loosepin-mechanics/src/model/coupling/"),
    ("CouplingNumbers", "loosepin-mechanics/src/model/coupling/"),
    ("Mesh", "loosepin-mechanics/src/model/coupling/"),
    ("DriveLaw", "loosepin-mechanics/src/model/drive/"),
    ("DriveMotion", "loosepin-mechanics/src/model/drive/"),
    ("FrictionLaw", "loosepin-mechanics/src/contact/friction/"),
    ("NormalLaw", "loosepin-mechanics/src/contact/normal/"),
    ("NormalDescription", "loosepin-mechanics/src/model/contact/"),
    ("ContactLaw", "loosepin-mechanics/src/model/contact/"),
    ("PlayShape", "loosepin-mechanics/src/mechanism/play_shape/"),
    ("PlaneRow", "loosepin-mechanics/src/model/joint/"),
    ("SpaceRow", "loosepin-mechanics/src/model/joint/"),
    ("PlaneAttachment", "loosepin-mechanics/src/mechanism/attachment/"),
    ("SpaceAttachment", "loosepin-mechanics/src/mechanism/attachment/"),
    ("DrawnJointKind", "loosepin-result/src/simulation/drawn_joint.rs"),
    ("SpatialKind", "loosepin-space/src/kind/"),
    ("SpatialPlay", "loosepin-space/src/kind/"),
    ("SpatialOutput", "loosepin-space/src/output/"),
    ("ModelOutputKind", "loosepin-space/src/model/output/"),
    ("PlayPart", "loosepin-space/src/play/"),
    ("JointSign", "loosepin-space/src/kind/"),
    ("Treatment", "loosepin-terms/src/treatment.rs"),
    ("Guarantee", "loosepin-terms/src/guarantee.rs"),
];

/// Crates that may name all variants: they compare what is known of each.
const NAMES_VARIANTS: [&str; 1] = ["loosepin-bench"];

#[test]
fn variants_of_what_is_one_place_are_named_there_alone() {
    let page = read(&repository().join("docs/architecture.md"));
    let mut listed = BTreeMap::new();
    for row in fenced_block(&page, "mentions").lines().skip(1).filter(|row| !row.is_empty()) {
        let [name, file, count, reason] = row.splitn(4, " : ").map(str::trim).collect::<Vec<_>>()[..] else {
            panic!("a row of the block ```mentions is 'enum : file : mentions : reason', not '{row}'");
        };
        assert!(!reason.is_empty(), "{row}");
        listed.insert((name.to_owned(), file.to_owned()), count.parse::<usize>().expect("a number of mentions"));
    }
    let mut found = BTreeMap::new();
    for package in packages() {
        let crate_name = package.file_name().expect("a name").to_string_lossy().into_owned();
        if NAMES_VARIANTS.contains(&crate_name.as_str()) {
            continue;
        }
        let sources = sources_below(&package.join("src"));
        for (name, own_folder) in ONE_PLACE {
            let counts = mentions(&sources, name).expect("Rust can read its sources");
            let outside = counts.into_iter().map(|(file, count)| (format!("{crate_name}/src/{file}"), count));
            let outside = outside.filter(|(file, _)| !file.starts_with(own_folder));
            found.extend(outside.map(|(file, count)| ((name.to_owned(), file), count)));
        }
    }
    assert_eq!(
        found, listed,
        "mentions of variants outside their folder are not those of the block ```mentions of docs/architecture.md; \
         ask for a property or a method instead, or state the reason there"
    );
}

/// Files of a crate that ask whether a model is of the plane or of space.
fn asking(sources: &[Source]) -> BTreeSet<String> {
    let all = [mentions(sources, "StudyModel"), calls(sources, "planar"), calls(sources, "spatial")];
    all.into_iter().flat_map(|found| found.expect("Rust can read its sources").into_keys()).collect()
}

#[test]
fn few_files_ask_whether_a_model_is_of_the_plane_or_of_space() {
    let page = read(&repository().join("docs/architecture.md"));
    let mut listed = BTreeSet::new();
    for row in fenced_block(&page, "asks").lines().skip(1).filter(|row| !row.is_empty()) {
        let Some((file, reason)) = row.split_once(" : ") else {
            panic!("a row of the block ```asks is 'file : reason', not '{row}'");
        };
        assert!(!reason.trim().is_empty(), "{row}");
        listed.insert(file.trim().to_owned());
    }
    let mut found = BTreeSet::new();
    for package in packages() {
        let crate_name = package.file_name().expect("a name").to_string_lossy().into_owned();
        let files = asking(&sources_below(&package.join("src"))).into_iter();
        found.extend(files.map(|file| format!("{crate_name}/src/{file}")));
    }
    assert_eq!(
        found, listed,
        "files that ask whether a model is of the plane or of space are not those of the block ```asks of \
         docs/architecture.md; ask what it can do instead (`KindOfModel`, `KindOfResponse`), or state the reason there"
    );
}

/// Entries of a folder, at most: its list is to read as a table of contents.
const MAX_ENTRIES: usize = 25;

#[test]
fn no_folder_is_long_and_each_says_what_stands_in_it() {
    let mut found = Vec::new();
    let fronts = [repository().join("crates/loosepin-studio/front/src")];
    let mut open: Vec<PathBuf> = packages().iter().map(|package| package.join("src")).chain(fronts).collect();
    while let Some(folder) = open.pop() {
        let entries = std::fs::read_dir(&folder).expect("a folder can be read");
        let paths: Vec<PathBuf> = entries.map(|entry| entry.expect("a folder entry can be read").path()).collect();
        if paths.len() > MAX_ENTRIES {
            found.push(format!("{} has {} entries", folder.display(), paths.len()));
        }
        if let Some(head) = paths.iter().find(|path| path.ends_with("mod.rs"))
            && !read(head).starts_with("//!")
        {
            found.push(format!("{} does not say what stands in its folder", head.display()));
        }
        open.extend(paths.into_iter().filter(|path| path.is_dir()));
    }
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn no_file_is_long_and_no_name_is_empty() {
    let page = read(&repository().join("docs/architecture.md"));
    let flat_tables: BTreeSet<&str> = fenced_block(&page, "flat-tables").split_whitespace().collect();
    let (mut found, mut seen) = (Vec::new(), BTreeSet::new());
    for package in packages() {
        let name = package.file_name().expect("a name").to_string_lossy().into_owned();
        for source in sources_below(&package) {
            let path = format!("{name}/{}", source.path);
            let lines = source.lines_before_tests();
            let is_flat = flat_tables.contains(path.as_str());
            if (lines > LONGEST_FILE_LINES && !is_flat) || has_empty_name(&source) {
                found.push(format!("{path} ({lines} lines)"));
            }
            if is_flat {
                seen.insert(path);
            }
        }
    }
    assert!(found.is_empty(), "too long, or a name that says nothing: {found:#?}");
    assert!(flat_tables.iter().all(|table| seen.contains(*table)), "a flat table is not there: {flat_tables:?}");
}

fn has_empty_name(source: &Source) -> bool {
    source.module_path().iter().any(|part| EMPTY_NAMES.contains(&part.as_str()))
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
    for manifest in ["Cargo.toml", "tests/architecture/Cargo.toml", "tests/fuzz/Cargo.toml"] {
        used.extend(dependencies(&read(&repository().join(manifest))));
    }
    let missing: Vec<_> = used.difference(&described).collect();
    let left_over: Vec<_> = described.difference(&used).collect();
    assert!(missing.is_empty(), "no row in docs/dependencies.md for: {missing:?}");
    assert!(left_over.is_empty(), "docs/dependencies.md has a row for what nothing depends on: {left_over:?}");
}

#[test]
fn the_lock_file_of_the_fuzzed_library_is_up_to_date() {
    let manifest = manifest(&repository().join("crates/loosepin"));
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
                    if package != "loosepin" && !package.starts_with("loosepin-") {
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

fn edges(files: &[(&str, &str)]) -> BTreeMap<String, BTreeSet<String>> {
    let sources: Vec<Source> =
        files.iter().map(|(path, text)| Source { path: (*path).to_owned(), text: (*text).to_owned() }).collect();
    imports::imports(&sources).expect("Rust can read it")
}

fn imported(text: &str) -> Vec<String> {
    let edges = edges(&[
        ("lib.rs", "mod contact; mod model; pub use model::quantity::Rule;"),
        ("contact/mod.rs", "mod hertz; mod law; pub use law::Law; pub struct Journal;"),
        ("contact/hertz.rs", text),
        ("contact/law.rs", ""),
        ("model/mod.rs", "pub mod quantity; pub struct Model;"),
        ("model/quantity.rs", ""),
    ]);
    edges["contact/hertz.rs"].iter().cloned().collect()
}

#[test]
fn an_import_is_followed_to_the_file_that_defines_the_name() {
    for text in [
        "use super::Law;",
        "use super::law::Law;",
        "use crate::contact::Law;",
        "use crate::contact::{Law as Other};",
        "fn f(x: &super::Law) {}",
        "fn f() { g(super::law::MOST) }",
        "fn f() { use super::Law; }",
        "impl super::Law for T { fn g(&self) { h({ crate::contact::law::X }) } }",
    ] {
        assert_eq!(imported(text), ["contact/law.rs"], "in: {text}");
    }
    assert_eq!(imported("use crate::Rule;"), ["model/quantity.rs"]);
    assert_eq!(imported("use crate::model::{self, Model, quantity::{Rule}};"), ["model/mod.rs", "model/quantity.rs"]);
    assert_eq!(imported("use super::Journal;"), ["contact/mod.rs"]);
}

#[test]
fn mention_in_comment_documentation_text_or_test_is_no_import() {
    for text in [
        "// use crate::model::Model;",
        "/// See [`crate::model::Model`].\nstruct Friction;",
        "const TEXT: &str = \"crate::model\";",
        "#[cfg(test)]\nmod tests { use crate::model::Model; }",
        "#[cfg(test)]\nuse crate::model::Model;",
        "use serde::Serialize; fn f() { f64::sqrt(2.0); Vec::<u8>::new() }",
    ] {
        assert!(imported(text).is_empty(), "in: {text}");
    }
}

#[test]
fn a_circle_is_found_and_re_exports_make_none() {
    let tied =
        edges(&[("lib.rs", "mod a; mod b;"), ("a.rs", "use crate::b::B;"), ("b.rs", "fn f() { crate::a::f() }")]);
    assert_eq!(imports::circles(&tied), [BTreeSet::from(["a.rs", "b.rs"].map(str::to_owned))]);
    let free =
        edges(&[("lib.rs", "mod a; mod b; pub use a::A; pub use b::B;"), ("a.rs", "use crate::B;"), ("b.rs", "")]);
    assert_eq!(imports::circles(&free), Vec::<BTreeSet<String>>::new());
    // A folder whose `mod.rs` defines what its files use, and calls them, is one too.
    let folder = edges(&[("m/mod.rs", "mod x; pub struct S; fn f() { x::f() }"), ("m/x.rs", "use super::S;")]);
    assert_eq!(imports::circles(&folder).len(), 1);
}

#[test]
fn imports_of_other_languages_are_followed() {
    let source = |path: &str, text: &str| Source { path: path.to_owned(), text: text.to_owned() };
    let edges = scripts::imports(&[
        source("_a.py", "from . import _b, _native\nif TYPE_CHECKING:\n    from ._c import C\n"),
        source("_b.py", "import os\nfrom collections import abc\n"),
        source("_c.py", "def f():\n    from ._a import A\n"),
        source("_inner/arrays.py", "from .._b import x\nfrom .seeds import y\nfrom .. import _c\n"),
        source("_inner/seeds.py", ""),
        source("_d.py", "from ._inner.arrays import z\nfrom ._inner import seeds\n"),
        source(
            "App.svelte",
            "<script>import Part from './parts/Part.svelte';\nimport type { Word } from \"./words\";</script>",
        ),
        source("parts/Part.svelte", "const lazy = import('../words.ts'); import { x } from 'svelte';"),
        source("words.ts", ""),
    ]);
    let to = |path: &str| edges[path].iter().map(String::as_str).collect::<Vec<_>>();
    assert_eq!(to("_a.py"), ["_b.py", "_c.py"]);
    assert_eq!(to("_inner/arrays.py"), ["_b.py", "_c.py", "_inner/seeds.py"]);
    assert_eq!(to("_d.py"), ["_inner/arrays.py", "_inner/seeds.py"]);
    assert!(to("_b.py").is_empty() && to("words.ts").is_empty());
    assert_eq!(to("App.svelte"), ["parts/Part.svelte", "words.ts"]);
    assert_eq!(to("parts/Part.svelte"), ["words.ts"]);
    assert_eq!(imports::circles(&edges), [BTreeSet::from(["_a.py", "_c.py"].map(str::to_owned))]);
}

#[test]
fn every_way_to_name_a_variant_is_a_mention() {
    let count = |text: &str| {
        let source = Source { path: "measure.rs".to_owned(), text: text.to_owned() };
        mentions(&[source], "Kind").expect("Rust can read it").into_values().sum::<usize>()
    };
    for (text, expected) in [
        ("fn f(k: Kind) { match k { Kind::Mean => a(), Kind::Quantile(p) | crate::Kind::Above(p) => b(p) } }", 3),
        ("fn f(k: Kind) -> bool { matches!(k, Kind::Mean) || k == Kind::Mean }", 2),
        ("fn f(k: Kind) { if let Kind::Quantile(p) = k { g(p) } }", 1),
        ("const ALL: [Kind; 2] = [Kind::Mean, Kind::Quantile(0.5)];", 2),
        ("use crate::Kind::{Mean, Quantile};", 2),
        ("use crate::Kind::*;", 1),
        ("use crate::Kind as Other;", 1),
        ("fn f() { Kind::PLAIN.len() + Kind::from_word(\"mean\") }", 0),
        ("// Kind::Mean\n/// [`Kind::Mean`]\nstruct S { kind: Kind }", 0),
        ("use crate::Kind; fn f(k: OtherKind) -> OtherKind { OtherKind::Mean }", 0),
        ("#[cfg(test)]\nmod tests { fn f() { Kind::Mean } }", 0),
        ("#[cfg(test)]\nuse crate::Kind::Mean;\nfn f() { Kind::Mean }", 1),
    ] {
        assert_eq!(count(text), expected, "in: {text}");
    }
}

#[test]
fn every_way_to_ask_for_the_kind_of_a_model_is_found() {
    let asks = |text: &str| {
        let source = Source { path: "check.rs".to_owned(), text: text.to_owned() };
        !asking(&[source]).is_empty()
    };
    for (text, expected) in [
        ("fn f(m: &StudyModel) -> bool { m.spatial().is_some() }", true),
        ("fn f(s: &Study) { let Some(model) = s.model.planar() else { return }; }", true),
        ("fn f(m: &StudyModel) -> bool { matches!(m, StudyModel::Planar(_)) }", true),
        ("fn f(m: &StudyModel) { match m { crate::StudyModel::Spatial(m) => g(m), _ => {} } }", true),
        ("use crate::model::StudyModel::{Planar, Spatial};", true),
        ("use crate::model::StudyModel as Kind;", true),
        ("fn f(m: &StudyModel) -> bool { m.has_dynamics() && spatial() && m.planar(1) }", false),
        ("fn f() -> StudyModel { StudyModel::from_source(source()) }", false),
        ("// m.spatial()\n#[cfg(test)]\nmod tests { fn f() { m.spatial() } }", false),
    ] {
        assert_eq!(asks(text), expected, "in: {text}");
    }
}

#[test]
fn a_file_of_tests_mentions_nothing() {
    let file = |path: &str, text: &str| Source { path: path.to_owned(), text: text.to_owned() };
    let sources = [
        file("lib.rs", "#[cfg(test)]\nmod cases;\nmod plan;"),
        file("cases/mod.rs", "mod exact;"),
        file("cases/exact.rs", "fn f() { Kind::Mean }"),
        file("plan/mod.rs", "#[cfg(test)]\nmod tests;\nfn f() { Kind::Mean }"),
        file("plan/tests.rs", "fn f() { Kind::Mean }"),
    ];
    let found = mentions(&sources, "Kind").expect("Rust can read it");
    assert_eq!(found, BTreeMap::from([("plan/mod.rs".to_owned(), 1)]));
}

#[test]
fn dependencies_are_read_from_every_kind_of_section() {
    let manifest = r#"
        [dependencies]
        plain = "3"
        loosepin-math = { path = "../loosepin-math" }
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
