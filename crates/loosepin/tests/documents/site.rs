//! The documentation as a site: every page is in its table of contents once, and every link leads somewhere; so do those of all other
//! pages of the repository.

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

/// Folders that are not the project's own.
const FOREIGN: [&str; 5] = ["build", "node_modules", "results", "target", "target-release"];

/// Pages outside the site.
fn pages_in_the_repository_alone() -> Vec<String> {
    let entries = fs::read_dir(repository()).expect("the repository").map(|entry| entry.expect("an entry"));
    let names = entries.filter_map(|entry| Some((entry.file_name().into_string().ok()?, entry.path().is_dir())));
    let own = names.filter(|(name, _)| !name.starts_with('.') && !FOREIGN.contains(&name.as_str()) && name != "docs");
    let files = own.flat_map(|(name, is_folder)| if is_folder { files_below(&name) } else { vec![name] });
    files.filter(|path| path.ends_with(".md")).collect()
}

/// Every file of a folder and of those in it, by its path in the repository.
fn files_below(folder: &str) -> Vec<String> {
    let (mut found, mut folders) = (Vec::new(), vec![folder.to_owned()]);
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(repository().join(&folder)).expect("a folder") {
            let entry = entry.expect("an entry");
            let path = format!("{folder}/{}", entry.file_name().to_str().expect("a name"));
            let name = entry.file_name();
            if name.to_string_lossy().starts_with('.') || FOREIGN.iter().any(|folder| name == *folder) {
                continue;
            }
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
        .chain(pages_in_the_repository_alone())
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

/// A page that says more than it must is not read. The generated page has some 10,000 words more.
#[test]
fn the_documentation_is_short() {
    const MOST_OF_SITE: usize = 110_000;
    const MOST_OF_README: usize = 1_400;
    let words = |page: &str| read(page).split_whitespace().count();
    let of_site: usize = files_below("docs").iter().filter(|path| path.ends_with(".md")).map(|page| words(page)).sum();
    assert!(of_site <= MOST_OF_SITE, "{of_site} words");
    assert!(words("README.md") <= MOST_OF_README, "{} words", words("README.md"));
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
