//! The documentation as a site: every page is in its table of contents once, and every link leads somewhere; so do those of the pages
//! that are in the repository alone.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Component, Path, PathBuf};

/// Pages that `just site` makes.
const GENERATED: [&str; 1] = ["docs/python-api.md"];

fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn read(path: &str) -> String {
    fs::read_to_string(repository().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// Pages outside the site.
const IN_THE_REPOSITORY_ALONE: [&str; 8] = [
    "CHANGELOG.md",
    "CONTRIBUTING.md",
    "README.md",
    "cases/README.md",
    "tools/compare/bounds/README.md",
    "tools/compare/identify/README.md",
    "tools/compare/space/README.md",
    "tools/compare/surrogates/README.md",
];

/// Every file of a folder and of those in it, by its path in the repository.
fn files_below(folder: &str) -> Vec<String> {
    let (mut found, mut folders) = (Vec::new(), vec![folder.to_owned()]);
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(repository().join(&folder)).expect("a folder") {
            let entry = entry.expect("an entry");
            let path = format!("{folder}/{}", entry.file_name().to_str().expect("a name"));
            if entry.path().is_dir() {
                folders.push(path);
            } else {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}

/// `docs/theory/../files/ask.md` is `docs/files/ask.md`.
fn tidy(path: &Path) -> String {
    let mut parts: Vec<&str> = Vec::new();
    for part in path.components() {
        match part {
            Component::ParentDir => {
                parts.pop().expect("a link out of the repository");
            }
            Component::Normal(name) => parts.push(name.to_str().expect("UTF-8")),
            _ => {}
        }
    }
    parts.join("/")
}

/// The lines of a page that are not code, and the links in them; code in backticks is left out.
fn links(page: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut in_code = false;
    for line in page.lines() {
        if line.trim_start().starts_with("```") {
            in_code = !in_code;
        }
        if in_code || line.starts_with("    ") {
            continue;
        }
        let prose: String = line.split('`').step_by(2).collect::<Vec<_>>().join("");
        let targets = prose.split("](").skip(1).filter_map(|rest| rest.split(')').next());
        found.extend(targets.map(|target| target.split(' ').next().unwrap_or(target).to_owned()));
    }
    found
}

/// The anchors of a page: its headings in small letters, with hyphens for blanks and without punctuation.
fn anchors(page: &str) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    let mut in_code = false;
    for line in page.lines() {
        if line.starts_with("```") {
            in_code = !in_code;
        }
        let heading = line.trim_start_matches('#');
        if in_code || heading == line || !heading.starts_with(' ') {
            continue;
        }
        let kept = heading.trim().chars().filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'));
        found.insert(kept.collect::<String>().to_lowercase().replace(' ', "-"));
    }
    found
}

/// The pages on the site and those of measurements; without the generated ones.
fn pages_of_docs_and_measured() -> Vec<String> {
    let measured = files_below("measured").into_iter().filter(|path| path.ends_with(".md"));
    contents().into_iter().filter(|page| !GENERATED.contains(&page.as_str())).chain(measured).collect()
}

/// The pages in the table of contents, by their paths in the repository, in its order.
fn contents() -> Vec<String> {
    links(&read("docs/SUMMARY.md").replace("    - ", "- "))
        .iter()
        .map(|link| tidy(&Path::new("docs").join(link)))
        .collect()
}

#[test]
fn every_page_is_in_the_table_of_contents_once() {
    let contents = contents();
    let unique: BTreeSet<&String> = contents.iter().collect();
    assert_eq!(unique.len(), contents.len(), "a page is there twice");
    for page in files_below("docs").iter().filter(|path| path.ends_with(".md") && *path != "docs/SUMMARY.md") {
        assert!(contents.contains(page), "{page} is not in docs/SUMMARY.md");
    }
}

#[test]
fn every_link_leads_somewhere() {
    let pages: BTreeMap<String, String> = pages_of_docs_and_measured()
        .into_iter()
        .chain(IN_THE_REPOSITORY_ALONE.map(str::to_owned))
        .map(|page| (page.clone(), read(&page)))
        .collect();
    let mut count = 0;
    for (page, text) in &pages {
        let folder = Path::new(page).parent().expect("a folder");
        for link in links(text).iter().filter(|link| !link.contains("://")) {
            let (path, anchor) = link.split_once('#').unwrap_or((link, ""));
            let target = if path.is_empty() { page.clone() } else { tidy(&folder.join(path)) };
            count += 1;
            if GENERATED.contains(&target.as_str()) {
                continue;
            }
            assert!(repository().join(&target).is_file(), "{page} links to {link}, which is no file");
            if !anchor.is_empty() {
                let known = anchors(&read(&target));
                assert!(known.contains(anchor), "{page} links to {link}; the headings there are {known:?}");
            }
        }
    }
    assert!(count > 80, "{count} links");
}

/// What no page shows is waste: it grows the repository, and nobody would notice that it is wrong.
#[test]
fn every_picture_is_shown() {
    let shown: BTreeSet<String> = pages_of_docs_and_measured()
        .iter()
        .flat_map(|page| {
            let folder = Path::new(page).parent().expect("a folder").to_owned();
            let link_targets = links(&read(page)).into_iter().filter(|link| !link.contains("://"));
            link_targets
                .map(move |link| tidy(&folder.join(link.split('#').next().expect("a path"))))
                .collect::<Vec<_>>()
        })
        .collect();
    let files = [files_below("docs"), files_below("measured")].concat();
    for picture in files.iter().filter(|path| path.ends_with(".svg") || path.ends_with(".png")) {
        assert!(shown.contains(picture), "no page shows {picture}");
    }
}
